//! Palette entries along lines of colours.

use fixel_scene::Rgb;

use super::to_bytes;
use crate::oklab::{Lab, distance2, from_rgb, to_rgb};

/// A line of colours, as fine as levels are.
pub(super) struct Ramp {
    colours: Vec<Rgb>,
    /// Length in Oklab from the start to each colour.
    along: Vec<f64>,
}

impl Ramp {
    pub(super) fn new(colours: Vec<Rgb>) -> Self {
        let lab: Vec<Lab> = colours.iter().map(|c| from_rgb(*c)).collect();
        let mut sum = 0.0;
        let mut along = vec![0.0];
        for pair in lab.windows(2) {
            sum += distance2(pair[0], pair[1]).sqrt();
            along.push(sum);
        }
        Self { colours, along }
    }

    fn length(&self) -> f64 {
        self.along.last().copied().unwrap_or(0.0)
    }

    /// `count` colours, evenly spaced, both ends among them if there are two.
    fn spread(&self, count: usize) -> Vec<[u8; 3]> {
        let last = self.colours.len() - 1;
        (0..count)
            .map(|i| {
                let part = if count > 1 {
                    i as f64 / (count - 1) as f64
                } else {
                    0.5
                };
                let target = part * self.length();
                let at = self.along.partition_point(|a| *a < target).min(last);
                let before = at.saturating_sub(1);
                let step = self.along[at] - self.along[before];
                let way = if step > 0.0 {
                    (target - self.along[before]) / step
                } else {
                    1.0
                };
                let (a, b) = (self.colours[before], self.colours[at]);
                to_bytes([0, 1, 2].map(|c| a[c] + (b[c] - a[c]) * way))
            })
            .collect()
    }
}

/// At most `wanted` different colours from all ramps, at least 2, in proportion to
/// the ramps' lengths, evenly along each.
pub(super) fn deal(ramps: &[Ramp], wanted: usize) -> Vec<[u8; 3]> {
    let total: f64 = ramps.iter().map(Ramp::length).sum();
    // Ramps often share colours or have fewer than their share: the density is
    // raised as long as the palette stays within bounds.
    let at_density = |density: f64| {
        let mut palette: Vec<[u8; 3]> = Vec::new();
        for ramp in ramps {
            let count = 1 + (ramp.length() * density) as usize;
            for colour in ramp.spread(count) {
                if !palette.contains(&colour) {
                    palette.push(colour);
                }
            }
        }
        palette
    };
    let (mut low, mut high) = (0.0, 8.0 * wanted as f64 / total.max(1e-6));
    let mut best = at_density(0.0);
    for _ in 0..24 {
        let middle = (low + high) / 2.0;
        let palette = at_density(middle);
        if palette.len() <= wanted {
            low = middle;
            if palette.len() >= best.len() || best.len() > wanted {
                best = palette;
            }
        } else {
            high = middle;
        }
    }
    best.truncate(wanted);
    while best.len() < 2 {
        best.push([255, 255, 255]);
    }
    best
}

/// The entries that a scene file asks for, in its order.
pub(super) fn asked_for(ramps: &[fixel_scene::Ramp]) -> Vec<[u8; 3]> {
    let entries = |ramp: &fixel_scene::Ramp| {
        let (from, to) = (from_rgb(ramp.from), from_rgb(ramp.to));
        let last = ramp.steps.saturating_sub(1).max(1);
        let entry = move |step| {
            let part = f64::from(step) / f64::from(last);
            to_bytes(to_rgb(
                [0, 1, 2].map(|i| from[i] + (to[i] - from[i]) * part),
            ))
        };
        (0..ramp.steps).map(entry).collect::<Vec<_>>()
    };
    ramps.iter().flat_map(entries).collect()
}
