//! A viewport's pixels, tile by tile.

use super::camera::RayCamera;
use super::coverage;
use super::gather::{Gathered, Way};
use super::light::Seed;
use super::nearest::Met;
use super::pass::Pass;
use super::sequence::in_pixel;
use super::trace::{Light, Shown, Tracer, lookup};
use super::watch::{RayStats, Seen, Watch};
use crate::fog::{self, FogDepths};
use crate::frame::Target;
use crate::math::Rect;
use crate::scene::{Dither, PlacedViewport};
use crate::shade::{Lookup, Pixel, dithered};

/// Columns and rows of a tile.
pub(super) const TILE: u16 = coverage::TILE as u16;

/// How often a tile is divided: beams for fewer rays take more than the rays.
const LAST: usize = 1;

/// A viewport being drawn.
pub(super) struct Drawing<'a, 's, 'p, W> {
    pub tracer: &'a mut Tracer<'s>,
    /// Actors that a tile's rays may meet.
    pub listed: &'a mut [u16],
    /// Triangles that they may meet.
    pub gathered: &'a mut Gathered,
    pub watch: &'a mut W,
    pub viewport: PlacedViewport,
    pub dither: Dither,
    pub stats: &'a mut RayStats,
    pub pass: &'a mut Pass<'p>,
    /// There are shadows of lights that are infinitely far away.
    pub parallel: bool,
}

impl<W: Watch> Drawing<'_, '_, '_, W> {
    /// Draws the viewport's part of a band, whose first row is the target's.
    #[inline(never)]
    pub(super) fn draw(&mut self, target: &mut Target<'_>) {
        let rect = self.viewport.rect;
        let background = self.tracer.background;
        target.clear(|y| background.at(y, rect.height()));
        let camera = RayCamera::of(&self.viewport);
        self.pass.begin(target, &rect);
        let samples = self.tracer.settings.samples;
        let mut top = target.top;
        while top < target.end {
            let bottom = (top - top % TILE + TILE).min(target.end);
            let mut left = 0;
            while left < target.width {
                let right = (left + TILE).min(target.width);
                let tile = Rect {
                    left,
                    top,
                    right,
                    bottom,
                };
                if samples > 1 && self.pass.is_whole() {
                    self.smooth_tile(&camera, target, &tile, samples);
                } else {
                    self.tile(&camera, target, &tile);
                }
                left = right;
            }
            top = bottom;
        }
        self.pass.spread(target, &rect);
        let scene = self.tracer.scene;
        if cfg!(feature = "fog")
            && let (Some(fog), Some(table)) = (scene.fog(), scene.fog_table())
        {
            fog::apply(
                target,
                table,
                &FogDepths::new(camera.frame(), &fog.distances),
            );
        }
    }

    /// Lists the actors that may be seen in a tile; says how many.
    pub(super) fn list(&mut self, camera: &RayCamera, tile: &Rect) -> usize {
        let view = (self.viewport.number, camera);
        self.tracer.actors.list(self.listed, view, tile)
    }

    fn tile(&mut self, camera: &RayCamera, target: &mut Target<'_>, tile: &Rect) {
        let count = self.list(camera, tile);
        if count == 0 {
            return;
        }
        if self.part(camera, target, tile, count, 0) {
            return;
        }
        // There are more triangles than the list has room for.
        for part in parts(tile, TILE / 2) {
            self.part(camera, target, &part, count, LAST);
        }
    }

    /// Draws a tile or a part of one that was divided so often; `false` if it has too many
    /// triangles, but not of what is not divided further.
    #[inline(never)]
    fn part(
        &mut self,
        camera: &RayCamera,
        target: &mut Target<'_>,
        tile: &Rect,
        count: usize,
        divided: usize,
    ) -> bool {
        let shares = camera.eye().is_some() && !self.pass.is_sparse();
        let listed = self.listed.get(..count).filter(|_| shares);
        let way = listed.map_or(Way::Alone, |listed| {
            let actors = &mut self.tracer.actors;
            let view = (self.viewport.number, camera);
            let (part, left) = ((tile, divided), &mut self.tracer.windows.left);
            let scene = self.tracer.scene;
            self.gathered.find(scene, actors, view, listed, part, left)
        });
        if way == Way::Divided {
            return false;
        }
        let gathered = way == Way::Gathered;
        let drawn = (count, gathered);
        if self.parallel && self.tracer.windows.by_quarters() {
            for quarter in parts(tile, TILE / 2) {
                self.pixels(camera, target, (tile, &quarter), drawn);
            }
        } else {
            self.pixels(camera, target, (tile, tile), drawn);
        }
        true
    }

    /// Draws the pixels of a part of a tile.
    #[inline(never)]
    fn pixels(
        &mut self,
        camera: &RayCamera,
        target: &mut Target<'_>,
        (tile, part): (&Rect, &Rect),
        drawn: (usize, bool),
    ) {
        let (_, gathered) = drawn;
        let plain = gathered && self.pass.is_plain();
        if self.parallel && self.tracer.windows.begin(tile != part) && plain {
            // Corners first: they tell where rays to lights start.
            let [right, bottom] = [part.right - 1, part.bottom - 1];
            self.note(camera, tile, [part.left, part.top], drawn);
            self.note(camera, tile, [right, bottom], drawn);
            if tile == part {
                self.note(camera, tile, [right, part.top], drawn);
                self.note(camera, tile, [part.left, bottom], drawn);
            }
        }
        for row in part.top..part.bottom {
            let mut next = camera.at(part.left.into(), row.into());
            for column in part.left..part.right {
                let at = next;
                next = camera.right_of(&at);
                let place = [column, row];
                if plain && self.gathered.nothing_at(in_tile(tile, place)) {
                    self.stats.rays += 1;
                    continue;
                }
                self.pixel((camera, &at), target, tile, place, drawn);
            }
        }
    }

    /// Notes what a pixel's ray meets, for rays to lights.
    #[inline(never)]
    fn note(
        &mut self,
        camera: &RayCamera,
        tile: &Rect,
        place: [u16; 2],
        (count, gathered): (usize, bool),
    ) {
        let [column, row] = place;
        let only = gathered.then(|| self.gathered.at(in_tile(tile, place)));
        if only.is_some_and(|only| only.is_empty()) {
            return;
        }
        let cast = camera.cast(&camera.at(column.into(), row.into()));
        let view = (self.viewport.number, camera);
        let mut met = Met::nothing(cast.ray.far);
        let listed = self.listed.get(..count);
        if self.tracer.camera(&cast.ray, view, listed, only, &mut met) {
            let at = cast.ray.at(met.distance);
            self.tracer.windows.note((met.actor, at));
        }
    }

    /// Draws a pixel of a tile whose triangles were gathered or not.
    #[inline(never)]
    fn pixel(
        &mut self,
        (camera, at): (&RayCamera, &[i64; 3]),
        target: &mut Target<'_>,
        tile: &Rect,
        place: [u16; 2],
        (count, gathered): (usize, bool),
    ) {
        let [column, row] = place;
        let rect = &self.viewport.rect;
        let in_frame = [rect.left + column, rect.top + row];
        if !self.pass.is_plain() {
            if !self.pass.takes(in_frame) {
                return;
            }
            if let Some((index, depth)) = self.pass.known(in_frame) {
                if depth != 0 {
                    put(target, place, index, Some(depth));
                }
                return;
            }
        }
        let pixel = gathered.then(|| in_tile(tile, place));
        if let Some((shown, depth)) = &self.cast((camera, at), place, 0, count, pixel) {
            let index = self.show(target, place, shown, *depth);
            self.pass.keep(in_frame, index, *depth);
        }
    }

    /// What a pixel's ray shows, and its depth; `pixel` is its place among those that
    /// were gathered, if they were.
    #[inline(always)]
    pub(super) fn cast(
        &mut self,
        (camera, at): (&RayCamera, &[i64; 3]),
        [column, row]: [u16; 2],
        number: u32,
        count: usize,
        pixel: Option<usize>,
    ) -> Option<(Shown, u16)> {
        self.stats.rays += 1;
        let only = pixel.map(|pixel| self.gathered.at(pixel));
        if only.is_some_and(|only| only.is_empty()) {
            return None;
        }
        // In 2^-16 pixels.
        let from_middle = |c: u32| c.wrapping_sub(1 << 31) as i32 >> 16;
        let mut cast = if number == 0 {
            camera.cast(at)
        } else {
            let place = in_pixel(number, self.tracer.settings.samples.into());
            camera.cast(&camera.beside(at, place.map(from_middle)))
        };
        let seed = Seed {
            pixel: [column.into(), row.into()],
            sample: number,
        };
        let view = (self.viewport.number, camera);
        let listed = self.listed.get(..count);
        let mut met = Met::nothing(cast.ray.far);
        let mut found = self.tracer.camera(&cast.ray, view, listed, only, &mut met);
        if found && camera.eye().is_some() && !camera.is_within(met.distance) {
            // A plane may cut it off.
            camera.clip(&mut cast);
            met = Met::nothing(cast.ray.far);
            found = self.tracer.camera(&cast.ray, view, listed, only, &mut met);
        }
        if !found {
            return None;
        }
        let shown = self.tracer.shown(&cast.ray, &met, seed)?;
        let depth = camera.depth(&cast, shown.distance);
        Some((shown, depth))
    }

    /// Draws a pixel; gives its index.
    pub(super) fn show(
        &mut self,
        target: &mut Target<'_>,
        place: [u16; 2],
        shown: &Shown,
        depth: u16,
    ) -> u8 {
        let scene = self.tracer.scene;
        let (lookup, lit) = match shown.light {
            Light::Own(material, lit, base) => {
                let material = self.tracer.materials.get(scene, material);
                (lookup(scene, material, base), lit)
            }
            Light::Mixed(lit) => (Lookup::Colours(scene.colours()), lit),
        };
        let pixel = Pixel {
            lookup,
            lit,
            place: place.map(i32::from),
            texel: [0; 2],
        };
        let [column, row] = place;
        self.watch.pixel(
            self.viewport.rect.left + column,
            self.viewport.rect.top + row,
            &Seen {
                actor: shown.actor,
                triangle: shown.triangle.and_then(|(mesh, meshlet, triangle)| {
                    let first = scene.mesh(mesh).first_meshlet;
                    let meshlet = scene.meshlet(first.wrapping_add(meshlet))?;
                    Some(meshlet.first_triangle.wrapping_add(triangle.into()))
                }),
                depth,
                lights: shown.lights,
                light: lit,
                index: dithered(&pixel, Dither::NONE),
            },
        );
        let index = dithered(&pixel, self.dither);
        put(target, place, index, Some(depth));
        index
    }
}

/// A pixel's place in a tile's bits.
#[inline(always)]
fn in_tile(tile: &Rect, [column, row]: [u16; 2]) -> usize {
    usize::from(row - tile.top) * coverage::TILE + usize::from(column - tile.left)
}

/// The parts of a tile that are so wide and high.
fn parts(tile: &Rect, size: u16) -> impl Iterator<Item = Rect> + use<> {
    let tile = *tile;
    let corners = [(0, 0), (size, 0), (0, size), (size, size)];
    let all = corners.into_iter().map(move |(x, y)| {
        let (left, top) = (tile.left + x, tile.top + y);
        Rect {
            left,
            top,
            right: (left + size).min(tile.right),
            bottom: (top + size).min(tile.bottom),
        }
    });
    all.filter(|part| part.left < part.right && part.top < part.bottom)
}

pub(super) fn put(target: &mut Target<'_>, [column, row]: [u16; 2], index: u8, depth: Option<u16>) {
    let line = usize::from(row.saturating_sub(target.top)) * usize::from(target.stride);
    let at = line + usize::from(column);
    if let Some(slot) = target.indices.get_mut(at) {
        *slot = index;
    }
    if let (Some(slot), Some(depth)) = (target.depths.get_mut(at), depth) {
        *slot = depth;
    }
}
