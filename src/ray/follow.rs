//! The rays that go on from a surface, by an explicit stack of those that wait (Whitted,
//! "An improved illumination model for shaded display", 1980).

use super::light::Seed;
use super::nearest::Met;
use super::ray::{FAR, Ray, moved};
use super::trace::{Local, OF_OTHERS, ONE, Tracer};
use super::waiting::Waiting;
use crate::light::Lit;
use crate::math::{Unit3, dot};
use crate::scene::Optics;

/// Rays of less weight show nothing: an eighth of a level.
const LEAST: u32 = 1 << 5;

impl Tracer<'_> {
    /// The colour of a surface and of all rays that go on from it.
    #[inline(never)]
    pub(super) fn go_on(&mut self, ray: &Ray, local: &Local, met: &Met, seed: Seed) -> Lit {
        let mut sums = [0; 3];
        let first = Waiting {
            origin: ray.origin,
            direction: ray.direction,
            weight: ONE,
            on: ray.on,
            left: self.settings.depth,
        };
        self.waiting.clear();
        self.add(&first, local, met, &mut sums);
        while let Some(now) = self.waiting.pop() {
            let ray = Ray {
                on: now.on,
                ..Ray::from_to(now.origin, now.direction, FAR)
            };
            let mut met = Met::nothing(FAR);
            if now.left != 0 {
                self.nearest(&ray, &mut met);
            }
            if !met.is_something() {
                self.add_background(now.direction, now.weight, &mut sums);
                continue;
            }
            if let Some(local) = &self.local(&ray, &met, seed, OF_OTHERS) {
                self.add(&now, local, &met, &mut sums);
            }
        }
        sums.map(|c| ((c + (1 << 15)) >> 16).min(255 << 6) as u16)
    }

    /// Adds the colour of a surface by itself; the rays that go on from it wait.
    #[inline(never)]
    fn add(&mut self, now: &Waiting, local: &Local, met: &Met, sums: &mut [u32; 3]) {
        let actor = met.actor;
        let optics = self.actors.get(actor).map_or(Optics::PLAIN, |a| a.optics);
        let part = |weight: u32, of: u32| (weight * (of >> 1)) >> 15;
        let mut mirror = part(now.weight, optics.reflectivity);
        let rest = now.weight - mirror.min(now.weight);
        let own = part(rest, optics.opacity);
        let mut through = rest - own.min(rest);
        if own != 0 {
            add(sums, self.colour(local), own);
        }
        let Some((facing, place, back)) = &local.facing else {
            return;
        };
        let Some(which) = self.actors.get(actor) else {
            return;
        };
        let (lift, ball) = (which.lift(met.distance), which.is_exact());
        let waiting = &mut *self.waiting;
        let mut push = |direction: Unit3, weight: u32, out: bool| {
            if weight < LEAST {
                return;
            }
            let outward = facing.outward();
            waiting.push(Waiting {
                origin: moved(*place, outward, if out { lift } else { -lift }),
                direction,
                weight,
                on: if ball { actor + 1 } else { 0 },
                left: now.left - 1,
            });
        };
        if through > 0 {
            if optics.index == ONE {
                push(now.direction, through, false);
            } else {
                // Q28 of the index on this side over that beyond.
                let ratio = if *back {
                    (optics.index << 12) as i32
                } else {
                    inverse(optics.index)
                };
                match facing.refracted(now.direction, ratio) {
                    Some((way, mirrored)) => {
                        let mirrored = part(through, mirrored.min(ONE));
                        through -= mirrored.min(through);
                        mirror += mirrored;
                        push(way, through, false);
                    }
                    None => mirror += through,
                }
            }
        }
        if mirror > 0 {
            push(facing.mirrored(now.direction), mirror, true);
        }
    }

    /// What a ray shows that meets nothing.
    fn add_background(&self, direction: Unit3, weight: u32, sums: &mut [u32; 3]) {
        let up = dot(direction, self.settings.up).clamp(-(1 << 30), 1 << 30);
        // From top to bottom.
        let down = (1u32 << 30).wrapping_sub(up as u32) >> 15;
        // Its ends are entries as they are, what is between them need not be.
        let [top, bottom] = self.background.ends().map(|index| self.entry(index));
        let mut colour = top;
        for (c, bottom) in colour.iter_mut().zip(bottom) {
            *c = (((0x1_0000 - down) * u32::from(*c) + down * u32::from(bottom)) >> 16) as u16;
        }
        add(sums, colour, weight);
    }
}

fn add(sums: &mut [u32; 3], colour: Lit, weight: u32) {
    for (sum, c) in sums.iter_mut().zip(colour) {
        // 14 bits and 17; weights are 1 in all.
        *sum = sum.saturating_add(u32::from(c) * weight);
    }
}

/// Q28 of one over a refractive index.
fn inverse(index: u32) -> i32 {
    let recip = crate::math::reciprocal(index);
    // 62 - shift fractional bits, 16 of the index.
    recip.mantissa >> (18 - recip.shift.min(18))
}
