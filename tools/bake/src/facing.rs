//! Which way triangles face: those of a meshlet in an order that puts like ones together, and
//! a cone for each few of them, so that backs are left out before their vertices are
//! transformed.

use fixel::scene::FaceCone;
use fixel::scene::layout::CONE_TRIANGLES;
use glam::{DVec3, IVec3};

use crate::mesh::Parts;
use crate::meshlet::Cluster;

/// Longest component of a cone's axis.
const AXIS: f64 = 15.0;
/// How large a meshlet is as its eye sees it, when cones of one set of triangles are compared.
const USUAL_SIZE: f64 = 0.12;
/// What is added to a cone's spread: triangles are left out only if they are turned away by
/// half a degree and more. Those that rounding on the screen turns round are thinner than a
/// thirtieth of a pixel then.
const MARGIN: f64 = 0.2;

/// Sorts a meshlet's triangles so that each few, from the first on, face one way.
pub(crate) fn sort(cluster: &mut Cluster, normal: impl Fn(usize) -> DVec3) {
    halve(cluster, &normal);
}

/// Cuts triangles across the direction in which their normals differ most, until they are few.
fn halve(part: &mut [usize], normal: &impl Fn(usize) -> DVec3) {
    if part.len() <= CONE_TRIANGLES {
        part.sort_unstable();
        return;
    }
    let normals: Vec<DVec3> = part.iter().map(|t| normal(*t)).collect();
    let axis = widest(&normals);
    part.sort_by(|a, b| {
        let along = [a, b].map(|t| normal(*t).dot(axis));
        along[0].total_cmp(&along[1]).then(a.cmp(b))
    });
    let groups = part.len().div_ceil(CONE_TRIANGLES);
    let (low, high) = part.split_at_mut(groups / 2 * CONE_TRIANGLES);
    halve(low, normal);
    halve(high, normal);
}

/// The direction in which some vectors differ most, by power iteration.
fn widest(vectors: &[DVec3]) -> DVec3 {
    let mean = vectors.iter().sum::<DVec3>() / vectors.len() as f64;
    let mut axis = DVec3::new(1.0, 0.9, 0.8);
    for _ in 0..12 {
        let next: DVec3 = vectors
            .iter()
            .map(|v| (*v - mean) * (*v - mean).dot(axis))
            .sum();
        axis = next.try_normalize().unwrap_or(axis);
    }
    axis
}

/// The cones of all meshlets, where [`fixel::Scene::meshlet_cones`] looks for them.
pub(crate) fn cones(parts: &Parts) -> Vec<[u8; 3]> {
    let mut cones = Vec::new();
    for (mesh, record) in parts.meshes.iter().enumerate() {
        let first = record.first_meshlet as usize;
        for number in first..first + record.meshlets as usize {
            let meshlet = &parts.meshlets[number];
            let from = meshlet.first_triangle as usize;
            let triangles = &parts.triangles[from..from + usize::from(meshlet.triangles)];
            let faces: Vec<_> = triangles
                .iter()
                .map(|t| Face::new(parts, mesh, number, *t))
                .collect();
            let at = from / CONE_TRIANGLES + number;
            let groups = faces.chunks(CONE_TRIANGLES);
            if cones.len() < at + groups.len() {
                cones.resize(at + groups.len(), FaceCone::NEVER.to_bytes());
            }
            for (cone, faces) in cones[at..].iter_mut().zip(groups) {
                *cone = self::cone(faces).unwrap_or(FaceCone::NEVER).to_bytes();
            }
        }
    }
    cones
}

/// A triangle as the blob has it.
struct Face {
    /// 0 of a triangle without area.
    normal: DVec3,
    /// How far its plane is behind the meshlet's base; the meshlet's radius is 1.
    behind: f64,
}

impl Face {
    fn new(parts: &Parts, mesh: usize, number: usize, triangle: [u8; 3]) -> Self {
        let meshlet = &parts.meshlets[number];
        let base = IVec3::from_array(meshlet.base);
        let [a, b, c] = triangle.map(|v| (point(parts, mesh, number, v) - base).as_dvec3());
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let radius = f64::from(meshlet.radius_steps().max(1));
        let behind = -normal.dot(a) / radius;
        Self { normal, behind }
    }
}

/// The cone of some triangles; `None` if they face too many ways for one.
fn cone(faces: &[Face]) -> Option<FaceCone> {
    // What has no area has no pixel.
    let faces: Vec<&Face> = faces.iter().filter(|f| f.normal != DVec3::ZERO).collect();
    let middle = middle(&faces)?;
    let mut best: Option<(f64, FaceCone)> = None;
    // Of the short vectors along the middle, the one that comes out best.
    for quarter in 36..104 {
        let axis = (middle * f64::from(quarter) / 4.0).round();
        let length = axis.length();
        if axis.abs().max_element() > AXIS || length < 1.0 {
            continue;
        }
        let along = |f: &Face| f.normal.dot(axis) / length;
        let least = faces.iter().map(|f| along(f)).fold(1.0, f64::min);
        if least <= 0.05 {
            continue;
        }
        let behind = faces.iter().map(|f| f.behind * along(f));
        let behind = behind.fold(f64::NEG_INFINITY, f64::max);
        let spread = ((1.0 - least * least).max(0.0).sqrt() * length + MARGIN).ceil();
        let offset = (behind * length / 2.0).ceil().max(-8.0);
        if spread > 31.0 || offset > 7.0 {
            continue;
        }
        let cost = (spread + 2.0 * offset * USUAL_SIZE) / length;
        if best.is_none_or(|(least, _)| cost < least) {
            let cone = FaceCone {
                axis: axis.to_array().map(|c| c as i8),
                spread: spread as u8,
                offset: offset as i8,
            };
            best = Some((cost, cone));
        }
    }
    best.map(|(_, cone)| cone)
}

/// About the middle of the narrowest cone around some normals: the mean is drawn to the
/// outermost again and again, less each time (Badoiu and Clarkson, "Smaller core-sets for
/// balls", 2003).
fn middle(faces: &[&Face]) -> Option<DVec3> {
    let mut axis = faces
        .iter()
        .map(|f| f.normal)
        .sum::<DVec3>()
        .try_normalize()?;
    let mut best = (f64::NEG_INFINITY, axis);
    for step in 0..60 {
        let outermost = faces
            .iter()
            .map(|f| (f.normal.dot(axis), f.normal))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        if outermost.0 > best.0 {
            best = (outermost.0, axis);
        }
        axis = (axis + outermost.1 * 0.3 / f64::from(1 + step)).try_normalize()?;
    }
    Some(best.1)
}

/// A vertex in grid steps.
pub(crate) fn point(parts: &Parts, mesh: usize, meshlet: usize, vertex: u8) -> IVec3 {
    let own = &parts.meshlets[meshlet];
    let at = own.first_vertex as usize + usize::from(vertex);
    let stored = parts.vertices[at];
    let fine = parts.meshes[mesh].fine.map(|offset| {
        let at = (at as u32).wrapping_add(offset);
        parts.fine[at as usize]
    });
    let axis = |axis: usize| {
        let low = fine.map_or(0, |fine| i32::from(fine[axis]));
        own.base[axis] + (i32::from(stored[axis]) << own.shifts[axis]) + low
    };
    IVec3::new(axis(0), axis(1), axis(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sphere's normals, as many as a meshlet may have.
    fn normals() -> Vec<DVec3> {
        let around = |i: usize| {
            let height = (i as f64 + 0.5) / 64.0 - 1.0;
            let angle = 2.4 * i as f64;
            let radius = (1.0 - height * height).sqrt();
            DVec3::new(radius * angle.cos(), height, radius * angle.sin())
        };
        (0..128).map(around).collect()
    }

    #[test]
    fn sorting_puts_like_ones_together_and_keeps_all() {
        let normals = normals();
        let mut cluster: Cluster = (0..normals.len()).collect();
        sort(&mut cluster, |t| normals[t]);
        let widest = |cluster: &[usize]| {
            let narrow = |few: &[usize]| {
                let few: Vec<Face> = few
                    .iter()
                    .map(|t| Face {
                        normal: normals[*t],
                        behind: 0.0,
                    })
                    .collect();
                cone(&few).map_or(1.0, |c| {
                    let axis = DVec3::from_array(c.axis.map(f64::from));
                    f64::from(c.spread) / axis.length()
                })
            };
            let groups = cluster.chunks(CONE_TRIANGLES);
            groups.map(narrow).sum::<f64>() / 16.0
        };
        assert!(widest(&cluster) < 0.6, "{}", widest(&cluster));
        cluster.sort_unstable();
        assert!(cluster.iter().copied().eq(0..128));
    }

    /// What a cone says of an eye is so of each of its triangles.
    #[test]
    fn what_a_cone_leaves_out_is_seen_from_behind() {
        let normals = normals();
        let faces = |group: &[DVec3]| -> Vec<Face> {
            let face = |(i, n): (usize, &DVec3)| Face {
                normal: *n,
                behind: (i as f64 * 0.37).sin(),
            };
            group.iter().enumerate().map(face).collect()
        };
        let mut left_out = 0;
        for group in normals.chunks(4) {
            let faces = faces(group);
            let Some(cone) = cone(&faces) else { continue };
            let axis = DVec3::from_array(cone.axis.map(f64::from));
            for way in normals.iter().flat_map(|n| [*n * 0.5, *n * 1.5, *n * 9.0]) {
                let limit = f64::from(cone.spread) * way.length() + 2.0 * f64::from(cone.offset);
                if axis.dot(way) >= limit {
                    left_out += 1;
                    for face in &faces {
                        assert!(face.normal.dot(way) >= face.behind, "{cone:?} {way}");
                    }
                }
            }
        }
        assert!(left_out > 200, "{left_out}");
    }
}
