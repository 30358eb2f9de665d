//! One actor in one frame, as rays meet it.

use super::faces::Faces;
use super::ray::between;
use crate::math::{Scaled, Unit3, leading_zeros, mul_high, scaled_reciprocal};
use crate::scene::{Actor, Cull, Node, Optics, Place, Record, Scene, Shape};
use crate::view::ModelFrame;

/// Where an actor is, and what of it rays meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayActor {
    /// The actor's number.
    pub number: u16,
    pub mesh: u16,
    pub material: u16,
    /// World to grid directions, rows of Q30 entries.
    pub to_grid: [Unit3; 3],
    /// The middle of the grid, or of the ball, raw world bits.
    pub centre: [i32; 3],
    /// A sphere about the centre holds all of it; of a ball, its radius. Raw world bits;
    /// 0: there is nothing.
    pub radius: i32,
    /// Raw world bits a grid step.
    pub step: Scaled,
    /// Grid steps a raw world bit.
    pub per_bit: Scaled,
    pub form: Form,
    /// What of it a ray from the camera sees.
    pub faces: Faces,
    pub optics: Optics,
    /// The texture that it is cut out by, if it is.
    pub holes: Option<u8>,
}

/// What rays meet of an actor: a [`Shape`] without what is looked up where it is needed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    Triangles {
        first_node: u32,
    },
    Ball,
    /// What brings it to the unit ball stays in the scene.
    Ellipsoid,
    Rectangle {
        /// Half its sides, raw world bits.
        half: [u32; 2],
        against: [bool; 3],
    },
}

/// A place in an actor's grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct GridPlace {
    /// In `2^-fraction` grid steps from the middle of the grid; below 2^29.
    pub place: [i32; 3],
    /// The closer to the grid, the more: -20..=8.
    pub fraction: i32,
}

impl GridPlace {
    /// How far a place, in grid steps, is off this one, in its units.
    #[inline(always)]
    pub(super) fn off(&self, steps: [i32; 3]) -> [i32; 3] {
        let left = self.fraction.max(0) as u32;
        let right = self.fraction.wrapping_neg().max(0) as u32;
        let mut off = steps;
        for (c, own) in off.iter_mut().zip(self.place) {
            *c = (c.wrapping_shl(left) >> right.min(31)).wrapping_sub(own);
        }
        off
    }
}

impl RayActor {
    /// All zero: a frame begins by saying whose each is.
    pub(super) const EMPTY: Self = Self {
        number: 0,
        mesh: 0,
        material: 0,
        to_grid: [[0; 3]; 3],
        centre: [0; 3],
        radius: 0,
        step: Scaled::ZERO,
        per_bit: Scaled::ZERO,
        form: Form::Triangles { first_node: 0 },
        faces: Faces {
            front: false,
            back: false,
        },
        optics: Optics {
            reflectivity: 0,
            opacity: 0,
            index: 0,
        },
        holes: None,
    };

    /// Actor `number` of a scene, which is at `place`.
    pub(super) fn new(scene: &Scene<'_>, number: u16, actor: &Actor, place: &Place) -> Self {
        let model = ModelFrame::new(actor, place);
        let (step, per_bit) = model.scales();
        let mut centre = model.centre().to_bits();
        let to_grid = model.world_to_model().rows;
        let (form, steps) = match scene.shape(actor.mesh) {
            Shape::Triangles { first_node, nodes } => {
                let radius = Scaled::new(scene.mesh(actor.mesh).radius, 0);
                let steps = if nodes == 0 { Scaled::ZERO } else { radius };
                (Form::Triangles { first_node }, steps)
            }
            Shape::Ball {
                centre: middle,
                radius,
            } => {
                centre = plus(centre, turned(&to_grid, &step, middle));
                (Form::Ball, Scaled::new(radius, -8))
            }
            Shape::Ellipsoid { .. } => {
                let radius = Scaled::new(scene.mesh(actor.mesh).radius, 0);
                (Form::Ellipsoid, radius)
            }
            Shape::Rectangle {
                centre: middle,
                mut half,
                against,
            } => {
                centre = plus(centre, turned(&to_grid, &step, middle));
                let mut all = Scaled::ZERO;
                for side in &mut half {
                    let own = Scaled::new(*side, -8);
                    all = all.plus(own);
                    *side = own.times(step).fixed(0).min(1 << 30);
                }
                // The sum of both is no less than half the diagonal.
                (Form::Rectangle { half, against }, all)
            }
        };
        let radius = steps.times(step);
        let optics = scene.optics(actor.material);
        let material = scene.material(actor.material);
        let cull = material.cull;
        let is_cut_out = |number: &u8| scene.texture(*number).is_some_and(|t| t.cut_out);
        let glass = optics.opacity < 1 << 16;
        let faces = Faces {
            front: glass || cull != Cull::Front,
            back: glass || cull != Cull::Back,
        };
        Self {
            number,
            mesh: actor.mesh,
            material: actor.material,
            to_grid,
            centre,
            radius: radius.plus(Scaled::new(1, -1)).fixed(0).min(1 << 30) as i32
                * i32::from(steps != Scaled::ZERO),
            step,
            per_bit,
            form,
            faces,
            optics,
            holes: material.texture.filter(is_cut_out),
        }
    }

    /// A place of the world in the grid; `None` if it is so far away that the actor
    /// is smaller than any pixel.
    pub(super) fn place(&self, world: [i32; 3]) -> Option<GridPlace> {
        let off = between(world, self.centre);
        let bits = off.iter().fold(1, |m, c| m | c.unsigned_abs());
        let up = leading_zeros(bits) as i32 - 1;
        let off = if up >= 0 {
            off.map(|c| c << up)
        } else {
            off.map(|c| c >> 1)
        };
        // 2^(up - 2) of a raw bit.
        let turned = self.direction(off);
        let half = (self.per_bit.mantissa() >> 1) as i32;
        // Grid steps are this times 2^exponent.
        let steps = turned.map(|c| mul_high(c, half));
        let exponent = self.per_bit.exponent() + 35 - up;
        let fraction = exponent.wrapping_neg().min(8);
        if fraction < -20 {
            return None;
        }
        let down = (-(exponent + fraction)).clamp(0, 31);
        Some(GridPlace {
            place: steps.map(|c| c >> down),
            fraction,
        })
    }

    /// A vector of the world in the grid's directions, divided by 4.
    #[inline(always)]
    pub(super) fn direction(&self, world: [i32; 3]) -> [i32; 3] {
        let [x, y, z] = world;
        self.to_grid
            .map(|[a, b, c]| mul_high(a, x) + mul_high(b, y) + mul_high(c, z))
    }

    /// A vector of the grid in the world's directions, divided by 4.
    #[inline(always)]
    pub(super) fn direction_to_world(&self, grid: [i32; 3]) -> [i32; 3] {
        to_world(&self.to_grid, grid)
    }

    /// A vector in `2^-fraction` grid steps, below 2^30, in raw world bits.
    pub(super) fn vector_to_world(&self, vector: [i32; 3], fraction: i32) -> [i32; 3] {
        // A quarter, with the length of a step still to come.
        let turned = self.direction_to_world(vector);
        let half = (self.step.mantissa() >> 1) as i32;
        let up = self.step.exponent() + 35 - fraction;
        turned.map(|c| {
            let c = mul_high(c, half);
            if up >= 0 {
                c.saturating_mul(1 << up.min(30))
            } else {
                c >> up.wrapping_neg().min(31)
            }
        })
    }

    /// The corners of a box around all triangles, raw world bits.
    pub(super) fn corners(&self, scene: &Scene<'_>) -> Option<[[i32; 3]; 8]> {
        let first_node = match self.form {
            Form::Triangles { first_node } => first_node,
            Form::Rectangle { half, .. } => return Some(self.rectangle_corners(half)),
            _ => return None,
        };
        let node = Node::from_words(scene.nodes_from(first_node).first()?);
        let high = node
            .sides
            .map(|[_, high]| high.into_iter().fold(0, u8::max));
        let mut far = node.origin;
        for (c, high) in far.iter_mut().zip(high) {
            *c += i32::from(high) << node.exponent.min(15);
        }
        let ([x0, y0, z0], [x1, y1, z1]) = (node.origin, far);
        let corners = [
            [x0, y0, z0],
            [x1, y0, z0],
            [x0, y1, z0],
            [x1, y1, z0],
            [x0, y0, z1],
            [x1, y0, z1],
            [x0, y1, z1],
            [x1, y1, z1],
        ];
        Some(corners.map(|corner| plus(self.centre, turned(&self.to_grid, &self.step, corner))))
    }

    /// What a place on its surface may be off, raw world bits.
    pub(super) fn roughness(&self) -> u32 {
        self.step.shifted(2).fixed(0).min(1 << 24)
    }

    /// Raw bits of the way along a ray a `2^-fraction` grid step of one axis, on which
    /// the direction's component is `along` (Q28).
    pub(super) fn way(&self, along: i32, fraction: i32) -> Scaled {
        let along = scaled_reciprocal(Scaled::new(along.unsigned_abs(), -28));
        along.times(self.step).shifted(-fraction)
    }
}

fn to_world(to_grid: &[Unit3; 3], [x, y, z]: [i32; 3]) -> [i32; 3] {
    let [[a, b, c], [d, e, f], [g, h, i]] = *to_grid;
    [[a, d, g], [b, e, h], [c, f, i]]
        .map(|[a, b, c]| mul_high(a, x) + mul_high(b, y) + mul_high(c, z))
}

/// Whole grid steps in raw world bits.
fn turned(to_grid: &[Unit3; 3], step: &Scaled, [x, y, z]: [i32; 3]) -> [i32; 3] {
    // 22 bits and a sign: 7 more for the products.
    let turned = to_world(to_grid, [x, y, z].map(|c| c.wrapping_shl(7)));
    turned.map(|c| {
        let sign = c.signum();
        let length = Scaled::new(c.unsigned_abs(), -5).times(*step);
        sign * length.fixed(0).min(1 << 30) as i32
    })
}

pub(super) fn plus([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i32; 3] {
    [
        ax.saturating_add(bx),
        ay.saturating_add(by),
        az.saturating_add(bz),
    ]
}
