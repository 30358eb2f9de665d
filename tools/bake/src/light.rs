//! What the description says of lights and materials, in the blob's records.

use fixel::math::Scaled;
use fixel::scene::{self as core_scene, Channels};
use fixel_scene::{Attenuation, Cull, Element, Light, LightKind, Material, Rgb, Scene, Shading};
use glam::DVec3;

use crate::error::{BakeError, Problem, Spot};
use crate::palette::{Path, ambient_level};
use crate::units::{Units, mantissa_exponent, unit_q30};

/// The `number`th light of the file, from 1.
pub(crate) fn light(
    units: &Units,
    number: usize,
    light: &Light,
) -> Result<core_scene::Light, BakeError> {
    let element = Element::Light(number - 1);
    let what = |field: &str| format!("light.{field}");
    let mut record = core_scene::Light {
        kind: core_scene::LightKind::Directional,
        towards: [0; 3],
        position: [0; 3],
        colour: [0; 3],
        attenuation: [Scaled::ZERO; 3],
        cone: 0,
        exponent: 0,
    };
    for (to, channel) in record.colour.iter_mut().zip(light.colour) {
        let strength = light.intensity * channel;
        if !(0.0..=32.0).contains(&strength) {
            let problem = Problem::Range {
                what: what("intensity"),
                value: strength,
                most: 32.0,
            };
            return Err(problem.at(element));
        }
        *to = (strength * 65536.0).round() as u32;
    }
    match light.kind {
        LightKind::Directional { direction } => record.towards = unit_q30(-DVec3::from(direction)),
        LightKind::Point {
            position,
            attenuation,
        } => {
            record.kind = core_scene::LightKind::Point;
            record.position =
                units.place(Spot::new(element, &what("position")), DVec3::from(position))?;
            record.attenuation = by_world_units(units, attenuation);
        }
        LightKind::Spot {
            position,
            direction,
            attenuation,
            cone_angle,
            exponent,
        } => {
            record.kind = core_scene::LightKind::Spot;
            record.towards = unit_q30(-DVec3::from(direction));
            record.position =
                units.place(Spot::new(element, &what("position")), DVec3::from(position))?;
            record.attenuation = by_world_units(units, attenuation);
            record.cone = (cone_angle.to_radians().cos() * f64::exp2(30.0)).round() as i32;
            record.exponent = (exponent * 256.0).round() as u16;
        }
    }
    Ok(record)
}

/// Coefficients for distances in world units. Those below 2^-128 are 0.
fn by_world_units(units: &Units, [c, l, q]: Attenuation) -> [Scaled; 3] {
    let unit = f64::exp2(-f64::from(units.exponent));
    [c, l * unit, q * unit * unit].map(|value| {
        if value < f64::exp2(-96.0) {
            return Scaled::ZERO;
        }
        let (mantissa, exponent) = mantissa_exponent(value);
        Scaled::new(mantissa, (exponent - 31).clamp(-128, 127))
    })
}

/// A material and its way from light to an index.
pub(crate) fn material(
    scene: &Scene,
    path: Path,
    texture: Option<usize>,
    transparency: core_scene::Transparency,
    material: &Material,
) -> core_scene::Material {
    let (shade, coloured) = match path {
        Path::Level(shade) | Path::Textured(shade) => (shade, false),
        Path::Colour => (0, true),
    };
    let plain = scene.lights.iter().all(|light| {
        let [r, g, b] = light.colour;
        matches!(light.kind, LightKind::Directional { .. }) && r == g && g == b
    });
    core_scene::Material {
        shading: match material.shading {
            Shading::Flat => core_scene::Shading::Flat,
            Shading::Gouraud => core_scene::Shading::Gouraud,
            Shading::Phong => core_scene::Shading::Phong,
        },
        cull: match material.cull {
            Cull::Back => core_scene::Cull::Back,
            Cull::Front => core_scene::Cull::Front,
            Cull::None => core_scene::Cull::None,
        },
        shade,
        ambient: (ambient_level(material, &scene.ambient) * 64.0).round() as u16,
        diffuse: (material.diffuse.clamp(0.0, 1.0) * 65536.0).round() as u32,
        full: coloured
            || !plain
            || material.specular > 0.0
            || material.shading == Shading::Phong
            || transparency != core_scene::Transparency::Opaque,
        coloured,
        // At most 255 of them.
        texture: texture.map(|index| index as u8),
        power: (material.specular_power * 256.0).round() as u16,
        channels: channels(scene, material, coloured),
        transparency,
    }
}

/// What a material's colour, or its level, is made from.
fn channels(scene: &Scene, material: &Material, coloured: bool) -> Channels {
    let level = |v: f64| (v.clamp(0.0, 1.0) * 255.0 * 64.0).round() as u16;
    if !coloured {
        let one = |v: f64| [level(v); 3];
        return Channels {
            constant: one(ambient_level(material, &scene.ambient) / 255.0),
            diffuse: one(material.diffuse),
            specular: one(material.specular),
        };
    }
    let of = |colour: Rgb, by: f64| colour.map(|c| c * by);
    let emission = of(material.diffuse_colour, material.emission);
    let ambient = of(material.ambient_colour, material.ambient);
    let constant = [0, 1, 2].map(|c| emission[c] + ambient[c] * scene.ambient[c]);
    Channels {
        constant: constant.map(level),
        diffuse: of(material.diffuse_colour, material.diffuse).map(level),
        specular: of(material.specular_colour, material.specular).map(level),
    }
}
