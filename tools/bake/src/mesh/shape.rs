//! A mesh as its instance has it, on its way into meshlets.

use std::collections::HashMap;

use fixel::scene::Coordinates;
use fixel_scene::{Mesh, Rgb};
use glam::{DVec3, IVec3};

use crate::grid::{Bounds, Grid, Shifts};
use crate::group::{Group, groups};
use crate::instance::Instance;
use crate::light_error::wrong_share;
use crate::meshlet::clusters;
use crate::snap::place_key;
use crate::{BakeError, coordinates, facing};

/// A mesh as its instance has it.
pub(super) struct Shape {
    pub positions: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    /// Of the vertices, or none.
    pub colours: Vec<[u8; 4]>,
    /// Of the vertices, or none, as the blob has them.
    pub coordinates: Vec<[i16; 2]>,
    /// Their record but for the offset.
    pub coordinate_grid: Option<Coordinates>,
    pub triangles: Vec<[u32; 3]>,
    /// Of each triangle, its index in the description.
    pub source: Vec<u32>,
    /// Grid points of the positions.
    pub snapped: Vec<IVec3>,
    pub flat: bool,
    /// Whether vertices are in whole grid steps.
    pub fine: bool,
}

impl Shape {
    pub fn new(instance: &Instance, mesh: &Mesh) -> Result<Self, BakeError> {
        let positions = instance.positions(mesh);
        let byte = |c: f64| (c.clamp(0.0, 1.0) * 255.0).round() as u8;
        let colour = |c: &Rgb| [byte(c[0]), byte(c[1]), byte(c[2]), 0];
        // Vertices that differ only in a normal that nobody needs are one.
        let keep = if instance.smooth
            || !mesh.colours.is_empty()
            || !mesh.texture_coordinates.is_empty()
        {
            (0..positions.len() as u32).collect()
        } else {
            weld(&positions)
        };
        let (source, triangles) = mesh
            .triangles
            .iter()
            .enumerate()
            .map(|(i, t)| (i as u32, instance.corners(*t).map(|v| keep[v as usize])))
            .filter(|(_, t)| has_area(&positions, t))
            .unzip();
        let (coordinate_grid, coordinates) = coordinates::place(&mesh.texture_coordinates)?;
        Ok(Self {
            coordinate_grid,
            coordinates,
            normals: instance.normals(mesh),
            colours: mesh.colours.iter().map(colour).collect(),
            positions,
            triangles,
            source,
            snapped: Vec::new(),
            flat: instance.flat,
            fine: false,
        })
    }

    /// What goes into its meshlets.
    pub fn groups(&self, instance: &Instance, mesh: &Mesh) -> Vec<Group> {
        let mut clusters = clusters(&self.positions, &self.triangles);
        // Marks are drawn in the order of the triangles' corners.
        if instance.culled && !instance.points {
            for cluster in &mut clusters {
                facing::sort(cluster, |t| self.face_normal(&self.triangles[t]));
            }
        }
        let edges = if instance.edges {
            mesh.edges.as_slice()
        } else {
            &[]
        };
        let points = 0..if instance.points {
            self.positions.len() as u32
        } else {
            0
        };
        groups(&self.triangles, clusters, edges, points)
    }

    pub fn places(&self, group: &Group) -> impl Iterator<Item = DVec3> {
        let vertices = group.vertices.iter();
        vertices.map(|v| self.positions[*v as usize])
    }

    pub fn shifts(&self, groups: &[Group], grid: &Grid) -> Vec<Shifts> {
        let shifts = |group: &Group| grid.shifts(Bounds::of(self.places(group)));
        groups.iter().map(shifts).collect()
    }

    /// See [`wrong_share`].
    pub fn wrong_share(&self, brightness: f64) -> f64 {
        wrong_share(&self.positions, &self.normals, &self.triangles, brightness)
    }

    pub fn face_normal(&self, triangle: &[u32; 3]) -> DVec3 {
        let [a, b, c] = triangle.map(|v| self.positions[v as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    }
}

/// For each vertex the first one at the same place.
fn weld(positions: &[DVec3]) -> Vec<u32> {
    let mut first = HashMap::new();
    let number = |(i, p): (usize, &DVec3)| *first.entry(place_key(p)).or_insert(i as u32);
    positions.iter().enumerate().map(number).collect()
}

fn has_area(positions: &[DVec3], t: &[u32; 3]) -> bool {
    let [a, b, c] = t.map(|v| positions[v as usize]);
    (b - a).cross(c - a) != DVec3::ZERO
}
