//! The `fixel` command: renders, compares and bakes scenes on the host.
//!
//! Exit codes: 0 done; 1 with one line on standard error; 2 for wrong usage.
//! Standard output carries only what was asked for there.

mod animate;
mod args;
mod bake;
mod baked;
mod compare;
mod html;
mod info;
mod input;
mod output;
mod progress;
mod raster;
mod reference;
mod render;

use anyhow::bail;
use args::{Cli, Command};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::parse();
    match run(cli.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let message = format!("{error:#}");
            let line = message.split_whitespace().collect::<Vec<_>>().join(" ");
            eprintln!("fixel: {line}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> anyhow::Result<()> {
    match command {
        Command::Render(args) => render::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Bake(args) => bake::run(&args),
        Command::Info(args) => info::run(&args),
        Command::Animate(args) => animate::run(&args),
        Command::View(_) => bail!("view is not there yet"),
        Command::Estimate(_) => bail!("estimate is not there yet"),
    }
}
