//! Meshes into meshlets, vertices and triangles of the blob.

mod shape;

use std::collections::HashMap;

use fixel::scene::layout::{CHAINED, LEAST_RADIUS, MOST_SHIFT};
use fixel::scene::{Coordinates, Mesh as MeshRecord, Meshlet};
use fixel_scene::Mesh;
use glam::{DMat3, DVec3, IVec3};

use self::shape::Shape;
use crate::error::at_most;
use crate::grid::{Bounds, Grid, Shifts};
use crate::group::Group;
use crate::instance::Instance;
use crate::simplify::Level;
use crate::snap::{place_key, snap};
use crate::{BakeError, Problem, normal};

/// A mesh of so many triangles may take 4 bytes more a vertex to be exact to 22
/// bits an axis: large faces that the eye stands close to need it, and flash does
/// not notice. Larger ones take them for 4 more bits an axis of their normals, if
/// these show ([`Instance::glossy`], [`WRONG_SHARE`]).
const FINE_TRIANGLES: usize = 1024;
/// Most of a lit surface whose level may be off by more than 2 of 255 before its mesh
/// takes finer normals. Half of the percent that a picture is allowed: it may show the
/// worst side.
const WRONG_SHARE: f64 = 0.005;

/// A triangle, an edge or a vertex of the description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// Index into the description's meshes.
    pub mesh: u32,
    /// Index into that mesh's triangles; of an edge counted on from the triangles, of
    /// a vertex from the edges; [`Source::LEVEL`] for those of a coarser level.
    pub triangle: u32,
}

impl Source {
    /// The triangle and the vertex of a level of detail, which the description does not have.
    pub const LEVEL: u32 = u32::MAX;
}

/// For each triangle, edge and vertex of a blob, where it comes from.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    /// Of triangles.
    pub triangles: Vec<Source>,
    /// Of edges.
    pub edges: Vec<Source>,
    /// Of vertices.
    pub vertices: Vec<Source>,
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
    pub coordinates: Vec<[i16; 2]>,
    pub edges: Vec<[u8; 2]>,
    /// Each meshlet's first edge, and one past the last.
    pub meshlet_edges: Vec<u32>,
    pub sources: Sources,
    pub grids: Vec<Grid>,
    /// Of each mesh, its levels of detail.
    levels: Vec<Vec<MeshRecord>>,
}

impl Parts {
    /// `levels` are the mesh's, as the instance has it. `least` is half the size that a
    /// mesh's grid is made for at least.
    pub(crate) fn add_mesh(
        &mut self,
        instance: &Instance,
        mesh: &Mesh,
        levels: &[Level],
        least: f64,
    ) -> Result<(), BakeError> {
        let mut shape = Shape::new(instance, mesh)?;
        let groups = shape.groups(instance, mesh);
        let of_levels = levels.iter().flat_map(|level| &level.mesh.positions);
        let of_levels = of_levels.map(|p| DVec3::from(*p));
        let own = groups.iter().flat_map(|group| shape.places(group));
        let grid = Grid::new(Bounds::of(own.chain(of_levels)), least);
        let shifts = shape.shifts(&groups, &grid);
        let coarse = shifts.iter().flatten().any(|s| *s > 0);
        shape.fine = instance.glossy
            || coarse && shape.triangles.len() <= FINE_TRIANGLES
            || instance.smooth && shape.wrong_share(instance.brightness) > WRONG_SHARE;
        let fine = shape.fine;
        let mut finest = self.add_shape(instance, mesh, shape, &groups, &grid)?;

        let mut coarser = Vec::new();
        for level in levels {
            let as_it_is = Instance {
                linear: DMat3::IDENTITY,
                ..instance.clone()
            };
            let mut shape = Shape::new(&as_it_is, &level.mesh)?;
            shape.source.fill(Source::LEVEL);
            shape.fine = fine;
            let groups = shape.groups(&as_it_is, &level.mesh);
            let record = self.add_shape(&as_it_is, &level.mesh, shape, &groups, &grid)?;
            // With what snapping to the coarsest grid may add.
            let snapped = f64::from(3 << MOST_SHIFT);
            let steps = level.error * f64::exp2(f64::from(grid.exponent)) + snapped;
            coarser.push(MeshRecord {
                error: steps.ceil() as u32,
                ..record
            });
        }
        // One sphere holds all of them.
        let all = coarser.iter().map(|record| record.radius);
        finest.radius = all.fold(finest.radius, u32::max);
        self.levels.push(coarser);
        self.meshes.push(finest);
        self.grids.push(grid);
        Ok(())
    }

    /// Puts all levels behind all meshes.
    pub(crate) fn add_levels(&mut self) -> Result<(), BakeError> {
        for (mesh, levels) in std::mem::take(&mut self.levels).into_iter().enumerate() {
            if levels.is_empty() {
                continue;
            }
            let first = self.meshes.len();
            at_most("meshes with their levels", first + levels.len(), 65535)?;
            self.meshes[mesh].levels = (first as u16, levels.len() as u8);
            self.meshes.extend(levels);
        }
        Ok(())
    }

    fn add_shape(
        &mut self,
        instance: &Instance,
        mesh: &Mesh,
        mut shape: Shape,
        groups: &[Group],
        grid: &Grid,
    ) -> Result<MeshRecord, BakeError> {
        let shifts = shape.shifts(groups, grid);
        // A vertex is on the coarsest grid of the meshlets that share it.
        let mut coarsest: HashMap<_, Shifts> = HashMap::new();
        for (group, shifts) in groups.iter().zip(&shifts).filter(|_| !shape.fine) {
            for vertex in &group.vertices {
                let corner = shape.positions[*vertex as usize];
                let held = coarsest.entry(place_key(&corner)).or_default();
                *held = [0, 1, 2].map(|axis| held[axis].max(shifts[axis]));
            }
        }
        shape.snapped = snap(&shape.positions, &shape.triangles, grid, &coarsest);

        let first_meshlet = self.meshlets.len() as u32;
        let vertices = self.vertices.len() as u32;
        let fine = (self.fine.len() as u32).wrapping_sub(vertices);
        let colours = (self.colours.len() as u32).wrapping_sub(vertices);
        let coordinates = (self.coordinates.len() as u32).wrapping_sub(vertices);
        let mut radius = f64::from(LEAST_RADIUS);
        for (group, shifts) in groups.iter().zip(shifts) {
            self.add_meshlet(&shape, group, shifts)?;
            self.add_edges(mesh, group);
            let source = |triangle: u32| Source {
                mesh: instance.mesh as u32,
                triangle,
            };
            let triangles = mesh.triangles.len() as u32;
            let after_edges = triangles + mesh.edges.len() as u32;
            let of_triangle = |t: &usize| source(shape.source[*t]);
            let of_edge = |e: &usize| source(triangles + *e as u32);
            let is_level = shape.source.first() == Some(&Source::LEVEL);
            let of_vertex = |v: &u32| match is_level {
                true => source(Source::LEVEL),
                false => source(after_edges + v),
            };
            let sources = &mut self.sources;
            sources
                .triangles
                .extend(group.triangles.iter().map(of_triangle));
            sources.edges.extend(group.edges.iter().map(of_edge));
            sources
                .vertices
                .extend(group.vertices.iter().map(of_vertex));
            let length = |v: &u32| shape.snapped[*v as usize].as_dvec3().length();
            radius = group.vertices.iter().map(length).fold(radius, f64::max);
        }
        Ok(MeshRecord {
            first_meshlet,
            meshlets: groups.len() as u32,
            radius: radius.ceil() as u32 + 1,
            face_normals: shape.flat,
            fine: shape.fine.then_some(fine),
            colours: (!shape.colours.is_empty()).then_some(colours),
            coordinates: shape.coordinate_grid.map(|grid| Coordinates {
                offset: coordinates,
                ..grid
            }),
            levels: (0, 0),
            error: 0,
        })
    }

    /// The edges of the meshlet that was added last.
    fn add_edges(&mut self, mesh: &Mesh, group: &Group) {
        // Lines by themselves leave an end to another that starts there.
        let chained =
            |end: &u32| mesh.triangles.is_empty() && mesh.edges.iter().any(|edge| edge[0] == *end);
        let number = |vertex: &u32| {
            let found = group.vertices.iter().position(|v| v == vertex);
            found.unwrap_or(0) as u8
        };
        if self.meshlet_edges.is_empty() {
            self.meshlet_edges.push(0);
        }
        for edge in &group.edges {
            let [from, to] = &mesh.edges[*edge];
            let flag = if chained(to) { CHAINED } else { 0 };
            self.edges.push([number(from), number(to) | flag]);
        }
        self.meshlet_edges.push(self.edges.len() as u32);
    }

    fn add_meshlet(
        &mut self,
        shape: &Shape,
        group: &Group,
        shifts: Shifts,
    ) -> Result<(), BakeError> {
        let cluster = &group.triangles;
        let members = &group.vertices;
        let list: Vec<[u32; 3]> = cluster.iter().map(|t| shape.triangles[*t]).collect();
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
        for v in members {
            let from_base = (shape.snapped[*v as usize] - base).to_array();
            let mut vertex = [0; 4];
            for axis in 0..3 {
                let steps = from_base[axis] >> shifts[axis];
                vertex[axis] = i16::try_from(steps).map_err(|_| Problem::Range {
                    what: "a vertex's distance from its meshlet's middle in steps".into(),
                    value: steps.into(),
                    most: i16::MAX.into(),
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
            self.coordinates.extend(shape.coordinates.get(*v as usize));
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
