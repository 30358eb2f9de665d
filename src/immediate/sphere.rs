//! Spheres by call, as triangles.

use super::Immediate;
use crate::frame::Target;
use crate::math::{Angle, Unit3, Vec3, World};

/// Fewest and most sides that a sphere has around.
const LEAST: u32 = 8;
const MOST: u32 = 48;

impl Immediate<'_> {
    /// A sphere in the material's light, of so many triangles that its outline is less
    /// than half a pixel off. Shaded smoothly if the material goes by level, face by face
    /// if it goes by colour.
    pub fn sphere(&self, target: &mut Target<'_>, centre: Vec3, radius: World) {
        let around = self.sides(centre, radius);
        let down = around / 2;
        for row in 0..down {
            let rings = [row, row + 1].map(|row| Angle::fraction(row, around).sin_cos());
            let mut before = Angle::fraction(0, around).sin_cos();
            for side in 1..=around {
                let after = Angle::fraction(side, around).sin_cos();
                let [upper, lower] = rings;
                let quad = [
                    direction(upper, before),
                    direction(lower, before),
                    direction(lower, after),
                    direction(upper, after),
                ];
                let [a, b, c, d] = quad;
                if row + 1 < down {
                    self.facet(target, (centre, radius), [a, b, c]);
                }
                if row > 0 {
                    self.facet(target, (centre, radius), [a, c, d]);
                }
                before = after;
            }
        }
    }

    fn facet(&self, target: &mut Target<'_>, (centre, radius): (Vec3, World), normals: [Unit3; 3]) {
        let places = normals.map(|normal| on(centre, radius, normal));
        #[cfg(feature = "gouraud")]
        if !self.view.material.coloured {
            let corner = |(place, normal)| (place, self.level(place, normal));
            let [a, b, c] = places;
            let [na, nb, nc] = normals;
            let corners = [(a, na), (b, nb), (c, nc)].map(corner);
            self.ramp_triangle(target, corners, self.ramp());
            return;
        }
        self.triangle(target, places);
    }

    /// Sides around: an arc of an angle `a` of a circle of `r` pixels is `r a^2 / 8` off
    /// its chord, which is half a pixel at `a = 2 / sqrt(r)`: `pi sqrt(r)` sides, here 3.5.
    fn sides(&self, centre: Vec3, radius: World) -> u32 {
        let [_, _, distance] = self.view.world_to_clip(centre);
        let pixels = self.pixels(radius, distance);
        // Of r in 1/16 pixels the root is in quarters.
        let root = (pixels.min(1 << 20)).isqrt();
        ((root * 7).div_ceil(8))
            .clamp(LEAST, MOST)
            .next_multiple_of(4)
    }

    /// A length at a distance in 1/16 pixels, by a lens as in the middle of the picture.
    fn pixels(&self, length: World, distance: i32) -> u32 {
        let zero = self.view.world_to_clip(Vec3::ZERO);
        let along = |x: World, y: World, z: World| self.view.world_to_clip(Vec3::new(x, y, z));
        let nought = World::ZERO;
        // The largest change of y on the screen's own scale, whichever way the world lies.
        let reach = [
            along(length, nought, nought),
            along(nought, length, nought),
            along(nought, nought, length),
        ]
        .iter()
        .map(|[_, y, _]| {
            let [_, y0, _] = zero;
            let change = i64::from(*y) - i64::from(y0);
            change * change
        })
        .sum::<i64>()
        .isqrt();
        let half = i64::from(self.half_height) << crate::math::SUBPX_BITS;
        let side = self.view.side_at(half, distance.into()).max(1);
        let sixteenths = reach.saturating_mul(i64::from(self.half_height) << 4) / side;
        sixteenths.clamp(0, 1 << 20) as u32
    }
}

/// The direction at a latitude from the upper pole and a longitude.
fn direction((sin, cos): (i32, i32), (sin_around, cos_around): (i32, i32)) -> Unit3 {
    let times = |c: i32| ((i64::from(sin) * i64::from(c) + (1 << 29)) >> 30) as i32;
    [times(sin_around), cos, times(cos_around)]
}

/// The point of a sphere in a direction.
fn on(centre: Vec3, radius: World, normal: Unit3) -> Vec3 {
    let by = i64::from(radius.to_bits());
    centre.plus(normal.map(|c| (i64::from(c) * by + (1 << 29)) >> 30))
}
