//! A frame, tile by tile.

use super::actors::RayActors;
use super::pass::Pass;
use super::scratch::RayWorkspace;
use super::tile::Drawing;
use super::trace::{Materials, Tracer};
use super::watch::{RayStats, Watch};
use crate::display::Display;
use crate::frame::Band;
use crate::palette::{Cycle, Palette};
use crate::scene::{Pose, Scene};

/// Draws a frame by rays: `pose.height` rows as wide as the band, in as many bands as
/// that takes, each shown as soon as it is finished. The scene is to be baked for it; of
/// one that is not, the background is shown.
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
pub fn render_frame<D: Display>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut RayWorkspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
) -> Result<RayStats, D::Error> {
    render_frame_watched(scene, pose, work, band, display, &mut ())
}

/// Draws a frame and has each pixel watched; see [`render_frame`].
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
pub fn render_frame_watched<D: Display, W: Watch>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut RayWorkspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
    watch: &mut W,
) -> Result<RayStats, D::Error> {
    let pass = &mut Pass::whole();
    draw_pass(scene, pose, work, band, display, (watch, pass))
}

/// Draws the pixels of a pass, and has each watched.
#[inline(never)]
pub(super) fn draw_pass<D: Display, W: Watch>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut RayWorkspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
    (watch, pass): (&mut W, &mut Pass<'_>),
) -> Result<RayStats, D::Error> {
    let mut stats = RayStats::default();
    let (width, height) = (band.width(), pose.height);
    let (first, count) = scene.header().cycle;
    let cycle = Cycle {
        first,
        count,
        shift: pose.palette_shift,
    };
    let palette = Palette {
        colours: scene.palette(),
        cycle,
    };
    // 1. Lights; actors follow when first needed.
    work.lights.set(scene);
    work.windows.clear();
    work.shades.clear();
    work.facet.clear();
    let settings = scene.ray_settings();
    let mut tracer = Tracer {
        scene,
        actors: RayActors::new(scene, pose, work.slots, work.known),
        lights: work.lights,
        windows: work.windows,
        shades: work.shades,
        facet: work.facet,
        waiting: work.waiting,
        materials: Materials::NONE,
        settings,
        needs_places: settings.shadows || work.lights.any_placed(),
        palette,
        background: scene.viewport_background(0),
    };
    let parallel = tracer.settings.shadows && tracer.lights.any_directional();
    display.begin(&palette)?;
    let mut top = 0;
    while top < height {
        let end = top.saturating_add(band.rows()).min(height);
        let mut target = band.target(top, end);
        stats.bands += 1;
        if !scene.is_filled(width) {
            target.clear(|y| scene.background(y, height));
        }
        for number in 0..scene.viewport_count() {
            // 2. A viewport's camera, 3. its rays.
            let viewport = scene.place_viewport(number, pose, width, height);
            tracer.background = scene.viewport_background(number);
            let mut part = target.part(&viewport.rect);
            let mut drawing = Drawing {
                tracer: &mut tracer,
                listed: work.listed,
                gathered: work.gathered,
                watch,
                viewport,
                dither: scene.dither(),
                stats: &mut stats,
                pass: &mut *pass,
                parallel,
            };
            drawing.draw(&mut part);
        }
        display.show(target.finished())?;
        top = end;
    }
    Ok(stats)
}
