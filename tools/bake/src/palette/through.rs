//! Colours that are seen through blended surfaces. In: samples of all surfaces in a
//! picture. Out: those of opaque ones as they are, and those of blended ones mixed with
//! what is behind them.
//!
//! The picture is cut into cells. What lies in the same cell is taken to lie behind each
//! other: so no ray is cast, and samples of two panes' edges mix too.

use std::collections::BTreeMap;

use fixel_scene::Rgb;

use super::choose::Sample;

/// Columns and rows of cells.
const CELLS: usize = 40;
/// Colours that are carried from layer to layer of a cell, at most.
const CARRIED: usize = 16;
/// Colours of a layer in a cell that are mixed with those, at most.
const MIXED: usize = 4;

/// A small part of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub sample: Sample,
    /// Where it is in the picture, 0..1 each.
    pub place: Option<[f64; 2]>,
    /// Along the line of sight.
    pub distance: f64,
    /// Whose it is: pieces of one layer are beside each other.
    pub layer: usize,
    /// How much it hides; 1 if it is not blended.
    pub opacity: f64,
}

/// The colours that are seen. `background`: from the top of the picture to its bottom.
pub(super) fn seen(pieces: Vec<Piece>, background: &[Rgb]) -> Vec<Sample> {
    let opaque = pieces.iter().filter(|piece| piece.opacity >= 1.0);
    let mut samples: Vec<Sample> = opaque.map(|piece| piece.sample).collect();
    if samples.len() == pieces.len() {
        return samples;
    }
    let mut cells: BTreeMap<[usize; 2], Vec<Piece>> = BTreeMap::new();
    for piece in pieces {
        if let Some(place) = piece.place {
            let [column, row] = place.map(|c| (c * CELLS as f64) as usize);
            cells.entry([column, row]).or_default().push(piece);
        }
    }
    for ([_, row], pieces) in cells {
        let at = (row as f64 + 0.5) / CELLS as f64 * background.len() as f64;
        through(&pieces, background[at as usize], &mut samples);
    }
    samples
}

/// Appends what is seen through the layers of a cell, far ones first.
fn through(pieces: &[Piece], background: Rgb, samples: &mut Vec<Sample>) {
    let mut layers: BTreeMap<usize, Vec<Piece>> = BTreeMap::new();
    let mut behind = vec![background];
    for piece in pieces {
        if piece.opacity < 1.0 {
            layers.entry(piece.layer).or_default().push(*piece);
        } else {
            behind.push(piece.sample.colour);
        }
    }
    let distance = |layer: &Vec<Piece>| {
        let sum: f64 = layer.iter().map(|piece| piece.distance).sum();
        sum / layer.len() as f64
    };
    let mut layers: Vec<Vec<Piece>> = layers.into_values().collect();
    layers.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
    for layer in layers {
        let weight: f64 = layer.iter().map(|piece| piece.sample.weight).sum();
        let behind_it = thinned(&behind, CARRIED);
        let mixed = thinned(&layer, MIXED).into_iter();
        let mixed = mixed.flat_map(|piece| behind_it.iter().map(move |other| mix(&piece, other)));
        behind = mixed.collect();
        let weight = weight / behind.len() as f64;
        samples.extend(behind.iter().map(|&colour| Sample { colour, weight }));
    }
}

fn mix(piece: &Piece, behind: &Rgb) -> Rgb {
    let (own, opacity) = (piece.sample.colour, piece.opacity);
    [0, 1, 2].map(|c| own[c] * opacity + behind[c] * (1.0 - opacity))
}

/// Some of them, evenly spread.
fn thinned<T: Copy>(all: &[T], most: usize) -> Vec<T> {
    let count = all.len().min(most);
    (0..count).map(|i| all[i * all.len() / count]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(layer: usize, colour: Rgb, distance: f64, opacity: f64) -> Piece {
        let weight = 0.5;
        Piece {
            sample: Sample { colour, weight },
            place: Some([0.5, 0.5]),
            distance,
            layer,
            opacity,
        }
    }

    /// A near and a far pane before a wall, in any order: what is seen is among the
    /// samples, the panes' own colours are not.
    #[test]
    fn panes_show_what_is_behind_them() {
        let wall = piece(2, [0.0, 0.0, 1.0], 9.0, 1.0);
        let far = piece(1, [0.0, 1.0, 0.0], 8.0, 0.5);
        let near = piece(0, [1.0, 0.0, 0.0], 7.0, 0.5);
        for pieces in [vec![near, far, wall], vec![wall, far, near]] {
            let samples = seen(pieces, &[[1.0; 3]]);
            let colours: Vec<Rgb> = samples.iter().map(|s| s.colour).collect();
            for wanted in [[0.0, 0.0, 1.0], [0.0, 0.5, 0.5], [0.5, 0.25, 0.25]] {
                assert!(colours.contains(&wanted), "{wanted:?} in {colours:?}");
            }
            assert!(!colours.contains(&[1.0, 0.0, 0.0]), "{colours:?}");
        }
    }
}
