//! The triangles of a hierarchy's leaves: what a ray meets of them.

use super::actor::GridPlace;
use super::grid_ray::GridRay;
use super::hierarchy::Hierarchy;
use super::holes::is_hole;
use super::surface::coordinates;
use super::triangle::{Faces, Points, TriangleHit, meet};
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
    /// The corners of a leaf's triangles as they are off a place, with their numbers.
    #[inline(always)]
    pub(super) fn corners(
        &self,
        leaf: Leaf,
        from: &GridPlace,
    ) -> impl Iterator<Item = (u8, [[i32; 3]; 3])> {
        let words = self.meshlets.get(leaf.meshlet as usize);
        let meshlet = words.map(Meshlet::from_words);
        let points = meshlet.map(|meshlet| Points::new(self.scene, self.mesh, meshlet));
        let numbers = leaf.first..leaf.first.saturating_add(leaf.count);
        points.into_iter().flat_map(move |points| {
            numbers.clone().map(move |number| {
                let corners = points.corners(number);
                (number, corners.map(|corner| from.off(points.place(corner))))
            })
        })
    }

    /// The nearest of some triangles that a ray meets within a range.
    #[inline(always)]
    pub(super) fn nearest_of(
        &self,
        ray: &GridRay,
        faces: Faces,
        range: (i32, i32),
        triangles: impl Iterator<Item = (u32, u8)>,
    ) -> Option<TriangleHit> {
        self.some(ray, faces, range, Wanted::Nearest, triangles)
            .nearest
    }

    /// Whether a ray meets any of some triangles.
    #[inline(always)]
    pub(super) fn any_of(
        &self,
        ray: &GridRay,
        range: (i32, i32),
        triangles: impl Iterator<Item = (u32, u8)>,
    ) -> bool {
        let way = self.some(ray, Faces::BOTH, range, Wanted::Any, triangles);
        way.count != 0
    }

    /// What is met of some triangles.
    #[inline(always)]
    fn some(
        &self,
        ray: &GridRay,
        faces: Faces,
        range: (i32, i32),
        wanted: Wanted,
        triangles: impl Iterator<Item = (u32, u8)>,
    ) -> Way {
        let mut way = Way::new(faces, range);
        for (meshlet, first) in triangles {
            let leaf = Leaf {
                meshlet,
                first,
                count: 1,
            };
            self.leaf(ray, leaf, wanted, &mut way);
            if wanted == Wanted::Any && way.count != 0 {
                break;
            }
        }
        way
    }

    #[inline(always)]
    pub(super) fn leaf(&self, ray: &GridRay, leaf: Leaf, wanted: Wanted, way: &mut Way) {
        let Some(words) = self.meshlets.get(leaf.meshlet as usize) else {
            return;
        };
        let points = Points::new(self.scene, self.mesh, Meshlet::from_words(words));
        for triangle in leaf.first..leaf.first.saturating_add(leaf.count) {
            let number = (leaf.meshlet, triangle);
            let Some(hit) = meet(ray, &points, number, way.faces, way.range) else {
                continue;
            };
            if let Some(texture) = self.holes
                && self.is_hole(texture, &points, &hit)
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
    /// Whether a ray meets a triangle where its texture is cut out.
    #[cold]
    #[inline(never)]
    fn is_hole(&self, texture: u8, points: &Points<'_>, hit: &TriangleHit) -> bool {
        let corners = points.corners(hit.triangle);
        let found = coordinates(self.scene, self.mesh, &points.meshlet, corners, hit.weights);
        found.is_some_and(|place| is_hole(self.scene, self.mesh, texture, place))
    }
}
