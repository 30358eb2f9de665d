//! A bare mesh as a scene of its own: seen from its right and above, lit
//! from the upper left, on a turntable.

use glam::DVec3;

use crate::description::{
    Actor, Animation, Background, ColourFormat, Display, Light, LightKind, Material, Palette,
    PanelDithering, Ray, Scene, Source, Stereo,
};
use crate::error::Error;
use crate::files::Origin;
use crate::framing::{self, Bounds};
use crate::mesh::{self, Surface};
use crate::panel::Screen;
use crate::parts;

/// Degrees from the front towards the mesh's right, and upwards.
const AZIMUTH: f64 = 30.0;
const ELEVATION: f64 = 20.0;
/// As VTK's.
const VIEW_ANGLE: f64 = 30.0;
/// Frames of a turn about the mesh's own middle.
const TURNTABLE: u32 = 60;
/// A dark blue, against which any mesh colour stands out.
const BACKGROUND: [u8; 3] = [0x18, 0x20, 0x2c];

/// Behind it on a display of this colour: on greys that are dithered a dark blue would be black
/// with stars.
pub(crate) fn background(colour: ColourFormat) -> Background {
    let colour = match colour.is_dithered() {
        true => [0; 3],
        false => BACKGROUND,
    };
    Background::Solid(colour.map(|channel| f64::from(channel) / 255.0))
}

/// Reads the mesh and builds its scene.
pub(crate) fn scene(
    origin: Origin<'_>,
    screen: Option<Screen>,
    notes: &mut Vec<String>,
) -> Result<Scene, Error> {
    let mut loaded = mesh::load(origin)?;
    notes.append(&mut loaded.notes);
    let mut textures = Vec::new();
    let mut meshes = loaded.parts();
    let mut surfaces = loaded.surfaces;
    surfaces.resize_with(meshes.len(), Surface::default);
    let name = &meshes[0].name;
    let material = |(number, surface): (usize, &Surface)| Material {
        name: parts::material_name(name, number),
        ambient: 0.15,
        diffuse: 0.85,
        ..surface.material(&mut textures)
    };
    let materials: Vec<_> = surfaces.iter().enumerate().map(material).collect();
    let mut actors = vec![Actor {
        name: name.clone(),
        ..Actor::default()
    }];
    let further = parts::further(0, &actors[0], (1..meshes.len()).map(|part| [part; 2]));
    let further: Vec<_> = further.collect();
    actors.extend(further);
    parts::forget_unused(&mut meshes, actors.iter(), &materials);
    let display = Display {
        width: 320,
        height: 240,
        colour: ColourFormat::Rgb565,
        dithering: PanelDithering::None,
        background: background(ColourFormat::Rgb565),
        samples: [1, 1],
        stereo: Stereo::None,
    };
    let display = match screen {
        Some(screen) => Display {
            background: background(screen.panel.colour),
            ..screen.of(display)
        },
        None => display,
    };
    // The sphere holds the mesh however it is turned about its middle.
    let bounds = Bounds::of(&actors, &meshes, &Animation::default());
    actors[0].origin = bounds.centre();
    let animation = Animation {
        turntable: Some(TURNTABLE),
        ..Animation::default()
    };
    let (sin, cos) = libm::sincos(AZIMUTH.to_radians());
    let (up, along) = libm::sincos(ELEVATION.to_radians());
    let from = DVec3::new(sin * along, up, cos * along);
    let aspect = f64::from(display.width) / f64::from(display.height);
    let mut camera = framing::frame(&bounds, from, VIEW_ANGLE, aspect);
    let turned = Bounds::of(&actors, &meshes, &animation);
    camera.clipping_range = framing::clipping_range(&[camera], &turned);
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
        materials,
        meshes,
        actors,
        fog: None,
        animation,
        palette: Palette::default(),
        lod: None,
        ray: Ray::default(),
        source: Source {
            file: origin.path.to_owned(),
            bare: true,
            ..Source::default()
        },
    })
}
