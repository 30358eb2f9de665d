//! `[[actor]]`.

use super::annotation::{list_of_places, places};
use super::look::look;
use super::table::{Keys, Neutral, Table, to_f64};
use crate::description::{Actor, Material, Mesh};
use crate::error::Error;
use crate::mesh;

pub(super) const ACTOR: Keys = Keys {
    known: &[
        "name",
        "mesh",
        "sphere",
        "detail",
        "polygon",
        "holes",
        "material",
        "origin",
        "position",
        "orientation",
        "scale",
        "representation",
        "line_width",
        "point_size",
        "point_shape",
    ],
    later: &[
        ("shear", Neutral::Zeros),
        ("matrix", Neutral::Never),
        ("parent", Neutral::Never),
        ("billboard", Neutral::Never),
    ],
};

/// Where an actor's mesh comes from.
pub(super) enum Shape<'t> {
    /// A file, by its name.
    File(&'t str),
    /// The scene file itself.
    Made(Mesh),
}

/// Triangles of a sphere: 20 times 4 to the power of this.
const DETAIL: u32 = 3;

/// A mesh's file, a sphere or a polygon.
pub(super) fn shape<'t>(table: &Table<'t, '_>) -> Result<Shape<'t>, Error> {
    let example = "meshes/teapot.obj";
    let given = ["mesh", "sphere", "polygon"].map(|key| table.has(key));
    if given.iter().filter(|given| **given).count() > 1 {
        let what = "is one mesh too many; expected one of mesh, sphere and polygon";
        let key = if given[2] { "polygon" } else { "sphere" };
        return Err(table.error(key, what));
    }
    for (key, owner) in [("detail", "sphere"), ("holes", "polygon")] {
        if table.has(key) && !table.has(owner) {
            let what = format!("says nothing here; expected it with {owner}");
            return Err(table.error(key, what));
        }
    }
    if let Some(radius) = table.number("sphere", super::FACTOR)? {
        let detail = table.whole("detail", 0..=6)?.unwrap_or(DETAIL);
        return Ok(Shape::Made(mesh::sphere(radius, detail)));
    }
    if table.has("polygon") {
        return polygon(table).map(Shape::Made);
    }
    match table.text("mesh", example)? {
        Some(name) => Ok(Shape::File(name)),
        None => {
            let what = format!("is missing; expected e.g. mesh = \"{example}\"");
            Err(table.error("mesh", what))
        }
    }
}

fn polygon(table: &Table<'_, '_>) -> Result<Mesh, Error> {
    let example = "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    let outline = places(table, "polygon", (3, super::LENGTH), example)?;
    let holes_example = "[[[0.2, 0.2, 0], [0.4, 0.2, 0], [0.2, 0.4, 0]]]";
    let mut holes = Vec::new();
    if let Some(array) = table.array("holes", holes_example)? {
        for hole in array {
            holes.push(list_of_places(
                table,
                "holes",
                hole.get_ref(),
                (3, super::LENGTH),
                holes_example,
            )?);
        }
    }
    let short = |ring: &Vec<[f64; 3]>| ring.len() < 3;
    for (key, short) in [
        ("polygon", short(&outline)),
        ("holes", holes.iter().any(short)),
    ] {
        if short {
            let what = format!("has fewer than 3 corners; expected e.g. polygon = {example}");
            return Err(table.error(key, what));
        }
    }
    mesh::polygon(&outline, &holes).map_err(|what| {
        table.error(
            "polygon",
            format!("{what}; expected e.g. polygon = {example}"),
        )
    })
}

/// Where an actor is, and of what material; its mesh is read by the caller.
pub(super) fn actor(
    table: &Table<'_, '_>,
    index: usize,
    mesh: usize,
    materials: &[Material],
) -> Result<Actor, Error> {
    let name = table.text("name", "pot")?.map(str::to_owned);
    let place = |key, example| {
        let numbers = table.numbers::<3>(key, super::LENGTH, example)?;
        Ok(numbers.unwrap_or_default())
    };
    Ok(Actor {
        name: name.unwrap_or_else(|| format!("actor {index}")),
        mesh,
        material: material(table, materials)?,
        origin: place("origin", "[0, 1.5, 0]")?,
        position: place("position", "[0, 1.5, 0]")?,
        orientation: table
            .numbers("orientation", super::ANGLE, "[0, 45, 0]")?
            .unwrap_or_default(),
        scale: scale(table)?,
        look: look(table)?,
        still: false,
    })
}

/// The material by name; the first one if the actor names none.
fn material(table: &Table<'_, '_>, materials: &[Material]) -> Result<usize, Error> {
    let Some(name) = table.text("material", "clay")? else {
        return Ok(0);
    };
    let found = materials.iter().position(|material| material.name == name);
    found.ok_or_else(|| {
        let names: Vec<_> = materials
            .iter()
            .map(|material| format!("\"{}\"", material.name))
            .collect();
        table.error(
            "material",
            format!(
                "no [[material]] is named \"{name}\"; expected {}",
                names.join(" or ")
            ),
        )
    })
}

/// One number for all three directions, or three.
fn scale(table: &Table<'_, '_>) -> Result<[f64; 3], Error> {
    let example = "2 or scale = [1, 2, 1]";
    let scale = match table.get("scale").map(|value| to_f64(value.get_ref())) {
        None => return Ok([1.0; 3]),
        Some(Some(number)) => [number; 3],
        Some(None) => table
            .numbers("scale", f64::MAX, example)?
            .unwrap_or([1.0; 3]),
    };
    for factor in scale {
        if !super::FACTOR.contains(&factor.abs()) {
            return Err(table.error(
                "scale",
                format!(
                    "{factor} is out of range (1e-6..=1e6 either side of 0); \
                     expected e.g. scale = {example}"
                ),
            ));
        }
    }
    Ok(scale)
}
