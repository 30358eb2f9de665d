//! A ray and single triangles of a tile's list.

use super::actor::{GridPlace, RayActor};
use super::candidates::Candidates;
use super::facet::Facet;
use super::grid_ray::{AXES, GridRay};
use super::triangle::{Corners, Points, TriangleHit, meet_corners};
use crate::scene::{Child, Meshlet, Record, Scene};

impl RayActor {
    /// The nearest of some of its triangles that a ray meets within a range; the last that was
    /// lit is `kept`.
    #[inline(always)]
    pub(super) fn nearest_listed(
        &self,
        scene: &Scene<'_>,
        grid: &GridRay,
        (near, mut far): (i32, i32),
        listed: Candidates<'_>,
        kept: &Facet,
    ) -> Option<TriangleHit> {
        let mut nearest: Option<TriangleHit> = None;
        for word in listed {
            let Child::Leaf(leaf) = Child::from_word(word.to_le()) else {
                continue;
            };
            let number = (leaf.meshlet, leaf.first);
            let range = (near, far);
            let hit = match grid.axes {
                [.., 0] => self.meet_one::<0>(scene, grid, number, range, kept),
                [.., 1] => self.meet_one::<1>(scene, grid, number, range, kept),
                _ => self.meet_one::<2>(scene, grid, number, range, kept),
            };
            if let Some(hit) = hit
                && nearest.is_none_or(|best| hit.before(&best))
            {
                far = hit.ahead;
                nearest = Some(hit);
            }
        }
        nearest
    }

    /// Where a ray, whose third axis is known to the compiler, meets one of its triangles. A
    /// function of its own: in a loop, signs of slopes would be taken out of it, and products
    /// take twice as long.
    #[inline(never)]
    fn meet_one<const THIRD: usize>(
        &self,
        scene: &Scene<'_>,
        grid: &GridRay,
        number: (u32, u8),
        range: (i32, i32),
        kept: &Facet,
    ) -> Option<TriangleHit> {
        let corners = match kept.corners_off(self, number, &grid.from) {
            Some(corners) => corners,
            None => self.corners_of(scene, number, &grid.from)?,
        };
        let axes = AXES.get(THIRD).copied().unwrap_or(grid.axes);
        let grid = &GridRay { axes, ..*grid };
        meet_corners(grid, &corners, number, self.faces, range)
    }

    /// The corners of one of its triangles as they are off a place in its grid.
    #[inline(always)]
    fn corners_of(
        &self,
        scene: &Scene<'_>,
        (meshlet, triangle): (u32, u8),
        from: &GridPlace,
    ) -> Option<Corners> {
        let mesh = scene.mesh(self.mesh);
        let words = scene.meshlets_of(&mesh).get(meshlet as usize)?;
        let points = Points::new(scene, &mesh, Meshlet::from_words(words), from);
        Some(points.triangle(triangle))
    }
}
