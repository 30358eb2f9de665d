//! Hidden lines: what should be seen is, without gaps (stitching), and nothing that
//! should not be (leaking).

use std::collections::{HashMap, HashSet};

use fixel_host::{Options, render};
use fixel_scene::{Actor, Material, Mesh, Projection, Representation, Scene};
use fixel_tests::root;

/// A scene with one white actor before black.
fn scene(mesh: &Mesh, orientation: [f64; 3], projection: Projection, width: u32) -> Scene {
    let mut scene = fixel_scene::load(&root().join("scenes/hidden_line.toml")).expect("a scene");
    scene.display.background = fixel_scene::Background::Solid([0.0; 3]);
    scene.materials = vec![Material {
        emission: 1.0,
        diffuse: 0.0,
        ..Material::default()
    }];
    scene.meshes = vec![mesh.clone()];
    scene.camera.projection = projection;
    scene.camera.clipping_range = [6.0, 15.0];
    let actor: &mut Actor = &mut scene.actors[0];
    actor.mesh = 0;
    actor.material = 0;
    actor.position = [0.0; 3];
    actor.scale = [1.7; 3];
    actor.orientation = orientation;
    actor.look.representation = Representation::HiddenLine;
    actor.look.line_width = width;
    scene.actors.truncate(1);
    scene
}

/// Pixels that are not the background's.
fn lit(scene: &Scene) -> HashSet<(usize, usize)> {
    let baked = fixel_bake::bake(scene).expect("it bakes");
    let core = baked.scene().expect("baked a moment ago");
    let drawn = render(&core, &Options::of(&core));
    let background = core.background(0, core.height());
    let width = usize::from(core.width());
    let on = drawn
        .index
        .iter()
        .enumerate()
        .filter(|(_, i)| **i != background);
    on.map(|(i, _)| (i % width, i / width)).collect()
}

/// The edges of a convex mesh that are seen: those of a face that shows its front.
fn seen(scene: &Scene) -> Mesh {
    let mesh = &scene.meshes[0];
    let matrix = fixel_reference::actor_matrix(scene, 0, 0);
    let view = fixel_reference::View::new(&scene.camera, 320, 240);
    let place = |index: u32| {
        let [x, y, z] = mesh.positions[index as usize];
        view.to_view(matrix.transform_point3([x, y, z].into()))
    };
    let key = |index: u32| mesh.positions[index as usize].map(|c| (c * 1e6).round() as i64);
    let mut front: HashMap<[[i64; 3]; 2], bool> = HashMap::new();
    for [a, b, c] in &mesh.triangles {
        let corners = [*a, *b, *c].map(place);
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let shows = match scene.camera.projection {
            Projection::Perspective { .. } => normal.dot(corners[0]) > 0.0,
            Projection::Parallel { .. } => normal.z > 0.0,
        };
        for side in [[*a, *b], [*b, *c], [*c, *a]] {
            let mut ends = side.map(key);
            ends.sort_unstable();
            *front.entry(ends).or_default() |= shows;
        }
    }
    let shown = |edge: &&[u32; 2]| {
        let mut ends = edge.map(key);
        ends.sort_unstable();
        front.get(&ends).copied().unwrap_or_default()
    };
    Mesh {
        edges: mesh.edges.iter().filter(shown).copied().collect(),
        ..mesh.clone()
    }
}

#[test]
fn convex_bodies_show_just_the_edges_of_their_front() {
    let files = ["cube", "sphere"];
    let meshes = files.map(|name| {
        let path = root().join(format!("scenes/meshes/{name}.obj"));
        fixel_scene::load_mesh(&path).expect("a mesh")
    });
    let perspective = Projection::Perspective { view_angle: 30.0 };
    let parallel = Projection::Parallel {
        parallel_scale: 2.5,
    };
    let (mut pixels, mut missing, mut extra) = (0, 0, 0);
    for mesh in &meshes {
        for projection in [perspective, parallel] {
            for (turn, width) in (0..12).flat_map(|turn| [1, 3].map(|width| (turn, width))) {
                let angle = f64::from(turn) * 31.0;
                let mut scene = scene(mesh, [angle * 0.7, angle, 10.0], projection, width);
                let hidden = lit(&scene);
                let shown = seen(&scene);
                scene.meshes = vec![shown];
                scene.actors[0].look.representation = Representation::Wireframe;
                scene.actors[0].look.depth_test = false;
                let wanted = lit(&scene);
                pixels += wanted.len();
                missing += wanted.difference(&hidden).count();
                extra += hidden.difference(&wanted).count();
            }
        }
    }
    assert!(pixels > 500_000);
    assert_eq!(missing, 0, "stitches, of {pixels} pixels");
    assert!(
        extra * 10_000 <= pixels,
        "leaks: {extra} of {pixels} pixels"
    );
}
