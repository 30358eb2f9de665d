//! In: the text of a scene file. Out: a [`Scene`] with every default filled
//! in, or the first mistake with its line. Used by [`crate::load`].

mod actor;
mod animation;
mod annotation;
mod camera;
mod colour;
mod display;
mod fog;
mod light;
mod look;
mod material;
mod palette;
mod palette_file;
mod panel;
mod ray;
mod table;
#[cfg(test)]
mod tests;
mod texture;
mod viewport;

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use glam::DVec3;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::description::{Actor, Camera, Light, LightKind, Material, Mesh, Scene, Target};
use crate::error::Error;
use crate::framing::Bounds;
use crate::look::Representation;
use crate::mesh::{self, Surface};
use crate::texture::Texture;
use table::{Keys, Source, Table};

/// Lengths and coordinates stay within this, either side of 0.
const LENGTH: f64 = 1e9;
/// Angles stay within this many degrees, either side of 0.
const ANGLE: f64 = 1e6;
/// Sizes of factors that must not be 0.
const FACTOR: RangeInclusive<f64> = 1e-6..=1e6;

/// Factors of size that move.
const SCALE: RangeInclusive<f64> = 0.001..=100.0;
/// Angles that move stay within this many degrees, either side of 0: 100 turns.
const TURNS: f64 = 36000.0;

const ROOT: Keys = Keys {
    known: &[
        "display",
        "camera",
        "light",
        "material",
        "actor",
        "line",
        "marker",
        "text",
        "animation",
        "palette",
        "viewport",
        "fog",
        "ray",
    ],
    later: &[],
};

/// Reads the scene file's text and the meshes that it names. Adds to `notes`
/// what was left out of the meshes.
pub(crate) fn parse(file: &Path, text: &str, notes: &mut Vec<String>) -> Result<Scene, Error> {
    let source = Source { file, text };
    let document = DeTable::parse(text).map_err(|error| syntax_error(&source, &error))?;
    let root = Table::new(&source, "", document.get_ref(), 0..0, &ROOT)?;

    let display = one(&root, "display", &display::DISPLAY)?;
    let display = display::display(display.as_ref())?;
    let palette = one(&root, "palette", &palette::PALETTE)?;
    let palette = palette::palette(palette.as_ref())?;
    let mut textures = Vec::new();
    let mut materials = materials(&root, &mut textures)?;
    let (ambient, lights) = lights(&root)?;
    let (mut meshes, mut actors) = actors(&root, &mut materials, &mut textures, notes)?;
    annotation::annotations(&root, &mut materials, &mut meshes, &mut actors)?;
    if actors.is_empty() {
        let what = "actor: is missing; expected at least one [[actor]] with a mesh";
        return Err(Error::new(source.file, what));
    }

    let animation = one(&root, "animation", &animation::ANIMATION)?;
    let own_cameras = viewport::own_cameras(&root)?;
    let animation = animation::animation(animation.as_ref(), &actors, &own_cameras, &palette)?;

    let bounds = Bounds::of(&actors, &meshes, &animation);
    let aspect = f64::from(display.width) / f64::from(display.height);
    let camera = one(&root, "camera", &camera::CAMERA)?;
    let camera = camera::camera(camera.as_ref(), &bounds, aspect, &animation, Target::Camera)?;
    let fog = one(&root, "fog", &fog::FOG)?;
    let fog = fog.as_ref().map(fog::fog).transpose()?;
    let ray = one(&root, "ray", &ray::RAY)?;
    let ray = ray::ray(ray.as_ref())?;
    let viewports = viewport::viewports(&root, &bounds, &display, &animation)?;
    let lights = lights.unwrap_or_else(|| vec![headlight(&camera)]);
    Ok(Scene {
        display,
        camera,
        viewports,
        ambient,
        lights,
        textures,
        materials,
        meshes,
        actors,
        fog,
        animation,
        palette,
        ray,
    })
}

fn syntax_error(source: &Source<'_>, error: &toml::de::Error) -> Error {
    let offset = error.span().map_or(0, |span| span.start);
    let (line, column) = source.place(offset);
    Error {
        column: Some(column),
        ..Error::at_line(source.file, line, format!("not TOML: {}", error.message()))
    }
}

/// A table that stands once, as in `[camera]`.
fn one<'t, 'i>(
    root: &Table<'t, 'i>,
    name: &'static str,
    keys: &Keys,
) -> Result<Option<Table<'t, 'i>>, Error> {
    let Some(value) = root.get(name) else {
        return Ok(None);
    };
    let DeValue::Table(table) = value.get_ref() else {
        let what = format!("is not a table; expected [{name}] once");
        return Err(root.error(name, what));
    };
    Table::new(root.source, name, table, value.span(), keys).map(Some)
}

/// The raw tables of an array, as in `[[light]]`.
fn many<'t, 'i>(
    table: &Table<'t, 'i>,
    name: &'static str,
) -> Result<Vec<(&'t DeTable<'i>, std::ops::Range<usize>)>, Error> {
    let wrong = || {
        table.error(
            name,
            format!(
                "is not a list of tables; expected [[{}]]",
                table.field(name)
            ),
        )
    };
    let Some(value) = table.get(name) else {
        return Ok(Vec::new());
    };
    let DeValue::Array(array) = value.get_ref() else {
        return Err(wrong());
    };
    let each = |value: &'t Spanned<DeValue<'i>>| match value.get_ref() {
        DeValue::Table(table) => Ok((table, value.span())),
        _ => Err(wrong()),
    };
    array.iter().map(each).collect()
}

/// All materials; a default one if the file has none.
fn materials(root: &Table<'_, '_>, textures: &mut Vec<Texture>) -> Result<Vec<Material>, Error> {
    let mut materials: Vec<Material> = Vec::new();
    for (table, header) in many(root, "material")? {
        let table = Table::new(root.source, "material", table, header, &material::MATERIAL)?;
        let material = material::material(&table, materials.len(), textures)?;
        if materials.iter().any(|other| other.name == material.name) {
            let name = &material.name;
            let what = format!("\"{name}\" is the name of another; expected a name of its own");
            return Err(table.error("name", what));
        }
        materials.push(material);
    }
    if materials.is_empty() {
        materials.push(Material {
            name: "default".to_owned(),
            ..Material::default()
        });
    }
    Ok(materials)
}

/// The ambient light, and the other lights if the file has any `[[light]]`.
fn lights(root: &Table<'_, '_>) -> Result<([f64; 3], Option<Vec<Light>>), Error> {
    let mut ambient: Option<[f64; 3]> = None;
    let mut lights = Vec::new();
    let tables = many(root, "light")?;
    let none = tables.is_empty();
    for (table, header) in tables {
        let table = Table::new(root.source, "light", table, header, &light::LIGHT)?;
        match light::light(&table)? {
            light::Parsed::Ambient(rgb) => {
                let sum = ambient.get_or_insert_default();
                for (sum, channel) in sum.iter_mut().zip(rgb) {
                    *sum += channel;
                }
            }
            light::Parsed::Light(light) => lights.push(light),
        }
    }
    Ok((ambient.unwrap_or([1.0; 3]), (!none).then_some(lights)))
}

/// VTK's default light: white, along the line of sight.
pub(crate) fn headlight(camera: &Camera) -> Light {
    let direction = DVec3::from(camera.focal_point) - DVec3::from(camera.position);
    Light {
        kind: LightKind::Directional {
            direction: direction.into(),
        },
        colour: [1.0; 3],
        intensity: 1.0,
        edges: None,
    }
}

/// All actors and the meshes that they name, each file read once.
fn actors(
    root: &Table<'_, '_>,
    materials: &mut Vec<Material>,
    textures: &mut Vec<Texture>,
    notes: &mut Vec<String>,
) -> Result<(Vec<Mesh>, Vec<Actor>), Error> {
    let mut paths: Vec<PathBuf> = Vec::new();
    let mut meshes: Vec<Mesh> = Vec::new();
    // What the meshes' files say of their surfaces, until it is asked for.
    let mut surfaces: Vec<Option<Surface>> = Vec::new();
    let mut actors: Vec<Actor> = Vec::new();
    let mut tables = Vec::new();
    for (table, header) in many(root, "actor")? {
        let table = Table::new(root.source, "actor", table, header, &actor::ACTOR)?;
        let index = match actor::shape(&table)? {
            actor::Shape::File(name) => {
                let path = root.source.beside(name);
                match paths.iter().position(|other| *other == path) {
                    Some(index) => index,
                    None => {
                        let bytes = mesh::check_name(&path)
                            .and_then(|()| mesh::read(&path))
                            .map_err(|what| {
                                table.file_error("mesh", name, &what, "meshes/teapot.obj")
                            })?;
                        let mut loaded = mesh::parse(&path, &bytes)?;
                        loaded.mesh.name = name.to_owned();
                        notes.append(&mut loaded.notes);
                        meshes.push(loaded.mesh);
                        surfaces.push(loaded.surface);
                        paths.push(path);
                        meshes.len() - 1
                    }
                }
            }
            actor::Shape::Made(made) => {
                let known = meshes.iter().position(|other| *other == made);
                known.unwrap_or_else(|| {
                    meshes.push(made);
                    surfaces.push(None);
                    // A name that no file has.
                    paths.push(PathBuf::new());
                    meshes.len() - 1
                })
            }
        };
        let mut actor = actor::actor(&table, actors.len(), index, materials)?;
        if !table.has("material")
            && let Some(surface) = &surfaces[index]
        {
            let name = &meshes[index].name;
            let known = materials.iter().position(|other| other.name == *name);
            actor.material = known.unwrap_or_else(|| {
                let name = name.clone();
                let own = surface.material(textures);
                materials.push(Material { name, ..own });
                materials.len() - 1
            });
        }
        let textured = materials[actor.material].texture.is_some();
        let surface = actor.look.representation == Representation::Surface;
        if textured && surface && meshes[index].texture_coordinates.is_empty() {
            let what = "has a texture, but the mesh has no texture coordinates; \
                        expected one with them, e.g. vt of an OBJ file";
            return Err(table.error("material", what));
        }
        if table.has("name") && actors.iter().any(|other| other.name == actor.name) {
            let name = &actor.name;
            let what = format!("\"{name}\" is the name of another; expected a name of its own");
            return Err(table.error("name", what));
        }
        actors.push(actor);
        tables.push(table);
    }
    actor::parents(&tables, &mut actors)?;
    for (index, mesh) in meshes.iter_mut().enumerate() {
        let textured = |actor: &Actor| materials[actor.material].texture.is_some();
        if !actors.iter().any(|a| a.mesh == index && textured(a)) {
            mesh::forget_texture_coordinates(mesh);
        }
    }
    Ok((meshes, actors))
}
