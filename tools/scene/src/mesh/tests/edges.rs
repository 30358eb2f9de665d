//! What a wireframe draws, and meshes given by numbers.

use super::super::{polygon, sphere};
use super::mesh;

fn places(mesh: &crate::Mesh) -> Vec<[[f64; 3]; 2]> {
    let place = |index: u32| mesh.positions[index as usize];
    mesh.edges.iter().map(|edge| edge.map(place)).collect()
}

#[test]
fn a_quad_has_four_edges_and_no_diagonal() {
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let mesh = mesh("a.obj", text);
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(mesh.edges, [[0, 1], [1, 2], [2, 3], [3, 0]]);
}

#[test]
fn an_edge_of_two_faces_is_there_once_even_if_a_crease_parts_their_vertices() {
    // Two quads at a right angle: 7 edges.
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\n\
        f 1 2 3 4\nf 5 6 2 1\n";
    let mesh = mesh("a.obj", text);
    assert_eq!(mesh.positions.len(), 8);
    assert_eq!(mesh.edges.len(), 7);
}

#[test]
fn a_side_of_a_polygon_that_is_a_neighbours_diagonal_is_an_edge_no_more() {
    // Triangles stay triangles: their sides are all edges.
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    assert_eq!(mesh("a.obj", text).edges.len(), 5);
}

fn area(mesh: &crate::Mesh) -> f64 {
    let cross = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| glam::DVec3::from(mesh.positions[i as usize]));
        (b - a).cross(c - a).z / 2.0
    };
    let areas = mesh.triangles.iter().map(cross);
    areas.inspect(|area| assert!(*area > 0.0)).sum()
}

fn square(low: f64, high: f64) -> Vec<[f64; 3]> {
    vec![
        [low, low, 0.0],
        [high, low, 0.0],
        [high, high, 0.0],
        [low, high, 0.0],
    ]
}

#[test]
fn a_polygon_leaves_out_its_holes_whichever_way_they_go_round() {
    let mut turned = square(6.0, 9.0);
    turned.reverse();
    let mesh = polygon(&square(0.0, 10.0), &[square(1.0, 3.0), turned]).unwrap();
    assert_eq!(area(&mesh), 100.0 - 4.0 - 9.0);
    assert_eq!(mesh.edges.len(), 12);
    assert!(mesh.normals.iter().all(|n| *n == [0.0, 0.0, 1.0]));
    let from_below: Vec<_> = square(0.0, 10.0).into_iter().rev().collect();
    let mesh = polygon(&from_below, &[]).unwrap();
    assert!(mesh.normals.iter().all(|n| *n == [0.0, 0.0, -1.0]));
}

#[test]
fn a_corner_on_a_straight_side_stays_an_end_of_edges() {
    let mut outline = square(0.0, 2.0);
    outline.insert(1, [1.0, 0.0, 0.0]);
    let mesh = polygon(&outline, &[]).unwrap();
    assert_eq!(area(&mesh), 4.0);
    assert!(places(&mesh).contains(&[[0.0; 3], [1.0, 0.0, 0.0]]));
    assert_eq!(mesh.edges.len(), 5);
}

#[test]
fn a_polygon_that_crosses_itself_is_refused() {
    let bow = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 2.0, 0.0],
    ];
    assert!(polygon(&bow, &[]).is_err());
    assert!(polygon(&square(0.0, 1.0), &[square(2.0, 3.0)]).is_err());
    assert!(polygon(&[[0.0; 3], [1.0; 3], [2.0; 3]], &[]).is_err());
}

#[test]
fn a_sphere_is_closed_and_faces_outward() {
    let mesh = sphere(2.0, 2);
    assert_eq!(mesh.triangles.len(), 20 * 16);
    // Euler: V - E + F = 2.
    assert_eq!(mesh.positions.len() + 320 - mesh.edges.len(), 2);
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| glam::DVec3::from(mesh.positions[i as usize]));
        assert!((b - a).cross(c - a).dot(a + b + c) > 0.0);
        assert!((a.length() - 2.0).abs() < 1e-12);
    }
}
