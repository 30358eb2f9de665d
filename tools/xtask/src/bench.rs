//! Instructions a frame, on every target.

use serde_json::{Map, Value, json};

use crate::measure::{Frame, ONE_BAND, Ready, Target};
use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{parallel, peers, scene};

/// The frames that the figures are means of: 2 to 11, as the peers'.
const FRAMES: std::ops::Range<u32> = 2..12;
/// Rows in a band of `instructions_bands16`.
const BAND_ROWS: u32 = 16;
/// Passes on the host, of which the fastest counts, frame by frame.
const HOST_PASSES: usize = 5;

/// What one scene takes on one target.
#[derive(Clone, Copy, Debug)]
struct Figures {
    one_band: u64,
    bands16: u64,
    covered_px: u64,
}

/// Renders the scenes named, or else every bench scene, on every target; gives
/// `{"scene": {"target": {"instructions": n, ...}}}`.
pub fn run(tally: &mut Tally, names: &[String]) -> Result<Value> {
    let ready: Vec<Ready> = Target::measured()
        .into_iter()
        .filter_map(|target| tally.need(&format!("bench on {}", target.name()), target.prepare()))
        .collect();
    let mut all = Map::new();
    let names = if names.is_empty() {
        scene::bench().map(str::to_owned).collect()
    } else {
        names.to_vec()
    };
    for name in &names {
        let Some(baked) = tally.need(&format!("bench of {name}"), scene::bake(name)) else {
            continue;
        };
        // Time on the host is only worth something with nothing else running.
        let (host, boards): (Vec<_>, Vec<_>) = ready
            .iter()
            .partition(|ready| matches!(ready.target, Target::Host(_)));
        let boards_done = parallel::map(&boards, |ready| figures(ready, &baked, 1));
        let host_done = host.iter().map(|ready| figures(ready, &baked, HOST_PASSES));
        let done = boards_done.into_iter().chain(host_done);
        let mut targets = Map::new();
        for (ready, figures) in boards.iter().chain(&host).zip(done) {
            let target = ready.target.name();
            let figures = tally.check(&format!("bench of {name} on {target}"), figures);
            let Some(figures) = figures else { continue };
            let value = match ready.target {
                Target::Host(_) => json!({
                    "wall_us": figures.one_band as f64 / 1000.0,
                    "wall_us_bands16": figures.bands16 as f64 / 1000.0,
                    "covered_px": figures.covered_px,
                }),
                Target::Board(_) => json!({
                    "instructions": figures.one_band,
                    "instructions_bands16": figures.bands16,
                    "covered_px": figures.covered_px,
                }),
            };
            targets.insert(target.into(), value);
        }
        all.insert(name.clone(), targets.into());
    }
    Ok(all.into())
}

fn figures(ready: &Ready, baked: &scene::Baked, passes: usize) -> Result<Figures> {
    let mut best = [None, None];
    for _ in 0..passes {
        for (best, rows) in best.iter_mut().zip([ONE_BAND, BAND_ROWS]) {
            let frames = ready.frames(baked, FRAMES, rows, None)?;
            *best = Some(match best.take() {
                Some(before) => faster(before, frames),
                None => frames,
            });
        }
    }
    let [one_band, bands16] = best.map(Option::unwrap_or_default);
    Ok(Figures {
        one_band: mean(&one_band, |frame| frame.count),
        bands16: mean(&bands16, |frame| frame.count),
        covered_px: mean(&one_band, |frame| frame.covered),
    })
}

/// Of two passes over the same frames, each frame's lower count.
fn faster(mut before: Vec<Frame>, now: Vec<Frame>) -> Vec<Frame> {
    for (before, now) in before.iter_mut().zip(now) {
        before.count = before.count.min(now.count);
    }
    before
}

/// Rounded to the nearest integer.
fn mean(frames: &[Frame], value: impl Fn(&Frame) -> u64) -> u64 {
    let count = frames.len().max(1) as u64;
    (frames.iter().map(value).sum::<u64>() + count / 2) / count
}

/// The README's table: millions of instructions a frame, and the peers'.
pub fn markdown(figures: &Value) -> String {
    let millions = |scene: &str, target: &str, field: &str| {
        let count = figures[scene][target][field].as_u64();
        count.map_or("-".into(), |count| format!("{:.2}", count as f64 / 1e6))
    };
    let rows: Vec<Vec<String>> = scene::bench()
        .map(|name| {
            let peer = peers::find(name);
            let covered = Target::measured()
                .iter()
                .find_map(|target| figures[name][target.name()]["covered_px"].as_u64());
            let what = peer.map_or(name, |peer| peer.what);
            let mut row = vec![
                what.to_owned(),
                covered.map_or("-".into(), |covered| covered.to_string()),
            ];
            for target in ["cortex-m4f", "cortex-m0plus", "riscv32imc"] {
                row.push(millions(name, target, "instructions"));
                row.push(millions(name, target, "instructions_bands16"));
            }
            row.push(peer.map_or(String::new(), |peer| peer.drawn_px.to_string()));
            row.push(peer.map_or(String::new(), |peer| peer.cortex_m4f.into()));
            row.push(peer.map_or(String::new(), |peer| peer.cortex_m0plus.into()));
            row
        })
        .collect();
    let head = [
        "scene",
        "covered px",
        "M4F",
        "M4F, 16 rows",
        "M0+",
        "M0+, 16 rows",
        "riscv32imc",
        "riscv32imc, 16 rows",
        "px drawn by peers",
        "best peer, M4F",
        "best peer, M0+",
    ];
    format!(
        "Millions of instructions (not cycles) a frame, 320x240 unless the name says otherwise, \
         RGB565 bytes out, clearing included; mean of frames 2 to 11; `cargo xtask bench --markdown`.\n\n{}",
        table(&head, &rows)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(count: u64) -> Frame {
        Frame {
            frame: 0,
            width: 0,
            height: 0,
            covered: 0,
            count,
            index: String::new(),
            depth: String::new(),
            panel: String::new(),
        }
    }

    #[test]
    fn means_are_rounded() {
        assert_eq!(mean(&[frame(1), frame(2)], |frame| frame.count), 2);
        assert_eq!(mean(&[], |frame| frame.count), 0);
    }

    #[test]
    fn the_fastest_pass_counts() {
        let best = faster(vec![frame(5), frame(2)], vec![frame(3), frame(4)]);
        assert_eq!(mean(&best, |frame| frame.count), 3);
    }
}
