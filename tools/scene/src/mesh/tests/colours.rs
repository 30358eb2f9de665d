//! Vertex colours.

use super::samples::{self, BYTES, COLOURED_PLY};
use super::{load, mesh, refused};
use crate::description::Rgb;

const RED: Rgb = [1.0, 0.0, 0.0];

#[test]
fn ply_colours_are_display_encoded() {
    let mesh = mesh("a.ply", COLOURED_PLY.as_bytes());
    assert_eq!(mesh.colours, [RED, [0.0, 0.2, 0.0], [0.0, 0.0, 1.0], RED]);
    assert_eq!(mesh.positions.len(), 4);
}

#[test]
fn ply_colours_may_be_of_any_type_and_name() {
    let floats = COLOURED_PLY
        .replace("uchar red", "float r")
        .replace("uchar green", "double diffuse_green")
        .replace("uchar blue", "ushort b")
        .replace("255 0 0 9", "0.25 0.5 13107 9")
        .replace("0 51 0 9", "0 1 0 9")
        .replace("0 0 255 9", "0 0 65535 9");
    let mesh = mesh("a.ply", floats.as_bytes());
    assert_eq!(mesh.colours[0], [0.25, 0.5, 0.2]);
    assert_eq!(mesh.colours[1], [0.0, 1.0, 0.0]);
    assert_eq!(mesh.colours[2], [0.0, 0.0, 1.0]);
    let too_much = floats.replace("0.25 0.5", "64 128");
    assert_eq!(
        refused("a.ply", too_much.as_bytes()),
        "a.ply:14: vertex 0: has a colour out of range; expected red, green and blue \
         in 0..=255 as uchar, or in 0..=1 as float"
    );
}

#[test]
fn obj_colours_stand_after_the_position_and_its_weight() {
    let text = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0.2 0\nv 0 1 0 0.5\nf 1 2 3\n";
    let mesh = mesh("a.obj", text.as_bytes());
    assert_eq!(mesh.colours, [RED, [0.0, 0.2, 0.0], [1.0; 3]]);
    let expected = "a.obj:1: v: has a colour out of range; \
        expected red, green and blue in 0..=1, e.g. v 0 0.5 1 1 0.5 0";
    for wrong in ["255 0 0", "1 -0.1 0", "1 nan 0", "1 0 x"] {
        let text = text.replacen("1 0 0", wrong, 1);
        assert_eq!(refused("a.obj", text.as_bytes()), expected);
    }
}

#[test]
fn two_colours_at_one_place_are_two_vertices() {
    // Two triangles side by side, each with its own vertices.
    let text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n\
        property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
        element face 2\nproperty list uchar int vertex_indices\nend_header\n\
        0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n\
        1 0 0 0 0 0\n1 1 0 0 0 0\n0 1 0 255 0 0\n3 0 1 2\n3 3 4 5\n";
    let mesh = mesh("a.ply", text.as_bytes());
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 2]]);
    assert_eq!(mesh.colours, [RED, RED, RED, [0.0; 3], [0.0; 3]]);
}

#[test]
fn white_is_no_colour() {
    let white = COLOURED_PLY
        .replace("255 0 0 9", "255 255 255 9")
        .replace("0 51 0 9", "255 255 255 9")
        .replace("0 0 255 9", "255 255 255 9");
    assert!(mesh("a.ply", white.as_bytes()).colours.is_empty());
}

#[test]
fn gltf_colours_are_linear_and_become_display_encoded() {
    // Half of the light is 188 of 255 on a display, near enough.
    let floats: Vec<u8> = [
        [1.0_f32, 0.0, 0.5],
        [0.0; 3],
        [2.0, -1.0, f32::NAN],
        [1.0; 3],
    ]
    .as_flattened()
    .iter()
    .flat_map(|channel| channel.to_le_bytes())
    .collect();
    let kind = r#""componentType": 5126, "type": "VEC3""#;
    let colours = mesh("a.glb", &samples::coloured_glb(kind, &floats)).colours;
    assert_eq!(colours[0][..2], [1.0, 0.0]);
    assert!((colours[0][2] - 0.735_356_9).abs() < 1e-6);
    assert_eq!(colours[1..], [[0.0; 3], RED, [1.0; 3]]);

    let mut bytes = [255; 16];
    bytes[1] = 55;
    let colours = mesh("a.glb", &samples::coloured_glb(BYTES, &bytes)).colours;
    let linear: f64 = 55.0 / 255.0;
    let encoded = 1.055 * linear.powf(1.0 / 2.4) - 0.055;
    assert!((colours[0][1] - encoded).abs() < 1e-6);
    assert_eq!(colours[1], [1.0; 3]);

    let shorts: Vec<u8> = [0, 65535, 0, 7]
        .repeat(4)
        .iter()
        .flat_map(|c: &u16| c.to_le_bytes())
        .collect();
    let kind = r#""componentType": 5123, "normalized": true, "type": "VEC4""#;
    let loaded = load("a.glb", &samples::coloured_glb(kind, &shorts)).unwrap();
    assert_eq!(loaded.mesh.colours, [[0.0, 1.0, 0.0]; 4]);
    assert!(loaded.notes.is_empty());
}

#[test]
fn gltf_colours_of_a_strange_type_are_refused() {
    let kind = r#""componentType": 5126, "type": "VEC2""#;
    assert_eq!(
        refused("a.glb", &samples::coloured_glb(kind, &[0; 32])),
        "a.glb: accessors[3]: has another type; \
         expected VEC3 or VEC4 of floats, unsigned bytes or shorts"
    );
}
