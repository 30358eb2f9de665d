//! Everything that continuous integration runs, stage by stage.

use std::env;
use std::process::Command;
use std::time::Instant;

use crate::board::{self, BOARDS, Board};
use crate::device::DEVICES;
use crate::measure::Target;
use crate::problem::Result;
use crate::report::Tally;
use crate::{
    accepted, accuracy, child, examples, firmware, footprint, fuzz, gallery, gba, hostbench, links,
    package, panels, parallel, parity, paths, picture, pictures, scene, small_chip, soak, supply,
    template, toolchain, view, web,
};

/// A stage: its name, and what it does.
type Stage = (&'static str, fn(&mut Tally));

/// In this order: what is quick and fails often comes first.
const STAGES: [Stage; 21] = [
    ("format", format),
    ("lints", lints),
    ("supply", supply::run),
    ("tests", tests),
    ("view", view::run),
    ("docs", docs),
    ("firmware-lints", firmware_lints),
    ("counter", counter),
    ("counts", accepted::check),
    ("parity", |tally| {
        let result = parity::run(tally, Target::all(), &[]);
        tally.need("parity", result);
    }),
    ("gba", gba_stage),
    ("panels", panels::run),
    ("web", web::run),
    ("footprint", footprint_stage),
    ("small-chip", |tally| {
        tally.check("a demo in a small chip", small_chip::run());
    }),
    ("accuracy", |tally| {
        let result = accuracy::run(tally, None);
        tally.need("accuracy", result);
    }),
    ("soak", |tally| {
        let result = soak::run(tally, 20_000, 500);
        tally.need("soak", result);
    }),
    ("fuzz", fuzz::stage),
    ("examples", examples::run),
    ("template", template::run),
    ("package", package::run),
];

/// Crates in `targets/` that the host builds and tests.
const HOST_CRATES: [&str; 4] = ["runner", "host", "demo", "libretro"];
/// Those of them that have tests and docs.
const TESTED: [&str; 3] = ["runner", "demo", "libretro"];
/// All crates in `targets/`.
const TARGET_CRATES: [&str; 10] = [
    "runner", "host", "demo", "libretro", "cortex-m", "riscv", "wasm", "gba", "rp2040", "web",
];

/// The stages' names.
pub fn names() -> Vec<&'static str> {
    STAGES.iter().map(|(name, _)| *name).collect()
}

/// Runs the stages named, or all. Prints `N passed, N failed, N skipped` as the last line on
/// standard output.
pub fn run(only: &[String]) -> Result<()> {
    let mut all = Tally::default();
    let mut times = Vec::new();
    for (name, stage) in STAGES {
        if !only.is_empty() && !only.iter().any(|wanted| wanted == name) {
            continue;
        }
        eprintln!("\n=== {name}");
        let start = Instant::now();
        let mut tally = Tally::default();
        stage(&mut tally);
        let seconds = start.elapsed().as_secs_f64();
        eprintln!("=== {name}: {} ({seconds:.1} s)", tally.summary());
        times.push((name, tally.summary(), seconds));
        all.add(tally);
    }
    eprintln!("\nSummary");
    for (name, summary, seconds) in times {
        eprintln!("  {name:<15} {seconds:>7.1} s  {summary}");
    }
    for name in &all.skipped {
        eprintln!("  skipped: {name}");
    }
    for name in &all.failed {
        eprintln!("  FAILED:  {name}");
    }
    println!("{}", all.summary());
    all.result()
}

/// Cargo on the host, at the repository's root.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new("cargo");
    child::without_outer_package(&mut command);
    command.args(arguments).current_dir(paths::root());
    command
}

/// The same for a crate in `targets/`, which shares nothing with the
/// workspace.
fn cargo_in(folder: &str, arguments: &[&str]) -> Command {
    let mut command = cargo(arguments);
    command
        .arg("--manifest-path")
        .arg(firmware::manifest(folder));
    command.env(
        "CARGO_TARGET_DIR",
        paths::target_crate(folder).join("target"),
    );
    command
}

fn format(tally: &mut Tally) {
    let rustfmt = toolchain::component("fmt", "rustfmt");
    if tally.need("format", rustfmt).is_none() {
        return;
    }
    let result = child::visibly(&mut cargo(&["fmt", "--all", "--check"]));
    tally.check("format of the workspace", result);
    for folder in TARGET_CRATES {
        let mut command = cargo(&["fmt", "--check", "--manifest-path"]);
        command.arg(firmware::manifest(folder));
        tally.check(
            &format!("format of targets/{folder}"),
            child::visibly(&mut command),
        );
    }
    let mut command = cargo(&["fmt", "--check", "--manifest-path"]);
    let result = child::visibly(command.arg(hostbench::manifest()));
    tally.check("format of tools/hostbench", result);
}

fn lints(tally: &mut Tally) {
    let clippy = toolchain::component("clippy", "clippy");
    if tally.need("lints", clippy).is_none() {
        return;
    }
    let arguments = [
        "clippy",
        "--workspace",
        "--all-targets",
        "--",
        "-D",
        "warnings",
    ];
    let result = child::visibly(&mut cargo(&arguments));
    tally.check("lints of the workspace", result);
    // What firmware leaves out must not be missed by what it keeps; and the workspace asks for
    // more than an application does.
    let alone: [(&str, &[&str]); 2] = [
        ("without features", &["--no-default-features"]),
        ("as applications have it", &[]),
    ];
    for (how, features) in alone {
        let mut command = cargo(&["clippy", "--package", "fixel"]);
        command.args(features).args(["--", "-D", "warnings"]);
        let result = child::visibly(&mut command);
        tally.check(&format!("lints of the core {how}"), result);
    }
    let mut command = cargo(&["clippy", "--quiet", "--manifest-path"]);
    command
        .arg(hostbench::manifest())
        .args(["--", "-D", "warnings"]);
    let result = child::visibly(&mut command);
    tally.check("lints of tools/hostbench", result);
    for folder in HOST_CRATES {
        let mut command = cargo_in(folder, &["clippy", "--quiet", "--all-targets"]);
        command.args(["--", "-D", "warnings"]);
        tally.check(
            &format!("lints of targets/{folder}"),
            child::visibly(&mut command),
        );
    }
}

fn tests(tally: &mut Tally) {
    let mut command = cargo(&["test", "--workspace", "--no-fail-fast"]);
    // Property tests try the same cases each time, if nothing else is asked for: what is found
    // does not hang on chance. By `cargo test` they try others each time.
    if env::var_os("PROPTEST_RNG_SEED").is_none() {
        command.env("PROPTEST_RNG_SEED", "1");
    }
    cargo_tests(tally, "the workspace", &mut command);
    for folder in TESTED {
        let mut command = cargo_in(folder, &["test", "--quiet", "--no-fail-fast"]);
        cargo_tests(tally, &format!("targets/{folder}"), &mut command);
    }
}

/// Runs `cargo test` and counts each of its tests.
pub fn cargo_tests(tally: &mut Tally, what: &str, command: &mut Command) {
    let mut counts = Counts::default();
    let mut failed = Vec::new();
    let result = child::tee(command, |line| {
        counts.take(line);
        if let Some(name) = failed_test(line) {
            failed.push(name.to_owned());
        }
    });
    tally.passed += counts.passed;
    for name in &failed {
        tally.failed.push(format!("test {name} of {what}"));
    }
    let unnamed = counts.failed.saturating_sub(failed.len());
    for _ in 0..unnamed {
        tally.failed.push(format!("a test of {what}"));
    }
    for _ in 0..counts.ignored {
        tally.skip(&format!("a test of {what}"), "marked as ignored");
    }
    let whole = result.and_then(|success| {
        if !success && counts.failed == 0 {
            return Err("it does not build, or stopped midway".into());
        }
        Ok(())
    });
    tally.need(&format!("tests of {what}"), whole);
}

/// Sums over `test result:` lines.
#[derive(Debug, Default, PartialEq, Eq)]
struct Counts {
    passed: usize,
    failed: usize,
    ignored: usize,
}

impl Counts {
    /// `test result: ok. 6 passed; 0 failed; 1 ignored; 0 measured; ...`
    fn take(&mut self, line: &str) {
        let Some((_, rest)) = line
            .strip_prefix("test result: ")
            .and_then(|rest| rest.split_once(". "))
        else {
            return;
        };
        for part in rest.split("; ") {
            let Some((number, what)) = part.split_once(' ') else {
                continue;
            };
            let number = number.parse().unwrap_or(0);
            match what {
                "passed" => self.passed += number,
                "failed" => self.failed += number,
                "ignored" => self.ignored += number,
                _ => {}
            }
        }
    }
}

/// The name in `test some::name ... FAILED`.
fn failed_test(line: &str) -> Option<&str> {
    line.strip_prefix("test ")?.strip_suffix(" ... FAILED")
}

fn docs(tally: &mut Tally) {
    let mut command = cargo(&["doc", "--workspace", "--no-deps"]);
    command.env("RUSTDOCFLAGS", "-D warnings");
    tally.check("docs of the workspace", child::visibly(&mut command));
    for folder in TESTED {
        let mut command = cargo_in(folder, &["doc", "--quiet", "--no-deps"]);
        command.env("RUSTDOCFLAGS", "-D warnings");
        let name = format!("docs of targets/{folder}");
        tally.check(&name, child::visibly(&mut command));
    }
    pages(tally);
}

/// The Markdown pages, which take no building.
pub fn pages(tally: &mut Tally) {
    tally.check("the gallery is current", gallery::is_current());
    tally.check("the pages' pictures are current", pictures::are_current());
    tally.check("links of the pages", links::check());
}

fn firmware_lints(tally: &mut Tally) {
    let scene = scene::bake(scene::SMALL);
    let Some(scene) = tally.need("firmware lints", scene) else {
        return;
    };
    let mut boards: Vec<&Board> = Vec::new();
    for board in board::all() {
        // The Cortex-M7 has the M4's firmware.
        let firmware = |board: &Board| (board.folder, board.target, board.features);
        if !boards
            .iter()
            .any(|known| firmware(known) == firmware(board))
        {
            boards.push(board);
        }
    }
    parallel::check(tally, &boards, |board, tally| {
        let name = format!("lints of targets/{} for {}", board.folder, board.name);
        tally.check(&name, firmware::clippy(board, &scene));
    });
    for device in &DEVICES {
        let name = format!("lints of targets/{} for {}", device.folder, device.name);
        tally.check(&name, firmware::clippy_device(device, &scene));
    }
}

/// Instruction counts are only worth something when they are exact.
fn counter(tally: &mut Tally) {
    let boards: Vec<&'static Board> = BOARDS.iter().collect();
    parallel::check(tally, &boards, |board, tally| {
        let name = format!("instruction counter of {}", board.name);
        let target = Target::Board(board);
        let loops = target.prepare().and_then(|ready| ready.counter_self_test());
        if let Some(loops) = tally.check(&name, loops) {
            eprintln!("      {loops} loops of known length, each exact");
        }
    });
}

fn footprint_stage(tally: &mut Tally) {
    let result = footprint::checks_can_fail();
    tally.check("a faulty firmware is found out", result);
    footprint::of_others(tally);
    let result = footprint::run(tally);
    tally.need("footprint", result);
}

/// Scenes that are played on the Game Boy Advance: one that turns, one whose palette
/// moves.
const PLAYED: [&str; 2] = ["teapot", "palette_cycle"];

/// The panel of the Game Boy Advance shows what this machine draws, and its keys turn
/// the object.
fn gba_stage(tally: &mut Tally) {
    let board = match board::find("gba") {
        Ok(board) => board,
        Err(error) => {
            tally.check::<()>("the board gba", Err(error.into()));
            return;
        }
    };
    for scene in PLAYED {
        let baked = scene::bake(scene);
        let rom = picture::build(board, scene);
        let ready = baked.and_then(|baked| Ok((baked, rom?)));
        let Some((baked, rom)) = tally.need(&format!("{scene} on {}", board.name), ready) else {
            continue;
        };
        let shown = gba::play(&rom, 2, ("none", 1));
        let result = shown.and_then(|shown| gba::check(&baked, &shown));
        tally.check(
            &format!("the panel of {} shows {scene}", board.name),
            result,
        );
        let shown = gba::play(&rom, 5, ("right", 3));
        let result = shown.and_then(|shown| gba::check_turned(&baked, &shown));
        tally.check(&format!("keys of {} turn {scene}", board.name), result);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn result_lines_are_summed() {
        let mut counts = Counts::default();
        counts.take("test result: ok. 6 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s");
        counts.take("test result: FAILED. 1 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s");
        counts.take("running 6 tests");
        let expected = Counts {
            passed: 7,
            failed: 2,
            ignored: 1,
        };
        assert_eq!(counts, expected);
    }

    #[test]
    fn failures_have_names() {
        assert_eq!(failed_test("test a::b ... FAILED"), Some("a::b"));
        assert_eq!(failed_test("test a::b ... ok"), None);
    }
}
