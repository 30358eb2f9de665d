//! In: the text of a scene file. Out: a [`Scene`] with every default filled
//! in, or the first mistake with its line. Used by [`crate::load`].

mod actor;
mod actors;
mod animation;
mod annotation;
mod camera;
mod colour;
mod display;
mod fog;
mod light;
mod lod;
mod look;
mod material;
mod palette;
mod palette_file;
mod ray;
mod table;
#[cfg(test)]
mod tests;
mod texture;
mod viewport;

use std::collections::{HashMap, HashSet};
use std::ops::{Range, RangeInclusive};

use glam::DVec3;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::description::{
    Camera, ColourFormat, Element, Light, LightKind, Material, Scene, Target,
};
use crate::error::Error;
use crate::files::Origin;
use crate::framing::Bounds;
use crate::panel::Screen;
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

/// Actors that a blob has at most.
const MOST_ACTORS: usize = 65_534;

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
        "lod",
        "ray",
    ],
    later: &[],
};

/// Reads the scene file's text and the meshes that it names. Adds to `notes`
/// what was left out of the meshes.
pub(crate) fn parse(
    origin: Origin<'_>,
    text: &str,
    screen: Option<Screen>,
    notes: &mut Vec<String>,
) -> Result<Scene, Error> {
    let source = Source::new(origin, text);
    let document = DeTable::parse(text).map_err(|error| syntax_error(&source, &error))?;
    let root = Table::new(&source, "", document.get_ref(), 0..0, &ROOT)?;

    for name in ["actor", "line", "marker", "text"] {
        let count = many(&root, name)?.len();
        if count > MOST_ACTORS {
            let what = format!("there are {count}; expected at most {MOST_ACTORS} [[{name}]]");
            return Err(root.error(name, what));
        }
    }
    let display = one(&root, "display", &display::DISPLAY)?;
    let mut display = display::display(display.as_ref())?;
    let palette = one(&root, "palette", &palette::PALETTE)?;
    let mut palette = palette::palette(palette.as_ref())?;
    let mut widening = 1.0;
    if let Some(screen) = screen {
        widening = screen.widening(display.width, display.height);
        display = screen.of(display);
        // There is none without a palette but of RGB565.
        palette.direct &= display.colour == ColourFormat::Rgb565;
    }
    let mut textures = Vec::new();
    let mut materials = materials(&root, &mut textures)?;
    let (ambient, lights) = lights(&root)?;
    let mut found = actors::Found {
        materials: &mut materials,
        textures: &mut textures,
        notes,
        meshes: actors::Meshes::default(),
    };
    let (mut actors, further) = actors::actors(&root, &mut found)?;
    let mut meshes = found
        .meshes
        .finish(actors.iter().chain(&further), &materials);
    annotation::annotations(&root, &mut materials, &mut meshes, &mut actors)?;
    // Behind all that have a number in the file.
    actors.extend(further);
    // Materials alone are for what firmware draws by itself.
    if actors.is_empty() && many(&root, "material")?.is_empty() {
        let what = "actor: is missing; expected at least one [[actor]] with a mesh, or a \
                    [[material]] for what is drawn by call";
        return Err(Error::new(origin.path, what));
    }

    let animation = one(&root, "animation", &animation::ANIMATION)?;
    let own_cameras = viewport::own_cameras(&root)?;
    let animation = animation::animation(animation.as_ref(), &actors, &own_cameras, &palette)?;

    let bounds = Bounds::of(&actors, &meshes, &animation);
    let shape = camera::Shape {
        aspect: f64::from(display.width) / f64::from(display.height),
        widening,
    };
    let camera = one(&root, "camera", &camera::CAMERA)?;
    let camera = camera::camera(camera.as_ref(), &bounds, shape, &animation, Target::Camera)?;
    let fog = one(&root, "fog", &fog::FOG)?;
    let fog = fog.as_ref().map(fog::fog).transpose()?;
    let lod = one(&root, "lod", &lod::LOD)?;
    let lod = lod.as_ref().map(lod::lod).transpose()?;
    let ray = one(&root, "ray", &ray::RAY)?;
    let ray = ray::ray(ray.as_ref())?;
    let viewports = viewport::viewports(&root, &bounds, shape, &animation)?;
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
        lod,
        ray,
        source: crate::description::Source {
            bare: false,
            file: origin.path.to_owned(),
            lines: lines(&root)?,
        },
    })
}

/// The line at which each table begins.
fn lines(root: &Table<'_, '_>) -> Result<HashMap<Element, usize>, Error> {
    let mut lines = HashMap::new();
    let line = |span: Range<usize>| root.source.place(span.start).0;
    for (name, element) in [
        ("camera", Element::Camera),
        ("animation", Element::Animation),
    ] {
        if let Some(value) = root.get(name) {
            lines.insert(element, line(value.span()));
        }
    }
    let element = |kind: usize| [Element::Viewport, Element::Material, Element::Light][kind];
    for (kind, name) in ["viewport", "material", "light"].into_iter().enumerate() {
        let ambient = |table: &DeTable<'_>| {
            let kind = table.get("kind").map(|kind| kind.get_ref());
            matches!(kind, Some(DeValue::String(kind)) if kind == "ambient")
        };
        let tables = many(root, name)?.into_iter();
        let tables = tables.filter(|(table, _)| name != "light" || !ambient(table));
        for (number, (_, header)) in tables.enumerate() {
            lines.insert(element(kind)(number), line(header));
        }
    }
    let mut actors = 0..;
    for name in ["actor", "line", "marker", "text"] {
        for ((_, header), actor) in many(root, name)?.into_iter().zip(&mut actors) {
            lines.insert(Element::Actor(actor), line(header));
        }
    }
    Ok(lines)
}

fn syntax_error(source: &Source<'_>, error: &toml::de::Error) -> Error {
    let offset = error.span().map_or(0, |span| span.start);
    let (line, column) = source.place(offset);
    Error {
        column: Some(column),
        ..Error::at_line(
            source.origin.path,
            line,
            format!("not TOML: {}", error.message()),
        )
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
) -> Result<Vec<(&'t DeTable<'i>, Range<usize>)>, Error> {
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
    let mut names = HashSet::new();
    for (table, header) in many(root, "material")? {
        let table = Table::new(root.source, "material", table, header, &material::MATERIAL)?;
        let material = material::material(&table, materials.len(), textures)?;
        if !names.insert(material.name.clone()) {
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
