use std::fmt::Write;

use super::{load, mesh};

fn bytes(name: &str) -> Vec<u8> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/meshes/");
    std::fs::read(format!("{folder}{name}")).unwrap()
}

#[test]
fn a_cube_splits_into_24_vertices() {
    let mesh = mesh("cube.obj", &bytes("cube.obj"));
    assert_eq!(mesh.positions.len(), 24);
    for normal in &mesh.normals {
        let sum: f64 = normal.iter().map(|x| x.abs()).sum();
        assert_eq!(sum, 1.0);
    }
}

#[test]
fn a_sphere_stays_whole_and_its_normals_point_outward() {
    let mesh = mesh("sphere.obj", &bytes("sphere.obj"));
    assert_eq!(mesh.positions.len(), 482);
    for (position, normal) in mesh.positions.iter().zip(&mesh.normals) {
        let dot: f64 = position.iter().zip(normal).map(|(a, b)| a * b).sum();
        assert!(dot > 0.9999, "{position:?} {normal:?}");
    }
}

/// Two squares that meet at an edge with an angle between them.
fn fold(degrees: f64) -> String {
    let (sin, cos) = degrees.to_radians().sin_cos();
    format!(
        "v 0 0 0\nv 0 1 0\nv -1 1 0\nv -1 0 0\nv {cos} 0 {sin}\nv {cos} 1 {sin}\n\
         f 1 2 3 4\nf 1 5 6 2\n"
    )
}

#[test]
fn an_edge_splits_beyond_60_degrees() {
    assert_eq!(mesh("a.obj", fold(59.9).as_bytes()).positions.len(), 6);
    assert_eq!(mesh("a.obj", fold(60.0).as_bytes()).positions.len(), 6);
    assert_eq!(mesh("a.obj", fold(60.1).as_bytes()).positions.len(), 8);
}

#[test]
fn angles_weigh_not_the_number_of_triangles() {
    // One side of the fold in four slivers, the other in one: the normal is
    // still halfway.
    let mut text = fold(40.0);
    text.truncate(text.find("f ").unwrap());
    text += "v -1 0.25 0\nv -1 0.5 0\nv -1 0.75 0\nf 1 7 4\nf 1 8 7\nf 1 9 8\nf 1 3 9\nf 1 2 3\n\
             f 1 5 6 2\n";
    let mesh = mesh("a.obj", text.as_bytes());
    let at = mesh.positions.iter().position(|p| *p == [0.0; 3]).unwrap();
    let halfway = 20_f64.to_radians();
    let [x, y, z] = mesh.normals[at];
    assert!((x + halfway.sin()).abs() < 1e-12 && y.abs() < 1e-12);
    assert!((z - halfway.cos()).abs() < 1e-12);
}

#[test]
fn bad_normals_are_made_anew() {
    for bad in ["0 0 0", "nan 0 1", "inf 0 0", "1e-30 0 0"] {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn {bad}\nf 1//1 2//1 3//1\n");
        let mesh = mesh("a.obj", text.as_bytes());
        assert_eq!(mesh.normals, [[0.0, 0.0, 1.0]; 3], "{bad}");
    }
}

#[test]
fn given_normals_are_kept_at_length_1() {
    let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nf 1//1 2//1 3//1\n";
    assert_eq!(mesh("a.obj", text).normals, [[0.0, 0.6, 0.8]; 3]);
}

#[test]
fn triangles_without_area_take_a_neighbours_normal() {
    // A sliver without area between two sides of a crease joins neither to
    // the other.
    let text = format!("{}f 1 2 2\nf 2 1 1\n", fold(90.0));
    let mesh = mesh("a.obj", text.as_bytes());
    assert_eq!(mesh.triangles.len(), 6);
    assert_eq!(mesh.positions.len(), 8);
}

#[test]
fn vertices_the_same_in_position_and_normal_become_one() {
    let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 0\nv 9 9 9\nv -1 0 0\nf 1 2 3\nf 4 3 6\n";
    assert_eq!(mesh("a.obj", text).positions.len(), 4);
}

#[test]
fn a_fan_of_very_many_faces_takes_no_long_time() {
    let count = 100_000;
    let mut text = "v 0 0 0\n".to_owned();
    for k in 0..count {
        let (sin, cos) = (f64::from(k) / f64::from(count) * 6.0).sin_cos();
        writeln!(text, "v {cos} {sin} 0").unwrap();
    }
    for k in 2..=count {
        writeln!(text, "f 1 {k} {}", k + 1).unwrap();
    }
    assert_eq!(mesh("a.obj", text.as_bytes()).positions.len(), 100_001);
}

#[test]
fn an_edge_of_very_many_faces_takes_no_long_time() {
    let mut text = "v 0 0 0\nv 0 0 1\n".to_owned();
    for k in 0..20_000 {
        let (sin, cos) = f64::from(k).sin_cos();
        writeln!(text, "v {cos} {sin} 0.5\nf 1 2 {}", k + 3).unwrap();
    }
    load("a.obj", text.as_bytes()).unwrap();
}
