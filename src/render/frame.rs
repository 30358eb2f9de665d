//! Whole frames to a display.

use core::ops::Range;

use super::bands::Bands;
use super::paint::{Paint, Shaded};
use super::scratch::Workspace;
use super::stats::FrameStats;
use crate::display::Display;
use crate::frame::Band;
use crate::palette::{Cycle, Palette};
use crate::scene::{Pose, Scene};

/// Draws a frame: `pose.height` rows as wide as the band, in as many bands as
/// that takes, each shown as soon as it is finished.
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
pub fn render_frame<D: Display>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut Workspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
) -> Result<FrameStats, D::Error> {
    let paint = Shaded {
        dither: scene.dither(),
    };
    render_frame_with(&paint, scene, pose, work, band, display)
}

/// Draws a frame whose indices mean what `paint` says; see [`render_frame`].
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
pub fn render_frame_with<P: Paint<Stored = u8>, D: Display>(
    paint: &P,
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut Workspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
) -> Result<FrameStats, D::Error> {
    render_rows_with(paint, scene, pose, work, band, 0..pose.height, display)
}

/// The palette as it is in a pose: an application that changes nothing but
/// [`Pose::palette_shift`] need not draw again.
pub fn palette<'a>(scene: &Scene<'a>, pose: &Pose<'_>) -> Palette<'a> {
    let (first, count) = scene.header().cycle;
    Palette {
        colours: scene.palette(),
        cycle: Cycle {
            first,
            count,
            shift: pose.palette_shift,
        },
    }
}

/// Draws some rows of a frame only; see [`render_frame`].
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
#[inline(never)]
pub fn render_rows_with<P: Paint<Stored = u8>, D: Display>(
    paint: &P,
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut Workspace<'_>,
    band: &mut Band<'_>,
    rows: Range<u16>,
    display: &mut D,
) -> Result<FrameStats, D::Error> {
    let mut bands = Bands::with(*paint, scene, pose, work, band, rows);
    display.begin(&palette(scene, pose))?;
    while let Some(rows) = bands.next() {
        display.show(rows)?;
    }
    Ok(bands.stats())
}
