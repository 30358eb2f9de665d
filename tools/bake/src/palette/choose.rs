//! A few colours that stand for many: k-means in Oklab.
//!
//! Own code, not the `quantette` crate: its k-means draws random samples of equal
//! weight, cannot leave entries in place, and computes in `f32` with whatever the
//! host's vector unit gives, while a baked scene is to be the same file everywhere.

use std::collections::BTreeMap;

use fixel_scene::Rgb;

use super::{to_bytes, to_unit};
use crate::oklab::{Lab, distance2, from_rgb, to_rgb};

/// A colour that is seen, and how much of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    pub colour: Rgb,
    pub weight: f64,
}

/// Rounds of moving entries to the middle of what they stand for.
const ROUNDS: usize = 12;

/// Different colours are told apart to 8 bits a channel, or to as many fewer as leave
/// at most so many.
const MOST_BINS: usize = 16384;

/// Samples that are the same to some bits a channel, as one.
struct Bin {
    lab: Lab,
    weight: f64,
}

/// `fixed`, and after it entries for what it does not stand for: at most `most` in
/// all, at least 2, no chosen one twice.
///
/// A colour's weight is the square root of how much there is of it: a highlight of a
/// few pixels is seen as well as a wall.
pub(crate) fn choose(samples: &[Sample], fixed: &[[u8; 3]], most: usize) -> Vec<[u8; 3]> {
    let bins = bins(samples);
    let mut entries: Vec<Lab> = fixed.iter().map(|c| from_rgb(to_unit(*c))).collect();
    let kept = entries.len();
    seed(&bins, &mut entries, most);
    for _ in 0..ROUNDS {
        settle(&bins, &mut entries, kept);
    }
    let mut palette = fixed.to_vec();
    for entry in &entries[kept..] {
        let colour = to_bytes(to_rgb(*entry));
        if !palette.contains(&colour) {
            palette.push(colour);
        }
    }
    while palette.len() < 2 {
        palette.push([255, 255, 255]);
    }
    palette
}

fn bins(samples: &[Sample]) -> Vec<Bin> {
    let mut bins = Vec::new();
    for lost in 0..8 {
        bins = bins_of(samples, lost);
        if bins.len() <= MOST_BINS {
            break;
        }
    }
    bins
}

/// `lost` bits of 8 are not looked at.
fn bins_of(samples: &[Sample], lost: u32) -> Vec<Bin> {
    let mut sums: BTreeMap<[u8; 3], (Lab, f64)> = BTreeMap::new();
    for sample in samples.iter().filter(|sample| sample.weight > 0.0) {
        let lab = from_rgb(sample.colour);
        let key = to_bytes(sample.colour).map(|channel| channel >> lost);
        let (sum, weight) = sums.entry(key).or_default();
        *sum = [0, 1, 2].map(|i| sum[i] + lab[i] * sample.weight);
        *weight += sample.weight;
    }
    let bin = |(sum, weight): (Lab, f64)| Bin {
        lab: sum.map(|channel| channel / weight),
        weight: weight.sqrt(),
    };
    sums.into_values().map(bin).collect()
}

/// Adds entries, each where most is lost so far, as long as anything is.
fn seed(bins: &[Bin], entries: &mut Vec<Lab>, most: usize) {
    let mut loss = vec![f64::INFINITY; bins.len()];
    let lower = |loss: &mut Vec<f64>, entry: &Lab| {
        for (loss, bin) in loss.iter_mut().zip(bins) {
            *loss = loss.min(distance2(bin.lab, *entry) * bin.weight);
        }
    };
    for entry in entries.iter() {
        lower(&mut loss, entry);
    }
    while entries.len() < most {
        let worst = (0..bins.len()).max_by(|a, b| loss[*a].total_cmp(&loss[*b]));
        let Some(worst) = worst.filter(|worst| loss[*worst] > 0.0) else {
            return;
        };
        entries.push(bins[worst].lab);
        lower(&mut loss, &bins[worst].lab);
    }
}

/// Moves each entry from number `kept` on to the middle of the bins that are
/// nearest to it.
fn settle(bins: &[Bin], entries: &mut [Lab], kept: usize) {
    let mut sums = vec![([0.0; 3], 0.0); entries.len()];
    for bin in bins {
        let distance = |i: &usize| distance2(entries[*i], bin.lab);
        let nearest = (0..entries.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        if let Some((sum, weight)) = nearest.map(|i| &mut sums[i]) {
            *sum = [0, 1, 2].map(|i| sum[i] + bin.lab[i] * bin.weight);
            *weight += bin.weight;
        }
    }
    for (entry, (sum, weight)) in entries.iter_mut().zip(sums).skip(kept) {
        if weight > 0.0 {
            *entry = sum.map(|channel| channel / weight);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(colour: [u8; 3], weight: f64) -> Sample {
        let colour = to_unit(colour);
        Sample { colour, weight }
    }

    /// The greatest squared distance from a sample to its entry.
    fn worst(samples: &[Sample], palette: &[[u8; 3]]) -> f64 {
        let lab: Vec<Lab> = palette.iter().map(|c| from_rgb(to_unit(*c))).collect();
        let loss = |sample: &Sample| {
            let own = from_rgb(sample.colour);
            lab.iter()
                .map(|entry| distance2(*entry, own))
                .fold(f64::INFINITY, f64::min)
        };
        samples.iter().map(loss).fold(0.0, f64::max)
    }

    #[test]
    fn few_colours_are_kept_as_they_are() {
        let colours = [[255, 0, 0], [0, 255, 0], [3, 2, 1], [200, 100, 50]];
        let samples: Vec<_> = colours.iter().map(|c| sample(*c, 0.1)).collect();
        let mut palette = choose(&samples, &[], 16);
        palette.sort();
        let mut wanted = colours;
        wanted.sort();
        assert_eq!(palette, wanted);
    }

    #[test]
    fn what_is_fixed_stays_and_is_made_use_of() {
        let fixed = [[0, 0, 255], [255, 0, 0], [0, 0, 255]];
        let samples = [sample([255, 0, 0], 1.0), sample([0, 255, 0], 1.0)];
        let palette = choose(&samples, &fixed, 8);
        assert_eq!(palette, [fixed[0], fixed[1], fixed[2], [0, 255, 0]]);
        assert_eq!(choose(&samples, &fixed, 3), fixed);
        assert_eq!(choose(&[], &[], 8).len(), 2);
    }

    #[test]
    fn a_rare_colour_gets_an_entry_too() {
        let ramp = (0..=255).map(|v| sample([v, v / 2, 0], 1.0));
        let samples: Vec<_> = ramp.chain([sample([0, 80, 255], 0.01)]).collect();
        for most in [16, 64] {
            let palette = choose(&samples, &[], most);
            assert_eq!(palette.len(), most);
            assert!(palette.contains(&[0, 80, 255]), "{palette:?}");
        }
    }

    #[test]
    fn more_entries_lose_less() {
        // A cube of colours.
        let level = |i: u8| [0, 85, 170, 255][usize::from(i)];
        let samples: Vec<_> = (0..64)
            .map(|i| sample([level(i >> 4), level(i >> 2 & 3), level(i & 3)], 1.0))
            .collect();
        let losses = [2, 4, 8, 16, 32, 63].map(|most| {
            let palette = choose(&samples, &[], most);
            assert_eq!(palette.len(), most);
            worst(&samples, &palette)
        });
        assert!(losses.is_sorted_by(|a, b| a > b), "{losses:?}");
        assert!(worst(&samples, &choose(&samples, &[], 64)) < 1e-5);
    }
}
