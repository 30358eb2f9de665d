//! The same bytes on every target, in one band and in many, within a bounded stack.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use crate::measure::{Drawn, Frame, ONE_BAND, Ready, Target};
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

/// Most bytes of stack of the measuring program on any target, whatever the scene: it links
/// everything, and its own frames count, so that it takes more than a demo.
const STACK_LIMIT: u64 = 16 * 1024;

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
/// target is one check, and so is the deepest stack of each target that is painted; gives
/// `{"scene": {"target": "hash"}}`.
pub fn run(tally: &mut Tally, targets: Vec<Target>, names: &[String]) -> Result<Value> {
    let ready = parallel::check(tally, &targets, |target, tally| {
        let name = format!("parity on {}", target.name());
        tally.need(&name, target.prepare())
    });
    let ready: Vec<Ready> = ready.into_iter().flatten().collect();
    let mut all = Map::new();
    let mut stacks = Stacks::default();
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
            let drawn = ready.drawn(&baked, which, rows, None)?;
            Ok((rows, drawn))
        });
        let mut hashes = Map::new();
        let mut first: Option<Vec<Frame>> = None;
        for (target, runs) in taking.iter().zip(runs.chunks(BANDS.len())) {
            let target = target.target.name();
            let runs: Result<Vec<_>> = runs.iter().cloned().collect();
            stacks.take(target, &name, runs.iter().flatten().map(|(_, drawn)| drawn));
            let hash = runs.and_then(|runs| agree(&runs, &mut first));
            if let Some(hash) = tally.check(&format!("parity of {name} on {target}"), hash) {
                hashes.insert(target.into(), json!(hash));
            } else {
                hashes.insert(target.into(), json!("differs"));
            }
        }
        all.insert(name, hashes.into());
    }
    for (target, deepest) in &stacks.0 {
        let result = within(deepest);
        tally.check(
            &format!(
                "stack on {target}, at most {} bytes, of {}",
                deepest.bytes, deepest.scene
            ),
            result,
        );
    }
    Ok(all.into())
}

/// The deepest stack of each target that paints it.
#[derive(Default)]
struct Stacks(BTreeMap<&'static str, Deepest>);

struct Deepest {
    bytes: u64,
    scene: String,
}

impl Stacks {
    fn take<'a>(
        &mut self,
        target: &'static str,
        scene: &str,
        runs: impl Iterator<Item = &'a Drawn>,
    ) {
        let Some(bytes) = runs.filter_map(|drawn| drawn.stack).max() else {
            return;
        };
        let deepest = self.0.get(target).map_or(0, |deepest| deepest.bytes);
        if bytes > deepest {
            let scene = scene::name(scene.as_ref());
            self.0.insert(target, Deepest { bytes, scene });
        }
    }
}

fn within(deepest: &Deepest) -> Result<()> {
    if deepest.bytes <= STACK_LIMIT {
        return Ok(());
    }
    let scene = &deepest.scene;
    Err(format!("{scene} takes more than the {STACK_LIMIT} bytes promised").into())
}

/// Whether all runs drew the frames that the first run of all did; gives the
/// hash of those that every target draws.
fn agree(runs: &[(u32, Drawn)], first: &mut Option<Vec<Frame>>) -> Result<String> {
    for (rows, Drawn { frames, .. }) in runs {
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
    let frames = runs.first().map(|(_, drawn)| drawn.frames.as_slice());
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

    fn drawn(depth: &str, stack: u64) -> Drawn {
        Drawn {
            frames: vec![frame(depth)],
            stack: Some(stack),
        }
    }

    #[test]
    fn the_deepest_stack_counts() {
        let mut stacks = Stacks::default();
        let runs = [drawn("1", 7), drawn("1", 17_000), drawn("1", 8)];
        stacks.take("a", "scenes/x.toml", runs[..1].iter());
        assert!(within(&stacks.0["a"]).is_ok());
        stacks.take("a", "scenes/y.toml", runs[1..].iter());
        stacks.take("a", "scenes/z.toml", runs[..1].iter());
        assert!(within(&stacks.0["a"]).is_err());
        let Deepest { bytes, scene } = &stacks.0["a"];
        assert_eq!((*bytes, scene.as_str()), (17_000, "y"));
    }

    #[test]
    fn one_different_depth_is_found() {
        let mut first = None;
        let same = [(16, drawn("1", 7)), (240, drawn("1", 8))];
        let hash = agree(&same, &mut first).ok();
        assert_eq!(hash, Some(combined(&[frame("1")])));
        assert!(agree(&[(16, drawn("2", 7))], &mut first).is_err());
    }

    #[test]
    fn the_hash_sees_every_part() {
        assert_ne!(combined(&[frame("1")]), combined(&[frame("2")]));
    }
}
