//! Wall time on this machine, beside other renderers': `tools/hostbench` draws the bench's
//! scenes through all of them in one process.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use serde_json::Value;

use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{child, paths, scene};

/// A run that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(600);
/// The one that the others are held against.
const OURS: &str = "fixel";

/// Who draws less than this part of our pixels does not draw the scene.
const LEAST_DRAWN: f64 = 0.95;

/// The crate's manifest.
pub fn manifest() -> PathBuf {
    paths::root().join("tools/hostbench/Cargo.toml")
}

/// Builds it and runs it. Gives `{"scene": {"renderer": {"wall_us": x, "covered_px": n}}}`;
/// pictures of what each drew go to a folder.
pub fn run(tally: &mut Tally, pictures: Option<&Path>) -> Result<Value> {
    let folder = paths::root().join("tools/hostbench/target");
    let mut command = Command::new("cargo");
    child::without_outer_cargo(&mut command);
    command
        .args(["build", "--quiet", "--release"])
        .arg("--manifest-path")
        .arg(manifest())
        .arg("--target-dir")
        .arg(&folder)
        .current_dir(paths::root());
    child::visibly(&mut command)?;
    let name = format!("fixel-hostbench{}", std::env::consts::EXE_SUFFIX);
    let mut command = Command::new(folder.join("release").join(name));
    command.args(scene::BENCH.map(scene::file));
    if let Some(pictures) = pictures {
        command.arg("--pictures").arg(pictures);
    }
    let finished = child::bounded(&mut command, LIMIT)?;
    if !finished.success {
        return Err(finished.stderr.trim().into());
    }
    let figures: Value =
        serde_json::from_str(&finished.stdout).map_err(|error| error.to_string())?;
    for name in scene::BENCH {
        let drawn = figures[name][OURS]["covered_px"].as_u64();
        let result = drawn.filter(|px| *px > 0).ok_or("nothing was drawn".into());
        tally.check(&format!("{name} side by side"), result);
    }
    Ok(figures)
}

/// A row a scene: microseconds a frame, and how many times as long as ours.
pub fn markdown(figures: &Value) -> String {
    let renderers: Vec<String> = scene::BENCH
        .iter()
        .find_map(|name| figures[*name].as_object())
        .map(|all| all.keys().cloned().collect())
        .unwrap_or_default();
    let rows: Vec<Vec<String>> = scene::BENCH
        .iter()
        .map(|name| {
            let figures = &figures[*name];
            let wall = |renderer: &str| figures[renderer]["wall_us"].as_f64();
            let mut cells = vec![(*name).to_owned()];
            let drawn = |renderer: &str| figures[renderer]["covered_px"].as_f64();
            cells.extend(renderers.iter().map(|renderer| {
                let (Some(theirs), Some(ours)) = (wall(renderer), wall(OURS)) else {
                    return "-".into();
                };
                let part = drawn(renderer).unwrap_or(0.0) / drawn(OURS).unwrap_or(1.0);
                match renderer.as_str() {
                    OURS => format!("{ours:.0}"),
                    _ if part < LEAST_DRAWN => format!("draws {:.0} %", 100.0 * part),
                    _ => format!("{theirs:.0} ({:.1})", theirs / ours),
                }
            }));
            cells
        })
        .collect();
    let head: Vec<&str> = std::iter::once("scene")
        .chain(renderers.iter().map(String::as_str))
        .collect();
    format!(
        "Microseconds a frame on this machine, one thread, up to RGB565 bytes; in brackets how \
         many times fixel's (none where less than the scene is drawn); mean of frames 2 to 11, of each the fastest of 60 rounds; `cargo \
         xtask bench --host`.\n\n{}",
        table(&head, &rows)
    )
}
