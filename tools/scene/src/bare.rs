//! A bare mesh as a scene of its own: seen from its right and above, lit
//! from the upper left.

use std::path::Path;

use glam::DVec3;

use crate::description::{
    Actor, Animation, Background, ColourFormat, Display, Light, LightKind, Material, Palette, Ray,
    Scene, Stereo,
};
use crate::error::Error;
use crate::framing::{self, Bounds};
use crate::mesh;

/// Degrees from the front towards the mesh's right, and upwards.
const AZIMUTH: f64 = 30.0;
const ELEVATION: f64 = 20.0;
/// As VTK's.
const VIEW_ANGLE: f64 = 30.0;
/// A dark blue, against which any mesh colour stands out.
const BACKGROUND: [u8; 3] = [0x18, 0x20, 0x2c];

/// Reads the mesh and builds its scene.
pub(crate) fn scene(path: &Path, notes: &mut Vec<String>) -> Result<Scene, Error> {
    let mut loaded = mesh::load(path)?;
    notes.append(&mut loaded.notes);
    let mut textures = Vec::new();
    let material = Material {
        name: "default".to_owned(),
        ambient: 0.15,
        diffuse: 0.85,
        ..loaded.surface.unwrap_or_default().material(&mut textures)
    };
    let mut meshes = vec![loaded.mesh];
    if material.texture.is_none() {
        mesh::forget_texture_coordinates(&mut meshes[0]);
    }
    let actors = vec![Actor {
        name: meshes[0].name.clone(),
        ..Actor::default()
    }];
    let display = Display {
        width: 320,
        height: 240,
        colour: ColourFormat::Rgb565,
        background: Background::Solid(BACKGROUND.map(|channel| f64::from(channel) / 255.0)),
        samples: [1, 1],
        stereo: Stereo::None,
    };
    let bounds = Bounds::of(&actors, &meshes, &Animation::default());
    let (sin, cos) = libm::sincos(AZIMUTH.to_radians());
    let (up, along) = libm::sincos(ELEVATION.to_radians());
    let from = DVec3::new(sin * along, up, cos * along);
    let aspect = f64::from(display.width) / f64::from(display.height);
    let mut camera = framing::frame(&bounds, from, VIEW_ANGLE, aspect);
    camera.clipping_range = framing::clipping_range(&[camera], &bounds);
    let right = DVec3::Y.cross(from).normalize();
    let above = from.cross(right);
    Ok(Scene {
        display,
        camera,
        viewports: Vec::new(),
        ambient: [1.0; 3],
        lights: vec![Light {
            kind: LightKind::Directional {
                direction: (right - above - from).into(),
            },
            colour: [1.0; 3],
            intensity: 1.0,
            edges: None,
        }],
        textures,
        materials: vec![material],
        meshes,
        actors,
        fog: None,
        animation: Animation::default(),
        palette: Palette::default(),
        ray: Ray::default(),
    })
}
