//! What a ray meets first, and what is in its way.

use super::actor::{Form, GridPlace, RayActor};
use super::ball::BallHit;
use super::candidates::Candidates;
use super::faces::Faces;
use super::facet::{Facet, Need};
use super::grid_ray::GridRay;
use super::hierarchy::{Hierarchy, Stack};
use super::ray::Ray;
use super::rectangle::RectangleHit;
use super::surface::Surface;
use super::triangle::TriangleHit;
use super::windows::{Parallel, Windows};
use crate::math::Scaled;
use crate::scene::{Mesh, Scene};

/// The nearest that a ray meets so far. It is filled in place: it is large.
#[derive(Debug)]
pub(super) struct Met {
    /// The actor's number.
    pub actor: u16,
    /// Raw world bits along the ray.
    pub distance: u32,
    what: What,
}

#[derive(Debug)]
enum What {
    Nothing,
    Triangle(GridRay, TriangleHit),
    Ball(BallHit),
    Rectangle(RectangleHit),
}

impl Met {
    /// Nothing before `far`.
    pub(super) fn nothing(far: u32) -> Self {
        Self {
            actor: 0,
            distance: far,
            what: What::Nothing,
        }
    }

    /// Whether there is anything.
    pub(super) fn is_something(&self) -> bool {
        !matches!(self.what, What::Nothing)
    }

    /// The meshlet's number in its mesh and the triangle's in that; `None` of a ball or a
    /// rectangle.
    pub(super) fn triangle(&self) -> Option<(u32, u8)> {
        match &self.what {
            What::Triangle(_, hit) => Some((hit.meshlet, hit.triangle)),
            _ => None,
        }
    }
}

/// Parts of an actor's mesh, and what looking for the nearest in them works with.
pub(super) struct Parts<'a, 'm> {
    pub of: Candidates<'a>,
    /// Memory for what is left for later.
    pub left: &'m mut Stack,
    /// The triangle that was lit last.
    pub kept: &'m Facet,
}

impl RayActor {
    /// Where a ray first meets this actor, if that is nearer than what it met so far; `from`
    /// is the ray's start in the actor's grid. Of a mesh, it is looked for in parts.
    #[inline(always)]
    pub(super) fn meet(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        from: Option<&GridPlace>,
        parts: Parts<'_, '_>,
        best: &mut Met,
    ) {
        match self.form {
            Form::Triangles { first_node } => {
                if let Some(from) = from {
                    self.meet_triangle(scene, ray, (from, first_node), parts, best);
                }
            }
            Form::Rectangle { half, .. } => {
                if let Some(hit) = self.meet_rectangle(scene, ray, self.faces, half)
                    && hit.distance < best.distance
                {
                    best.actor = self.number;
                    best.distance = hit.distance;
                    best.what = What::Rectangle(hit);
                }
            }
            _ => {
                if let Some(hit) = self.meet_ball(scene, ray, self.faces)
                    && hit.distance < best.distance
                {
                    best.actor = self.number;
                    best.distance = hit.distance;
                    best.what = What::Ball(hit);
                }
            }
        }
    }

    /// The same of a mesh.
    #[inline(never)]
    fn meet_triangle(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        (from, first_node): (&GridPlace, u32),
        parts: Parts<'_, '_>,
        best: &mut Met,
    ) {
        let grid = GridRay::new(self, ray, from);
        let near = grid.units(self, ray.near);
        let range = (near, limit(&grid, self, best.distance));
        let hit = if parts.of.single && self.holes.is_none() {
            self.nearest_listed(scene, &grid, range, parts.of, parts.kept)
        } else {
            let mesh = scene.mesh(self.mesh);
            let tree = Hierarchy::new(scene, &mesh, first_node, self.holes);
            tree.nearest(&grid, self.faces, range, parts.of, parts.left)
        };
        let Some(hit) = hit else { return };
        let way = self.way(grid.along, grid.from.fraction);
        let distance = Scaled::new(hit.ahead.unsigned_abs(), 0).times(way).fixed(0);
        if distance < best.distance {
            best.actor = self.number;
            best.distance = distance;
            best.what = What::Triangle(grid, hit);
        }
    }

    /// The hierarchy of its mesh, which is given, if it is met by its triangles.
    pub(super) fn hierarchy<'a>(
        &self,
        scene: &'a Scene<'a>,
        mesh: &'a Mesh,
    ) -> Option<Hierarchy<'a>> {
        match self.form {
            Form::Triangles { first_node } => {
                Some(Hierarchy::new(scene, mesh, first_node, self.holes))
            }
            _ => None,
        }
    }

    /// How often a ray meets this actor; of an opaque one, whether it does.
    /// Those to a light at infinity share windows.
    pub(super) fn in_the_way(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        (windows, parallel): (&mut Windows, Option<Parallel>),
    ) -> u32 {
        let first_node = match self.form {
            Form::Triangles { first_node } => first_node,
            Form::Rectangle { half, .. } => {
                let hit = self.meet_rectangle(scene, ray, Faces::BOTH, half);
                return hit.is_some().into();
            }
            _ => return self.count_ball(scene, ray),
        };
        let opaque = self.is_opaque();
        if opaque && let Some(parallel) = parallel {
            return windows.any(self, scene, ray, parallel).into();
        }
        let mesh = scene.mesh(self.mesh);
        let tree = Hierarchy::new(scene, &mesh, first_node, self.holes);
        let Some(from) = self.place(ray.origin) else {
            return 0;
        };
        let grid = GridRay::new(self, ray, &from);
        let range = (0, grid.units(self, ray.far));
        if opaque {
            tree.any(&grid, range, &mut windows.left).into()
        } else {
            tree.count(&grid, range, &mut windows.left)
        }
    }

    /// The surface where a ray meets it; a triangle is `kept` for the next.
    #[inline(always)]
    pub(super) fn surface_at(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        met: &Met,
        (need, kept): (impl FnOnce() -> Need, &mut Facet),
    ) -> Option<Surface> {
        match &met.what {
            What::Nothing => None,
            What::Triangle(grid, hit) => self.surface(scene, ray, (grid, hit), need(), kept),
            What::Ball(hit) => self.ball_surface(scene, ray, hit),
            What::Rectangle(hit) => Some(self.rectangle_surface(scene, hit)),
        }
    }

    /// Whether it is met as a ball or a rectangle: a ray that starts on it is told so.
    pub(super) fn is_exact(&self) -> bool {
        !matches!(self.form, Form::Triangles { .. })
    }

    /// Whether no light goes through its surface.
    pub(super) fn is_opaque(&self) -> bool {
        self.optics.opacity >= 1 << 16
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
