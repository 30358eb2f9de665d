//! `[[actor]]`.

use super::table::{Keys, Neutral, Table, to_f64};
use crate::description::{Actor, Material};
use crate::error::Error;

pub(super) const ACTOR: Keys = Keys {
    known: &[
        "name",
        "mesh",
        "material",
        "origin",
        "position",
        "orientation",
        "scale",
    ],
    later: &[
        ("sphere", Neutral::Never),
        ("shear", Neutral::Zeros),
        ("matrix", Neutral::Never),
        ("parent", Neutral::Never),
        ("representation", Neutral::Text("surface")),
        ("billboard", Neutral::Never),
    ],
};

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
