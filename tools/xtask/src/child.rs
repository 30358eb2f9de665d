//! Child processes: their output is visible, their time is bounded, and the
//! environment of the cargo that started us does not leak into another one.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::problem::Result;

/// Variables that cargo sets for the program that it runs.
const PACKAGE: [&str; 4] = [
    "CARGO",
    "CARGO_BIN_NAME",
    "CARGO_CRATE_NAME",
    "CARGO_PRIMARY_PACKAGE",
];
const PACKAGE_PREFIXES: [&str; 2] = ["CARGO_MANIFEST_", "CARGO_PKG_"];
/// Variables that a person sets for host builds.
const HOST: [&str; 6] = [
    "CARGO_ENCODED_RUSTFLAGS",
    "OUT_DIR",
    "RUSTC",
    "RUSTC_WORKSPACE_WRAPPER",
    "RUSTC_WRAPPER",
    "RUSTFLAGS",
];
const HOST_PREFIXES: [&str; 3] = ["CARGO_BUILD_", "CARGO_PROFILE_", "CARGO_TARGET_"];

fn is_package(name: &str) -> bool {
    let mut prefixes = PACKAGE_PREFIXES.iter();
    PACKAGE.contains(&name) || prefixes.any(|prefix| name.starts_with(prefix))
}

fn is_host(name: &str) -> bool {
    let mut prefixes = HOST_PREFIXES.iter();
    HOST.contains(&name) || prefixes.any(|prefix| name.starts_with(prefix))
}

/// Takes away what the outer cargo says about this program's own package.
pub fn without_outer_package(command: &mut Command) {
    remove(command, is_package);
}

/// Takes that away, and what is set for host builds: for builds of `targets/`.
pub fn without_outer_cargo(command: &mut Command) {
    remove(command, |name| is_package(name) || is_host(name));
}

fn remove(command: &mut Command, unwanted: impl Fn(&str) -> bool) {
    for (name, _) in std::env::vars_os() {
        if name.to_str().is_some_and(&unwanted) {
            command.env_remove(name);
        }
    }
}

/// The command as a person would type it.
pub fn shown(command: &Command) -> String {
    let mut text = command.get_program().to_string_lossy().into_owned();
    for argument in command.get_args() {
        text.push(' ');
        text.push_str(&argument.to_string_lossy());
    }
    text
}

/// Runs a command with all its output on our standard error; fails if it does.
pub fn visibly(command: &mut Command) -> Result<()> {
    let status = command
        .stdin(Stdio::null())
        .stdout(std::io::stderr())
        .status();
    check(command, status)
}

/// Runs a command with its output on our standard error, and hands every line
/// of its standard output to `line` as well. Gives its success.
pub fn tee(command: &mut Command, mut line: impl FnMut(&str)) -> Result<bool> {
    let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn();
    let mut child = child.map_err(|error| format!("{}: {error}", shown(command)))?;
    if let Some(stdout) = child.stdout.take() {
        for text in BufReader::new(stdout).lines().map_while(|line| line.ok()) {
            let _ = writeln!(std::io::stderr(), "{text}");
            line(&text);
        }
    }
    let status = child.wait();
    let status = status.map_err(|error| format!("{}: {error}", shown(command)))?;
    Ok(status.success())
}

/// Runs a command silently; gives its standard output if it succeeds.
pub fn output(command: &mut Command) -> Option<String> {
    let output = command.stdin(Stdio::null()).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then_some(text)
}

/// What a bounded run gave.
#[derive(Debug)]
pub struct Finished {
    /// Whether it succeeded.
    pub success: bool,
    /// Its standard output.
    pub stdout: String,
    /// Its standard error.
    pub stderr: String,
}

/// Runs a command and takes its output; ends it when `limit` has passed.
pub fn bounded(command: &mut Command, limit: Duration) -> Result<Finished> {
    let child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut child = child.map_err(|error| format!("{}: {error}", shown(command)))?;
    let stdout = child.stdout.take().map(collect);
    let stderr = child.stderr.take().map(collect);
    let status = wait(&mut child, limit);
    let text = |reader: Option<thread::JoinHandle<String>>| {
        reader
            .and_then(|reader| reader.join().ok())
            .unwrap_or_default()
    };
    let (stdout, stderr) = (text(stdout), text(stderr));
    match status {
        Some(status) => Ok(Finished {
            success: status.success(),
            stdout,
            stderr,
        }),
        None => Err(format!(
            "{} did not end within {} s; its output so far: {stdout}{stderr}",
            shown(command),
            limit.as_secs()
        )
        .into()),
    }
}

fn collect(mut stream: impl Read + Send + 'static) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// Waits for a child; ends it and gives nothing when `limit` has passed.
fn wait(child: &mut Child, limit: Duration) -> Option<ExitStatus> {
    let end = Instant::now() + limit;
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Some(status),
            Ok(None) if Instant::now() < end => thread::sleep(Duration::from_millis(5)),
            _ => {
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
        }
    }
}

fn check(command: &Command, status: std::io::Result<ExitStatus>) -> Result<()> {
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{} failed ({status})", shown(command)).into()),
        Err(error) => Err(format!("{}: {error}", shown(command)).into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_leaks_from_an_outer_cargo() {
        assert!(is_package("CARGO_PKG_NAME") && is_package("CARGO"));
        assert!(is_host("RUSTFLAGS") && is_host("CARGO_TARGET_DIR"));
        for name in ["CARGO_HOME", "CARGO_NET_OFFLINE", "PATH", "RUSTUP_HOME"] {
            assert!(!is_package(name) && !is_host(name), "{name}");
        }
    }

    #[test]
    fn a_child_that_hangs_is_ended() {
        let mut command = Command::new("sleep");
        command.arg("60");
        let start = Instant::now();
        assert!(bounded(&mut command, Duration::from_millis(50)).is_err());
        assert!(start.elapsed() < Duration::from_secs(10));
    }
}
