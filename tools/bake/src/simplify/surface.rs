//! A surface that is being simplified: faces over places and corners. A place has one
//! corner for each of its sets of attributes: several along a seam.

use std::collections::HashMap;

use fixel_scene::Mesh;
use glam::DVec3;

use super::quadric::{ATTRIBUTES, Fit, Quadric};
use crate::snap::place_key;

/// How much a feature (a border, a seam) is held to its line, over how much a face is to
/// its plane.
const FEATURE: f64 = 10.0;
/// What a normal that is off by so much costs, over a place that is off by the mesh's size.
const NORMAL: f64 = 0.01;
/// The same of a colour.
const COLOUR: f64 = 0.05;

/// Where a place may go.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Freedom {
    /// Anywhere.
    Free,
    /// Along the border or seam that it lies on.
    Feature,
    /// Nowhere: borders or seams meet there, or faces in an odd way.
    Fixed,
}

/// A surface on its way.
pub(super) struct Surface {
    /// Scaled so that the longest side of the surface's box is 1.
    pub positions: Vec<DVec3>,
    pub freedoms: Vec<Freedom>,
    /// What borders and seams cost at each place.
    pub features: Vec<Quadric>,
    /// Living faces around each place; others may be among them.
    pub around: Vec<Vec<u32>>,
    /// Places of a face's corners; none: it is gone.
    pub faces: Vec<Option<[u32; 3]>>,
    /// A face's corners.
    pub corners: Vec<[u32; 3]>,
    pub fits: Vec<Fit>,
    pub attributes: Vec<[f64; ATTRIBUTES]>,
    /// How many attributes count.
    pub count: usize,
    pub living: usize,
    layout: Layout,
    scale: f64,
    middle: DVec3,
}

/// Which attributes there are, and what they count.
#[derive(Clone, Copy, Debug)]
struct Layout {
    normals: bool,
    colours: bool,
    /// Length on the surface, as scaled, that a unit of texture coordinates is.
    texture: Option<f64>,
}

impl Surface {
    /// `normals`: whether they show.
    pub(super) fn new(mesh: &Mesh, normals: bool) -> Self {
        let given: Vec<DVec3> = mesh.positions.iter().map(|p| DVec3::from(*p)).collect();
        let used = || mesh.triangles.as_flattened().iter();
        let bounds = used().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), v| {
            let p = given[*v as usize];
            (low.min(p), high.max(p))
        });
        let size = (bounds.1 - bounds.0).max_element();
        let scale = 1.0 / size.max(f64::MIN_POSITIVE);
        let middle = (bounds.0 + bounds.1) / 2.0;
        let layout = Layout {
            normals,
            colours: !mesh.colours.is_empty(),
            texture: texture_unit(mesh, &given).map(|unit| unit * scale),
        };
        let mut surface = Self {
            positions: Vec::new(),
            freedoms: Vec::new(),
            features: Vec::new(),
            around: Vec::new(),
            faces: Vec::new(),
            corners: Vec::new(),
            fits: Vec::new(),
            attributes: Vec::new(),
            count: layout.count(),
            living: 0,
            layout,
            scale,
            middle,
        };
        let (mut places, mut corners) = (HashMap::new(), HashMap::new());
        let number: Vec<[u32; 2]> = (0..given.len())
            .map(|v| {
                let next = places.len() as u32;
                let at = *places.entry(place_key(&given[v])).or_insert(next);
                if at == next {
                    surface.positions.push((given[v] - middle) * scale);
                }
                let attributes = layout.of(mesh, v);
                let next = corners.len() as u32;
                let key = (at, attributes.map(|a| (a + 0.0).to_bits()));
                let corner = *corners.entry(key).or_insert(next);
                if corner == next {
                    surface.attributes.push(attributes);
                }
                [at, corner]
            })
            .collect();
        surface.around = vec![Vec::new(); surface.positions.len()];
        surface.fits = vec![Fit::ZERO; surface.attributes.len()];
        for triangle in &mesh.triangles {
            let [at, corners] = [0, 1].map(|i: usize| triangle.map(|v| number[v as usize][i]));
            let [p, q, r] = at.map(|v| surface.positions[v as usize]);
            if (q - p).cross(r - p) != DVec3::ZERO {
                surface.add(at, corners);
            }
        }
        surface.living = surface.faces.len();
        surface.find_features();
        surface
    }

    fn add(&mut self, at: [u32; 3], corners: [u32; 3]) {
        let number = self.faces.len() as u32;
        for place in at {
            self.around[place as usize].push(number);
        }
        let positions = at.map(|v| self.positions[v as usize]);
        let attributes = corners.map(|c| &self.attributes[c as usize]);
        let fit = Fit::of_face(positions, attributes, self.count);
        for corner in corners {
            self.fits[corner as usize] += fit;
        }
        self.faces.push(Some(at));
        self.corners.push(corners);
    }

    /// Living faces around a place.
    pub(super) fn faces_around(&self, place: u32) -> impl Iterator<Item = (usize, [u32; 3])> {
        let all = self.around[place as usize].iter();
        all.filter_map(|f| Some((*f as usize, self.faces[*f as usize]?)))
    }

    /// Places that share a face with a place, each once, in order.
    pub(super) fn neighbours(&self, place: u32) -> Vec<u32> {
        let all = self.faces_around(place).flat_map(|(_, face)| face);
        let mut all: Vec<u32> = all.filter(|v| *v != place).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The living faces at an edge.
    pub(super) fn faces_at(&self, [u, v]: [u32; 2]) -> impl Iterator<Item = usize> {
        let of_edge = self
            .faces_around(u)
            .filter(move |(_, face)| face.contains(&v));
        of_edge.map(|(f, _)| f)
    }

    /// The corner that a face has at a place.
    pub(super) fn corner(&self, face: usize, place: u32) -> u32 {
        let at = self.faces[face].and_then(|f| f.iter().position(|v| *v == place));
        self.corners[face][at.unwrap_or(0)]
    }

    /// Whether an edge with these faces is a border or a seam.
    pub(super) fn is_feature(&self, edge: [u32; 2], faces: &[usize]) -> bool {
        let [one, other] = *faces else { return true };
        edge.iter()
            .any(|v| self.corner(one, *v) != self.corner(other, *v))
    }

    fn find_features(&mut self) {
        self.freedoms = vec![Freedom::Free; self.positions.len()];
        self.features = vec![Quadric::ZERO; self.positions.len()];
        for place in 0..self.positions.len() as u32 {
            let mut lines = 0;
            let mut odd = self.fans(place) > 1;
            for neighbour in self.neighbours(place) {
                let edge = [place, neighbour];
                let faces: Vec<usize> = self.faces_at(edge).collect();
                odd |= faces.len() > 2;
                if self.is_feature(edge, &faces) {
                    lines += 1;
                    for face in faces {
                        self.hold(place, neighbour, face);
                    }
                }
            }
            self.freedoms[place as usize] = match lines {
                _ if odd => Freedom::Fixed,
                0 => Freedom::Free,
                2 => Freedom::Feature,
                _ => Freedom::Fixed,
            };
        }
    }

    /// Holds a place to the plane through an edge across a face.
    fn hold(&mut self, place: u32, neighbour: u32, face: usize) {
        let Some(at) = self.faces[face] else { return };
        let [p, q, r] = at.map(|v| self.positions[v as usize]);
        let [from, to] = [place, neighbour].map(|v| self.positions[v as usize]);
        let along = to - from;
        let across = along.cross((q - p).cross(r - p)).normalize_or_zero();
        let weight = along.length_squared() * FEATURE;
        self.features[place as usize] += Quadric::of(across, -across.dot(from), weight);
    }

    /// How many fans of faces meet at a place.
    fn fans(&self, place: u32) -> usize {
        let others: Vec<[u32; 2]> = self
            .faces_around(place)
            .map(|(_, face)| {
                let mut others = face.into_iter().filter(|v| *v != place);
                [0, 1].map(|_| others.next().unwrap_or(place))
            })
            .collect();
        let mut left: Vec<[u32; 2]> = others;
        let mut fans = 0;
        while let Some(first) = left.pop() {
            fans += 1;
            let mut reached = first.to_vec();
            while let Some(at) = reached.pop() {
                left.retain(|pair| {
                    let beside = pair.contains(&at);
                    if beside {
                        reached.extend(pair);
                    }
                    !beside
                });
            }
        }
        fans
    }

    /// The faces that are left, as a mesh.
    pub(super) fn mesh(&self, original: &Mesh) -> Mesh {
        let mut mesh = Mesh {
            name: original.name.clone(),
            primitive: original.primitive,
            ..Mesh::default()
        };
        let mut numbers: HashMap<u32, u32> = HashMap::new();
        for (face, at) in self.faces.iter().enumerate() {
            let Some(at) = at else { continue };
            let corners = self.corners[face];
            let triangle = [0, 1, 2].map(|i: usize| {
                *numbers.entry(corners[i]).or_insert_with(|| {
                    let position = self.positions[at[i] as usize] / self.scale + self.middle;
                    mesh.positions.push(position.to_array());
                    self.layout
                        .put(&self.attributes[corners[i] as usize], &mut mesh);
                    mesh.positions.len() as u32 - 1
                })
            });
            mesh.triangles.push(triangle);
        }
        if !self.layout.normals {
            mesh.normals = face_normals(&mesh);
        }
        mesh
    }

    /// Distance in the mesh's own units.
    pub(super) fn length(&self, scaled: f64) -> f64 {
        scaled / self.scale
    }
}

impl Layout {
    fn count(&self) -> usize {
        3 * usize::from(self.normals)
            + 3 * usize::from(self.colours)
            + 2 * usize::from(self.texture.is_some())
    }

    /// A vertex's attributes, each times what it counts.
    fn of(&self, mesh: &Mesh, vertex: usize) -> [f64; ATTRIBUTES] {
        let normal = self
            .normals
            .then(|| mesh.normals[vertex].map(|c| c * NORMAL));
        let colour = self
            .colours
            .then(|| mesh.colours[vertex].map(|c| c * COLOUR));
        let texture = self
            .texture
            .map(|unit| mesh.texture_coordinates[vertex].map(|c| c * unit));
        let all = normal.into_iter().flatten();
        let all = all.chain(colour.into_iter().flatten());
        let all = all.chain(texture.into_iter().flatten());
        let mut attributes = [0.0; ATTRIBUTES];
        for (to, from) in attributes.iter_mut().zip(all) {
            *to = from;
        }
        attributes
    }

    /// The way back.
    fn put(&self, attributes: &[f64; ATTRIBUTES], mesh: &mut Mesh) {
        let mut rest = attributes.as_slice();
        let mut three = || {
            let (head, tail) = rest.split_at(3);
            rest = tail;
            DVec3::from_slice(head)
        };
        if self.normals {
            let normal = three().try_normalize();
            mesh.normals.push(normal.unwrap_or(DVec3::Z).to_array());
        }
        if self.colours {
            let colour = (three() / COLOUR).clamp(DVec3::ZERO, DVec3::ONE);
            mesh.colours.push(colour.to_array());
        }
        if let (Some(unit), [u, v, ..]) = (self.texture, rest) {
            mesh.texture_coordinates.push([u / unit, v / unit]);
        }
    }
}

/// Length on the surface that a unit of texture coordinates is, on the whole.
fn texture_unit(mesh: &Mesh, positions: &[DVec3]) -> Option<f64> {
    if mesh.texture_coordinates.is_empty() {
        return None;
    }
    let (mut on_surface, mut in_picture) = (0.0, 0.0);
    for triangle in &mesh.triangles {
        let [p, q, r] = triangle.map(|v| positions[v as usize]);
        on_surface += (q - p).cross(r - p).length();
        let [a, b, c] = triangle.map(|v| mesh.texture_coordinates[v as usize]);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        in_picture += (u[0] * v[1] - u[1] * v[0]).abs();
    }
    let unit = (on_surface / in_picture).sqrt();
    Some(if unit.is_finite() && unit > 0.0 {
        unit
    } else {
        1.0
    })
}

/// Normals of vertices from the faces around them.
fn face_normals(mesh: &Mesh) -> Vec<[f64; 3]> {
    let mut sums = vec![DVec3::ZERO; mesh.positions.len()];
    for triangle in &mesh.triangles {
        let [p, q, r] = triangle.map(|v| DVec3::from(mesh.positions[v as usize]));
        let across = (q - p).cross(r - p);
        for v in triangle {
            sums[*v as usize] += across;
        }
    }
    let normal = |sum: DVec3| sum.try_normalize().unwrap_or(DVec3::Z).to_array();
    sums.into_iter().map(normal).collect()
}
