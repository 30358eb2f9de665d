//! The same flight again and again: no byte may change when the camera returns to its
//! start, however often.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::firmware::HostProfile;
use crate::measure::{Frame, Ready, Target};
use crate::problem::Result;
use crate::report::{self, Tally};
use crate::{board, paths, scene};

/// Frames after which the scene's camera and actors are where they were.
const ROUND: u32 = 250;
/// Frames of one run of a program: several rounds, since its memory goes on from frame to
/// frame.
const CHUNK: u32 = 5_000;
/// Bands that do not divide the picture.
const ROWS: u32 = 7;
/// The board that flies as well.
const BOARD: &str = "cortex-m4f";

/// Draws so many frames on the host and on a board; each target is a check.
pub fn run(tally: &mut Tally, on_host: u32, on_board: u32) -> Result<Value> {
    let file = paths::root().join("scenes/soak/flight.toml");
    let baked = scene::bake(&file.to_string_lossy())?;
    let mut figures = serde_json::Map::new();
    let board = board::find(BOARD)?;
    let targets = [
        (Target::Host(HostProfile::Release), on_host),
        (Target::Board(board), on_board),
    ];
    let mut round: Option<Vec<Frame>> = None;
    for (target, frames) in targets {
        if frames == 0 {
            continue;
        }
        let name = target.name();
        let Some(ready) = tally.need(&format!("soak on {name}"), target.prepare()) else {
            continue;
        };
        let start = Instant::now();
        let flown = fly(&ready, &baked, frames, &mut round);
        if tally
            .check(&format!("{frames} frames on {name}"), flown)
            .is_some()
        {
            let seconds = start.elapsed().as_secs_f64().round();
            figures.insert(name.into(), json!({"frames": frames, "seconds": seconds}));
        }
    }
    Ok(figures.into())
}

/// The figures as a table.
pub fn markdown(value: &Value) -> String {
    let all = value.as_object().into_iter().flatten();
    let rows = all.map(|(name, of)| {
        vec![
            name.clone(),
            of["frames"].to_string(),
            of["seconds"].to_string(),
        ]
    });
    report::table(&["target", "frames", "seconds"], &rows.collect::<Vec<_>>())
}

fn fly(
    ready: &Ready,
    baked: &scene::Baked,
    frames: u32,
    round: &mut Option<Vec<Frame>>,
) -> Result<()> {
    const A_MINUTE: Duration = Duration::from_secs(60);
    let mut told = Instant::now();
    for first in (0..frames).step_by(CHUNK as usize) {
        let chunk = first..(first + CHUNK).min(frames);
        let drawn = ready.frames(baked, chunk, ROWS, None)?;
        let round =
            round.get_or_insert_with(|| drawn.iter().take(ROUND as usize).cloned().collect());
        for frame in &drawn {
            let expected = &round[(frame.frame % ROUND) as usize % round.len()];
            same(frame, expected)?;
        }
        if told.elapsed() > A_MINUTE {
            eprintln!("  {first} of {frames} frames");
            told = Instant::now();
        }
    }
    Ok(())
}

fn same(frame: &Frame, expected: &Frame) -> Result<()> {
    let parts = |of: &Frame| [of.index.clone(), of.depth.clone(), of.panel.clone()];
    if parts(frame) != parts(expected) {
        return Err(format!(
            "frame {} is not what frame {} was",
            frame.frame, expected.frame
        )
        .into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_byte_is_found() {
        let frame = |number, depth: &str| Frame {
            frame: number,
            width: 64,
            height: 48,
            covered: 9,
            count: 1,
            index: "a".into(),
            depth: depth.into(),
            panel: "c".into(),
        };
        assert!(same(&frame(250, "b"), &frame(0, "b")).is_ok());
        assert!(same(&frame(250, "x"), &frame(0, "b")).is_err());
    }
}
