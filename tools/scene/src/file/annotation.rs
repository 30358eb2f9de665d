//! `[[line]]`, `[[marker]]` and `[[text]]`: actors with a mesh of lines or points
//! and a material that gives its colour whatever the light.

use toml::de::DeValue;

use super::colour::{self, colour};
use super::look::{self, BIAS};
use super::table::{Keys, Table, to_f64};
use crate::description::{Actor, Material, Mesh, Rgb};
use crate::error::Error;
use crate::look::{Look, Mark, Representation, Shape, Space};

pub(super) const LINE: Keys = Keys {
    known: &[
        "name",
        "points",
        "colour",
        "width",
        "closed",
        "space",
        "depth_test",
        "bias",
    ],
    later: &[],
};
pub(super) const MARKER: Keys = Keys {
    known: &[
        "name",
        "points",
        "colour",
        "shape",
        "size",
        "space",
        "depth_test",
        "bias",
    ],
    later: &[],
};
pub(super) const TEXT: Keys = Keys {
    known: &[
        "name",
        "text",
        "position",
        "colour",
        "font",
        "anchor",
        "space",
        "depth_test",
        "bias",
    ],
    later: &[],
};

/// The furthest that a pixel may be from the picture's corner.
const PIXELS: f64 = 4096.0;

/// Adds all annotations to what the file's actors have: lines, then markers,
/// then texts.
pub(super) fn annotations(
    root: &Table<'_, '_>,
    materials: &mut Vec<Material>,
    meshes: &mut Vec<Mesh>,
    actors: &mut Vec<Actor>,
) -> Result<(), Error> {
    for (kind, keys, read) in [
        ("line", &LINE, line as fn(&Table<'_, '_>) -> _),
        ("marker", &MARKER, marker),
        ("text", &TEXT, text),
    ] {
        for (at, (table, header)) in super::many(root, kind)?.into_iter().enumerate() {
            let table = Table::new(root.source, kind, table, header, keys)?;
            let name = table.text("name", "axis")?;
            let name = name.map_or_else(|| format!("{kind} {at}"), str::to_owned);
            let (mesh, look): (Mesh, Look) = read(&table)?;
            let paint = colour(&table, "colour")?.unwrap_or([1.0; 3]);
            actors.push(Actor {
                name: name.clone(),
                mesh: meshes.len(),
                material: unlit(materials, paint),
                look,
                still: true,
                ..Actor::default()
            });
            meshes.push(Mesh { name, ..mesh });
        }
    }
    Ok(())
}

/// The material that shines in a colour, made if there is none.
fn unlit(materials: &mut Vec<Material>, paint: Rgb) -> usize {
    let name = format!("unlit {}", colour::text(paint));
    let material = Material {
        ambient_colour: paint,
        diffuse_colour: paint,
        ambient: 0.0,
        diffuse: 0.0,
        emission: 1.0,
        name,
        ..Material::default()
    };
    let found = materials.iter().position(|other| *other == material);
    found.unwrap_or_else(|| {
        materials.push(material);
        materials.len() - 1
    })
}

/// What all annotations share; labels are read before what is behind them.
fn common(
    table: &Table<'_, '_>,
    representation: Representation,
    depth_test: bool,
) -> Result<Look, Error> {
    let spaces = [("world", Space::World), ("screen", Space::Screen)];
    let space = table.choice("space", &spaces, &[])?.unwrap_or(Space::World);
    let asked = table.boolean("depth_test")?;
    if space == Space::Screen {
        for key in ["depth_test", "bias"] {
            if table.has(key) {
                let what = "says nothing on the screen, which has no depth; expected no such key";
                return Err(table.error(key, what));
            }
        }
    }
    Ok(Look {
        representation,
        depth_test: space == Space::World && asked.unwrap_or(depth_test),
        bias: table.whole("bias", 0..=1000)?.unwrap_or(BIAS),
        space,
        ..Look::default()
    })
}

fn line(table: &Table<'_, '_>) -> Result<(Mesh, Look), Error> {
    let mut look = common(table, Representation::Wireframe, true)?;
    look.line_width = table.whole("width", 1..=16)?.unwrap_or(1);
    let positions = points(table, "points", look.space, 2)?;
    let closed = table.boolean("closed")?.unwrap_or(false);
    let count = positions.len() as u32;
    let mut edges: Vec<[u32; 2]> = (1..count).map(|i| [i - 1, i]).collect();
    if closed && count > 2 {
        edges.push([count - 1, 0]);
    }
    let mesh = Mesh {
        edges,
        ..points_only(positions)
    };
    Ok((mesh, look))
}

fn marker(table: &Table<'_, '_>) -> Result<(Mesh, Look), Error> {
    let mut look = common(table, Representation::Points, true)?;
    look.mark = look::shape(table, "shape", "size", (Shape::Dot, 7))?;
    Ok((points_only(points(table, "points", look.space, 1)?), look))
}

fn text(table: &Table<'_, '_>) -> Result<(Mesh, Look), Error> {
    const LETTERS: usize = 200;
    let mut look = common(table, Representation::Points, false)?;
    let example = "Hello";
    let Some(text) = table.text("text", example)? else {
        let what = format!("is missing; expected e.g. text = \"{example}\"");
        return Err(table.error("text", what));
    };
    let strange = |c: char| c != '\n' && !matches!(c, ' '..='~' | '\u{a0}'..='\u{ff}');
    if let Some(letter) = text.chars().find(|c| strange(*c)) {
        let what = format!("'{letter}' is in none of the fonts; expected letters of ISO 8859-1");
        return Err(table.error("text", format!("{what}, e.g. text = \"{example}\"")));
    }
    let letters = text.chars().count();
    if !(1..=LETTERS).contains(&letters) {
        return Err(table.error(
            "text",
            format!("has {letters} letters; expected 1..={LETTERS}, e.g. text = \"{example}\""),
        ));
    }
    look.mark = look::text(table, text)?;
    debug_assert!(matches!(look.mark, Mark::Text { .. }));
    let position = place(table, "position", look.space)?;
    Ok((points_only(vec![position]), look))
}

fn points_only(positions: Vec<[f64; 3]>) -> Mesh {
    Mesh {
        normals: vec![[0.0, 0.0, 1.0]; positions.len()],
        positions,
        ..Mesh::default()
    }
}

/// One place.
fn place(table: &Table<'_, '_>, key: &str, space: Space) -> Result<[f64; 3], Error> {
    let example = one(space);
    let found = match space {
        Space::World => table.numbers::<3>(key, super::LENGTH, example)?,
        Space::Screen => table
            .numbers::<2>(key, PIXELS, example)?
            .map(|[x, y]| [x, y, 0.0]),
    };
    found.ok_or_else(|| table.error(key, format!("is missing; expected e.g. {key} = {example}")))
}

fn one(space: Space) -> &'static str {
    match space {
        Space::World => "[0, 1.5, 0]",
        Space::Screen => "[10.5, 20.5]",
    }
}

/// At least `least` places.
fn points(
    table: &Table<'_, '_>,
    key: &str,
    space: Space,
    least: usize,
) -> Result<Vec<[f64; 3]>, Error> {
    let (count, limit, example) = match space {
        Space::World => (3, super::LENGTH, "[[0, 0, 0], [1, 0, 0]]"),
        Space::Screen => (2, PIXELS, "[[10.5, 20.5], [30.5, 20.5]]"),
    };
    let places = places(table, key, (count, limit), example)?;
    if places.len() < least {
        let found = places.len();
        return Err(table.error(
            key,
            format!(
                "has {found} points where at least {least} belong; expected e.g. {key} = {example}"
            ),
        ));
    }
    Ok(places)
}

/// A list of places, each of `count` numbers within `limit`.
pub(super) fn places(
    table: &Table<'_, '_>,
    key: &str,
    numbers: (usize, f64),
    example: &str,
) -> Result<Vec<[f64; 3]>, Error> {
    match table.get(key) {
        Some(value) => list_of_places(table, key, value.get_ref(), numbers, example),
        None => Err(table.error(key, format!("is missing; expected e.g. {key} = {example}"))),
    }
}

/// The same from a value of `key`.
pub(super) fn list_of_places(
    table: &Table<'_, '_>,
    key: &str,
    value: &DeValue<'_>,
    (count, limit): (usize, f64),
    example: &str,
) -> Result<Vec<[f64; 3]>, Error> {
    const MOST: usize = 10_000;
    let wrong = |what: String| table.error(key, format!("{what}; expected e.g. {key} = {example}"));
    let DeValue::Array(array) = value else {
        return Err(wrong("is not a list of points".to_owned()));
    };
    if array.len() > MOST {
        return Err(wrong(format!("has {} points, at most {MOST}", array.len())));
    }
    let place = |(at, value): (usize, &toml::Spanned<DeValue<'_>>)| {
        let wrong = |what: String| wrong(format!("point {at} {what}"));
        let DeValue::Array(numbers) = value.get_ref() else {
            return Err(wrong(format!("is not {count} numbers")));
        };
        if numbers.len() != count {
            let found = numbers.len();
            return Err(wrong(format!("has {found} numbers where {count} belong")));
        }
        let mut place = [0.0; 3];
        for (slot, number) in place.iter_mut().zip(numbers.iter()) {
            *slot = to_f64(number.get_ref())
                .ok_or_else(|| wrong("holds what is not a number".to_owned()))?;
            if !(-limit..=limit).contains(slot) {
                return Err(wrong(format!(
                    "has {slot}, out of range (-{limit:e}..={limit:e})"
                )));
            }
        }
        Ok(place)
    };
    array.iter().enumerate().map(place).collect()
}
