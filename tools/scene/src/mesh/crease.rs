//! Normals for a mesh that has none: each face's normal, weighted by its
//! angle at the vertex, summed over the faces that meet there without a
//! crease between them (G. Thürrner and C. Wüthrich, "Computing vertex
//! normals from polygonal facets", 1998).

use glam::DVec3;

/// Faces that meet at more than 60 degrees have a crease between them. Less
/// by a hair, so that rounding splits no mesh at just 60.
const COS_CREASE: f64 = 0.5 - 1e-9;

/// At an edge of more faces than this, only faces next to each other in the
/// file are compared.
const MAX_EDGE_FACES: usize = 16;

/// A corner's normal for each corner of each triangle. `points` holds each
/// position once, so that faces that touch share an index.
pub(super) fn corner_normals(points: &[DVec3], triangles: &[[u32; 3]]) -> Vec<[DVec3; 3]> {
    let faces: Vec<Option<DVec3>> = triangles
        .iter()
        .map(|triangle| face_normal(triangle.map(|index| points[index as usize])))
        .collect();
    let mut normals = vec![[DVec3::Z; 3]; triangles.len()];
    let (starts, corners) = corners_by_point(points.len(), triangles);
    let mut vertex = Vertex::default();
    for ends in starts.windows(2) {
        vertex.group(&corners[ends[0]..ends[1]], triangles, &faces);
        vertex.sum(points, triangles, &faces);
        for (corner, normal) in vertex.corners.iter().zip(&vertex.normals) {
            normals[corner.triangle][corner.corner] = *normal;
        }
    }
    normals
}

/// One triangle at a vertex.
#[derive(Clone, Copy, Debug)]
struct Corner {
    triangle: usize,
    corner: usize,
}

/// Corners sorted by their point: those of point `p` are
/// `corners[starts[p]..starts[p + 1]]`, in the order of triangles.
fn corners_by_point(points: usize, triangles: &[[u32; 3]]) -> (Vec<usize>, Vec<Corner>) {
    let mut starts = vec![0; points + 1];
    for &index in triangles.iter().flatten() {
        starts[index as usize + 1] += 1;
    }
    for point in 0..points {
        starts[point + 1] += starts[point];
    }
    let mut next = starts.clone();
    let unset = Corner {
        triangle: 0,
        corner: 0,
    };
    let mut corners = vec![unset; triangles.len() * 3];
    for (triangle, indices) in triangles.iter().enumerate() {
        for (corner, &index) in indices.iter().enumerate() {
            corners[next[index as usize]] = Corner { triangle, corner };
            next[index as usize] += 1;
        }
    }
    (starts, corners)
}

/// The unit normal by the winding; none if the triangle has no area to speak
/// of beside its longest edge.
pub(super) fn face_normal([a, b, c]: [DVec3; 3]) -> Option<DVec3> {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let longest = ab.length_squared().max(ac.length_squared());
    if normal.length() <= longest * 1e-14 {
        return None;
    }
    normal.try_normalize()
}

/// The faces around one vertex, sorted into groups without creases.
#[derive(Debug, Default)]
struct Vertex {
    corners: Vec<Corner>,
    /// For each corner one of its group, the least after `group`.
    group: Vec<usize>,
    /// For each corner itself, or the one whose normal it takes.
    stand_in: Vec<usize>,
    /// Other end of an edge at the vertex, and a corner that has this edge.
    edges: Vec<(u32, usize)>,
    /// For each corner.
    normals: Vec<DVec3>,
}

impl Vertex {
    fn group(&mut self, corners: &[Corner], triangles: &[[u32; 3]], faces: &[Option<DVec3>]) {
        self.corners.clear();
        self.corners.extend_from_slice(corners);
        self.group.clear();
        self.group.extend(0..corners.len());
        self.edges.clear();
        for (at, corner) in corners.iter().enumerate() {
            let indices = triangles[corner.triangle];
            self.edges.push((indices[(corner.corner + 1) % 3], at));
            self.edges.push((indices[(corner.corner + 2) % 3], at));
        }
        self.edges.sort_unstable();
        let edges = std::mem::take(&mut self.edges);
        let face = |at: usize| faces[corners[at].triangle];
        for edge in edges.chunk_by(|a, b| a.0 == b.0) {
            for (first, (_, a)) in edge.iter().enumerate() {
                let others = if edge.len() > MAX_EDGE_FACES {
                    1
                } else {
                    edge.len()
                };
                for (_, b) in edge.iter().skip(first + 1).take(others) {
                    let smooth = match (face(*a), face(*b)) {
                        (Some(a), Some(b)) => a.dot(b) >= COS_CREASE,
                        _ => false,
                    };
                    if smooth {
                        self.join(*a, *b);
                    }
                }
            }
        }
        // A face without area has no say; it goes with a neighbour, or with
        // any face here that has an area.
        let any = (0..corners.len()).find(|&at| face(at).is_some());
        self.stand_in.clear();
        self.stand_in
            .extend((0..corners.len()).map(|at| face(at).map_or(any.unwrap_or(at), |_| at)));
        for edge in edges.chunk_by(|a, b| a.0 == b.0) {
            if let Some(&(_, neighbour)) = edge.iter().find(|(_, at)| face(*at).is_some()) {
                for &(_, at) in edge.iter().filter(|(_, at)| face(*at).is_none()) {
                    self.stand_in[at] = neighbour;
                }
            }
        }
        self.edges = edges;
    }

    fn root(&self, mut at: usize) -> usize {
        while self.group[at] != at {
            at = self.group[at];
        }
        at
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.group[a.max(b)] = a.min(b);
    }

    fn sum(&mut self, points: &[DVec3], triangles: &[[u32; 3]], faces: &[Option<DVec3>]) {
        let mut sums = vec![DVec3::ZERO; self.corners.len()];
        for (at, corner) in self.corners.iter().enumerate() {
            if let Some(normal) = faces[corner.triangle] {
                let indices = triangles[corner.triangle];
                let [here, b, c] =
                    [0, 1, 2].map(|step| points[indices[(corner.corner + step) % 3] as usize]);
                let (b, c) = (b - here, c - here);
                let angle = libm::atan2(b.cross(c).length(), b.dot(c));
                sums[self.root(at)] += normal * angle;
            }
        }
        self.normals.clear();
        for &at in &self.stand_in {
            let own = faces[self.corners[at].triangle].unwrap_or(DVec3::Z);
            // Faces of a thin spike may cancel out.
            let sum = sums[self.root(at)];
            self.normals.push(if sum.length() > 1e-9 {
                sum.normalize()
            } else {
                own
            });
        }
    }
}
