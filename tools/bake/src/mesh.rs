//! Meshes into meshlets, vertices and triangles of the blob.

use std::collections::HashMap;

use fixel::scene::layout::LEAST_RADIUS;
use fixel::scene::{Mesh as MeshRecord, Meshlet};
use fixel_scene::{Mesh, Rgb};
use glam::{DVec3, IVec3};

use crate::grid::{Bounds, Grid, Shifts};
use crate::instance::Instance;
use crate::meshlet::{Cluster, clusters};
use crate::snap::{place, snap};
use crate::{BakeError, normal};

/// A mesh of so many triangles may take 4 bytes more a vertex to be exact to 22
/// bits an axis: large faces that the eye stands close to need it, and flash does
/// not notice.
const FINE_TRIANGLES: usize = 512;

/// A triangle of the description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// Index into the description's meshes.
    pub mesh: u32,
    /// Index into that mesh's triangles.
    pub triangle: u32,
}

/// Sections of the blob as they grow.
#[derive(Default)]
pub(crate) struct Parts {
    pub meshes: Vec<MeshRecord>,
    pub meshlets: Vec<Meshlet>,
    pub vertices: Vec<[i16; 4]>,
    pub triangles: Vec<[u8; 3]>,
    pub face_normals: Vec<u32>,
    pub fine: Vec<[u8; 4]>,
    pub colours: Vec<[u8; 4]>,
    pub sources: Vec<Source>,
    pub grids: Vec<Grid>,
}

/// A mesh as its instance has it.
struct Shape {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// Of the vertices, or none.
    colours: Vec<[u8; 4]>,
    triangles: Vec<[u32; 3]>,
    /// Of each triangle, its index in the description.
    source: Vec<u32>,
    /// Grid points of the positions.
    snapped: Vec<IVec3>,
    flat: bool,
    /// Whether vertices are in whole grid steps.
    fine: bool,
}

impl Parts {
    pub(crate) fn add_mesh(&mut self, instance: &Instance, mesh: &Mesh) -> Result<(), BakeError> {
        let mut shape = Shape::new(instance, mesh);
        let clusters = clusters(&shape.positions, &shape.triangles);
        let bounds = |cluster: &Cluster| Bounds::of(shape.corners(cluster));
        let all = Bounds::of(shape.corners(&(0..shape.triangles.len()).collect()));
        let grid = Grid::new(all);
        let shifts: Vec<Shifts> = clusters.iter().map(|c| grid.shifts(bounds(c))).collect();

        let coarse = shifts.iter().flatten().any(|s| *s > 0);
        shape.fine = coarse && shape.triangles.len() <= FINE_TRIANGLES;

        // A vertex is on the coarsest grid of the meshlets that share it.
        let mut coarsest: HashMap<_, Shifts> = HashMap::new();
        for (cluster, shifts) in clusters.iter().zip(&shifts) {
            for corner in shape.corners(cluster).filter(|_| !shape.fine) {
                let held = coarsest.entry(place(&corner)).or_default();
                *held = [0, 1, 2].map(|axis| held[axis].max(shifts[axis]));
            }
        }
        shape.snapped = snap(&shape.positions, &shape.triangles, &grid, &coarsest);

        let first_meshlet = self.meshlets.len() as u32;
        let vertices = self.vertices.len() as u32;
        let fine = (self.fine.len() as u32).wrapping_sub(vertices);
        let colours = (self.colours.len() as u32).wrapping_sub(vertices);
        let mut radius = f64::from(LEAST_RADIUS);
        for (cluster, shifts) in clusters.iter().zip(shifts) {
            self.add_meshlet(&shape, cluster, shifts)?;
            let source = |t: &usize| Source {
                mesh: instance.mesh as u32,
                triangle: shape.source[*t],
            };
            self.sources.extend(cluster.iter().map(source));
            let length = |v: u32| shape.snapped[v as usize].as_dvec3().length();
            radius = cluster
                .iter()
                .flat_map(|t| shape.triangles[*t])
                .map(length)
                .fold(radius, f64::max);
        }
        self.meshes.push(MeshRecord {
            first_meshlet,
            meshlets: clusters.len() as u32,
            radius: radius.ceil() as u32 + 1,
            face_normals: shape.flat,
            fine: shape.fine.then_some(fine),
            colours: (!shape.colours.is_empty()).then_some(colours),
        });
        self.grids.push(grid);
        Ok(())
    }

    fn add_meshlet(
        &mut self,
        shape: &Shape,
        cluster: &Cluster,
        shifts: Shifts,
    ) -> Result<(), BakeError> {
        let list: Vec<[u32; 3]> = cluster.iter().map(|t| shape.triangles[*t]).collect();
        let mut members: Vec<u32> = Vec::new();
        for v in list.as_flattened() {
            if !members.contains(v) {
                members.push(*v);
            }
        }
        let points = || members.iter().map(|v| shape.snapped[*v as usize]);
        let low = points().fold(IVec3::MAX, IVec3::min);
        let high = points().fold(IVec3::MIN, IVec3::max);
        // As its vertices, the base is a multiple of the meshlet's own step.
        let to_step = |c: i32, s: u8| (c >> s) << s;
        let middle = (low + (high - low) / 2).to_array();
        let base = IVec3::from_array([0, 1, 2].map(|axis| to_step(middle[axis], shifts[axis])));
        let radius = points()
            .map(|p| (p - base).as_dvec3().length())
            .fold(0.0, f64::max);
        let unit = f64::from(1 << shifts.iter().fold(0, |m, s| *s.max(&m)));

        let faces: Vec<DVec3> = list.iter().map(|t| shape.face_normal(t)).collect();
        let (cone_axis, cone_cutoff) = cone(&faces);
        self.meshlets.push(Meshlet {
            base: base.to_array(),
            shifts,
            radius: (radius / unit).ceil() as u16,
            vertices: members.len() as u8,
            triangles: list.len() as u8,
            cone_axis,
            cone_cutoff,
            first_vertex: self.vertices.len() as u32,
            first_triangle: self.triangles.len() as u32,
        });
        for v in &members {
            let from_base = (shape.snapped[*v as usize] - base).to_array();
            let mut vertex = [0; 4];
            for axis in 0..3 {
                let steps = from_base[axis] >> shifts[axis];
                vertex[axis] = i16::try_from(steps).map_err(|_| BakeError::Range {
                    what: "a vertex's distance from its meshlet's middle in steps".into(),
                    value: steps.into(),
                })?;
            }
            let one = if shape.fine {
                normal::FINE
            } else {
                normal::COARSE
            };
            let code = normal::encode(shape.normals[*v as usize], one);
            let high = code.map(|c| if shape.fine { c >> 4 } else { c } as u8);
            vertex[3] = i16::from_le_bytes(high);
            self.vertices.push(vertex);
            self.colours.extend(shape.colours.get(*v as usize));
            if shape.fine {
                let low = |axis: usize| (from_base[axis] & ((1 << shifts[axis]) - 1)) as u8;
                let [u, v] = code.map(|c| (c & 15) as u8);
                self.fine.push([low(0), low(1), low(2), u | v << 4]);
            }
        }
        let index: HashMap<u32, u8> = members
            .iter()
            .enumerate()
            .map(|(i, v)| (*v, i as u8))
            .collect();
        self.triangles
            .extend(list.iter().map(|t| t.map(|v| index[&v])));
        if shape.flat {
            self.face_normals
                .extend(faces.iter().map(|n| normal::pack(*n)));
        }
        Ok(())
    }
}

impl Shape {
    fn new(instance: &Instance, mesh: &Mesh) -> Self {
        let positions = instance.positions(mesh);
        let byte = |c: f64| (c.clamp(0.0, 1.0) * 255.0).round() as u8;
        let colour = |c: &Rgb| [byte(c[0]), byte(c[1]), byte(c[2]), 0];
        // Vertices that differ only in a normal that nobody needs are one.
        let keep = if instance.smooth || !mesh.colours.is_empty() {
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
        Self {
            normals: instance.normals(mesh),
            colours: mesh.colours.iter().map(colour).collect(),
            positions,
            triangles,
            source,
            snapped: Vec::new(),
            flat: instance.flat,
            fine: false,
        }
    }

    /// Places of a cluster's corners.
    fn corners(&self, cluster: &Cluster) -> impl Iterator<Item = DVec3> {
        cluster
            .iter()
            .flat_map(|t| self.triangles[*t])
            .map(|v| self.positions[v as usize])
    }

    fn face_normal(&self, triangle: &[u32; 3]) -> DVec3 {
        let [a, b, c] = triangle.map(|v| self.positions[v as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    }
}

/// For each vertex the first one at the same place.
fn weld(positions: &[DVec3]) -> Vec<u32> {
    let mut first = HashMap::new();
    let number = |(i, p): (usize, &DVec3)| *first.entry(place(p)).or_insert(i as u32);
    positions.iter().enumerate().map(number).collect()
}

fn has_area(positions: &[DVec3], t: &[u32; 3]) -> bool {
    let [a, b, c] = t.map(|v| positions[v as usize]);
    (b - a).cross(c - a) != DVec3::ZERO
}

/// Axis and cutoff of the cone of face normals; see [`Meshlet::cone_cutoff`].
fn cone(faces: &[DVec3]) -> ([i8; 3], i8) {
    let axis = faces.iter().sum::<DVec3>().normalize_or_zero();
    let narrowest = faces.iter().map(|n| n.dot(axis)).fold(1.0, f64::min);
    if narrowest <= 0.05 {
        return ([0; 3], 127);
    }
    let coarse = (axis * 127.0).round();
    // What rounding the axis costs is added to the cutoff.
    let off = (coarse / 127.0 - axis).length();
    let cutoff = ((1.0 - narrowest * narrowest).max(0.0).sqrt() + off) * 127.0;
    (
        coarse.to_array().map(|c| c as i8),
        cutoff.ceil().min(127.0) as i8,
    )
}
