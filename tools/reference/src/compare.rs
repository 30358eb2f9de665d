//! A frame against the truth.

use crate::bases::Lights;
use crate::frame::{Frame, FrameError, NO_TRIANGLE};
use crate::hit::Hit;
use crate::metric::{Differences, Psnr, percent};
use crate::report::{Mismatch, MismatchKind, Report};
use crate::shadow;
use crate::truth::Truth;

/// Places in textures that repeat are known up to a multiple of so many texels.
const PERIOD: f64 = 65536.0;

/// How many mismatching pixels a report names.
const LISTED: usize = 20;

/// Two surfaces closer than this in depth are a tie: either may be seen.
const TIE_LSB: f64 = 1.0;

/// Measures `frame` against `truth`. [`Report`] defines every figure.
///
/// # Errors
/// If the two differ in size, or the frame's arrays do not fit together.
pub fn compare(truth: &Truth, frame: &Frame) -> Result<Report, FrameError> {
    frame.check(truth, truth.materials)?;
    let (mut depth, mut level) = (Differences::default(), Differences::default());
    let mut texel = Differences::default();
    let (mut missing_or_extra, mut visible, mut union, mut equal) = (0, 0, 0, 0);
    let mut mismatches = Vec::new();
    let mut doubtful = vec![false; truth.pixels.len()];
    let mut same = vec![false; truth.pixels.len()];
    let lights = frame.lookup.lights();
    let through_palette = frame.lookup.indices(truth);
    let same_way = frame.lookup.shown(truth, &through_palette);
    for (i, reference_index) in through_palette.iter().enumerate() {
        let seen = Pixel::of(truth, frame, i);
        if seen != Pixel::Nothing {
            union += 1;
            equal += usize::from(frame.index[i] == *reference_index);
        }
        let kind = match seen {
            Pixel::Nothing | Pixel::Tie => None,
            Pixel::Doubt => {
                doubtful[i] = true;
                None
            }
            Pixel::Same => {
                same[i] = true;
                if let Some(hit) = &truth.pixels[i] {
                    depth.add(i, f64::from(frame.depth[i]) - hit.depth_lsb, 1.0);
                    level.add(i, light_difference(frame, &lights, hit, i), 2.0);
                    if let (Some(true_place), Some(place)) =
                        (hit.texture_place, frame.texture_place.get(i))
                    {
                        let off = [0, 1].map(|axis| {
                            let off = true_place[axis] - place[axis];
                            (off - (off / PERIOD).round() * PERIOD).abs()
                        });
                        texel.add(i, off[0].max(off[1]), 1.0);
                    }
                }
                None
            }
            Pixel::Mismatch(kind) => Some(kind),
        };
        if let Some(kind) = kind {
            *(if kind == MismatchKind::Visible {
                &mut visible
            } else {
                &mut missing_or_extra
            }) += 1;
            if mismatches.len() < LISTED {
                mismatches.push(mismatch(truth, frame, i, kind));
            }
        }
    }
    let (mut quantised, mut all, mut covered) = (Psnr::default(), Psnr::default(), Psnr::default());
    for (i, colour) in truth.colours().enumerate().filter(|(i, _)| !doubtful[*i]) {
        let shown = frame.rgb[i].map(f64::from);
        quantised.add(shown, same_way[i].map(f64::from));
        let colour = colour.map(|c| 255.0 * c);
        all.add(shown, colour);
        if truth.pixels[i].is_some() {
            covered.add(shown, colour);
        }
    }
    let shadows = shadow::mismatches(truth, frame, &same);
    let at = |i: usize| [i as u32 % truth.width, i as u32 / truth.width];
    let covered_px = truth.covered_px();
    Ok(Report {
        width: truth.width,
        height: truth.height,
        covered_px,
        coverage_mismatch_px: missing_or_extra,
        depth_max_lsb: depth.max,
        depth_mean_lsb: depth.mean(),
        visible_mismatch_px: visible,
        line_doubt_px: doubtful.into_iter().filter(|doubtful| *doubtful).count(),
        level_max: level.max,
        level_mean: level.mean(),
        rgb_psnr_db: quantised.db(),
        rgb_psnr_true_db: all.db(),
        index_equal_percent: percent(equal, union),
        agreeing_px: depth.count,
        coverage_mismatch_percent: 100.0 * missing_or_extra as f64 / covered_px.max(1) as f64,
        depth_within_1_percent: percent(depth.within, depth.count),
        level_within_2_percent: percent(level.within, level.count),
        rgb_psnr_true_covered_db: covered.db(),
        depth_max_at: depth.max_at.map(at),
        level_max_at: level.max_at.map(at),
        texel_max: texel.max,
        texel_mean: texel.mean(),
        lit_px: shadow::lit_px(truth),
        shadow_mismatch_px: shadows.iter().filter(|differs| **differs).count(),
        shadow_mismatch_clusters: shadow::clusters(&shadows, truth.width as usize),
        mismatches,
    })
}

/// The difference of light on an agreeing pixel, of 255: of its level, or of the
/// channel that is farthest off.
pub(crate) fn light_difference(frame: &Frame, lights: &Lights<'_>, hit: &Hit, i: usize) -> f64 {
    let channels = frame.light[i].into_iter().zip(lights.of(hit));
    let differences = channels.map(|(frame, truth)| (f64::from(frame) - truth).abs());
    differences.fold(0.0, f64::max)
}

/// What the two show at one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pixel {
    /// Background in both.
    Nothing,
    /// The same triangle of the same actor.
    Same,
    /// Different triangles that are equally near.
    Tie,
    /// Not the same, where rounding decides which pixel a line or a mark takes.
    Doubt,
    /// Not the same.
    Mismatch(MismatchKind),
}

impl Pixel {
    /// Of pixel number `i`.
    pub fn of(truth: &Truth, frame: &Frame, i: usize) -> Self {
        match Self::by_surface(truth, frame, i) {
            Self::Mismatch(_) if truth.is_doubtful(i) => Self::Doubt,
            pixel => pixel,
        }
    }

    fn by_surface(truth: &Truth, frame: &Frame, i: usize) -> Self {
        match (&truth.pixels[i], frame_surface(frame, i)) {
            (None, None) => Self::Nothing,
            (Some(_), None) => Self::Mismatch(MismatchKind::Missing),
            (None, Some(_)) => Self::Mismatch(MismatchKind::Extra),
            (Some(hit), Some([actor, triangle])) => {
                let whole = truth.is_primitive(actor) || triangle == NO_TRIANGLE as usize;
                if hit.actor == actor && (hit.triangle == triangle || whole) {
                    return Self::Same;
                }
                let (x, y) = (i as u32 % truth.width, i as u32 / truth.width);
                match truth.depth_of_lsb(actor, triangle, x, y) {
                    Some(depth) if hit.depth_lsb - depth <= TIE_LSB => Self::Tie,
                    _ => Self::Mismatch(MismatchKind::Visible),
                }
            }
        }
    }
}

/// The frame's actor and triangle index at a pixel.
fn frame_surface(frame: &Frame, i: usize) -> Option<[usize; 2]> {
    let actor = usize::from(frame.actor[i]).checked_sub(1)?;
    Some([actor, frame.triangle[i] as usize])
}

fn mismatch(truth: &Truth, frame: &Frame, i: usize, kind: MismatchKind) -> Mismatch {
    let hit = truth.pixels[i].as_ref();
    Mismatch {
        x: i as u32 % truth.width,
        y: i as u32 / truth.width,
        kind,
        truth: hit.map(|hit| [hit.actor, hit.triangle]),
        frame: frame_surface(frame, i),
        truth_depth_lsb: hit.map_or(0.0, |hit| hit.depth_lsb),
        frame_depth_lsb: frame.depth[i],
    }
}
