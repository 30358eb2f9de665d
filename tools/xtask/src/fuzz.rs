//! Fuzzers by libFuzzer, on the nightly toolchain: what they run is in
//! `tests/support/fuzz`. Built with the flags of `cargo fuzz` (coverage counters, traced
//! comparisons, address sanitizer), without the program itself.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::problem::{Problem, Result};
use crate::report::{self, Tally};
use crate::{child, debian, parallel, paths, scene};

/// One of the fuzzers.
struct Fuzzer {
    name: &'static str,
    /// Longest input in bytes.
    longest: u32,
    /// Executions in continuous integration: 10 to 70 seconds of them on two processors that have more to do.
    executions: u32,
}

const fn fuzzer(name: &'static str, longest: u32, executions: u32) -> Fuzzer {
    Fuzzer {
        name,
        longest,
        executions,
    }
}

const FUZZERS: [Fuzzer; 8] = [
    fuzzer("scene", 1024, 200),
    fuzzer("blob", 16 << 10, 120_000),
    fuzzer("calls", 512, 15_000),
    fuzzer("arithmetic", 256, 400_000),
    fuzzer("panels", 512, 200_000),
    fuzzer("text", 4096, 20_000),
    fuzzer("mesh", 8192, 4_000),
    fuzzer("picture", 4096, 50_000),
];

const HOST: &str = "x86_64-unknown-linux-gnu";

/// As `cargo fuzz` has them.
const FLAGS: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
    -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares \
    -Zsanitizer=address -Ccodegen-units=1 --cfg fuzzing";

/// Scenes whose blobs the blobs' fuzzer starts from: small ones, of every kind.
const SEEDS: [&str; 5] = ["small", "moving", "lines", "panes", "rays"];

/// The fuzzers' names.
pub fn names() -> Vec<&'static str> {
    FUZZERS.iter().map(|fuzzer| fuzzer.name).collect()
}

/// Time after which continuous integration gives a fuzzer up: many times what it takes.
const STAGE_LIMIT: Duration = Duration::from_secs(900);

/// How long fuzzers run, and from where.
enum Course {
    /// So many seconds, from another beginning each time.
    Seconds(u32),
    /// As many executions as each has in continuous integration, from the same beginning each
    /// time: how far it comes does not hang on how fast the machine is.
    Executions,
}

impl Course {
    /// As libFuzzer takes it.
    fn arguments(&self, fuzzer: &Fuzzer) -> Vec<String> {
        match self {
            Self::Seconds(seconds) => vec![format!("-max_total_time={seconds}")],
            // Its own folder is not read again, which it does by the clock.
            Self::Executions => vec![
                "-seed=1".into(),
                format!("-runs={}", fuzzer.executions),
                "-reload=0".into(),
            ],
        }
    }

    fn limit(&self) -> Duration {
        match self {
            Self::Seconds(seconds) => Duration::from_secs(u64::from(*seconds) * 2 + 120),
            Self::Executions => STAGE_LIMIT,
        }
    }

    fn said(&self, fuzzer: &Fuzzer) -> String {
        match self {
            Self::Seconds(seconds) => format!("fuzzer {}, {seconds} s", fuzzer.name),
            Self::Executions => format!("fuzzer {}, {} executions", fuzzer.name, fuzzer.executions),
        }
    }
}

/// Runs the fuzzers named, all if none is, for so many seconds each. Each one that finds
/// nothing is a check; what is found stays in `fuzz/artifacts`.
pub fn run(tally: &mut Tally, only: &[String], seconds: u32) -> Result<Value> {
    let corpora = folder().join("corpus");
    all(tally, only, &Course::Seconds(seconds), &corpora)
}

/// What continuous integration runs: all of them for a moment, the same each time.
pub fn stage(tally: &mut Tally) {
    let begun = paths::work("fuzz").and_then(|corpora| {
        // What an earlier run kept is no part of the beginning.
        fs::remove_dir_all(&corpora).map_err(|error| format!("{}: {error}", corpora.display()))?;
        Ok(corpora)
    });
    let result = begun.and_then(|corpora| all(tally, &[], &Course::Executions, &corpora));
    if let Some(figures) = tally.need("fuzzers", result) {
        eprint!("{}", markdown(&figures));
    }
}

/// A folder for each fuzzer's inputs is in `corpora`.
fn all(tally: &mut Tally, only: &[String], course: &Course, corpora: &Path) -> Result<Value> {
    build()?;
    let named = |name: &str| only.is_empty() || only.iter().any(|wanted| wanted == name);
    let all = FUZZERS.iter();
    let chosen: Vec<_> = all.filter(|fuzzer| named(fuzzer.name)).collect();
    let results = parallel::map(&chosen, |fuzzer| fuzz(fuzzer, course, corpora));
    let mut figures = serde_json::Map::new();
    for (fuzzer, result) in chosen.into_iter().zip(results) {
        if let Some(figure) = tally.check(&course.said(fuzzer), result) {
            figures.insert(fuzzer.name.to_owned(), figure);
        }
    }
    Ok(Value::Object(figures))
}

/// The figures as a table.
pub fn markdown(value: &Value) -> String {
    let head = [
        "fuzzer",
        "seconds",
        "executions",
        "branches covered",
        "of",
        "inputs kept",
    ];
    let all = value.as_object().into_iter().flatten();
    let rows = all.map(|(name, of)| {
        let cell = |key: &str| of[key].to_string();
        vec![
            name.clone(),
            cell("seconds"),
            cell("executions"),
            cell("coverage"),
            cell("branches"),
            cell("corpus"),
        ]
    });
    report::table(&head, &rows.collect::<Vec<_>>())
}

fn folder() -> PathBuf {
    paths::root().join("fuzz")
}

/// Builds all of them.
fn build() -> Result<()> {
    let nightly = child::output(Command::new("rustc").args(["+nightly", "--version"]));
    let Some(version) = nightly else {
        return Err(Problem::Missing(
            "no nightly toolchain: `rustup toolchain install nightly` would bring it".into(),
        ));
    };
    eprintln!("fuzzers: {}", version.trim());
    cxx()?;
    let mut command = Command::new("cargo");
    child::without_outer_cargo(&mut command);
    command
        .args([
            "+nightly",
            "build",
            "--quiet",
            "--release",
            "--target",
            HOST,
        ])
        .arg("--manifest-path")
        .arg(folder().join("Cargo.toml"))
        .env("CARGO_TARGET_DIR", target())
        .env("RUSTFLAGS", FLAGS);
    child::visibly(&mut command)
}

/// A C++ compiler, for libFuzzer itself.
fn cxx() -> Result<()> {
    if debian::which("c++").is_none() && debian::can_install() {
        debian::install(&["g++"])?;
    }
    if debian::which("c++").is_none() {
        let missing = "no C++ compiler: `apt-get install g++` or its like would bring it";
        return Err(Problem::Missing(missing.into()));
    }
    Ok(())
}

fn target() -> PathBuf {
    match std::env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => Path::new(&folder).join("fuzz"),
        None => folder().join("target"),
    }
}

fn fuzz(fuzzer: &Fuzzer, course: &Course, corpora: &Path) -> Result<Value> {
    let name = fuzzer.name;
    let (corpus, begin) = (corpora.join(name), corpora.join("begin").join(name));
    let artifacts = folder().join("artifacts").join(name);
    for folder in [&corpus, &begin, &artifacts] {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut first = Vec::new();
    for (seed, bytes) in seeds(name)? {
        let to = begin.join(seed);
        fs::write(&to, bytes).map_err(|error| format!("{}: {error}", to.display()))?;
        first.push(to);
    }
    first.extend(found(name)?);
    let mut command = at_fixed_addresses(&target().join(HOST).join("release").join(name));
    command
        .arg(&corpus)
        .args(course.arguments(fuzzer))
        .arg(format!("-artifact_prefix={}/", artifacts.display()))
        .arg(format!("-max_len={}", fuzzer.longest))
        // Which thread was first shall not show in what is covered.
        .env("RAYON_NUM_THREADS", "1")
        .args(["-print_final_stats=1", "-timeout=20", "-rss_limit_mb=4096"]);
    if !first.is_empty() {
        // By name: a folder's files come in an order that is each file system's own.
        let first: Vec<_> = first.iter().map(|path| path.to_string_lossy()).collect();
        command.arg(format!("-seed_inputs={}", first.join(",")));
    }
    let began = Instant::now();
    let run = child::bounded(&mut command, course.limit())?;
    let seconds = began.elapsed().as_secs();
    if !run.success {
        return Err(format!(
            "found something, in {}; `cargo test -p fixel-tests --test fuzzed` runs it once it is \
             in tests/data/fuzz/{name}:\n{}",
            artifacts.display(),
            broken(&run.stderr)
        )
        .into());
    }
    let figures = Figures::of(&run.stderr);
    Ok(json!({
        "seconds": seconds,
        "executions": figures.executions,
        "coverage": figures.coverage,
        "branches": figures.branches,
        "corpus": figures.corpus,
    }))
}

/// A program whose addresses are the same in each run, where the system lets it be: libFuzzer
/// keys what it remembers of comparisons by them.
fn at_fixed_addresses(program: &Path) -> Command {
    let mut command = Command::new("setarch");
    if child::output(command.args(["-R", "true"])).is_none() {
        return Command::new(program);
    }
    let mut command = Command::new("setarch");
    command.arg("-R").arg(program);
    command
}

/// What it once found, in order.
fn found(name: &str) -> Result<Vec<PathBuf>> {
    let folder = paths::root().join("tests/data/fuzz").join(name);
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let entries =
        fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    files.sort();
    Ok(files)
}

/// What a fuzzer starts from: small files of every kind.
fn seeds(name: &str) -> Result<Vec<(String, Vec<u8>)>> {
    let root = paths::root();
    let read = |file: &str| {
        let path = root.join(file);
        fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let mut seeds = Vec::new();
    match name {
        "blob" => {
            for seed in SEEDS {
                let file = root.join(format!("tests/data/{seed}.toml"));
                seeds.push((seed.to_owned(), scene::blob(&file, seed == "rays")?));
            }
        }
        "text" => {
            for seed in SEEDS {
                seeds.push((seed.to_owned(), read(&format!("tests/data/{seed}.toml"))?));
            }
        }
        "mesh" => {
            // The first byte says which kind it is.
            for (kind, folder, file) in [
                (0, "scenes/meshes", "cube.obj"),
                (1, "scenes/meshes", "house.gltf"),
                (4, "scenes/meshes", "ring_coloured.ply"),
                (5, "tests/data", "post.mtl"),
            ] {
                let bytes = read(&format!("{folder}/{file}"))?;
                seeds.push((file.to_owned(), [&[kind], bytes.as_slice()].concat()));
            }
        }
        "picture" => seeds.push(("checker".to_owned(), read("scenes/textures/checker.png")?)),
        _ => {}
    }
    Ok(seeds)
}

/// What broke: from the panic's message on, and the end of what the fuzzer says.
fn broken(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let panic = lines.iter().position(|line| line.contains("panicked at"));
    let message = panic.map_or(&[][..], |at| &lines[at..lines.len().min(at + 4)]);
    let end = &lines[lines.len().saturating_sub(30)..];
    [message, &["..."], end].concat().join("\n")
}

/// What libFuzzer says of a run.
#[derive(Debug, Default, PartialEq, Eq)]
struct Figures {
    executions: u64,
    coverage: u64,
    /// Branches that there are, in the fuzzer and all that it links.
    branches: u64,
    corpus: u64,
}

impl Figures {
    /// From `INFO: Loaded 1 modules (8000 inline 8-bit counters): ...`, from
    /// `#512 NEW cov: 93 ft: 101 corp: 7/2044b ...`, the last such line, and
    /// `stat::number_of_executed_units: 1024`.
    fn of(text: &str) -> Self {
        let mut figures = Self::default();
        for line in text.lines() {
            if let Some(count) = line.strip_prefix("stat::number_of_executed_units:") {
                figures.executions = count.trim().parse().unwrap_or(0);
            }
            let after = |key: &str| {
                let rest = line.split_once(key)?.1.trim_start();
                let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
                digits.parse().ok()
            };
            if line.contains("inline 8-bit counters)") {
                figures.branches = after("(").unwrap_or(0);
            }
            if line.starts_with('#') {
                figures.coverage = after("cov:").unwrap_or(figures.coverage);
                figures.corpus = after("corp:").unwrap_or(figures.corpus);
            }
        }
        figures
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_figures_count() {
        let text = "INFO: Loaded 1 modules   (8000 inline 8-bit counters): 8000 [0x1, 0x2),\n\
            #2\tINITED cov: 10 ft: 11 corp: 1/1b exec/s: 0 rss: 40Mb\n\
            #512\tNEW    cov: 93 ft: 101 corp: 7/2044b lim: 4\n\
            stat::number_of_executed_units: 1024\n";
        let wanted = Figures {
            executions: 1024,
            coverage: 93,
            branches: 8000,
            corpus: 7,
        };
        assert_eq!(Figures::of(text), wanted);
    }

    #[test]
    fn what_broke_is_said() {
        let text = format!(
            "a\nthread panicked at x.rs:1\nwhy\n{}end",
            "frame\n".repeat(50)
        );
        let said = broken(&text);
        assert!(said.starts_with("thread panicked at x.rs:1\nwhy\n") && said.ends_with("end"));
        assert_eq!(broken("end"), "...\nend");
    }
}
