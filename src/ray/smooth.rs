//! Pixels that differ from a neighbour, by several rays.

use super::camera::RayCamera;
use super::tile::{Drawing, TILE, put};
use super::trace::{Light, Shown};
use super::watch::Watch;
use crate::frame::Target;
use crate::light::Lit;
use crate::math::Rect;
use crate::scene::Dither;
use crate::shade::{Lookup, Pixel, dithered};

/// Columns and rows of a tile with its neighbours.
const GROWN: usize = TILE as usize + 2;

/// What neighbours are compared by: red, green and blue, and the actor; background has
/// none.
#[derive(Clone, Copy)]
struct Looks {
    colour: Lit,
    actor: u16,
}

/// No actor's number.
const NOTHING: u16 = u16::MAX;

impl<W: Watch> Drawing<'_, '_, '_, W> {
    /// A tile whose pixels that differ from a neighbour have several rays.
    #[inline(never)]
    pub(super) fn smooth_tile(
        &mut self,
        camera: &RayCamera,
        target: &mut Target<'_>,
        tile: &Rect,
        samples: u8,
    ) {
        let rect = self.viewport.rect;
        let grown = Rect {
            left: tile.left.saturating_sub(1),
            top: tile.top.saturating_sub(1),
            right: (tile.right + 1).min(rect.width()),
            bottom: (tile.bottom + 1).min(rect.height()),
        };
        let count = self.list(camera, &grown);
        if count == 0 {
            return;
        }
        let nothing = Looks {
            colour: [0; 3],
            actor: NOTHING,
        };
        let mut looks = [[nothing; GROWN]; GROWN];
        for (row, looks) in (grown.top..grown.bottom).zip(&mut looks) {
            let within = tile.top <= row && row < tile.bottom;
            for (column, looks) in (grown.left..grown.right).zip(looks) {
                let place = [column, row];
                let at = camera.at(column.into(), row.into());
                let seen = self.cast((camera, &at), place, 0, count, None);
                *looks = self.looks(seen.as_ref().map(|(shown, _)| shown), row);
                if let (Some((shown, depth)), true) = (seen, within)
                    && tile.left <= column
                    && column < tile.right
                {
                    self.show(target, place, &shown, depth);
                }
            }
        }
        for row in tile.top..tile.bottom {
            for column in tile.left..tile.right {
                let at = |column: u16, row: u16| {
                    let inside = (grown.left..grown.right).contains(&column)
                        && (grown.top..grown.bottom).contains(&row);
                    let looks = looks.get(usize::from(row.wrapping_sub(grown.top)));
                    let looks = looks?.get(usize::from(column.wrapping_sub(grown.left)));
                    looks.filter(|_| inside)
                };
                let Some(own) = at(column, row) else { continue };
                let around = [
                    at(column.wrapping_sub(1), row),
                    at(column + 1, row),
                    at(column, row.wrapping_sub(1)),
                    at(column, row + 1),
                ];
                let threshold = self.tracer.settings.threshold;
                let mut around = around.into_iter().flatten();
                if around.any(|other| differ(own, other, threshold)) {
                    self.smooth(camera, target, [column, row], own.colour, samples, count);
                }
            }
        }
    }

    /// Draws a pixel of which one ray shows `first`, by several rays.
    fn smooth(
        &mut self,
        camera: &RayCamera,
        target: &mut Target<'_>,
        place: [u16; 2],
        first: Lit,
        samples: u8,
        count: usize,
    ) {
        let [column, row] = place;
        let mut sums = first.map(u32::from);
        let at = camera.at(column.into(), row.into());
        for number in 1..u32::from(samples) {
            let seen = self.cast((camera, &at), place, number, count, None);
            let looks = self.looks(seen.as_ref().map(|(shown, _)| shown), row);
            for (sum, c) in sums.iter_mut().zip(looks.colour) {
                *sum += u32::from(c);
            }
        }
        let all = u32::from(samples);
        let mean = |sum: u32| (sum + all / 2).checked_div(all).unwrap_or(0) as u16;
        let pixel = Pixel {
            lookup: Lookup::Colours(self.tracer.scene.colours()),
            lit: sums.map(mean),
            place: place.map(i32::from),
            texel: [0; 2],
        };
        self.watch.smoothed(
            self.viewport.rect.left + column,
            self.viewport.rect.top + row,
            pixel.lit,
            dithered(&pixel, Dither::NONE),
        );
        put(target, place, dithered(&pixel, self.dither), None);
    }

    /// What a ray shows as a colour.
    fn looks(&mut self, shown: Option<&Shown>, row: u16) -> Looks {
        let Some(shown) = shown else {
            let height = self.viewport.rect.height();
            let index = self.tracer.background.at(row, height);
            return Looks {
                colour: self.tracer.entry(index),
                actor: NOTHING,
            };
        };
        let colour = match shown.light {
            Light::Own(material, lit, base) => self.tracer.rgb(material, lit, base),
            Light::Mixed(lit) => lit,
        };
        Looks {
            colour,
            actor: shown.actor,
        }
    }
}

fn differ(a: &Looks, b: &Looks, threshold: u16) -> bool {
    let mut channels = a.colour.iter().zip(b.colour);
    a.actor != b.actor || channels.any(|(a, b)| a.abs_diff(b) > threshold)
}
