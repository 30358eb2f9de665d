//! A viewport's pixels, tile by tile.

use super::camera::RayCamera;
use super::coverage;
use super::frame::{RayStats, Seen, Watch};
use super::gather::Gathered;
use super::light::Seed;
use super::progressive::Pass;
use super::sequence::in_pixel;
use super::trace::{Light, Shown, Tracer, lookup};
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
        let number = self.viewport.number;
        let mut count = 0;
        for actor in 0..self.tracer.actors.count() {
            let bounds = self.tracer.actors.bounds(actor, number, camera);
            let across = bounds.left < tile.right && bounds.right > tile.left;
            let down = bounds.top < tile.bottom && bounds.bottom > tile.top;
            if across && down {
                if let Some(slot) = self.listed.get_mut(count) {
                    *slot = actor;
                }
                count += 1;
            }
        }
        count
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
        let gathered = listed.is_some_and(|listed| {
            let actors = &mut self.tracer.actors;
            let view = (self.viewport.number, camera);
            let part = (tile, divided);
            self.gathered
                .gather_if_it_pays(self.tracer.scene, actors, view, listed, part)
        });
        if !gathered && divided < LAST && listed.is_some() {
            return false;
        }
        self.tracer.windows.begin();
        // Corners first: they tell where rays to lights start.
        let [right, bottom] = [tile.right - 1, tile.bottom - 1];
        let ordered = self.tracer.settings.shadows && tile.left < right && tile.top < bottom;
        if ordered {
            for place in [
                [tile.left, tile.top],
                [right, bottom],
                [right, tile.top],
                [tile.left, bottom],
            ] {
                self.pixel(camera, target, tile, place, (count, gathered));
            }
        }
        for row in tile.top..tile.bottom {
            let ends = ordered && (row == tile.top || row == bottom);
            for column in tile.left..tile.right {
                if !(ends && (column == tile.left || column == right)) {
                    self.pixel(camera, target, tile, [column, row], (count, gathered));
                }
            }
        }
        true
    }

    /// Draws a pixel of a tile whose triangles were gathered or not.
    #[inline(always)]
    fn pixel(
        &mut self,
        camera: &RayCamera,
        target: &mut Target<'_>,
        tile: &Rect,
        place: [u16; 2],
        (count, gathered): (usize, bool),
    ) {
        let [column, row] = place;
        let rect = &self.viewport.rect;
        let in_frame = [rect.left + column, rect.top + row];
        if !self.pass.takes(in_frame) {
            return;
        }
        if let Some((index, depth)) = self.pass.known(in_frame) {
            if depth != 0 {
                put(target, place, index, Some(depth));
            }
            return;
        }
        let (x, y) = (column - tile.left, row - tile.top);
        let pixel = usize::from(y) * coverage::TILE + usize::from(x);
        let pixel = gathered.then_some(pixel);
        if let Some((shown, depth)) = self.cast(camera, place, 0, count, pixel) {
            let index = self.show(target, place, &shown, depth);
            self.pass.keep(in_frame, index, depth);
        }
    }

    /// What a pixel's ray shows, and its depth; `pixel` is its place among those that
    /// were gathered, if they were.
    #[inline(never)]
    pub(super) fn cast(
        &mut self,
        camera: &RayCamera,
        [column, row]: [u16; 2],
        number: u32,
        count: usize,
        pixel: Option<usize>,
    ) -> Option<(Shown, u16)> {
        if pixel.is_some_and(|pixel| self.gathered.nothing_at(pixel)) {
            self.stats.rays += 1;
            return None;
        }
        // In 2^-16 pixels.
        let from_middle = |c: u32| c.wrapping_sub(1 << 31) as i32 >> 16;
        let offset = match number {
            0 => [0; 2],
            _ => in_pixel(number, self.tracer.settings.samples.into()).map(from_middle),
        };
        let cast = camera.cast(column.into(), row.into(), offset);
        self.stats.rays += 1;
        let seed = Seed {
            pixel: [column.into(), row.into()],
            sample: number,
        };
        let view = (self.viewport.number, camera);
        let only = pixel.map(|pixel| self.gathered.at(pixel));
        let listed = self.listed.get(..count);
        let shown = self.tracer.camera(&cast.ray, view, listed, only, seed)?;
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
                let material = self.tracer.material(material);
                (lookup(scene, &material, base), lit)
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
