//! Pictures of where a frame differs from the truth: 8 bits a channel, by
//! rows from the top left, as large as the frame.

use crate::compare::{Pixel, light_difference};
use crate::frame::{Frame, FrameError};
use crate::report::MismatchKind;
use crate::shadow;
use crate::truth::Truth;

/// Background in both, or pixels that the map does not judge.
const NEUTRAL: [u8; 3] = [24, 24, 28];
/// The same surface in both.
const AGREE: [u8; 3] = [70, 70, 76];
/// Equally near surfaces.
const TIE: [u8; 3] = [60, 90, 160];
/// A surface in the truth only.
const MISSING: [u8; 3] = [255, 60, 40];
/// A surface in the frame only.
const EXTRA: [u8; 3] = [255, 0, 255];
/// Another triangle.
const VISIBLE: [u8; 3] = [255, 210, 0];

/// Where a map of depth is white.
pub const DEPTH_FULL: f64 = 4.0;
/// Where a map of light is white.
pub const LEVEL_FULL: f64 = 8.0;
/// Where a map of colour is white.
pub const COLOUR_FULL: f64 = 32.0;

/// The maps of a comparison.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HeatMaps {
    /// Which surface is seen: grey where the same, blue at ties in depth, red
    /// where the frame lacks a surface, magenta where it has one too many,
    /// yellow where it shows another triangle.
    pub coverage: Vec<[u8; 3]>,
    /// Depth difference on agreeing pixels, 0..=4 units from black over red
    /// and yellow to white.
    pub depth: Vec<[u8; 3]>,
    /// Light difference on agreeing pixels, 0..=8 of 255: of the level, or of the
    /// worst channel, as in [`crate::Report::level_max`].
    pub level: Vec<[u8; 3]>,
    /// Greatest difference of a colour channel against the unquantised truth,
    /// everywhere, 0..=32 of 255.
    pub colour: Vec<[u8; 3]>,
    /// Shadows on agreeing pixels: the more lights get there the lighter, red where one
    /// does not that should, magenta where one does that should not, as
    /// [`crate::Report::shadow_mismatch_px`] counts them. Empty if the frame has none.
    pub shadow: Vec<[u8; 3]>,
}

/// How far off each pixel is, as [`HeatMaps`] show it: absolute differences.
#[derive(Clone, Debug, PartialEq)]
pub struct Differences {
    /// Depth, in units of 65535, on agreeing pixels.
    pub depth: Vec<Option<f64>>,
    /// Light, of 255, on agreeing pixels.
    pub level: Vec<Option<f64>>,
    /// The worst channel of the colour against the unquantised truth, of 255.
    pub colour: Vec<f64>,
}

/// Measures each pixel by itself.
///
/// # Errors
/// As [`crate::compare()`].
pub fn differences(truth: &Truth, frame: &Frame) -> Result<Differences, FrameError> {
    frame.check(truth, truth.materials)?;
    Ok(off(truth, frame, &pixels(truth, frame)))
}

fn pixels(truth: &Truth, frame: &Frame) -> Vec<Pixel> {
    let all = 0..truth.pixels.len();
    all.map(|i| Pixel::of(truth, frame, i)).collect()
}

fn off(truth: &Truth, frame: &Frame, pixels: &[Pixel]) -> Differences {
    let agreeing = |difference: &dyn Fn(usize, &crate::Hit) -> f64| {
        let at = |(i, pixel): (usize, &Pixel)| match (pixel, &truth.pixels[i]) {
            (Pixel::Same, Some(hit)) => Some(difference(i, hit).abs()),
            _ => None,
        };
        pixels.iter().enumerate().map(at).collect()
    };
    let lights = frame.lookup.lights();
    let colour = truth.colours().zip(&frame.rgb).map(|(truth, shown)| {
        let channel = |(t, s): (f64, &u8)| (255.0 * t - f64::from(*s)).abs();
        let channels = truth.into_iter().zip(shown).map(channel);
        channels.fold(0.0, f64::max)
    });
    Differences {
        depth: agreeing(&|i, hit| f64::from(frame.depth[i]) - hit.depth_lsb),
        level: agreeing(&|i, hit| light_difference(frame, &lights, hit, i)),
        colour: colour.collect(),
    }
}

/// Draws all maps.
///
/// # Errors
/// As [`crate::compare()`].
pub fn draw(truth: &Truth, frame: &Frame) -> Result<HeatMaps, FrameError> {
    frame.check(truth, truth.materials)?;
    let pixels = pixels(truth, frame);
    let off = off(truth, frame, &pixels);
    let judged = |off: &[Option<f64>], full: f64| {
        let heat_of = |off: &Option<f64>| off.map_or(NEUTRAL, |off| heat(off / full));
        off.iter().map(heat_of).collect()
    };
    Ok(HeatMaps {
        coverage: pixels.iter().map(coverage).collect(),
        depth: judged(&off.depth, DEPTH_FULL),
        level: judged(&off.level, LEVEL_FULL),
        colour: off
            .colour
            .iter()
            .map(|off| heat(off / COLOUR_FULL))
            .collect(),
        shadow: shadow(truth, frame, &pixels),
    })
}

fn shadow(truth: &Truth, frame: &Frame, pixels: &[Pixel]) -> Vec<[u8; 3]> {
    if frame.lit.is_empty() {
        return Vec::new();
    }
    let same: Vec<bool> = pixels.iter().map(|pixel| *pixel == Pixel::Same).collect();
    let wrong = shadow::mismatches(truth, frame, &same);
    let lit = truth.lit();
    let lights = lit.iter().map(|bits| bits.count_ones()).max().unwrap_or(0);
    let colour = |i: usize| {
        if !same[i] {
            NEUTRAL
        } else if !wrong[i] {
            [40 + (160 * lit[i].count_ones() / lights.max(1)) as u8; 3]
        } else if frame.lit[i] & !lit[i] != 0 {
            EXTRA
        } else {
            MISSING
        }
    };
    (0..pixels.len()).map(colour).collect()
}

fn coverage(pixel: &Pixel) -> [u8; 3] {
    match pixel {
        Pixel::Nothing => NEUTRAL,
        Pixel::Same => AGREE,
        Pixel::Tie | Pixel::Doubt => TIE,
        Pixel::Mismatch(MismatchKind::Missing) => MISSING,
        Pixel::Mismatch(MismatchKind::Extra) => EXTRA,
        Pixel::Mismatch(MismatchKind::Visible) => VISIBLE,
    }
}

/// Black, red, yellow, white over 0..=1.
fn heat(t: f64) -> [u8; 3] {
    [0.0, 1.0, 2.0].map(|third| ((3.0 * t - third).clamp(0.0, 1.0) * 255.0).round() as u8)
}
