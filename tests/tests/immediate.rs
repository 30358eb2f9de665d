//! What is drawn by call is what the same thing is as an actor.

use fixel::Band;
use fixel::frame::Target;
use fixel::immediate::{Immediate, Pen};
use fixel::math::{Vec3, World};
use fixel::render::Bands;
use fixel::scene::Scene;
use fixel_bake::Baked;
use fixel_scene::{Dithering, Light, LightKind, Material, Mesh, Scene as Description, Shading};
use fixel_tests::made;

/// Indices and depths of a frame in bands of `rows`, each of which `over` draws over.
fn frame(
    scene: &Scene<'_>,
    rows: u16,
    mut over: impl FnMut(&mut Immediate<'_>, &mut Target<'_>),
) -> (Vec<u8>, Vec<u16>) {
    let pixels = usize::from(scene.frame_width()) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(scene.frame_width(), &mut indices, &mut depths).expect("a band");
    let mut scratch = Box::new(fixel::Scratch::<64, 8, 4>::new());
    let (pose, mut work) = (scene.pose(0), scratch.workspace());
    let mut immediate = Immediate::new(scene, &pose, 0, scene.frame_width());
    let mut bands = Bands::new(scene, &pose, &mut work, &mut band);
    let mut all = (Vec::new(), Vec::new());
    while let Some(mut target) = bands.next_target() {
        over(&mut immediate, &mut target);
        all.0.extend(&*target.indices);
        all.1.extend(&*target.depths);
    }
    all
}

/// The same of what `draw` draws alone.
fn alone(
    scene: &Scene<'_>,
    rows: u16,
    mut draw: impl FnMut(&mut Immediate<'_>, &mut Target<'_>),
) -> (Vec<u8>, Vec<u16>) {
    frame(scene, rows, |immediate, target| {
        target.clear(|y| scene.background(y, scene.frame_height()));
        draw(immediate, target);
    })
}

/// A place of the description in the world.
fn world(scene: &Scene<'_>, place: [f64; 3]) -> Vec3 {
    let [x, y, z] = place.map(World::from_num);
    scene.world(Vec3::new(x, y, z))
}

fn draw_mesh(scene: &Scene<'_>, mesh: &Mesh, immediate: &mut Immediate<'_>, t: &mut Target<'_>) {
    for triangle in &mesh.triangles {
        let corners = triangle.map(|i| world(scene, mesh.positions[i as usize]));
        immediate.triangle(t, corners);
    }
}

/// Pixels that only one of two frames covers, pixels of both, and of these those whose
/// depths are more than 2 units apart and whose indices differ.
fn differences(a: &(Vec<u8>, Vec<u16>), b: &(Vec<u8>, Vec<u16>)) -> [usize; 4] {
    let mut counts = [0; 4];
    for i in 0..a.0.len() {
        let (za, zb) = (a.1[i], b.1[i]);
        if (za == 0) != (zb == 0) {
            counts[0] += 1;
        } else if za != 0 {
            counts[1] += 1;
            counts[2] += usize::from(za.abs_diff(zb) > 2);
            counts[3] += usize::from(a.0[i] != b.0[i]);
        }
    }
    counts
}

fn flat(mesh: &str, specular: f64) -> (Description, Baked) {
    let mut description = made::empty();
    description.palette.dithering = Dithering::None;
    description.materials.push(Material {
        ambient: 0.1,
        specular,
        shading: Shading::Flat,
        ..Material::default()
    });
    made::add(&mut description, made::mesh(mesh), [0.0; 3]);
    let places = &description.meshes[0].positions;
    let most = |sign: f64, c: usize| places.iter().fold(f64::MIN, |m, p| m.max(sign * p[c]));
    let middle: [f64; 3] = std::array::from_fn(|c| (most(1.0, c) - most(-1.0, c)) / 2.0);
    let size = (most(1.0, 0) + most(-1.0, 0)) / 2.0;
    let offset = [1.6, 2.4, 6.0];
    description.camera.position = std::array::from_fn(|c| middle[c] + size * offset[c]);
    description.camera.focal_point = middle;
    description.camera.clipping_range = [size, 40.0 * size];
    bake(description)
}

fn bake(description: Description) -> (Description, Baked) {
    let baked = fixel_bake::bake(&description).unwrap_or_else(|e| panic!("{e}"));
    (description, baked)
}

#[test]
fn triangles_are_where_an_actor_s_are() {
    for mesh in ["cube", "bunny"] {
        let (description, baked) = flat(mesh, 0.0);
        let scene = baked.scene().expect("baked a moment ago");
        let actor = frame(&scene, 120, |_, _| {});
        let mesh = &description.meshes[0];
        let by_call = alone(&scene, 120, |i, t| draw_mesh(&scene, mesh, i, t));
        let [coverage, covered, depth, index] = differences(&actor, &by_call);
        assert!(covered > 2000, "{covered} pixels");
        assert!(coverage <= 2, "{coverage} of {covered} pixels covered");
        assert!(depth * 500 <= covered, "{depth} of {covered} depths");
        assert!(index * 50 <= covered, "{index} of {covered} indices");
        for rows in [1, 7, 16] {
            let bands = alone(&scene, rows, |i, t| draw_mesh(&scene, mesh, i, t));
            assert!(bands == by_call, "bands of {rows}");
        }
    }
}

#[test]
fn what_is_behind_the_eye_is_clipped() {
    let (mut description, _) = flat("cube", 0.0);
    description.camera.position = [0.3, 0.2, 0.9];
    description.camera.focal_point = [0.1, 0.0, -1.0];
    description.camera.clipping_range = [0.1, 20.0];
    description.materials[0].cull = fixel_scene::Cull::None;
    for (position, focal_point) in [
        ([0.3, 0.2, 0.9], [0.1, 0.0, -1.0]),
        ([0.45, 0.3, 0.49], [-3.0, 0.0, 0.4]),
    ] {
        description.camera.position = position;
        description.camera.focal_point = focal_point;
        let (description, baked) = bake(description.clone());
        let scene = baked.scene().expect("baked a moment ago");
        let actor = frame(&scene, 120, |_, _| {});
        let mesh = &description.meshes[0];
        let by_call = alone(&scene, 120, |i, t| draw_mesh(&scene, mesh, i, t));
        let [coverage, covered, depth, _] = differences(&actor, &by_call);
        assert!(covered > 5000, "{covered} pixels");
        assert!(coverage <= 4, "{coverage} of {covered} pixels covered");
        assert!(depth * 500 <= covered, "{depth} of {covered} depths");
    }
}

#[test]
fn light_is_an_actor_s() {
    let (mut description, _) = flat("cube", 0.4);
    description.lights.push(Light {
        kind: LightKind::Point {
            position: [2.0, 2.0, 2.0],
            attenuation: [1.0, 0.1, 0.0],
        },
        colour: [1.0, 0.6, 0.2],
        intensity: 0.8,
        edges: None,
    });
    let (description, baked) = bake(description);
    let scene = baked.scene().expect("baked a moment ago");
    let actor = frame(&scene, 120, |_, _| {});
    let mesh = &description.meshes[0];
    let by_call = alone(&scene, 120, |i, t| draw_mesh(&scene, mesh, i, t));
    let mut worst = 0;
    for i in 0..actor.0.len() {
        if actor.1[i] != 0 && by_call.1[i] != 0 {
            let [a, b] = [&actor, &by_call].map(|f| scene.palette()[usize::from(f.0[i])]);
            let far = a.into_iter().zip(b).map(|(a, b)| a.abs_diff(b));
            worst = far.fold(worst, u8::max);
        }
    }
    // A step of the look-up's 4 bits.
    assert!(worst <= 17, "{worst} of 255");
    let seen: std::collections::HashSet<u8> = by_call.0.iter().copied().collect();
    assert!(seen.len() >= 4, "sides differ: {seen:?}");
}

#[test]
fn lines_are_those_of_the_file() {
    let path = fixel_tests::root().join("tests/data/polyline.toml");
    let (description, baked) = fixel_tests::load(&path);
    let scene = baked.scene().expect("baked a moment ago");
    let line = &description.actors[0];
    let places: Vec<Vec3> = description.meshes[line.mesh]
        .positions
        .iter()
        .map(|place| world(&scene, std::array::from_fn(|c| place[c] + line.position[c])))
        .collect();
    assert_eq!(places.len(), 7, "one for each point of the file");
    let in_file = frame(&scene, 64, |_, _| {});
    let pen = Pen {
        index: in_file.0[in_file.1.iter().position(|z| *z != 0).expect("a line")],
        width: line.look.line_width as u8,
        ..Pen::ONE_PIXEL
    };
    let by_call = alone(&scene, 64, |i, t| i.polyline(t, &places, pen));
    let [coverage, covered, depth, index] = differences(&in_file, &by_call);
    assert!(covered > 500, "{covered} pixels");
    assert!(coverage <= 2, "{coverage} of {covered} pixels covered");
    assert_eq!((depth, index), (0, 0), "of {covered} depths and indices");
    for rows in [1, 7] {
        let bands = alone(&scene, rows, |i, t| i.polyline(t, &places, pen));
        assert!(bands == by_call, "bands of {rows}");
    }
}

#[test]
fn a_sphere_is_round() {
    let mut description = made::empty();
    description.materials.push(Material {
        ambient: 0.1,
        ..Material::default()
    });
    description.palette.dithering = Dithering::None;
    made::add(&mut description, made::ball(0.8), [0.1, 0.2, -0.3]);
    description.camera.position = [0.5, 1.0, 3.0];
    description.camera.focal_point = [0.0; 3];
    description.camera.clipping_range = [0.5, 20.0];
    let (description, baked) = bake(description);
    let scene = baked.scene().expect("baked a moment ago");
    let (width, height) = (160i32, 120i32);
    let centre = world(&scene, [0.1, 0.2, -0.3]);
    let radius = world(&scene, [0.8, 0.0, 0.0]).x - world(&scene, [0.0; 3]).x;
    let by_call = alone(&scene, 120, |i, t| i.sphere(t, centre, radius));
    let for_rays = fixel_bake::bake_for_rays(&description).expect("a ball bakes");
    let rays = for_rays.scene().expect("baked a moment ago");
    let rays = fixel_host::render_rays(&rays, &fixel_host::Options::of(&rays)).depth;
    let covered = rays.iter().filter(|z| **z != 0).count();
    assert!(covered > 1500, "{covered} pixels");
    let there = |z: &[u16], x: i32, y: i32| {
        (0..width).contains(&x) && (0..height).contains(&y) && z[(y * width + x) as usize] != 0
    };
    let mut differ = 0;
    for y in 0..height {
        for x in 0..width {
            if there(&rays, x, y) != there(&by_call.1, x, y) {
                differ += 1;
                // Only at the outline.
                let around = [(-1, 0), (1, 0), (0, -1), (0, 1)];
                let edge = around
                    .iter()
                    .any(|(dx, dy)| there(&rays, x + dx, y + dy) != there(&rays, x, y));
                assert!(edge, "pixel {x}, {y} is not at the outline");
            }
        }
    }
    assert!(differ * 50 < covered, "{differ} of {covered} pixels");
    let levels: std::collections::HashSet<u8> = by_call.0.iter().copied().collect();
    assert!(levels.len() > 20, "{} levels", levels.len());
}

#[test]
fn places_are_those_of_actors() {
    for offset in [0.0, 3000.0] {
        let mut description = made::empty();
        let place = [offset + 0.25, -0.5, 0.125];
        made::add(&mut description, made::cube(), place);
        made::add(&mut description, made::cube(), [offset + 2.0, 0.0, 0.0]);
        description.camera.position = [offset, 0.0, 6.0];
        description.camera.focal_point = [offset, 0.0, 0.0];
        let (_, baked) = bake(description);
        let scene = baked.scene().expect("baked a moment ago");
        let found = world(&scene, place).to_bits();
        let wanted = scene.actor(0).position;
        assert!(
            found.iter().zip(wanted).all(|(a, b)| a.abs_diff(b) <= 1),
            "{found:?}, {wanted:?}"
        );
    }
}
