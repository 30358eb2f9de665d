//! A ray and a ball: how near the ray comes to the centre first, so that tangent rays
//! are as exact as others (Haines, Günther and Akenine-Möller, "Precision improvements
//! for ray/sphere intersection", Ray Tracing Gems, 2019).

use super::actor::{Form, RayActor, plus};
use super::faces::Faces;
use super::ray::{FAR, Ray, between};
use super::surface::Surface;
use crate::math::{Scaled, Unit3, mul_high, mul_q30, root, square, unit, unit_vector};
use crate::scene::{Scene, Shape};

/// Where a ray meets a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BallHit {
    /// Raw world bits along the ray.
    pub distance: u32,
    /// From the centre to the place, in raw world bits; of an ellipsoid, in its space.
    to_surface: [i32; 3],
    /// Whether it is seen from inside.
    pub back: bool,
}

/// The chord of a ray in a ball, in any unit.
struct Chord {
    /// From the ray's start to the point nearest to the centre.
    middle: i32,
    /// From there to either end.
    half: i32,
    /// From the centre to that point.
    off: [i32; 3],
}

/// What is nearer than this, raw world bits, is where a ray starts.
const LEAST: i32 = 1;

impl Chord {
    /// `to_centre` from the ray's start, `radius` and the result in one unit, below 2^30.
    #[inline(always)]
    fn new(to_centre: [i32; 3], direction: Unit3, radius: i32) -> Option<Self> {
        let [x, y, z] = to_centre;
        let [dx, dy, dz] = direction;
        let middle = mul_q30(x, dx)
            .saturating_add(mul_q30(y, dy))
            .saturating_add(mul_q30(z, dz));
        if middle < radius.wrapping_neg() {
            return None;
        }
        let mut off = [0; 3];
        for ((off, c), d) in off.iter_mut().zip(to_centre).zip(direction) {
            *off = mul_q30(middle, d).saturating_sub(c);
            if off.unsigned_abs() > radius.unsigned_abs() {
                return None;
            }
        }
        let off_squared: u64 = off.map(square).iter().sum();
        let left = square(radius).checked_sub(off_squared)?;
        Some(Self {
            middle,
            half: root(left) as i32,
            off,
        })
    }

    /// The ends, entering and leaving, that lie ahead.
    fn ends(&self) -> [Option<i32>; 2] {
        let (near, far) = (
            self.middle.saturating_sub(self.half),
            self.middle.saturating_add(self.half),
        );
        [near, far].map(|end| (end > LEAST).then_some(end))
    }

    /// From the centre to an end.
    fn radius_to(&self, end: i32, direction: Unit3) -> [i32; 3] {
        let along = end.saturating_sub(self.middle);
        let mut out = self.off;
        for (c, d) in out.iter_mut().zip(direction) {
            *c = c.saturating_add(mul_q30(d, along));
        }
        out
    }
}

/// An ellipsoid's space, in which it is a ball about the origin.
struct Round {
    to_centre: [i32; 3],
    direction: Unit3,
    radius: i32,
    /// Raw world bits a unit.
    unit: Scaled,
}

impl Round {
    fn new(
        actor: &RayActor,
        ray: &Ray,
        centre: [i32; 3],
        rows: &[Unit3; 3],
        exponent: u8,
    ) -> Option<Self> {
        let from = actor.place(ray.origin)?;
        let fraction = from.fraction;
        let steps = |c: i32| {
            if fraction >= 0 {
                c << fraction
            } else {
                c >> fraction.unsigned_abs()
            }
        };
        let to_centre = between(centre.map(steps), from.place);
        // 2^-up of the unit ball's radius; at most half of 2^30 in all.
        let apply = |v: [i32; 3]| {
            let [x, y, z] = v;
            rows.map(|[a, b, c]| mul_high(a, x) + mul_high(b, y) + mul_high(c, z))
        };
        let up = i32::from(exponent) + fraction - 32;
        if !(4..30).contains(&up) {
            return None;
        }
        // Q26 of the grid's direction, and rows: the length of a raw bit in there.
        let grid = actor.direction(ray.direction).map(|c| c << 1); // Q29
        let (direction, per_length) = unit(apply(grid))?;
        // The vector's unit is 2^-29 of a bit's way: in grid steps per_bit; in the
        // ball's units 2^fraction.
        let way = per_length.times(actor.step);
        Some(Self {
            to_centre: apply(to_centre),
            direction,
            radius: 1 << up,
            unit: Scaled::new(way.mantissa(), way.exponent() + 29 - fraction),
        })
    }
}

impl RayActor {
    /// Whether a ray passes by the sphere about all of this actor, or ends before it.
    #[inline(always)]
    pub(super) fn missed(&self, ray: &Ray, far: u32) -> bool {
        let to_centre = between(self.centre, ray.origin);
        let [x, y, z] = to_centre;
        let [dx, dy, dz] = ray.direction;
        let middle = mul_q30(x, dx)
            .saturating_add(mul_q30(y, dy))
            .saturating_add(mul_q30(z, dz));
        // 8 for the roundings.
        let reach = self.radius.saturating_add(8);
        if middle < reach.wrapping_neg() || i64::from(middle) - i64::from(reach) > i64::from(far) {
            return true;
        }
        let parts = to_centre.into_iter().zip(ray.direction);
        let mut off = parts.map(|(c, d)| mul_q30(middle, d).saturating_sub(c));
        off.any(|c| c.unsigned_abs() > reach.unsigned_abs())
    }

    /// The chord of a ray in a ball or an ellipsoid, with raw world bits a unit; the
    /// direction in its space.
    fn chord(&self, scene: &Scene<'_>, ray: &Ray) -> Option<(Chord, Unit3, Option<Scaled>)> {
        match self.form {
            Form::Ellipsoid => {
                let Shape::Ellipsoid {
                    centre,
                    rows,
                    exponent,
                } = scene.shape(self.mesh)
                else {
                    return None;
                };
                let round = Round::new(self, ray, centre, &rows, exponent)?;
                let chord = Chord::new(round.to_centre, round.direction, round.radius)?;
                Some((chord, round.direction, Some(round.unit)))
            }
            _ => {
                let to_centre = between(self.centre, ray.origin);
                let chord = Chord::new(to_centre, ray.direction, self.radius)?;
                Some((chord, ray.direction, None))
            }
        }
    }

    /// Where a ray meets this ball, the nearer end first.
    #[inline(never)]
    pub(super) fn meet_ball(&self, scene: &Scene<'_>, ray: &Ray, faces: Faces) -> Option<BallHit> {
        let (chord, direction, unit_bits) = self.chord(scene, ray)?;
        let ends = self.ends(&chord, ray, unit_bits);
        let shown = [faces.front, faces.back];
        let within = |distance: u32| distance >= ray.near && distance <= ray.far;
        let found = ends.into_iter().zip(shown).enumerate();
        let mut found = found.filter_map(|(which, (end, shown))| {
            let (end, distance) = end?;
            (shown && within(distance)).then_some((which, end, distance))
        });
        let (which, end, distance) = found.next()?;
        Some(BallHit {
            distance,
            to_surface: chord.radius_to(end, direction),
            back: which == 1,
        })
    }

    /// The surface there.
    #[inline(never)]
    pub(super) fn ball_surface(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        hit: &BallHit,
    ) -> Option<Surface> {
        let (normal, place) = if matches!(self.form, Form::Ellipsoid) {
            let Shape::Ellipsoid { rows, .. } = scene.shape(self.mesh) else {
                return None;
            };
            let own = unit_vector(hit.to_surface)?;
            // By the transpose of what brings places there.
            let [[a, b, c], [d, e, f], [g, h, i]] = rows;
            let [x, y, z] = own;
            let columns = [[a, d, g], [b, e, h], [c, f, i]];
            let in_grid =
                columns.map(|[a, b, c]| (mul_high(a, x) + mul_high(b, y) + mul_high(c, z)) >> 2);
            let normal = self.direction_to_world(unit_vector(in_grid)?);
            (normal.map(|c| c << 2), ray.at(hit.distance))
        } else {
            let place = plus(self.centre, hit.to_surface);
            (unit_vector(hit.to_surface)?, place)
        };
        Some(Surface {
            place,
            face: normal,
            normal,
            tint: None,
            coordinates: None,
            back: hit.back,
        })
    }

    /// How often a ray goes through this ball's surface.
    pub(super) fn count_ball(&self, scene: &Scene<'_>, ray: &Ray) -> u32 {
        let Some((chord, _, unit_bits)) = self.chord(scene, ray) else {
            return 0;
        };
        let ends = self.ends(&chord, ray, unit_bits);
        let within = |end: &Option<(i32, u32)>| {
            end.is_some_and(|(_, distance)| distance >= ray.near && distance <= ray.far)
        };
        ends.iter().filter(|end| within(end)).count() as u32
    }

    /// Both ends of a chord, in its unit and in raw world bits. A ray that starts on the
    /// ball only has the other end, if it goes inside.
    fn ends(&self, chord: &Chord, ray: &Ray, unit_bits: Option<Scaled>) -> [Option<(i32, u32)>; 2] {
        let distance = |end: i32| {
            let bits = unit_bits.map_or(end as u32, |unit| {
                unit.times(Scaled::new(end as u32, 0)).fixed(0)
            });
            (end, bits.min(FAR))
        };
        let [near, far] = chord.ends();
        if ray.on == self.number.wrapping_add(1) {
            return [None, far.filter(|_| chord.middle > 0).map(distance)];
        }
        [near, far].map(|end| end.map(distance))
    }
}
