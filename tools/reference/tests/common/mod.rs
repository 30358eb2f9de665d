//! Scenes with answers known beforehand.

#![allow(dead_code, reason = "each test file uses a part")]

use fixel_reference::{Options, Truth, render};
use fixel_scene::{
    Actor, Animation, Background, Camera, ColourFormat, Display, Light, LightKind, Material, Mesh,
    Palette, PanelDithering, Projection, Ray, Scene, Shading, Source, Stereo,
};

/// Distance of the plane z = 0 from the eye in [`parallel`] and [`perspective`].
pub const EYE: f64 = 10.0;
/// Near and far plane there.
pub const RANGE: [f64; 2] = [1.0, 21.0];

/// A scene without actors, seen by a parallel camera for which the world point
/// (x, -y, z) falls on screen position (x, y) in pixels; z = 0 is `EYE` away.
pub fn parallel(width: u32, height: u32) -> Scene {
    scene(
        width,
        height,
        Projection::Parallel {
            parallel_scale: f64::from(height) / 2.0,
        },
    )
}

/// The same by a perspective camera; it holds for z = 0 only.
pub fn perspective(width: u32, height: u32) -> Scene {
    let view_angle = 2.0 * (f64::from(height) / 2.0 / EYE).atan().to_degrees();
    scene(width, height, Projection::Perspective { view_angle })
}

fn scene(width: u32, height: u32, projection: Projection) -> Scene {
    let (x, y) = (f64::from(width) / 2.0, -f64::from(height) / 2.0);
    Scene {
        display: Display {
            width,
            height,
            colour: ColourFormat::Rgb888,
            dithering: PanelDithering::None,
            background: Background::Solid([0.0; 3]),
            samples: [1, 1],
            stereo: Stereo::None,
        },
        camera: Camera {
            position: [x, y, EYE],
            focal_point: [x, y, 0.0],
            view_up: [0.0, 1.0, 0.0],
            projection,
            clipping_range: RANGE,
        },
        viewports: Vec::new(),
        ambient: [1.0; 3],
        lights: vec![white_light([0.0, 0.0, -1.0])],
        textures: Vec::new(),
        materials: vec![material()],
        meshes: Vec::new(),
        actors: Vec::new(),
        fog: None,
        animation: Animation::default(),
        palette: Palette::default(),
        lod: None,
        ray: Ray::default(),
        source: Source::default(),
    }
}

/// White, flat, diffuse only, back faces left out.
pub fn material() -> Material {
    Material {
        name: "white".into(),
        shading: Shading::Flat,
        ..Material::default()
    }
}

/// A light that travels along `direction`.
pub fn white_light(direction: [f64; 3]) -> Light {
    Light {
        kind: LightKind::Directional { direction },
        colour: [1.0; 3],
        intensity: 1.0,
        edges: None,
    }
}

/// A mesh of separate triangles; normals are those of the faces.
pub fn mesh(triangles: &[[[f64; 3]; 3]]) -> Mesh {
    let mut mesh = Mesh {
        name: "made".into(),
        ..Mesh::default()
    };
    for corners in triangles {
        let first = mesh.positions.len() as u32;
        let [a, b, c] = corners.map(glam::DVec3::from);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        mesh.positions.extend(corners);
        mesh.normals.extend([normal.to_array(); 3]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    mesh
}

/// Two triangles, counter-clockwise corners.
pub fn quad([a, b, c, d]: [[f64; 3]; 4]) -> Mesh {
    mesh(&[[a, b, c], [a, c, d]])
}

/// A rectangle on the screen in pixels, facing the eye, at height `z`.
pub fn screen_rect([left, top]: [f64; 2], [right, bottom]: [f64; 2], z: f64) -> Mesh {
    quad([
        [left, -bottom, z],
        [right, -bottom, z],
        [right, -top, z],
        [left, -top, z],
    ])
}

/// A sphere about 0 of quads split in two; vertices on the sphere.
pub fn sphere(radius: f64, slices: u32, stacks: u32) -> Mesh {
    let mut mesh = Mesh {
        name: "sphere".into(),
        ..Mesh::default()
    };
    for stack in 0..=stacks {
        for slice in 0..slices {
            let polar = std::f64::consts::PI * f64::from(stack) / f64::from(stacks);
            let around = std::f64::consts::TAU * f64::from(slice) / f64::from(slices);
            let n = [
                polar.sin() * around.sin(),
                polar.cos(),
                polar.sin() * around.cos(),
            ];
            mesh.positions.push(n.map(|v| v * radius));
            mesh.normals.push(n);
        }
    }
    for stack in 0..stacks {
        for slice in 0..slices {
            let at = |stack, slice| stack * slices + slice % slices;
            let (a, b) = (at(stack + 1, slice), at(stack + 1, slice + 1));
            let (c, d) = (at(stack, slice + 1), at(stack, slice));
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// Adds a mesh as an actor of its own with material 0; returns the actor.
pub fn add(scene: &mut Scene, mesh: Mesh) -> &mut Actor {
    scene.meshes.push(mesh);
    scene.actors.push(Actor {
        name: "actor".into(),
        mesh: scene.meshes.len() - 1,
        material: 0,
        ..Actor::default()
    });
    scene.actors.last_mut().unwrap()
}

/// Renders at the display's size.
pub fn truth(scene: &Scene) -> Truth {
    truth_at(scene, 0)
}

/// Renders a frame at the display's size.
pub fn truth_at(scene: &Scene, frame: u32) -> Truth {
    let (width, height) = (scene.display.width, scene.display.height);
    render(
        scene,
        Options {
            width,
            height,
            frame,
        },
    )
}

/// What is covered, drawn: `#` or `.` for each pixel.
pub fn drawing(truth: &Truth) -> Vec<String> {
    let cell = |x, y| if truth.hit(x, y).is_some() { '#' } else { '.' };
    let row = |y| (0..truth.width()).map(move |x| cell(x, y));
    (0..truth.height()).map(|y| row(y).collect()).collect()
}
