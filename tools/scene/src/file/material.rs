//! `[[material]]`.

use super::colour::colour;
use super::table::{Keys, Neutral, Table};
use crate::description::{Cull, Material, Shading};
use crate::error::Error;

pub(super) const MATERIAL: Keys = Keys {
    known: &[
        "name",
        "colour",
        "ambient_colour",
        "diffuse_colour",
        "ambient",
        "diffuse",
        "emission",
        "shading",
        "cull",
    ],
    later: &[
        ("specular", Neutral::Number(0.0)),
        // Without a specular coefficient these two say nothing.
        ("specular_colour", Neutral::Any),
        ("specular_power", Neutral::Any),
        ("texture", Neutral::Never),
        ("opacity", Neutral::Number(1.0)),
        ("reflectivity", Neutral::Number(0.0)),
        ("refractive_index", Neutral::Number(1.0)),
        ("alpha_test", Neutral::Number(0.0)),
        ("vertex_colours", Neutral::Never),
    ],
};

/// VTK's default material.
pub(super) fn default(name: &str) -> Material {
    Material {
        name: name.to_owned(),
        ambient_colour: [1.0; 3],
        diffuse_colour: [1.0; 3],
        ambient: 0.0,
        diffuse: 1.0,
        emission: 0.0,
        shading: Shading::Gouraud,
        cull: Cull::Back,
    }
}

/// Reads one material; `index` names it if it has no name.
pub(super) fn material(table: &Table<'_, '_>, index: usize) -> Result<Material, Error> {
    let name = table.text("name", "clay")?;
    let mut material = default(name.unwrap_or(&format!("material {index}")));
    if let Some(both) = colour(table, "colour")? {
        material.ambient_colour = both;
        material.diffuse_colour = both;
    }
    if let Some(ambient) = colour(table, "ambient_colour")? {
        material.ambient_colour = ambient;
    }
    if let Some(diffuse) = colour(table, "diffuse_colour")? {
        material.diffuse_colour = diffuse;
    }
    for (key, coefficient) in [
        ("ambient", &mut material.ambient),
        ("diffuse", &mut material.diffuse),
        ("emission", &mut material.emission),
    ] {
        if let Some(number) = table.number(key, 0.0..=1.0)? {
            *coefficient = number;
        }
    }
    let shadings = [("flat", Shading::Flat), ("gouraud", Shading::Gouraud)];
    if let Some(shading) = table.choice("shading", &shadings, &["phong"])? {
        material.shading = shading;
    }
    let culls = [
        ("back", Cull::Back),
        ("front", Cull::Front),
        ("none", Cull::None),
    ];
    if let Some(cull) = table.choice("cull", &culls, &[])? {
        material.cull = cull;
    }
    Ok(material)
}
