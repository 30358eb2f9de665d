//! Scenes out of bytes, held against the f64 reference: what the core covers is what the
//! reference covers, but for pixels at an outline.

use std::f64::consts::TAU;
use std::sync::LazyLock;

use fixel_host::Options;
use fixel_scene::{Camera, Cull, Display, LightKind, Material, Mesh, Projection, Scene, Shading};

use super::numbers::Numbers;
use crate::made;

const SIZE: (u32, u32) = (48, 36);

/// Things are at most this far from the origin, in scene units before all is scaled.
const REACH: f64 = 8.0;

/// Bakes a scene, draws it by triangles and by rays, and looks where it differs from the
/// reference. A scene that is not baked has been refused with a message.
pub fn scene(bytes: &[u8]) {
    let mut numbers = Numbers(bytes);
    let scene = described(&mut numbers);
    let Ok(baked) = fixel_bake::bake(&scene) else {
        return;
    };
    let core = baked.scene().expect("baked a moment ago");
    let options = |rows| Options {
        band_rows: Some(rows),
        ..Options::of(&core)
    };
    let drawn = fixel_host::render(&core, &options(7));
    let (width, height) = SIZE;
    let of = fixel_reference::Options {
        width,
        height,
        frame: 0,
    };
    let truth = fixel_reference::render(&scene, of);
    let covered: Vec<bool> = truth.pixels().iter().map(Option::is_some).collect();
    let by_core: Vec<bool> = drawn.depth.iter().map(|z| *z != 0).collect();
    hold("triangles", &scene, &covered, &by_core);

    let Ok(baked) = fixel_bake::bake_for_rays(&scene) else {
        return;
    };
    let core = baked.scene().expect("baked a moment ago");
    let drawn = fixel_host::render_rays(&core, &options(7));
    let truth = fixel_reference::render_rays(&scene, of);
    let covered: Vec<bool> = truth.pixels().iter().map(Option::is_some).collect();
    let by_core: Vec<bool> = drawn.depth.iter().map(|z| *z != 0).collect();
    hold("rays", &scene, &covered, &by_core);
}

/// Pixels that differ have one beside them that is otherwise in one of the two pictures;
/// few enough do not, where something is thinner than a pixel.
fn hold(what: &str, scene: &Scene, truth: &[bool], core: &[bool]) {
    let (width, height) = (SIZE.0 as i32, SIZE.1 as i32);
    let at = |plane: &[bool], x: i32, y: i32| {
        let inside = (0..width).contains(&x) && (0..height).contains(&y);
        inside.then(|| plane[(y * width + x) as usize])
    };
    let mut alone = 0;
    for y in 0..height {
        for x in 0..width {
            let (t, c) = (at(truth, x, y), at(core, x, y));
            if t == c {
                continue;
            }
            let mut around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
            let edge = around.any(|(x, y)| {
                let other = |plane, own| at(plane, x, y).is_some_and(|o| Some(o) != own);
                other(truth, t) || other(core, c)
            });
            alone += usize::from(!edge);
        }
    }
    let differ = truth.iter().zip(core).filter(|(t, c)| t != c).count();
    let most = MOST_AT_OUTLINES.max(truth.len() / 200);
    assert!(
        alone == 0 && differ <= most,
        "by {what} {differ} pixels differ, {alone} of them away from any outline: {scene:#?}"
    );
}

/// Pixels of [`SIZE`] whose centre an outline may all but meet.
const MOST_AT_OUTLINES: usize = 6;

static BASE: LazyLock<Scene> = LazyLock::new(made::empty);
static CUBE: LazyLock<Mesh> = LazyLock::new(made::cube);
static BALL: LazyLock<Mesh> = LazyLock::new(|| made::ball(0.7));

fn described(n: &mut Numbers<'_>) -> Scene {
    let mut scene = BASE.clone();
    let unit = 10f64.powi(n.below(9) as i32 - 4);
    let (width, height) = SIZE;
    scene.display = Display {
        width,
        height,
        ..scene.display
    };
    scene.camera = camera(n, unit);
    scene.lights = vec![made::far_light([n.between(-1.0, 1.0), -1.0, -0.4])];
    if n.below(3) == 0 {
        scene.lights.push(made::lamp(n.place(REACH * unit)));
        if let LightKind::Point { attenuation, .. } = &mut scene.lights[1].kind {
            *attenuation = [1.0, n.between(0.0, 0.5) / unit, 0.0];
        }
    }
    scene.materials = (0..3).map(|i| material(n, i)).collect();
    for number in 0..1 + n.below(4) {
        let mesh = match n.below(4) {
            0 => CUBE.clone(),
            1 => BALL.clone(),
            _ => mesh(n, number),
        };
        let position = n.place(REACH / 2.0).map(|c| c * unit);
        let actor = made::add(&mut scene, mesh, position);
        actor.material = n.below(3);
        actor.orientation = [0; 3].map(|_| n.between(-360.0, 360.0));
        let even = n.between(0.05, 3.0) * unit;
        actor.scale = match n.below(4) {
            0 => [0; 3].map(|_| even * n.one_of(&[1.0, -1.0, 0.3])),
            _ => [even; 3],
        };
    }
    scene
}

fn camera(n: &mut Numbers<'_>, unit: f64) -> Camera {
    let near = unit * n.one_of(&[0.02, 0.1, 0.5, 2.0]);
    Camera {
        position: n.place(REACH).map(|c| c * unit),
        focal_point: n.place(1.0).map(|c| c * unit),
        view_up: n.one_of(&[[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, 1.0, -0.2]]),
        projection: match n.below(3) {
            0 => Projection::Parallel {
                parallel_scale: n.between(0.2, 6.0) * unit,
            },
            _ => Projection::Perspective {
                view_angle: n.between(5.0, 120.0),
            },
        },
        clipping_range: [near, near + unit * n.one_of(&[1.0, 6.0, 40.0])],
    }
}

fn material(n: &mut Numbers<'_>, number: usize) -> Material {
    Material {
        name: format!("material {number}"),
        ambient: 0.2,
        shading: n.one_of(&[Shading::Flat, Shading::Gouraud, Shading::Phong]),
        cull: n.one_of(&[Cull::Back, Cull::None, Cull::Front]),
        specular: n.one_of(&[0.0, 0.0, 0.5]),
        specular_power: 8.0,
        diffuse_colour: n.one_of(&[[1.0; 3], [0.9, 0.5, 0.1]]),
        ..Material::default()
    }
}

/// Triangles between some points of which several coincide: without area, thin, through
/// one another.
fn mesh(n: &mut Numbers<'_>, number: usize) -> Mesh {
    let positions: Vec<[f64; 3]> = (0..3 + n.below(10)).map(|_| n.place(2.0)).collect();
    let normal = |n: &mut Numbers<'_>| {
        let (turn, up) = (n.between(0.0, TAU), n.between(-1.0, 1.0));
        let around = (1.0 - up * up).sqrt();
        [around * turn.cos(), up, around * turn.sin()]
    };
    let normals = positions.iter().map(|_| normal(n)).collect();
    let corner = |n: &mut Numbers<'_>| n.below(positions.len()) as u32;
    let triangles = (0..1 + n.below(12)).map(|_| [0; 3].map(|_| corner(n)));
    let triangles: Vec<[u32; 3]> = triangles.collect();
    Mesh {
        name: format!("mesh {number}"),
        triangles,
        normals,
        positions,
        ..Mesh::default()
    }
}
