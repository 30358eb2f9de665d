//! The data path, in order, a band at a time.

use core::ops::Range;

use super::actors::Actors;
use super::draw::{Place, draw_meshlet};
use super::entry::Entry;
use super::lines::Pass;
use super::meshlet_cache::MeshletCache;
use super::paint::{Paint, Shaded};
use super::scratch::Workspace;
use super::stats::FrameStats;
use super::viewports::Viewports;
use super::visible_list;
use crate::frame::{Band, BandRows, Target};
use crate::scene::{Pose, Scene};

/// A frame that is drawn band by band as the application asks for them: what
/// [`render_frame`](super::render_frame) goes through by itself. For those who have
/// something to do in between, such as sending the last band while the next is drawn.
///
/// ```
/// # use fixel::{Band, Pose, Scene, Scratch, render::Bands};
/// # fn draw(scene: &Scene<'_>, pose: &Pose<'_>, mut send: impl FnMut(&[u8])) {
/// let mut scratch = Scratch::<64, 8, 4>::new();
/// let (mut indices, mut depths) = ([0; 320 * 16], [0; 320 * 16]);
/// let mut band = Band::new(320, &mut indices, &mut depths).unwrap();
/// let mut work = scratch.workspace();
/// let mut bands = Bands::new(scene, pose, &mut work, &mut band);
/// while let Some(rows) = bands.next() {
///     send(rows.indices);
/// }
/// # }
/// ```
#[derive(Debug)]
pub struct Bands<'a, 'b, P: Paint = Shaded> {
    paint: P,
    scene: &'a Scene<'a>,
    height: u16,
    actors: Actors<'a>,
    entries: &'a mut [Entry],
    /// How many of them are listed.
    listed: usize,
    /// The row before which they are all that is visible of the rows that are not drawn yet.
    complete_to: u16,
    cache: MeshletCache<'a>,
    band: &'a mut Band<'b, P::Stored>,
    /// Those that are not drawn yet.
    rows: Range<u16>,
    stats: FrameStats,
}

impl<'a, 'b> Bands<'a, 'b> {
    /// A frame of `pose.height` rows as wide as the band, from its top on.
    pub fn new(
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        work: &'a mut Workspace<'_>,
        band: &'a mut Band<'b>,
    ) -> Self {
        let paint = Shaded {
            dither: scene.dither(),
        };
        Self::with(paint, scene, pose, work, band, 0..pose.height)
    }
}

impl<'a, 'b, P: Paint> Bands<'a, 'b, P> {
    /// Some rows of a frame whose indices mean what `paint` says. What it takes to make them
    /// is off the stack when they are drawn.
    #[inline(never)]
    pub fn with(
        paint: P,
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        work: &'a mut Workspace<'_>,
        band: &'a mut Band<'b, P::Stored>,
        rows: Range<u16>,
    ) -> Self {
        let (width, height) = (band.width(), pose.height);
        let rows = rows.start..rows.end.min(height);

        // 1. Viewports and their cameras; the actors' matrices and lights follow
        //    when first needed.
        Self {
            paint,
            scene,
            height,
            actors: Actors::new(scene, pose, (width, height), work.actors),
            entries: work.entries,
            listed: 0,
            complete_to: rows.start,
            cache: MeshletCache::new(scene, work.room, work.kept),
            band,
            rows,
            stats: FrameStats::default(),
        }
    }

    /// What was done up to now.
    pub fn stats(&self) -> FrameStats {
        self.stats.summed()
    }

    /// Draws the next band; `None` after the last.
    #[expect(
        clippy::should_implement_trait,
        reason = "an iterator cannot lend what it will write into again"
    )]
    pub fn next(&mut self) -> Option<BandRows<'_, P::Stored>> {
        self.next_target().map(Target::into_finished)
    }

    /// The same, to be drawn over: see [`Overlay`](crate::display::Overlay).
    #[inline(never)]
    pub fn next_target(&mut self) -> Option<Target<'_, P::Stored>> {
        if self.rows.is_empty() {
            return None;
        }
        let top = self.rows.start;
        let rows = top..top.saturating_add(self.band.rows()).min(self.rows.end);
        let end = self.rows.end;
        self.rows.start = rows.end;
        let (paint, scene, actors) = (&self.paint, self.scene, &mut self.actors);
        let (cache, stats) = (&mut self.cache, &mut self.stats);
        let mut target = self.band.target(rows.start, rows.end);
        let mut viewports = Viewports::new(paint, scene, &mut target, self.height);
        cache.begin_band(rows.end);
        stats.bands += 1;

        let mut after = None;
        loop {
            // 2. Meshlets that may be seen, near ones first: once for the whole frame if the
            //    list holds them, else for as many bands as it does, and as often as a band
            //    takes.
            if self.complete_to < rows.end {
                stats.list_refills += u32::from(stats.bands > 1 || after.is_some());
                let wanted = (&rows, end);
                let list = visible_list::fill(self.entries, after, scene, actors, wanted, stats);
                (after, self.complete_to, self.listed) = (list.last, list.complete_to, list.count);
            }
            let entries = self.entries.get_mut(..self.listed).unwrap_or_default();
            for entry in entries.iter_mut().filter(|entry| entry.touches(&rows)) {
                // 3. Vertices: transform, project, light - or as kept from the
                //    band before. 4. Triangles: back faces, clipping, setup,
                //    spans.
                let viewport = entry.viewport();
                viewports.reach(viewport, actors, &mut target);
                let mut haze = None;
                if cfg!(feature = "transparency") && entry.pass() == Pass::Blended {
                    viewports.fog(viewport, actors, &mut target);
                    haze = actors.haze::<P>(viewport);
                }
                let rect = actors.viewport(viewport).rect;
                let Some(view) = actors.get(viewport, entry.actor) else {
                    continue;
                };
                let place = Place {
                    view,
                    haze: haze.as_ref(),
                    rect: &rect,
                    rows: &rows,
                };
                let target = &mut target.part(&rect);
                draw_meshlet(paint, scene, place, entry, cache, target, stats);
            }
            if after.is_none() {
                break;
            }
        }
        viewports.reach(scene.viewport_count(), actors, &mut target);

        // 5. The finished rows.
        Some(target)
    }
}
