//! `libretro CORE ROM STEP...`: runs a cartridge in an emulator that is a libretro
//! core, step by step. Steps:
//!
//! - `end`: until the program says that it has ended; prints its report's text, and
//!   fails if the program does;
//! - `pictures N`: until it has shown that many pictures since its start; prints its
//!   report's text, which is about the last of them;
//! - `frames N`: for that many of the panel's own;
//! - `hold BUTTONS`: holds these from now on, separated by commas (`up`, `a`, `l`,
//!   ...; `none`);
//! - `screen FILE`: the panel's pixels, 8 bits each of red, green and blue;
//! - `memory ADDRESS LENGTH FILE`: bytes of the machine's memory.

mod core;
mod report;

use std::process::ExitCode;

use crate::core::Core;
use report::{Report, State};

/// Panel frames after which a program that is waited for hangs: ten minutes of its
/// time.
const LIMIT: u32 = 10 * 60 * 60;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), String> {
    let [core, rom, steps @ ..] = arguments else {
        return Err("usage: libretro CORE ROM STEP...".into());
    };
    let read = |path: &String| std::fs::read(path).map_err(|error| format!("{path}: {error}"));
    let mut core = Core::load(core, read(rom)?)?;
    let mut steps = steps.iter().map(String::as_str);
    while let Some(step) = steps.next() {
        let mut operand = || steps.next().ok_or(format!("{step}: what?"));
        let number = |text: &str| {
            let parsed = match text.strip_prefix("0x") {
                Some(digits) => u32::from_str_radix(digits, 16),
                None => text.parse(),
            };
            parsed.map_err(|error| format!("{text}: {error}"))
        };
        match step {
            "end" => {
                let report = until(&mut core, "the end", |report| report.state != State::Runs)?;
                print!("{}", report.text);
            }
            "pictures" => {
                let count = number(operand()?)?;
                let what = format!("picture {count}");
                let report = until(&mut core, &what, |report| report.pictures >= count)?;
                print!("{}", report.text);
            }
            "frames" => (0..number(operand()?)?).for_each(|_| core.frame()),
            "hold" => core::hold(operand()?)?,
            "screen" => write(operand()?, &core::screen()?)?,
            "memory" => {
                let (address, length) = (number(operand()?)?, number(operand()?)?);
                let bytes = core.memory(address as usize, length as usize)?;
                write(operand()?, bytes)?;
            }
            _ => return Err(format!("no step is called {step}")),
        }
    }
    Ok(())
}

/// Runs until the program's report is as asked; fails if the program does.
fn until(core: &mut Core, what: &str, done: impl Fn(&Report) -> bool) -> Result<Report, String> {
    for _ in 0..LIMIT {
        let report = Report::read(core.memory(report::ADDRESS, report::LENGTH)?);
        match report {
            Some(report) if report.state == State::Failed => return Err(report.text),
            Some(report) if done(&report) => return Ok(report),
            Some(report) if report.state == State::Ended => {
                return Err(format!("it ended before {what}: {}", report.text));
            }
            _ => core.frame(),
        }
    }
    Err(format!("{what} did not come"))
}

fn write(path: &str, bytes: &[u8]) -> Result<(), String> {
    std::fs::write(path, bytes).map_err(|error| format!("{path}: {error}"))
}
