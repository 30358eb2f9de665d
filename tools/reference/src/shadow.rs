//! Where a frame and the truth disagree about shadows.

use crate::frame::Frame;
use crate::truth::Truth;

/// A light's part times the cosine of its angle: differences up to this change no
/// colour by a step of 255.
const SEEN: f64 = 1.0 / 255.0;

/// Pixels that touch, at sides or corners, and are at least so many, are no chance.
const CLUSTER: usize = 4;

/// Pixels in which some light does not get to the same surface as it should: neither
/// at a terminator, where the light gives nothing, nor by less than can be seen.
pub(crate) fn mismatches(truth: &Truth, frame: &Frame, same: &[bool]) -> Vec<bool> {
    let Some(traced) = truth.traced.as_ref().filter(|_| !frame.lit.is_empty()) else {
        return vec![false; same.len()];
    };
    let differs = |i: usize| {
        let mut lights = traced.reaches[i].iter().take(8).enumerate();
        lights.any(|(light, reach)| {
            let lit = frame.lit[i] >> light & 1 == 1;
            let part = if reach.part > 0.0 { reach.part } else { 1.0 };
            lit != (reach.part > 0.0) && part * reach.cosine > SEEN
        })
    };
    let all = same.iter().enumerate();
    all.map(|(i, same)| *same && differs(i)).collect()
}

/// How many pixels get some light in the truth.
pub(crate) fn lit_px(truth: &Truth) -> usize {
    let traced = truth.traced.iter();
    let pixels = traced.flat_map(|traced| &traced.reaches);
    pixels
        .filter(|reaches| reaches.iter().any(|r| r.part > 0.0))
        .count()
}

/// How many groups of pixels there are that touch and are not few.
pub(crate) fn clusters(mismatches: &[bool], width: usize) -> usize {
    let mut left = mismatches.to_vec();
    let mut count = 0;
    for start in 0..left.len() {
        let (mut stack, mut size) = (vec![start], 0);
        while let Some(i) = stack.pop() {
            if !std::mem::take(&mut left[i]) {
                continue;
            }
            size += 1;
            let (x, y) = (i % width, i / width);
            for row in y.saturating_sub(1)..=(y + 1).min(left.len() / width - 1) {
                for column in x.saturating_sub(1)..=(x + 1).min(width - 1) {
                    stack.push(row * width + column);
                }
            }
        }
        count += usize::from(size >= CLUSTER);
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_that_touch_are_a_cluster() {
        let map = |text: &str| text.bytes().map(|b| b == b'#').collect::<Vec<_>>();
        // A diagonal of four; three in a row; four that do not touch over the edge.
        assert_eq!(
            clusters(&map("#.... .#... ..#.. ...#.".replace(' ', "").as_str()), 5),
            1
        );
        assert_eq!(
            clusters(&map("###.. ..... ..... .....".replace(' ', "").as_str()), 5),
            0
        );
        assert_eq!(
            clusters(&map("...## ##... ..... ...##".replace(' ', "").as_str()), 5),
            0
        );
        assert_eq!(
            clusters(&map("##..# ##..# ....# ....#".replace(' ', "").as_str()), 5),
            2
        );
    }
}
