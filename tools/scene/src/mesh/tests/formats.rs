use std::path::Path;

use super::samples::{self, INDICES};
use super::{load, mesh, refused};
use crate::Loader;
use crate::files::InMemory;

/// All samples are the same square, so all give the same mesh, bar the
/// mirrored one.
#[test]
fn every_format_gives_the_same_square() {
    for (name, bytes) in samples::all() {
        let mesh = mesh(name, &bytes);
        let side = if name == "a.glb" { -1.0 } else { 1.0 };
        let expected = [
            [0.0; 3],
            [side, 0.0, 0.0],
            [side, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ];
        if name == "a.glb" {
            assert_eq!(mesh.triangles, [[0, 1, 2], [0, 3, 1]]);
            assert_eq!(mesh.positions[1], expected[2], "{name}");
            assert_eq!(mesh.positions[2], expected[1], "{name}");
        } else {
            assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]], "{name}");
            assert_eq!(mesh.positions, expected, "{name}");
        }
        assert_eq!(mesh.normals, [[0.0, 0.0, 1.0]; 4], "{name}");
        assert_eq!(mesh.name, name);
    }
}

#[test]
fn obj_indices_may_count_backwards_and_lines_go_on() {
    let text = b"v 0 0 0\nv 1 0 0 # a corner\nv 0 1 \\\n 0\r\nf -3 \\\n-2 -1\nl 1 2\n";
    assert_eq!(mesh("a.obj", text).positions[2], [0.0, 1.0, 0.0]);
}

#[test]
fn obj_faces_may_lack_normals_where_others_have_them() {
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 3 4\n";
    let mesh = mesh("a.obj", text);
    assert_eq!(mesh.positions.len(), 6);
    assert_eq!(mesh.normals[..3], [[1.0, 0.0, 0.0]; 3]);
    assert_eq!(mesh.normals[3..], [[0.0, 0.0, 1.0]; 3]);
}

#[test]
fn a_concave_polygon_keeps_its_notch() {
    // An arrow head: the fan from its first corner would leave the outline.
    let text = b"v 0 0 0\nv 2 -2 0\nv 0 3 0\nv -2 -2 0\nf 2 3 4 1\n";
    let mesh = mesh("a.obj", text);
    assert_eq!(mesh.triangles.len(), 2);
    let area = |[a, b, c]: [[f64; 3]; 3]| {
        ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2.0
    };
    let areas: Vec<f64> = mesh
        .triangles
        .iter()
        .map(|triangle| area(triangle.map(|index| mesh.positions[index as usize])))
        .collect();
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
    assert_eq!(areas.iter().sum::<f64>(), 6.0);
}

#[test]
fn ply_strips_and_normals_are_read() {
    let text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n\
        property double z\nproperty float nx\nproperty float ny\nproperty float nz\n\
        property uchar red\nelement tristrips 1\nproperty list int int vertex_indices\n\
        end_header\n0 0 0 1 0 0 9\n1 0 0 1 0 0 9\n0 1 0 1 0 0 9\n1 1 0 1 0 0 9\n5 0 1 2 3 -1\n";
    let loaded = load("a.ply", text.as_bytes()).unwrap();
    assert_eq!(loaded.mesh.triangles, [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(loaded.mesh.normals, [[1.0, 0.0, 0.0]; 4]);
    assert_eq!(
        loaded.notes,
        ["a.ply: vertex colours are left out, as red, green or blue is missing"]
    );
}

#[test]
fn gltf_modes_give_the_same_square() {
    // Without indices the corners go round: a fan is the square.
    let fan = mesh("a.glb", &samples::glb("", r#", "mode": 6"#));
    assert_eq!(fan.triangles, [[0, 1, 2], [0, 2, 3]]);
    let strip = mesh("a.glb", &samples::glb("", r#", "mode": 5"#));
    assert_eq!(strip.triangles, [[0, 1, 2], [2, 1, 3]]);
    let message = refused("a.glb", &samples::glb("", r#", "mode": 1"#));
    assert_eq!(
        message,
        "a.glb: has no faces; expected at least one triangle"
    );
}

#[test]
fn gltf_nodes_move_their_meshes() {
    let quarter = "0.70710678";
    let node = format!(
        r#", "translation": [1, 2, 3], "scale": [2, 2, 2], "rotation": [{quarter}, 0, 0, {quarter}]"#
    );
    let mesh = mesh("a.gltf", samples::gltf(&node, INDICES).as_bytes());
    let close = |found: [f64; 3], expected: [f64; 3]| {
        found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-7)
    };
    assert!(close(mesh.positions[2], [3.0, 2.0, 5.0]));
    assert!(close(mesh.normals[2], [0.0, -1.0, 0.0]));
}

/// A URI is no name: what has a meaning in it is written by its number.
#[test]
fn gltf_buffers_beside_have_any_name() {
    let load = |name: &str, uri: &str| {
        let (text, data) = samples::gltf_beside(uri);
        let mut files = InMemory::default();
        files.insert(Path::new("a.gltf"), text.into());
        files.insert(Path::new(name), data);
        let loaded = Loader::new(&files).load(Path::new("a.gltf"));
        loaded.map_err(|error| error.to_string())
    };
    for (name, uri) in [
        ("a square.bin", "a%20square.bin"),
        ("größe #1.bin", "gr%C3%B6%c3%9fe%20%231.bin"),
        ("100%.bin", "100%.bin"),
    ] {
        let (scene, _) = load(name, uri).unwrap();
        assert_eq!(scene.meshes[0].triangles.len(), 2, "{uri}");
    }
    let message = load("a.bin", "%ff.bin").unwrap_err();
    assert!(message.contains("\"%ff.bin\" is no name"), "{message}");
}

#[test]
fn a_gltf_base_colour_is_display_encoded() {
    let colour = load("a.glb", &samples::glb("", INDICES)).unwrap().surfaces;
    let [red, green, blue] = colour[0].colour;
    assert_eq!([red, green], [1.0, 0.0]);
    assert!((blue - 0.735_356_9).abs() < 1e-6);
}

#[test]
fn messages_say_where() {
    let obj = |text: &str| refused("a.obj", text.as_bytes());
    let three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let face = "expected e.g. f 1 2 3 or f 1/1 2/2 3/3 or f 1//1 2//2 3//3";
    assert_eq!(
        obj("v 0 0\n"),
        "a.obj:1: v: has 2 numbers where 3 belong; expected e.g. v 0 0.5 1"
    );
    assert_eq!(
        obj("\nv 0 x 0\n"),
        "a.obj:2: v: \"x\" is not a number; expected e.g. v 0 0.5 1"
    );
    assert_eq!(
        obj("v 0 nan 0\n"),
        "a.obj:1: v: is not finite, or beyond 1e9; expected e.g. v 0 0.5 1"
    );
    assert_eq!(
        obj(&format!("{three}f 1 2 4\n")),
        format!("a.obj:4: f: vertex index 4 is out of range (the file has 3); {face}")
    );
    assert_eq!(
        obj(&format!("{three}f 0 1 2\n")),
        format!("a.obj:4: f: vertex index 0 is out of range (the file has 3); {face}")
    );
    assert_eq!(
        obj(&format!("{three}f 1//1 2 3\n")),
        format!("a.obj:4: f: normal index 1 is out of range (the file has 0); {face}")
    );
    assert_eq!(
        obj(&format!("{three}f\n")),
        format!("a.obj:4: f: has 0 vertices where at least 3 belong; {face}")
    );
    assert_eq!(
        obj(three),
        "a.obj: has no faces; expected at least one triangle"
    );
    assert_eq!(
        obj(&format!("{three}f 1 1 2\n")),
        "a.obj: has no triangle with an area"
    );
    let ply = |from: &str, to: &str| refused("a.ply", samples::PLY.replace(from, to).as_bytes());
    assert_eq!(
        ply("4 0 1 2 3", "4 0 1 2 7"),
        "a.ply:15: face 0: vertex index 7 is out of range (the file has 4)"
    );
    assert_eq!(
        ply("1 1 0\n", "1 x 0\n"),
        "a.ply:13: no valid PLY: Couldn't read element line."
    );
    assert_eq!(
        ply("float z", "float w"),
        "a.ply:11: vertex 0: lacks a property; expected x, y and z"
    );
    let stl = |from: &str, to: &str| {
        refused(
            "a.stl",
            samples::stl_ascii().replacen(from, to, 1).as_bytes(),
        )
    };
    assert_eq!(
        stl("vertex 1 0", "vertex 1 zero"),
        "a.stl:5: vertex: is not three finite numbers within 1e9; expected e.g. vertex 0 0.5 1"
    );
    assert_eq!(
        stl("endsolid", ""),
        "a.stl:16: \"square\" does not belong here; \
         expected facet, outer loop, vertex, endloop, endfacet or endsolid"
    );
    let mut cut = samples::stl_binary();
    cut[..5].copy_from_slice(b"plain");
    cut.truncate(100);
    assert_eq!(
        refused("a.stl", &cut),
        "a.stl: says it has 2 triangles, which take 184 bytes, but has 100 bytes"
    );
    let draco = samples::gltf("", INDICES).replacen(
        '{',
        r#"{"extensionsRequired": ["KHR_draco_mesh_compression"],"#,
        1,
    );
    assert_eq!(
        refused("a.gltf", draco.as_bytes()),
        "a.gltf: extensionsRequired: \"KHR_draco_mesh_compression\" is not supported; \
         expected a file without it, e.g. exported without compression"
    );
    let text = samples::gltf("", INDICES);
    let beyond = text.replace("\"count\": 6", "\"count\": 7");
    assert_eq!(
        refused("a.gltf", beyond.as_bytes()),
        "a.gltf: accessors[0]: reaches beyond its buffer, or is empty"
    );
    let circle = text.replace("\"mesh\": 0 ", "\"mesh\": 0, \"children\": [0] ");
    assert_eq!(
        refused("a.gltf", circle.as_bytes()),
        "a.gltf: nodes[0]: has more than one parent"
    );
    assert!(refused("a.gltf", b"{\n\"asset\": }").starts_with("a.gltf:2: no valid glTF"));
}
