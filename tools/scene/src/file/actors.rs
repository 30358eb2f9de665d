//! All `[[actor]]` tables, and the meshes that they name.

use std::collections::HashSet;
use std::path::PathBuf;

use super::actor::{self, Shape};
use super::many;
use super::table::Table;
use crate::description::{Actor, Material, Mesh};
use crate::error::Error;
use crate::files::Origin;
use crate::look::Representation;
use crate::mesh::{self, Loaded};
use crate::parts;
use crate::texture::Texture;

/// What actors need besides themselves.
pub(super) struct Found<'a> {
    pub materials: &'a mut Vec<Material>,
    pub textures: &'a mut Vec<Texture>,
    pub notes: &'a mut Vec<String>,
    pub meshes: Meshes,
}

/// A scene's meshes, each once.
#[derive(Default)]
pub(super) struct Meshes {
    meshes: Vec<Mesh>,
    files: Vec<(PathBuf, Loaded)>,
    /// What came of a file's triangles, all or those of one surface: its number, the
    /// surface's, the mesh's.
    taken: Vec<(usize, Option<usize>, usize)>,
}

impl Meshes {
    /// The number of a mesh file, which is read at its first use.
    fn file(
        &mut self,
        table: &Table<'_, '_>,
        name: &str,
        notes: &mut Vec<String>,
    ) -> Result<usize, Error> {
        let path = table.source.origin.beside(name);
        if let Some(known) = self.files.iter().position(|(other, _)| *other == path) {
            return Ok(known);
        }
        let bytes = mesh::check_name(&path)
            .and_then(|()| table.source.origin.read(name))
            .map_err(|what| table.file_error("mesh", name, &what, "meshes/teapot.obj"))?;
        let origin = Origin {
            path: &path,
            ..table.source.origin
        };
        let mut loaded = mesh::parse(origin, &bytes)?;
        loaded.mesh.name = name.to_owned();
        notes.append(&mut loaded.notes);
        self.files.push((path, loaded));
        Ok(self.files.len() - 1)
    }

    /// The mesh of a file's triangles: of one surface, or all.
    fn of_file(&mut self, file: usize, surface: Option<usize>) -> usize {
        let known = self
            .taken
            .iter()
            .find(|(f, s, _)| (*f, *s) == (file, surface));
        if let Some((_, _, mesh)) = known {
            return *mesh;
        }
        let loaded = &self.files[file].1;
        let mesh = surface.map_or_else(|| loaded.mesh.clone(), |surface| loaded.part(surface));
        self.meshes.push(mesh);
        self.taken.push((file, surface, self.meshes.len() - 1));
        self.meshes.len() - 1
    }

    /// A mesh that no file has.
    fn made(&mut self, made: Mesh) -> usize {
        let known = self.meshes.iter().position(|other| *other == made);
        known.unwrap_or_else(|| {
            self.meshes.push(made);
            self.meshes.len() - 1
        })
    }
}

/// All actors and the meshes that they name; last, the further parts of actors that have
/// several surfaces.
pub(super) fn actors(
    root: &Table<'_, '_>,
    found: &mut Found<'_>,
) -> Result<(Vec<Actor>, Vec<Actor>), Error> {
    let mut actors: Vec<Actor> = Vec::new();
    let mut further = Vec::new();
    let mut tables = Vec::new();
    let mut names = HashSet::new();
    for (table, header) in many(root, "actor")? {
        let table = Table::new(root.source, "actor", table, header, &actor::ACTOR)?;
        let pieces = pieces(&table, found)?;
        let (mesh, material) = pieces[0];
        let mut actor = actor::actor(&table, actors.len(), mesh, found.materials)?;
        actor.material = material.unwrap_or(actor.material);
        let textured = found.materials[actor.material].texture.is_some();
        let surface = actor.look.representation == Representation::Surface;
        let meshes = &found.meshes.meshes;
        if textured && surface && meshes[mesh].texture_coordinates.is_empty() {
            let what = "has a texture, but the mesh has no texture coordinates; \
                        expected one with them, e.g. vt of an OBJ file";
            return Err(table.error("material", what));
        }
        if !names.insert(actor.name.clone()) && table.has("name") {
            let name = &actor.name;
            let what = format!("\"{name}\" is the name of another; expected a name of its own");
            return Err(table.error("name", what));
        }
        let rest = pieces[1..]
            .iter()
            .map(|(mesh, own)| [*mesh, own.unwrap_or(0)]);
        further.extend(parts::further(actors.len(), &actor, rest));
        actors.push(actor);
        tables.push(table);
    }
    actor::parents(&tables, &mut actors)?;
    Ok((actors, further))
}

/// The meshes that an actor consists of, with the materials that come with them.
fn pieces(
    table: &Table<'_, '_>,
    found: &mut Found<'_>,
) -> Result<Vec<(usize, Option<usize>)>, Error> {
    let file = match actor::shape(table)? {
        Shape::Made(mesh) => return Ok(vec![(found.meshes.made(mesh), None)]),
        Shape::File(name) => found.meshes.file(table, name, found.notes)?,
    };
    let surfaces = found.meshes.files[file].1.surfaces.len();
    if table.has("material") || surfaces == 0 {
        return Ok(vec![(found.meshes.of_file(file, None), None)]);
    }
    let piece = |number: usize| {
        let several = surfaces > 1;
        let mesh = found.meshes.of_file(file, several.then_some(number));
        let name = &found.meshes.meshes[mesh].name;
        let name = parts::material_name(name, number);
        let known = found.materials.iter().position(|other| other.name == name);
        let material = known.unwrap_or_else(|| {
            let own = found.meshes.files[file].1.surfaces[number].material(found.textures);
            found.materials.push(Material { name, ..own });
            found.materials.len() - 1
        });
        (mesh, Some(material))
    };
    Ok((0..surfaces).map(piece).collect())
}

impl Meshes {
    /// All of them; texture coordinates stay where a texture is.
    pub(super) fn finish<'a>(
        mut self,
        actors: impl Iterator<Item = &'a Actor> + Clone,
        materials: &[Material],
    ) -> Vec<Mesh> {
        parts::forget_unused(&mut self.meshes, actors, materials);
        self.meshes
    }
}
