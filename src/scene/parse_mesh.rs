//! Checks of meshes and their meshlets.

use super::access::cones;
use super::layout::{self, MESHLET_TRIANGLES, MESHLET_VERTICES};
use super::range::{count, last, range};
use super::{Field, Mesh, Meshlet, Record, Scene, SceneError, Section};
use crate::math::square_root;

impl Scene<'_> {
    pub(super) fn check_meshes(&self) -> Result<(), SceneError> {
        let meshlets = self.meshlets.len();
        count(Section::Meshlets, meshlets, 0, layout::MESHLETS)?;
        for (i, words) in self.meshes.iter().enumerate() {
            let mesh = Mesh::from_words(words);
            let (first, count) = (i64::from(mesh.first_meshlet), i64::from(mesh.meshlets));
            let last = last(self.meshlets.len(), count);
            let s = Section::Meshes;
            range(s, i, Field::FirstMeshlet, first, 0, last)?;
            self.check_levels(i, &mesh)?;
            let radius = mesh.radius.into();
            let (least, most) = (
                layout::LEAST_RADIUS.into(),
                i64::from(layout::GRID_HALF) << 1,
            );
            range(s, i, Field::Radius, radius, least, most)?;
            range(s, i, Field::Error, mesh.error.into(), 0, most)?;
            let span = first as usize..first.saturating_add(count) as usize;
            for (j, words) in self
                .meshlets
                .iter()
                .enumerate()
                .take(span.end)
                .skip(span.start)
            {
                self.check_meshlet(j, &Meshlet::from_words(words), &mesh)?;
            }
        }
        Ok(())
    }

    /// A mesh's levels are in the scene's list, and each has what the mesh has and is no larger.
    fn check_levels(&self, i: usize, mesh: &Mesh) -> Result<(), SceneError> {
        let s = Section::Meshes;
        let (first, levels) = mesh.levels;
        let last = last(self.meshes.len(), levels.into());
        range(s, i, Field::Level, first.into(), 0, last.max(0))?;
        let has = |mesh: &Mesh| {
            let parts = [
                mesh.face_normals,
                mesh.fine.is_some(),
                mesh.colours.is_some(),
                mesh.coordinates.is_some(),
            ];
            parts
                .iter()
                .fold(0, |all, part| all << 1 | i64::from(*part))
        };
        for number in first..first.saturating_add(levels.into()) {
            let level = self.mesh(number);
            range(s, i, Field::Level, has(&level), has(mesh), has(mesh))?;
            // The mesh's sphere holds them too.
            range(
                s,
                i,
                Field::Radius,
                level.radius.into(),
                0,
                mesh.radius.into(),
            )?;
        }
        Ok(())
    }

    fn check_meshlet(&self, i: usize, meshlet: &Meshlet, mesh: &Mesh) -> Result<(), SceneError> {
        let s = Section::Meshlets;
        let (vertices, triangles) = (i64::from(meshlet.vertices), i64::from(meshlet.triangles));
        range(s, i, Field::Count, vertices, 1, MESHLET_VERTICES as i64)?;
        // A meshlet of lines or points has none.
        range(s, i, Field::Count, triangles, 0, MESHLET_TRIANGLES as i64)?;
        self.check_edges(i, meshlet)?;
        let half = i64::from(layout::GRID_HALF);
        for c in meshlet.base {
            range(s, i, Field::Base, c.into(), half.wrapping_neg(), half)?;
        }
        for shift in meshlet.shifts {
            range(
                s,
                i,
                Field::Shift,
                shift.into(),
                0,
                layout::MOST_SHIFT.into(),
            )?;
        }
        let room = last(self.vertices.len(), vertices);
        range(
            s,
            i,
            Field::FirstVertex,
            meshlet.first_vertex.into(),
            0,
            room,
        )?;
        let first = i64::from(meshlet.first_triangle);
        range(
            s,
            i,
            Field::FirstTriangle,
            first,
            0,
            last(self.triangles.len(), triangles),
        )?;
        if let Some(offset) = mesh.fine {
            let first = meshlet.first_vertex.wrapping_add(offset);
            range(
                s,
                i,
                Field::Fine,
                first.into(),
                0,
                last(self.fine.len(), vertices),
            )?;
        }
        if let Some(coordinates) = mesh.coordinates.filter(|_| cfg!(feature = "texture")) {
            let first = meshlet.first_vertex.wrapping_add(coordinates.offset).into();
            let last = last(self.coordinates.len(), vertices);
            range(s, i, Field::Coordinates, first, 0, last)?;
        }
        if let Some(offset) = mesh.colours {
            let first = meshlet.first_vertex.wrapping_add(offset).into();
            let last = last(self.vertex_colours.len(), vertices);
            range(s, i, Field::VertexColours, first, 0, last)?;
        }
        if mesh.face_normals {
            let last = last(self.face_normals.len(), triangles);
            range(s, i, Field::FaceNormals, first, 0, last)?;
        }
        if !self.face_cones.is_empty() {
            let (first, count) = cones(i as u32, meshlet);
            let last = last(self.face_cones.len(), count.into());
            range(s, i, Field::FaceCones, first as i64, 0, last)?;
        }
        let first = first as usize;
        let own = self
            .triangles
            .iter()
            .enumerate()
            .skip(first)
            .take(triangles as usize);
        for (j, index) in own.flat_map(|(j, t)| t.iter().map(move |v| (j, v))) {
            range(
                Section::Triangles,
                j,
                Field::VertexIndex,
                i64::from(*index),
                0,
                vertices.wrapping_sub(1),
            )?;
        }
        self.check_spheres(meshlet, mesh)
    }

    /// The spheres of a meshlet and its mesh hold its vertices: they alone say which rows it may
    /// touch, whether it is clipped, and how large numbers get.
    #[inline(never)]
    fn check_spheres(&self, meshlet: &Meshlet, mesh: &Mesh) -> Result<(), SceneError> {
        let square = |c: i32| i64::from(c).wrapping_mul(c.into());
        let fine = self.meshlet_fine(meshlet, mesh);
        let [bx, by, bz] = meshlet.base;
        for (j, vertex) in self.meshlet_vertices(meshlet).iter().enumerate() {
            let from_base = meshlet.steps(*vertex, fine.get(j).copied().unwrap_or_default());
            let [x, y, z] = from_base;
            let from_centre = [bx.wrapping_add(x), by.wrapping_add(y), bz.wrapping_add(z)];
            for (place, radius) in [
                (from_base, meshlet.radius_steps()),
                (from_centre, mesh.radius as i32),
            ] {
                let squared = place
                    .iter()
                    .fold(0, |sum: i64, c| sum.wrapping_add(square(*c)));
                if squared > square(radius) {
                    let vertex = j.wrapping_add(meshlet.first_vertex as usize);
                    // Rounded up, so beyond the radius.
                    let distance = i64::from(square_root(squared as u64)).wrapping_add(1);
                    range(
                        Section::Vertices,
                        vertex,
                        Field::Distance,
                        distance,
                        0,
                        radius.into(),
                    )?;
                }
            }
        }
        Ok(())
    }
}
