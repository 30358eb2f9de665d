//! Files are whole or not there, whatever happens.

#![cfg(unix)]

mod common;

use common::*;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const BUNNY: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenes/bench/w3_bunny_gouraud.toml"
);
const CUBE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");

/// Runs `fixel` in a shell's hands.
fn shell(folder: &Folder, script: &str) -> Run {
    let mut command = Command::new("sh");
    command
        .current_dir(folder.path(""))
        .env("FIXEL", env!("CARGO_BIN_EXE_fixel"))
        .args(["-c", script]);
    Run::of(&mut command)
}

#[test]
fn a_full_disk_is_told_and_leaves_nothing() {
    let folder = Folder::new();
    folder.write("old.png", "old");
    let before = folder.names();
    // Files of 512 bytes at most are all that there is room for.
    let room = "trap '' XFSZ; ulimit -f 1; exec \"$FIXEL\"";
    for words in [
        format!("render {CUBE} -o new.png"),
        format!("render {CUBE} -o old.png"),
        format!("bake {CUBE} -o cube.fxl"),
        format!("compare {CUBE} --report ."),
        format!("animate {CUBE} --frames 2 -o cube.gif"),
    ] {
        let line = shell(&folder, &format!("{room} {words}")).fails();
        assert!(line.starts_with("fixel: cannot write "), "{line}");
        assert_eq!(folder.names(), before, "{words}");
    }
    assert_eq!(std::fs::read(folder.path("old.png")).unwrap(), b"old");
    if Path::new("/dev/full").exists() {
        let line = folder.fixel("render scene.toml -o /dev/full").fails();
        assert!(line.contains("cannot write /dev/full"), "{line}");
        let run = shell(
            &folder,
            "exec \"$FIXEL\" render scene.toml --stats - > /dev/full",
        );
        assert!(run.fails().contains("standard output"));
        folder.fixel("info --help").ok();
    }
}

/// Ctrl-C, or an end without warning, at any moment: what is there under the final name is
/// the old file or the new.
#[test]
fn an_interrupted_command_leaves_no_half_file() {
    for signal in [2, 9] {
        interrupted_by(signal);
    }
}

/// Neither the scene nor what it names, whatever the command.
#[test]
fn what_is_read_is_not_written_over() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder")).unwrap();
    let before = folder.names();
    for words in [
        "bake scene.toml -o scene.toml",
        "bake scene.toml -o square.obj",
        "bake square.obj -o folder/../square.obj",
        "render scene.toml -o scene.toml",
        "render scene.toml -o a.png --depth-out square.obj",
        "render scene.toml -o a.png --stats scene.toml",
        "compare scene.toml --json scene.toml",
        "estimate scene.toml --board microbit --json square.obj",
    ] {
        let line = folder.fixel(words).fails();
        assert!(line.contains("is what the output would replace"), "{line}");
    }
    assert_eq!(folder.names(), before);
    folder.fixel("render scene.toml -o a.png").ok();
    folder.fixel("render scene.toml -o a.png").ok();
}

fn interrupted_by(signal: i32) {
    let folder = Folder::new();
    // Long enough that a signal comes in time on a slow machine, too: some 500 ms.
    for (words, out) in [
        (format!("animate {CUBE} --frames 400 -o out.gif"), "out.gif"),
        (format!("bake {BUNNY} -o out.fxl"), "out.fxl"),
    ] {
        interrupted(&folder, &words, out, signal);
    }
}

/// A part of a time, another each time.
fn some_of(time: Duration) -> Duration {
    let random = RandomState::new().build_hasher().finish();
    time.mul_f64(random as f64 / u64::MAX as f64)
}

fn interrupted(folder: &Folder, words: &str, out: &str, signal: i32) {
    let begun = Instant::now();
    folder.fixel(words).ok();
    let mut took = begun.elapsed();
    let whole = std::fs::read(folder.path(out)).unwrap();
    let mut interrupted = 0;
    for _ in 0..10 {
        let delay = some_of(took);
        folder.write(out, "old");
        let mut child = Command::new(env!("CARGO_BIN_EXE_fixel"))
            .current_dir(folder.path(""))
            .args(words.split_whitespace())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(delay);
        // It may be done already.
        let _ = Command::new("kill")
            .args([format!("-{signal}"), child.id().to_string()])
            .status();
        let status = child.wait().unwrap();
        let found = std::fs::read(folder.path(out)).unwrap();
        if status.success() {
            assert!(found == whole, "{words}: after {delay:?}");
            // It takes less than it did the first time.
            took = took * 3 / 4;
        } else {
            assert_eq!(status.signal(), Some(signal));
            interrupted += 1;
            assert!(
                found == whole || found == b"old",
                "{words}: after {delay:?}"
            );
        }
    }
    assert!(interrupted > 0, "every run was done before a signal came");
}

/// Neither a half-written file nor the temporary one.
#[test]
fn who_is_interrupted_leaves_whole_files_alone() {
    use std::time::Duration;
    let folder = Folder::new();
    for try_number in 0..12 {
        let film = format!("film{try_number}");
        let mut running = Command::new(env!("CARGO_BIN_EXE_fixel"))
            .args(["animate", "scene.toml", "--frames", "100000", "-o", &film])
            .current_dir(folder.path(""))
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begun = Instant::now();
        let first = folder.path(&film).join("frame_00000.png");
        while !first.exists() {
            assert!(begun.elapsed() < Duration::from_secs(60), "no frame");
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(try_number));
        let pid = running.id().to_string();
        assert!(
            Command::new("kill")
                .args(["-INT", &pid])
                .status()
                .unwrap()
                .success()
        );
        assert_eq!(running.wait().unwrap().signal(), Some(2));
        for entry in std::fs::read_dir(folder.path(&film)).unwrap() {
            let path = entry.unwrap().path();
            assert_eq!(path.extension(), Some("png".as_ref()), "{}", path.display());
            read_png(path);
        }
    }
}
