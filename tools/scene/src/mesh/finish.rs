//! What every format's mesh goes through: checks, normals, and vertices that
//! are the same made one.

use std::collections::{HashMap, HashSet};

use glam::DVec3;

use super::{Loaded, MAX_TRIANGLES, Refusal, Soup, crease, polygon};
use crate::description::Mesh;

/// A mesh with each vertex once, in the order of its first use.
pub(super) fn finish(name: &str, soup: Soup) -> Result<Loaded, Refusal> {
    if soup.triangles.is_empty() {
        return Err(Refusal::new("has no faces; expected at least one triangle"));
    }
    if soup.triangles.len() > MAX_TRIANGLES {
        return Err(Refusal::too_many());
    }
    if let Some(index) = soup.positions.iter().position(|p| !polygon::is_sane(p)) {
        return Err(Refusal::new(format!(
            "vertex {index} is not finite, or beyond 1e9"
        )));
    }
    let (points, point_of) = weld(&soup.positions);
    let by_point: Vec<[u32; 3]> = soup
        .triangles
        .iter()
        .map(|triangle| triangle.map(|index| point_of[index as usize]))
        .collect();
    let has_area = |triangle: &[u32; 3]| {
        crease::face_normal(triangle.map(|index| points[index as usize])).is_some()
    };
    if !by_point.iter().any(has_area) {
        return Err(Refusal::new("has no triangle with an area"));
    }

    let given: Vec<Option<DVec3>> = soup.normals.iter().map(|n| n.and_then(unit)).collect();
    let all_given = soup
        .triangles
        .iter()
        .flatten()
        .all(|&index| given[index as usize].is_some());
    let made = if all_given {
        Vec::new()
    } else {
        crease::corner_normals(&points, &by_point)
    };

    // White changes nothing.
    let coloured = soup.colours.iter().any(|colour| *colour != [1.0; 3]);
    let mut mesh = Mesh {
        name: name.to_owned(),
        ..Mesh::default()
    };
    let by_points = |side: [u32; 2]| polygon::sorted(side.map(|index| point_of[index as usize]));
    let diagonals: HashSet<[u32; 2]> = soup.diagonals.iter().copied().map(by_points).collect();
    let mut edges = HashSet::new();
    let mut vertices = HashMap::new();
    for (at, triangle) in soup.triangles.iter().enumerate() {
        let corners = std::array::from_fn(|corner| {
            let point = by_point[at][corner];
            let given = given[triangle[corner] as usize];
            let normal = given.unwrap_or_else(|| made[at][corner]) + DVec3::ZERO;
            let next = mesh.positions.len() as u32;
            let colour = coloured.then(|| soup.colours[triangle[corner] as usize]);
            let bits = |numbers: [f64; 3]| numbers.map(f64::to_bits);
            let coordinates = soup.texture_coordinates.get(triangle[corner] as usize);
            let place = coordinates.map(|place| place.map(|number| (number + 0.0).to_bits()));
            let key = (point, bits(normal.into()), colour.map(bits), place);
            *vertices.entry(key).or_insert_with(|| {
                mesh.positions.push(points[point as usize].into());
                mesh.normals.push(normal.into());
                mesh.colours.extend(colour);
                mesh.texture_coordinates.extend(coordinates);
                next
            })
        });
        mesh.triangles.push(corners);
        let sides = polygon::sides(*triangle)
            .into_iter()
            .zip(polygon::sides(corners));
        for (side, edge) in sides {
            let side = by_points(side);
            if side[0] != side[1] && !diagonals.contains(&side) && edges.insert(side) {
                mesh.edges.push(edge);
            }
        }
    }
    Ok(Loaded {
        mesh,
        surfaces: soup.surfaces,
        surface_of: soup.surface_of,
        notes: soup
            .notes
            .iter()
            .map(|note| format!("{name}: {note}"))
            .collect(),
    })
}

/// Takes texture coordinates away from a mesh that needs none; vertices that now are
/// the same become one.
pub(crate) fn forget_texture_coordinates(mesh: &mut Mesh) {
    if mesh.texture_coordinates.is_empty() {
        return;
    }
    mesh.texture_coordinates.clear();
    let mut kept = Vec::new();
    let mut seen = HashMap::new();
    let mut new_of_old = Vec::new();
    for (index, position) in mesh.positions.iter().enumerate() {
        let bits = |numbers: &[f64; 3]| numbers.map(f64::to_bits);
        let colour = mesh.colours.get(index).map(bits);
        let key = (bits(position), bits(&mesh.normals[index]), colour);
        new_of_old.push(*seen.entry(key).or_insert_with(|| {
            kept.push(index);
            kept.len() as u32 - 1
        }));
    }
    let keep = |list: &[[f64; 3]]| kept.iter().map(|index| list[*index]).collect();
    mesh.positions = keep(&mesh.positions);
    mesh.normals = keep(&mesh.normals);
    if !mesh.colours.is_empty() {
        mesh.colours = keep(&mesh.colours);
    }
    let all = mesh.triangles.as_flattened_mut().iter_mut();
    for index in all.chain(mesh.edges.as_flattened_mut()) {
        *index = new_of_old[*index as usize];
    }
}

/// Each position once, and for each vertex the index of its position.
fn weld(positions: &[[f64; 3]]) -> (Vec<DVec3>, Vec<u32>) {
    let mut points = Vec::new();
    let mut seen = HashMap::new();
    let point_of = positions
        .iter()
        .map(|&position| {
            // Adding 0 makes -0 the same as 0.
            let point = DVec3::from(position) + DVec3::ZERO;
            *seen
                .entry(point.to_array().map(f64::to_bits))
                .or_insert_with(|| {
                    points.push(point);
                    points.len() as u32 - 1
                })
        })
        .collect();
    (points, point_of)
}

/// A normal of length 1; none if it has no direction and must be made.
fn unit(normal: [f64; 3]) -> Option<DVec3> {
    let normal = DVec3::from(normal);
    let length = normal.length();
    (length.is_finite() && length > 1e-12).then(|| normal / length)
}
