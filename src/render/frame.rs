//! The data path, in order.

use core::ops::Range;

use super::actors::Actors;
use super::draw::{Place, draw_meshlet};
use super::lines::Pass;
use super::meshlet_cache::MeshletCache;
use super::paint::{Paint, Shaded};
use super::scratch::Workspace;
use super::stats::FrameStats;
use super::viewports::Viewports;
use super::visible_list;
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
pub fn render_frame_with<P: Paint, D: Display>(
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
pub fn render_rows_with<P: Paint, D: Display>(
    paint: &P,
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut Workspace<'_>,
    band: &mut Band<'_>,
    rows: Range<u16>,
    display: &mut D,
) -> Result<FrameStats, D::Error> {
    let mut stats = FrameStats::default();
    let (width, height) = (band.width(), pose.height);
    let rows = rows.start..rows.end.min(height);

    // 1. Viewports and their cameras; the actors' matrices and lights follow
    //    when first needed.
    let mut actors = Actors::new(scene, pose, (width, height), work.actors);

    // 2. Meshlets that may be seen, near ones first: once for the whole frame if
    //    the list holds them, else for each band, as often as it takes.
    let whole = visible_list::fill(work.entries, None, scene, &mut actors, &rows, &mut stats);
    let whole = whole.last.is_none().then_some(whole.entries.len());
    let mut cache = MeshletCache::new(work.slots);

    display.begin(&palette(scene, pose))?;
    let mut top = rows.start;
    while top < rows.end {
        let rows = top..top.saturating_add(band.rows()).min(rows.end);
        let mut target = band.target(rows.start, rows.end);
        let mut viewports = Viewports::new(paint, scene, &mut target, height);
        cache.begin_band(rows.end);
        stats.bands += 1;

        let mut after = None;
        loop {
            let entries = match whole {
                Some(count) => work.entries.get_mut(..count).unwrap_or_default(),
                None => {
                    stats.list_refills += 1;
                    let list = visible_list::fill(
                        work.entries,
                        after,
                        scene,
                        &mut actors,
                        &rows,
                        &mut stats,
                    );
                    after = list.last;
                    list.entries
                }
            };
            for entry in entries.iter_mut().filter(|entry| entry.touches(&rows)) {
                // 3. Vertices: transform, project, light - or as kept from the
                //    band before. 4. Triangles: back faces, clipping, setup,
                //    spans.
                let viewport = entry.viewport();
                viewports.reach(viewport, &mut actors, &mut target);
                let mut haze = None;
                if cfg!(feature = "transparency") && entry.pass() == Pass::Blended {
                    viewports.fog(viewport, &mut actors, &mut target);
                    haze = actors.haze::<P>(viewport);
                }
                let rect = actors.viewport(viewport).rect;
                let Some(view) = actors.get(viewport, entry.actor) else {
                    continue;
                };
                draw_meshlet(
                    paint,
                    scene,
                    Place {
                        view,
                        haze: haze.as_ref(),
                        rect: &rect,
                        rows: &rows,
                    },
                    entry,
                    &mut cache,
                    &mut target.part(&rect),
                    &mut stats,
                );
            }
            if after.is_none() {
                break;
            }
        }

        viewports.reach(scene.viewport_count(), &mut actors, &mut target);

        // 5. The finished rows.
        display.show(target.finished())?;
        top = rows.end;
    }
    Ok(stats)
}
