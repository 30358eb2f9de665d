//! The figures of a comparison.

use serde::{Deserialize, Serialize};

/// What stands for an infinite PSNR (identical pictures), which JSON cannot
/// say.
pub const PSNR_IDENTICAL_DB: f64 = 999.0;

/// A frame held against the truth at pixel centres. Where a field counts
/// "agreeing" pixels, the frame and the truth both show the same triangle of
/// the same actor there. The maxima and means of no pixels are 0, the
/// percentages of none 100.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Pixels with a surface in the truth.
    pub covered_px: usize,
    /// Pixels where exactly one of the two shows a surface.
    pub coverage_mismatch_px: usize,
    /// Greatest difference between the frame's 16-bit depth and the truth's
    /// unrounded one, on agreeing pixels. 0.5 is the best possible.
    pub depth_max_lsb: f64,
    /// Mean of that difference.
    pub depth_mean_lsb: f64,
    /// Pixels where both show a surface, but not the same triangle, and the
    /// frame's is not as near as the truth's: the truth does not meet the
    /// frame's triangle there at all (also where an edge between neighbours
    /// moved across the pixel's centre), or more than 1 depth unit behind the
    /// nearest.
    pub visible_mismatch_px: usize,
    /// Pixels that differ where a line or a mark passes within 1/1024 pixel of
    /// taking another pixel, so that rounding decides: left out of all other
    /// figures.
    #[serde(default)]
    pub line_doubt_px: usize,
    /// Greatest difference of light, of 255, on agreeing pixels, against the
    /// truth's unrounded light: of the level where the material goes by level, of
    /// the worst of red, green and blue where it goes by colour (before either is
    /// looked up and dithered).
    pub level_max: f64,
    /// Mean of that difference.
    pub level_mean: f64,
    /// PSNR over all pixels of the picture (peak 255, mean over the channels)
    /// against the reference's level or colour, whichever way the material
    /// takes, put through the frame's own look-up without dithering. Identical:
    /// [`PSNR_IDENTICAL_DB`].
    pub rgb_psnr_db: f64,
    /// The same against the reference's unquantised colour.
    pub rgb_psnr_true_db: f64,
    /// Of the pixels where either shows a surface, the share whose palette
    /// index equals that of the reference through the frame's own look-up.
    pub index_equal_percent: f64,

    /// Pixels where both show the same triangle of the same actor.
    pub agreeing_px: usize,
    /// `coverage_mismatch_px` as a share of `covered_px`.
    pub coverage_mismatch_percent: f64,
    /// Share of agreeing pixels whose depth differs by at most 1 unit.
    pub depth_within_1_percent: f64,
    /// Share of agreeing pixels whose light differs by at most 2.
    pub level_within_2_percent: f64,
    /// `rgb_psnr_true_db` over the pixels covered in the truth only.
    pub rgb_psnr_true_covered_db: f64,
    /// Column and row of the greatest depth difference.
    pub depth_max_at: Option<[u32; 2]>,
    /// Column and row of the greatest light difference.
    pub level_max_at: Option<[u32; 2]>,
    /// Greatest difference of the place in the texture, in texels across or down,
    /// whichever is more, on agreeing pixels with a texture, if the frame knows.
    #[serde(default)]
    pub texel_max: f64,
    /// Mean of that difference.
    #[serde(default)]
    pub texel_mean: f64,
    /// Of the ray caster: pixels that some light gets to in the truth.
    #[serde(default)]
    pub lit_px: usize,
    /// Of those that show the same surface, pixels to which some light gets that does
    /// not in the truth, or the other way round, and its part, times the cosine of its
    /// angle to the normal, is more than 1 of 255.
    #[serde(default)]
    pub shadow_mismatch_px: usize,
    /// Groups of at least 4 such pixels that touch at sides or corners.
    #[serde(default)]
    pub shadow_mismatch_clusters: usize,
    /// The first 20 pixels that count as a coverage or visible mismatch, by
    /// rows from the top.
    pub mismatches: Vec<Mismatch>,
}

/// One pixel that differs in what is seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mismatch {
    /// Column.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
    /// In which way.
    pub kind: MismatchKind,
    /// The truth's actor index and triangle index.
    pub truth: Option<[usize; 2]>,
    /// The frame's actor index and triangle index.
    pub frame: Option<[usize; 2]>,
    /// The truth's depth; 0 where nothing is seen.
    pub truth_depth_lsb: f64,
    /// The frame's depth; 0 where nothing is seen.
    pub frame_depth_lsb: u16,
}

/// How a pixel differs in what is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MismatchKind {
    /// A surface in the truth, none in the frame.
    Missing,
    /// A surface in the frame, none in the truth.
    Extra,
    /// Another triangle.
    Visible,
}
