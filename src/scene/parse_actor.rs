//! Checks of actors.

use super::range::{count, last, range};
use super::{Actor, Field, Record, Scene, SceneError, Section, Shading, layout};

impl Scene<'_> {
    pub(super) fn check_actors(&self) -> Result<(), SceneError> {
        count(Section::Actors, self.actors.len(), 0, 65535)?;
        for (i, words) in self.actors.iter().enumerate() {
            let actor = Actor::from_words(words);
            let (meshes, materials) = (self.meshes.len(), self.materials.len());
            range(
                Section::Actors,
                i,
                Field::Mesh,
                actor.mesh.into(),
                0,
                last(meshes, 1),
            )?;
            range(
                Section::Actors,
                i,
                Field::Material,
                actor.material.into(),
                0,
                last(materials, 1),
            )?;
            let mantissa = actor.step_mantissa.into();
            range(
                Section::Actors,
                i,
                Field::Scale,
                mantissa,
                1 << 31,
                (1 << 32) - 1,
            )?;
            range(
                Section::Actors,
                i,
                Field::Scale,
                actor.step_exponent.into(),
                layout::STEP_EXPONENTS.0.into(),
                layout::STEP_EXPONENTS.1.into(),
            )?;
            self.check_parents(i, &actor)?;
            let (mesh, material) = (self.mesh(actor.mesh), self.material(actor.material));
            if material.texture.is_some() {
                let has = mesh.coordinates.is_some().into();
                range(Section::Actors, i, Field::Coordinates, has, 1, 1)?;
            }
            if material.shading == Shading::Flat {
                let has = i64::from(mesh.face_normals);
                range(Section::Actors, i, Field::FaceNormals, has, 1, 1)?;
            }
        }
        Ok(())
    }

    /// Every chain of parents ends.
    fn check_parents(&self, i: usize, actor: &Actor) -> Result<(), SceneError> {
        let s = Section::Actors;
        let last = last(self.actors.len(), 1);
        let mut above = actor.parent;
        for _ in 0..layout::PARENTS {
            let Some(parent) = above else { return Ok(()) };
            range(s, i, Field::Parent, parent.into(), 0, last)?;
            above = self.actor(parent).parent;
        }
        match above {
            Some(parent) => range(s, i, Field::Parent, parent.into(), -1, -1),
            None => Ok(()),
        }
    }
}
