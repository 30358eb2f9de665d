//! Which of a mesh's levels of detail does for an actor in a frame.

use super::ActorView;
use crate::scene::{Mesh, Scene};

impl ActorView {
    /// Takes the coarsest of the mesh's levels whose surface is seen less than the scene's
    /// bound off the mesh's, wherever it is: as large as its error would be where the level
    /// is nearest to the eye. So from farther away it never takes a finer one. Each level is
    /// asked in turn, by its own meshlets, which costs what the level is large.
    #[inline(never)]
    pub(super) fn choose_level(&mut self, scene: &Scene<'_>) {
        let [x, y] = self.side_lengths.map(i64::from);
        let bound = i64::from(scene.header().level_error);
        let (first, count) = self.mesh.levels;
        for number in (first..first.saturating_add(count.into())).rev() {
            let level = scene.mesh(number);
            // In clip units, rounded up.
            let error = ((i64::from(level.error) * x.max(y)) >> self.row_fraction) + 1;
            let nearest = self.nearest(scene, &level).saturating_sub(error);
            if error <= self.side_at(bound, nearest.max(self.near.into())) {
                self.mesh = level;
                return;
            }
        }
    }

    /// The least distance that a mesh's vertices may have, in clip units.
    fn nearest(&self, scene: &Scene<'_>, mesh: &Mesh) -> i64 {
        let ([_, _, row], [_, _, constant]) = (self.rows, self.constants);
        let [_, _, length] = self.row_lengths.map(i64::from);
        let meshlets = mesh.first_meshlet..mesh.first_meshlet.saturating_add(mesh.meshlets);
        let nearest = meshlets.filter_map(|number| {
            let meshlet = scene.meshlet(number)?;
            let along = row.into_iter().zip(meshlet.base);
            let along = along.map(|(c, base)| i64::from(c) * i64::from(base));
            let reach = i64::from(meshlet.radius_steps()) * length;
            Some(
                along
                    .fold(constant, i64::saturating_add)
                    .saturating_sub(reach),
            )
        });
        nearest.min().unwrap_or(constant) >> self.row_fraction
    }
}
