//! `[[material]]`.

use std::ops::RangeInclusive;

use super::colour::colour;
use super::table::{Keys, Table};
use super::texture::texture;
use crate::description::{Cull, Material, Shading, Transparency};
use crate::error::Error;
use crate::texture::Texture;

/// OpenGL's and VTK's sharpest highlight.
const POWER: RangeInclusive<f64> = 1.0..=128.0;
/// From the air's to the most that a gem has, and more.
const REFRACTIVE_INDEX: RangeInclusive<f64> = 1.0..=4.0;

pub(super) const MATERIAL: Keys = Keys {
    known: &[
        "name",
        "colour",
        "ambient_colour",
        "diffuse_colour",
        "specular_colour",
        "ambient",
        "diffuse",
        "specular",
        "specular_power",
        "emission",
        "shading",
        "cull",
        "texture",
        "opacity",
        "transparency",
        "reflectivity",
        "refractive_index",
    ],
    later: &[],
};

/// Reads one material; `index` names it if it has no name.
pub(super) fn material(
    table: &Table<'_, '_>,
    index: usize,
    textures: &mut Vec<Texture>,
) -> Result<Material, Error> {
    let name = table.text("name", "clay")?;
    let mut material = Material {
        name: name.map_or_else(|| format!("material {index}"), str::to_owned),
        ..Material::default()
    };
    let all = colour(table, "colour")?;
    for (key, part) in [
        ("ambient_colour", &mut material.ambient_colour),
        ("diffuse_colour", &mut material.diffuse_colour),
        ("specular_colour", &mut material.specular_colour),
    ] {
        if let Some(rgb) = colour(table, key)?.or(all) {
            *part = rgb;
        }
    }
    for (key, coefficient, range) in [
        ("ambient", &mut material.ambient, 0.0..=1.0),
        ("diffuse", &mut material.diffuse, 0.0..=1.0),
        ("specular", &mut material.specular, 0.0..=1.0),
        ("specular_power", &mut material.specular_power, POWER),
        ("emission", &mut material.emission, 0.0..=1.0),
        ("opacity", &mut material.opacity, 0.0..=1.0),
        ("reflectivity", &mut material.reflectivity, 0.0..=1.0),
        (
            "refractive_index",
            &mut material.refractive_index,
            REFRACTIVE_INDEX,
        ),
    ] {
        if let Some(number) = table.number(key, range)? {
            *coefficient = number;
        }
    }
    let shadings = [
        ("flat", Shading::Flat),
        ("gouraud", Shading::Gouraud),
        ("phong", Shading::Phong),
    ];
    if let Some(shading) = table.choice("shading", &shadings, &[])? {
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
    let transparencies = [
        ("blend", Transparency::Blend),
        ("screen_door", Transparency::ScreenDoor),
    ];
    if let Some(transparency) = table.choice("transparency", &transparencies, &[])? {
        material.transparency = transparency;
    }
    material.texture = texture(table, textures)?;
    Ok(material)
}
