//! Instructions that are accepted: a committed file, which continuous integration holds
//! fresh counts against.

use std::fs;
use std::path::PathBuf;

use serde_json::{Map, Value, json};

use crate::measure::{self, ONE_BAND};
use crate::problem::{Problem, Result};
use crate::report::Tally;
use crate::{board, parallel, paths, scene, toolchain};

/// Boards that are held to it.
const BOARDS: [&str; 3] = ["cortex-m4f", "cortex-m0plus", "riscv32imc"];
/// Bands that are.
const BANDS: [(&str, u32); 2] = [("instructions", ONE_BAND), ("instructions_bands16", 16)];
/// The frame that is counted.
const FRAME: u32 = 4;
/// How much more than accepted fails; how much less is worth accepting.
const MOST_PERCENT: f64 = 3.0;
/// Makes the counts of today the accepted ones.
const ACCEPT: &str = "cargo xtask bench --accept";

fn file() -> PathBuf {
    paths::root().join("tests/bench/instructions.json")
}

/// A count: scene, board, figure, instructions.
type Count = (&'static str, &'static str, &'static str, Result<u64>);

/// Counts every row, and holds it to what is accepted.
pub fn check(tally: &mut Tally) {
    let accepted = read().and_then(|all| {
        let compiler = compiler()?;
        let ours = all.get(&compiler).cloned();
        ours.ok_or_else(|| {
            let known: Vec<&str> = all.keys().map(String::as_str).collect();
            Problem::Missing(format!(
                "there are some of {}; {compiler}, which makes other code, has none: \
                 `{ACCEPT}` makes them",
                known.join(" and ")
            ))
        })
    });
    let Some(accepted) = tally.need("accepted counts", accepted) else {
        return;
    };
    let mut gained = Vec::new();
    for (scene, board, figure, count) in counts(tally) {
        let row = format!("{figure} of {scene} on {board}");
        let before = accepted[scene][board][figure].as_u64();
        let held = count.and_then(|count| hold(before, count));
        if let Some(percent) = tally.check(&row, held)
            && percent < -MOST_PERCENT
        {
            gained.push(format!("{row} ({percent:+.1} %)"));
        }
    }
    if !gained.is_empty() {
        eprintln!(
            "      fewer than accepted, so that a later loss of it would pass: {}; \
             `{ACCEPT}` keeps the gain",
            gained.join(", ")
        );
    }
}

/// By how many percent more it is, unless that is too much.
fn hold(accepted: Option<u64>, count: u64) -> Result<f64> {
    let Some(accepted) = accepted else {
        return Err(format!("{count}, and no count is accepted; `{ACCEPT}` takes it").into());
    };
    let percent = 100.0 * (count as f64 - accepted as f64) / accepted.max(1) as f64;
    if percent > MOST_PERCENT {
        return Err(format!(
            "{count} instructions, {accepted} are accepted: {percent:+.1} %; \
             `{ACCEPT}` accepts it knowingly"
        )
        .into());
    }
    Ok(percent)
}

/// What is accepted, by compiler.
fn read() -> Result<Map<String, Value>> {
    let text = fs::read_to_string(file()).map_err(|error| error.to_string());
    let all = text.and_then(|text| serde_json::from_str(&text).map_err(|e| e.to_string()));
    Ok(all.map_err(|error| format!("{}: {error}", file().display()))?)
}

/// Writes the counts of today into the file, beside those of other compilers.
pub fn accept(tally: &mut Tally) -> Result<Value> {
    let mut scenes = Map::new();
    for (scene, board, figure, count) in counts(tally) {
        let boards = scenes.entry(scene).or_insert_with(|| json!({}));
        boards[board][figure] = count?.into();
    }
    let mut all = read()?;
    all.insert(compiler()?, scenes.into());
    let value = Value::from(all);
    let text = serde_json::to_string_pretty(&value).map_err(|error| error.to_string())?;
    fixel_output::write(&file(), (text + "\n").as_bytes())?;
    eprintln!("wrote {}", file().display());
    Ok(value)
}

/// The compiler of the firmware, its version alone: commits and dates are those of whoever
/// packs it.
fn compiler() -> Result<String> {
    let route = toolchain::provide(board::find(BOARDS[0])?.target)?;
    let version = route.version();
    Ok(version.split(" (").next().unwrap_or_default().to_owned())
}

/// Every row.
fn counts(tally: &mut Tally) -> Vec<Count> {
    let ready = measure::boards(&BOARDS, "counts", tally);
    let mut rows = Vec::new();
    for name in scene::bench() {
        let Some(baked) = tally.need(&format!("counts of {name}"), scene::bake(name)) else {
            continue;
        };
        for ready in &ready {
            rows.extend(BANDS.map(|band| (name, baked.clone(), ready, band)));
        }
    }
    parallel::map(&rows, |(name, baked, ready, (figure, rows))| {
        let frames = ready.frames(baked, FRAME..FRAME + 1, *rows, None);
        let count = frames.map(|frames| frames.iter().map(|frame| frame.count).sum());
        (*name, ready.target.name(), *figure, count)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loss_is_found() {
        assert!(hold(Some(1000), 1030).is_ok_and(|percent| (percent - 3.0).abs() < 1e-9));
        assert!(hold(Some(1000), 1031).is_err());
        assert!(hold(Some(1000), 500).is_ok_and(|percent| percent < -MOST_PERCENT));
        assert!(hold(None, 1).is_err());
    }
}
