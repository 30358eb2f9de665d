//! What a ray meets first, and what is in its way.

use super::actor::{GridPlace, RayActor};
use super::ball::BallHit;
use super::gather::Candidates;
use super::grid_ray::GridRay;
use super::hierarchy::Hierarchy;
use super::ray::Ray;
use super::rectangle::RectangleHit;
use super::surface::{Need, Surface};
use super::triangle::{Faces, TriangleHit};
use super::windows::Windows;
use crate::math::Scaled;
use crate::scene::{Scene, Shape};

/// What a ray meets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Met {
    /// Raw world bits along the ray.
    pub distance: u32,
    what: What,
}

#[derive(Clone, Copy, Debug)]
enum What {
    Triangle(GridRay, TriangleHit),
    Ball(BallHit),
    Rectangle(RectangleHit),
}

impl Met {
    /// The meshlet's number in its mesh and the triangle's in that; `None` of a ball or a
    /// rectangle.
    pub(super) fn triangle(&self) -> Option<(u32, u8)> {
        match &self.what {
            What::Triangle(_, hit) => Some((hit.meshlet, hit.triangle)),
            _ => None,
        }
    }
}

impl RayActor {
    /// Where a ray first meets this actor, nearer than `far`; `from` is the ray's start
    /// in the actor's grid, `only` the triangles that it may meet, where that is known. What
    /// of its triangles is nearer than `near` is not met.
    #[inline(always)]
    pub(super) fn meet(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        from: Option<GridPlace>,
        (near, far): (u32, u32),
        only: Option<Candidates<'_>>,
    ) -> Option<Met> {
        let first_node = match self.shape {
            Shape::Triangles { first_node, .. } => first_node,
            Shape::Rectangle { half, .. } => {
                let hit = self.meet_rectangle(scene, ray, self.faces, half)?;
                return (hit.distance < far).then_some(Met {
                    distance: hit.distance,
                    what: What::Rectangle(hit),
                });
            }
            _ => {
                let ball = self.meet_ball(ray, self.faces)?;
                return (ball.distance < far).then_some(Met {
                    distance: ball.distance,
                    what: What::Ball(ball),
                });
            }
        };
        if only.is_some_and(|only| !only.any(self.number)) {
            return None;
        }
        let grid = GridRay::new(self, ray, from?);
        let mesh = scene.mesh(self.mesh);
        let tree = Hierarchy::new(scene, &mesh, first_node, self.holes);
        let near = grid.units(self, near);
        let hit = match only {
            Some(only) => {
                let triangles = only.of(self.number);
                // Of the nearest, what is too far is seen below.
                tree.nearest_of(&grid, self.faces, (near, i32::MAX), triangles)?
            }
            None => {
                let range = (near, limit(&grid, self, far));
                tree.nearest(&grid, self.faces, range)?
            }
        };
        let way = self.way(grid.along, grid.from.fraction);
        let distance = Scaled::new(hit.ahead.unsigned_abs(), 0).times(way).fixed(0);
        (distance < far).then_some(Met {
            distance,
            what: What::Triangle(grid, hit),
        })
    }

    /// How often a ray meets this actor; of an opaque one, whether it does.
    /// Those to a light at infinity, whose number is given, share windows.
    pub(super) fn in_the_way(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        parallel: Option<(&mut Windows, u8)>,
    ) -> u32 {
        let first_node = match self.shape {
            Shape::Triangles { first_node, .. } => first_node,
            Shape::Rectangle { half, .. } => {
                let hit = self.meet_rectangle(scene, ray, Faces::BOTH, half);
                return hit.is_some().into();
            }
            _ => return self.count_ball(ray),
        };
        let Some(from) = self.place(ray.origin) else {
            return 0;
        };
        let grid = GridRay::new(self, ray, from);
        let mesh = scene.mesh(self.mesh);
        let tree = Hierarchy::new(scene, &mesh, first_node, self.holes);
        let range = (0, grid.units(self, ray.far));
        if self.optics.opacity < 1 << 16 {
            tree.count(&grid, range)
        } else if let Some((windows, light)) = parallel {
            let key = (self.number, light);
            windows.any(&tree, key, &grid).into()
        } else {
            tree.any(&grid, range).into()
        }
    }

    /// The surface where a ray meets it.
    pub(super) fn surface_at(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        met: &Met,
        need: Need,
    ) -> Option<Surface> {
        match &met.what {
            What::Triangle(grid, hit) => self.surface(scene, ray, grid, hit, need),
            What::Ball(ball) => Some(Surface {
                place: ball.place,
                face: ball.normal,
                normal: ball.normal,
                tint: None,
                coordinates: None,
                back: ball.back,
            }),
            What::Rectangle(hit) => Some(self.rectangle_surface(scene, hit)),
        }
    }

    /// Whether it is met as a ball or a rectangle: a ray that starts on it is told so.
    pub(super) fn is_exact(&self) -> bool {
        !matches!(self.shape, Shape::Triangles { .. })
    }

    /// How far from its surface a ray has to start that shall not meet it again: what
    /// roundings take, raw world bits. Of a distance, they took up to 2^-23: three
    /// products and a shift of 28 bits, and a turn that comes from several.
    pub(super) fn lift(&self, distance: u32) -> i32 {
        let lift = 32 + self.roughness() + (distance >> 22);
        lift as i32
    }
}

/// A distance in the units of the third axis, rounded up by what it may be off.
fn limit(grid: &GridRay, actor: &RayActor, far: u32) -> i32 {
    let units = grid.units(actor, far);
    units.saturating_add((units >> 24) + 4)
}
