//! A frame in several passes: coarse ones, of which something is to be seen at once, and
//! the whole. Pixels of a coarse pass are kept, so that no ray is cast twice.

use super::frame::draw_pass;
use super::pass::{KeptPixel, Pass};
use super::scratch::RayWorkspace;
use super::watch::RayStats;
use crate::display::Display;
use crate::frame::Band;
use crate::scene::{Pose, Scene};

/// Of the first pass: every 8th pixel of every 8th row.
const COARSEST: u32 = 3;

/// Draws a frame by rays in several passes, each of which goes to the display as a frame of
/// its own: first every 8th pixel of every 8th row, as blocks of 8x8, then blocks half as
/// large, as long as `kept` has room for one entry each, and at last the whole, which is
/// the same bytes as [`render_frame`](super::render_frame)'s. For 320x240, 1,200 entries are
/// one coarse pass, 4,800 two. A first pass takes a 64th of the rays, and no ray is cast
/// twice, but in scenes whose pixels have several where they differ from neighbours.
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
pub fn render_progressively<D: Display>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut RayWorkspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
    kept: &mut [KeptPixel],
) -> Result<RayStats, D::Error> {
    let size = [band.width(), pose.height].map(usize::from);
    let blocks = |step: u32| size.map(|c| c.div_ceil(1 << step));
    let fits = |step: &u32| {
        let [columns, rows] = blocks(*step);
        columns * rows <= kept.len()
    };
    let finest = (1..=COARSEST).find(fits).unwrap_or(COARSEST + 1);
    let [columns, _] = blocks(finest);
    let mut pass = Pass {
        kept,
        finest,
        columns,
        step: COARSEST,
        known: None,
    };
    let mut stats = RayStats::default();
    for step in (finest..=COARSEST).rev().chain([0]) {
        pass.step = step;
        let own = draw_pass(scene, pose, work, band, display, (&mut (), &mut pass))?;
        stats.bands += own.bands;
        stats.rays += own.rays;
        pass.known = Some(step);
    }
    Ok(stats)
}
