//! The `fixel` command: renders, compares and bakes scenes on the host.
//!
//! Exit codes: 0 done; 1 with one line on standard error; 2 for wrong usage.
//! Standard output carries only what was asked for there.

mod animate;
mod args;
mod bake;
mod baked;
mod compare;
mod estimate;
mod examples;
mod info;
mod input;
#[cfg(unix)]
mod interrupt;
mod output;
mod progress;
mod raster;
mod reference;
mod render;
mod view;

use args::{Cli, Command};
use clap::{CommandFactory, Parser};
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::parse();
    #[cfg(unix)]
    interrupt::listen();
    match run(cli.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("fixel: {}", fixel_scene::one_line(&format!("{error:#}")));
            ExitCode::FAILURE
        }
    }
}

fn completions(shell: clap_complete::Shell) -> anyhow::Result<()> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "fixel", &mut script);
    output::stdout(&String::from_utf8_lossy(&script))
}

fn run(command: Command) -> anyhow::Result<()> {
    match command {
        Command::Render(args) => render::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Bake(args) => bake::run(&args),
        Command::Info(args) => info::run(&args),
        Command::Animate(args) => animate::run(&args),
        Command::View(args) => view::run(&args),
        Command::Estimate(args) => estimate::run(&args),
        Command::Completions(args) => completions(args.shell),
    }
}
