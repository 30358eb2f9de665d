//! The triangles of a hierarchy's leaves: what a ray meets of them.

use super::actor::GridPlace;
use super::faces::Faces;
use super::grid_ray::{AXES, GridRay};
use super::hierarchy::Hierarchy;
use super::holes::is_hole;
use super::surface::coordinates;
use super::triangle::{Corners, Points, TriangleHit, meet};
use crate::scene::{Leaf, Meshlet, Record};

/// What is wanted of a way through a hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    Nearest,
    Any,
    Count,
}

/// The way so far.
pub(super) struct Way {
    /// The nearest triangle.
    pub nearest: Option<TriangleHit>,
    /// How many there are.
    pub count: u32,
    /// Between which distances.
    pub range: (i32, i32),
    faces: Faces,
}

impl Way {
    pub(super) fn new(faces: Faces, range: (i32, i32)) -> Self {
        Self {
            nearest: None,
            count: 0,
            range,
            faces,
        }
    }
}

impl Hierarchy<'_> {
    /// Hands on the corners of a leaf's triangles as they are off a place, with their numbers;
    /// `false` if `each` said so, and then ended there.
    #[inline(always)]
    pub(super) fn each_triangle(
        &self,
        leaf: Leaf,
        from: &GridPlace,
        mut each: impl FnMut(u8, &Corners) -> bool,
    ) -> bool {
        let Some(words) = self.meshlets.get(leaf.meshlet as usize) else {
            return true;
        };
        let points = Points::new(self.scene, self.mesh, Meshlet::from_words(words), from);
        let mut numbers = leaf.first..leaf.first.saturating_add(leaf.count);
        numbers.all(|number| each(number, &points.triangle(number)))
    }

    /// Whether a ray meets any of some triangles.
    #[inline(always)]
    pub(super) fn any_of(
        &self,
        ray: &GridRay,
        range: (i32, i32),
        triangles: impl Iterator<Item = (u32, u8)>,
    ) -> bool {
        match ray.axes {
            [.., 0] => self.any_along_of::<0>(ray, range, triangles),
            [.., 1] => self.any_along_of::<1>(ray, range, triangles),
            _ => self.any_along_of::<2>(ray, range, triangles),
        }
    }

    /// The same of a ray whose third axis is known to the compiler.
    #[inline(never)]
    fn any_along_of<const THIRD: usize>(
        &self,
        ray: &GridRay,
        range: (i32, i32),
        triangles: impl Iterator<Item = (u32, u8)>,
    ) -> bool {
        let axes = AXES.get(THIRD).copied().unwrap_or(ray.axes);
        let ray = &GridRay { axes, ..*ray };
        // The meshlet of the last one: neighbours mostly have the same.
        let mut last = None;
        for number in triangles {
            let (meshlet, _) = number;
            if last.is_none_or(|(known, _)| known != meshlet) {
                let Some(words) = self.meshlets.get(meshlet as usize) else {
                    continue;
                };
                let points =
                    Points::new(self.scene, self.mesh, Meshlet::from_words(words), &ray.from);
                last = Some((meshlet, points));
            }
            let Some((_, points)) = &last else { continue };
            let Some(hit) = meet(ray, points, number, Faces::BOTH, range) else {
                continue;
            };
            let hole = self
                .holes
                .is_some_and(|texture| self.is_hole(texture, ray, &hit));
            if !hole {
                return true;
            }
        }
        false
    }

    /// What a ray meets of a leaf's triangles.
    #[inline(always)]
    pub(super) fn leaf(&self, ray: &GridRay, leaf: Leaf, wanted: Wanted, way: &mut Way) {
        let Some(words) = self.meshlets.get(leaf.meshlet as usize) else {
            return;
        };
        let meshlet = Meshlet::from_words(words);
        let points = Points::new(self.scene, self.mesh, meshlet, &ray.from);
        for triangle in leaf.first..leaf.first.saturating_add(leaf.count) {
            let number = (leaf.meshlet, triangle);
            let Some(hit) = meet(ray, &points, number, way.faces, way.range) else {
                continue;
            };
            if let Some(texture) = self.holes
                && self.is_hole(texture, ray, &hit)
            {
                continue;
            }
            way.count += 1;
            if wanted == Wanted::Nearest && way.nearest.is_none_or(|best| hit.before(&best)) {
                way.range.1 = hit.ahead;
                way.nearest = Some(hit);
            }
        }
    }

    /// Whether a ray meets a triangle where its texture is cut out. It looks the meshlet up anew:
    /// handed over, all of it would be written to memory for every leaf.
    #[cold]
    #[inline(never)]
    fn is_hole(&self, texture: u8, ray: &GridRay, hit: &TriangleHit) -> bool {
        let Some(words) = self.meshlets.get(hit.meshlet as usize) else {
            return false;
        };
        let meshlet = Meshlet::from_words(words);
        let corners = Points::new(self.scene, self.mesh, meshlet, &ray.from).corners(hit.triangle);
        let found = coordinates(self.scene, self.mesh, &meshlet, corners, hit.weights);
        found.is_some_and(|place| is_hole(self.scene, self.mesh, texture, place))
    }
}
