//! The same bytes on every target, in one band and in many.

use serde_json::{Map, Value, json};

use crate::measure::{Frame, ONE_BAND, Ready, Target};
use crate::problem::Result;
use crate::report::Tally;
use crate::{parallel, scene};

/// Frames that are compared: enough of a turn to see every side.
const FRAMES: std::ops::Range<u32> = 0..12;
/// The same on an emulated board.
const BOARD_FRAMES: std::ops::Range<u32> = 0..6;
/// The same by rays, which take long.
const RAY_FRAMES: std::ops::Range<u32> = 0..1;
/// The same in bands of other heights on an emulated board. That bands do not
/// show is a property of the code, which the host looks for in all frames; an
/// emulator is slow.
const FEW_FRAMES: std::ops::Range<u32> = 0..2;
/// Band heights that are compared: the usual one, one that divides nothing,
/// and the full frame.
const BANDS: [u32; 3] = [16, 7, ONE_BAND];

/// Which frames of a scene are compared on a target in bands of so many rows.
fn frames(scene: &str, target: Target, rows: u32) -> std::ops::Range<u32> {
    if scene::by_rays(scene) {
        return RAY_FRAMES;
    }
    match target {
        Target::Host(_) => FRAMES,
        Target::Board(board) if board.scenes.is_none() && rows == BANDS[0] => BOARD_FRAMES,
        Target::Board(_) => FEW_FRAMES,
    }
}

/// Renders the scenes named, or else all, on the targets. Each pair of scene and
/// target is one check; gives `{"scene": {"target": "hash"}}`.
pub fn run(tally: &mut Tally, targets: Vec<Target>, names: &[String]) -> Result<Value> {
    let ready: Vec<Ready> = targets
        .into_iter()
        .filter_map(|target| {
            let name = format!("parity on {}", target.name());
            tally.need(&name, target.prepare())
        })
        .collect();
    let mut all = Map::new();
    for name in scene::named_or_all(names)? {
        let Some(baked) = tally.need(&format!("parity of {name}"), scene::bake(&name)) else {
            continue;
        };
        let taking: Vec<&Ready> = ready
            .iter()
            .filter(|ready| ready.target.takes(&scene::name(name.as_ref())))
            .collect();
        let jobs: Vec<(&Ready, u32)> = taking
            .iter()
            .flat_map(|ready| BANDS.map(|rows| (*ready, rows)))
            .collect();
        let runs = parallel::map(&jobs, |&(ready, rows)| {
            let which = frames(&name, ready.target, rows);
            let frames = ready.frames(&baked, which, rows, None)?;
            Ok((rows, frames))
        });
        let mut hashes = Map::new();
        let mut first: Option<Vec<Frame>> = None;
        for (target, runs) in taking.iter().zip(runs.chunks(BANDS.len())) {
            let target = target.target.name();
            let runs: Result<Vec<_>> = runs.iter().cloned().collect();
            let hash = runs.and_then(|runs| agree(&runs, &mut first));
            if let Some(hash) = tally.check(&format!("parity of {name} on {target}"), hash) {
                hashes.insert(target.into(), json!(hash));
            } else {
                hashes.insert(target.into(), json!("differs"));
            }
        }
        all.insert(name, hashes.into());
    }
    Ok(all.into())
}

/// Whether all runs drew the frames that the first run of all did; gives the
/// hash of those that every target draws.
fn agree(runs: &[(u32, Vec<Frame>)], first: &mut Option<Vec<Frame>>) -> Result<String> {
    for (rows, frames) in runs {
        let expected = first.get_or_insert_with(|| frames.clone());
        for (frame, expected) in frames.iter().zip(expected.iter()) {
            let parts = [
                ("palette indices", &frame.index, &expected.index),
                ("depths", &frame.depth, &expected.depth),
                ("RGB565 bytes", &frame.panel, &expected.panel),
            ];
            for (what, hash, expected) in parts {
                if hash != expected {
                    return Err(format!(
                        "frame {} in bands of {rows} rows differs in its {what}: {hash}, not {expected}",
                        frame.frame
                    )
                    .into());
                }
            }
        }
    }
    let frames = runs.first().map(|(_, frames)| frames.as_slice());
    let few = frames.unwrap_or_default().iter().take(FEW_FRAMES.len());
    Ok(combined(few))
}

/// One hash of all frames' hashes: FNV-1a, 64 bits.
fn combined<'a>(frames: impl IntoIterator<Item = &'a Frame>) -> String {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for frame in frames {
        for part in [&frame.index, &frame.depth, &frame.panel] {
            for byte in part.bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
    }
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(depth: &str) -> Frame {
        Frame {
            frame: 2,
            width: 320,
            height: 240,
            covered: 0,
            count: 0,
            index: "0".into(),
            depth: depth.into(),
            panel: "0".into(),
        }
    }

    #[test]
    fn one_different_depth_is_found() {
        let mut first = None;
        let same = [(16, vec![frame("1")]), (240, vec![frame("1")])];
        let hash = agree(&same, &mut first).ok();
        assert_eq!(hash, Some(combined(&[frame("1")])));
        assert!(agree(&[(16, vec![frame("2")])], &mut first).is_err());
    }

    #[test]
    fn the_hash_sees_every_part() {
        assert_ne!(combined(&[frame("1")]), combined(&[frame("2")]));
    }
}
