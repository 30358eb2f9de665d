//! From a colour to its palette entry.

use fixel_scene::Rgb;

use super::to_unit;
use crate::oklab::{Lab, distance2, from_rgb};

/// Colours that the look-up of what goes by colour tells apart.
pub(super) const COLOURS: usize = 1 << 12;

/// The index of the palette entry that is nearest in Oklab.
#[derive(Debug)]
pub(super) struct Nearest(Vec<Lab>);

impl Nearest {
    pub(super) fn new(palette: &[[u8; 3]]) -> Self {
        Self(palette.iter().map(|c| from_rgb(to_unit(*c))).collect())
    }

    pub(super) fn index(&self, colour: Rgb) -> u8 {
        let target = from_rgb(colour);
        let distance = |i: &usize| distance2(self.0[*i], target);
        (0..self.0.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0) as u8
    }
}

/// The index of each colour of 4 bits a channel, red in the highest bits, blue in
/// the lowest; 15 is full.
pub(super) fn lookup(nearest: &Nearest) -> Vec<u8> {
    let colour = |i: usize| [8, 4, 0].map(|shift| (i >> shift & 15) as f64 / 15.0);
    (0..COLOURS).map(|i| nearest.index(colour(i))).collect()
}
