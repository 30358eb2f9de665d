//! The triangles of a hierarchy's leaves: what a ray meets of them.

use super::actor::GridPlace;
use super::gather::Candidates;
use super::grid_ray::{AXES, GridRay};
use super::hierarchy::Hierarchy;
use super::holes::is_hole;
use super::surface::coordinates;
use super::triangle::{Corners, Faces, Points, TriangleHit, meet, meet_corners};
use crate::scene::{Child, Leaf, Meshlet, Record};

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

    /// The nearest of some triangles that a ray meets within a range, whose corners are given.
    #[inline(never)]
    pub(super) fn nearest_of(
        &self,
        ray: &GridRay,
        faces: Faces,
        range: (i32, i32),
        triangles: Candidates<'_>,
    ) -> Option<TriangleHit> {
        let way = Way::new(faces, range);
        match ray.axes {
            [.., 0] => self.nearest_along::<0>(ray, way, triangles),
            [.., 1] => self.nearest_along::<1>(ray, way, triangles),
            _ => self.nearest_along::<2>(ray, way, triangles),
        }
    }

    /// The same of a ray whose third axis is known to the compiler.
    #[inline(always)]
    fn nearest_along<const THIRD: usize>(
        &self,
        ray: &GridRay,
        mut way: Way,
        triangles: Candidates<'_>,
    ) -> Option<TriangleHit> {
        let axes = AXES.get(THIRD).copied().unwrap_or(ray.axes);
        let ray = &GridRay { axes, ..*ray };
        for (word, corners) in triangles.triangles() {
            let Child::Leaf(leaf) = Child::from_word(word.to_le()) else {
                continue;
            };
            let number = (leaf.meshlet, leaf.first);
            if let Some(hit) = meet_corners(ray, corners, number, way.faces, way.range)
                && way.nearest.is_none_or(|best| hit.before(&best))
                && !self.is_through(ray, &hit)
            {
                way.range.1 = hit.ahead;
                way.nearest = Some(hit);
            }
        }
        way.nearest
    }

    /// Whether a ray meets a triangle where its texture is cut out, if there is one.
    #[inline(always)]
    fn is_through(&self, ray: &GridRay, hit: &TriangleHit) -> bool {
        self.holes.is_some_and(|texture| {
            let words = self.meshlets.get(hit.meshlet as usize);
            let meshlet = words.map(Meshlet::from_words);
            let points = meshlet.map(|own| Points::new(self.scene, self.mesh, own, &ray.from));
            points.is_some_and(|points| self.is_hole(texture, &points, hit))
        })
    }

    /// Whether a ray meets any of some triangles.
    #[inline(always)]
    pub(super) fn any_of(
        &self,
        ray: &GridRay,
        range: (i32, i32),
        triangles: impl Iterator<Item = (u32, u8)>,
    ) -> bool {
        let mut way = Way::new(Faces::BOTH, range);
        for (meshlet, first) in triangles {
            let leaf = Leaf {
                meshlet,
                first,
                count: 1,
            };
            self.leaf(ray, leaf, Wanted::Any, &mut way);
            if way.count != 0 {
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
