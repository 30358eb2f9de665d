//! Triangles into meshlets: greedy growth over shared vertices, as compact and
//! as even in direction as the limits allow.

use std::collections::HashMap;

use fixel::scene::layout::{MESHLET_TRIANGLES, MESHLET_VERTICES};
use glam::DVec3;

/// A cluster: its triangles, as indices into the mesh's, in drawing order.
pub(crate) type Cluster = Vec<usize>;

/// What distance and a turned face cost, in vertices.
const FAR: f64 = 0.5;
const TURNED: f64 = 0.5;

struct Builder<'a> {
    triangles: &'a [[u32; 3]],
    centres: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// Triangles around each place; vertices at one place count as one, so that
    /// a crease does not end a cluster.
    around: Vec<Vec<u32>>,
    place: Vec<u32>,
    taken: Vec<bool>,
    /// About the radius of a full cluster.
    radius: f64,
}

/// Cuts a mesh into clusters of at most 64 vertices and 128 triangles. A mesh
/// within these limits stays whole and in its own order.
pub(crate) fn clusters(positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<Cluster> {
    let mut vertices = triangles.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    if vertices.len() <= MESHLET_VERTICES && triangles.len() <= MESHLET_TRIANGLES {
        let whole: Cluster = (0..triangles.len()).collect();
        return Vec::from_iter((!whole.is_empty()).then_some(whole));
    }
    let mut builder = Builder::new(positions, triangles);
    let mut clusters = Vec::new();
    let mut order = spatial_order(&builder.centres).into_iter();
    let mut border: Vec<u32> = Vec::new();
    loop {
        // Go on beside what is done, where the fewest neighbours are left, so
        // that no islands stay behind; else at the next place in space.
        border.retain(|t| !builder.taken[*t as usize]);
        let beside = border
            .iter()
            .copied()
            .min_by_key(|t| (builder.free_around(*t as usize), *t));
        let next = || order.find(|t| !builder.taken[*t]);
        let Some(seed) = beside.map(|t| t as usize).or_else(next) else {
            break;
        };
        let cluster = builder.grow(seed);
        border.extend(cluster.iter().flat_map(|t| builder.neighbours(*t)));
        border.sort_unstable();
        border.dedup();
        clusters.push(cluster);
    }
    clusters
}

impl<'a> Builder<'a> {
    fn new(positions: &[DVec3], triangles: &'a [[u32; 3]]) -> Self {
        let corners = |t: &[u32; 3]| t.map(|v| positions[v as usize]);
        let area2 = |t: &[u32; 3]| {
            let [a, b, c] = corners(t);
            (b - a).cross(c - a)
        };
        let mut places = HashMap::new();
        let place: Vec<u32> = positions
            .iter()
            .map(|p| {
                let next = places.len() as u32;
                *places.entry(p.to_array().map(f64::to_bits)).or_insert(next)
            })
            .collect();
        let mut around = vec![Vec::new(); places.len()];
        for (i, triangle) in triangles.iter().enumerate() {
            for v in triangle {
                around[place[*v as usize] as usize].push(i as u32);
            }
        }
        let area: f64 = triangles.iter().map(|t| area2(t).length() / 2.0).sum();
        let share = area / triangles.len().max(1) as f64 * MESHLET_TRIANGLES as f64;
        Self {
            triangles,
            centres: triangles
                .iter()
                .map(|t| corners(t).iter().sum::<DVec3>() / 3.0)
                .collect(),
            normals: triangles
                .iter()
                .map(|t| area2(t).normalize_or_zero())
                .collect(),
            around,
            place,
            taken: vec![false; triangles.len()],
            radius: (share.sqrt() * 0.5).max(f64::MIN_POSITIVE),
        }
    }

    /// Triangles that share a place with a triangle, itself among them.
    fn neighbours(&self, triangle: usize) -> impl Iterator<Item = u32> {
        let places = self.triangles[triangle].map(|v| self.place[v as usize] as usize);
        places
            .into_iter()
            .flat_map(|place| self.around[place].iter().copied())
    }

    /// How many of them are in no cluster yet, counted once a shared place.
    fn free_around(&self, triangle: usize) -> usize {
        self.neighbours(triangle)
            .filter(|t| !self.taken[*t as usize])
            .count()
    }

    fn grow(&mut self, seed: usize) -> Cluster {
        let mut cluster = Vec::new();
        let mut vertices: Vec<u32> = Vec::new();
        let mut border: Vec<u32> = Vec::new();
        let (mut centre, mut axis) = (DVec3::ZERO, DVec3::ZERO);
        let mut next = Some(seed);
        while let Some(triangle) = next {
            self.taken[triangle] = true;
            cluster.push(triangle);
            centre += self.centres[triangle];
            axis += self.normals[triangle];
            for v in self.triangles[triangle] {
                if !vertices.contains(&v) {
                    vertices.push(v);
                    let place = self.place[v as usize] as usize;
                    border.extend(&self.around[place]);
                }
            }
            border.retain(|t| !self.taken[*t as usize]);
            if cluster.len() == MESHLET_TRIANGLES {
                break;
            }
            let (middle, direction) = (centre / cluster.len() as f64, axis.normalize_or_zero());
            next = self.best(&border, &vertices, middle, direction);
        }
        cluster
    }

    /// The triangle of the border that adds the fewest vertices, then stays
    /// close and faces the same way.
    fn best(
        &self,
        border: &[u32],
        vertices: &[u32],
        middle: DVec3,
        direction: DVec3,
    ) -> Option<usize> {
        let mut best: Option<(f64, usize)> = None;
        for candidate in border {
            let i = *candidate as usize;
            let extra = self.triangles[i]
                .iter()
                .filter(|v| !vertices.contains(v))
                .count();
            if vertices.len() + extra > MESHLET_VERTICES {
                continue;
            }
            let far = self.centres[i].distance(middle) / self.radius;
            let turned = 1.0 - self.normals[i].dot(direction);
            // One that would soon be alone is taken along.
            let lonely = 6.0 / self.free_around(i).max(1) as f64;
            let cost = extra as f64 + far * FAR + TURNED * turned - lonely;
            if best.is_none_or(|(least, at)| (cost, i) < (least, at)) {
                best = Some((cost, i));
            }
        }
        best.map(|(_, i)| i)
    }
}

/// Triangles along a Z curve, so that clusters start beside earlier ones.
fn spatial_order(centres: &[DVec3]) -> Vec<usize> {
    let low = centres.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = centres
        .iter()
        .copied()
        .fold(DVec3::NEG_INFINITY, DVec3::max);
    let size = (high - low).max_element().max(f64::MIN_POSITIVE);
    let key = |centre: &DVec3| {
        let cell = ((*centre - low) / size * 1023.0)
            .to_array()
            .map(|c| c as u32);
        (0..10).fold(0u32, |key, bit| {
            cell.iter()
                .fold(key, |key, c| (key << 1) | ((c >> (9 - bit)) & 1))
        })
    };
    let mut order: Vec<usize> = (0..centres.len()).collect();
    order.sort_by_key(|i| (key(&centres[*i]), *i));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid of `n` x `n` squares, each two triangles.
    fn grid(n: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let row = n + 1;
        let positions = (0..row * row)
            .map(|i| DVec3::new(f64::from(i % row), f64::from(i / row), 0.0))
            .collect();
        let square = |i: u32| {
            let a = i / n * row + i % n;
            [[a, a + 1, a + row], [a + 1, a + row + 1, a + row]]
        };
        (positions, (0..n * n).flat_map(square).collect())
    }

    #[test]
    fn every_triangle_is_in_one_cluster_within_the_limits() {
        let (positions, triangles) = grid(40);
        let clusters = clusters(&positions, &triangles);
        let mut seen = vec![0; triangles.len()];
        for cluster in &clusters {
            let mut vertices: Vec<u32> = cluster.iter().flat_map(|t| triangles[*t]).collect();
            vertices.sort_unstable();
            vertices.dedup();
            assert!(vertices.len() <= MESHLET_VERTICES);
            assert!(cluster.len() <= MESHLET_TRIANGLES);
            cluster.iter().for_each(|t| seen[*t] += 1);
        }
        assert!(seen.iter().all(|n| *n == 1));
        // 64 vertices hold at most 98 triangles of a grid.
        let mean = triangles.len() as f64 / clusters.len() as f64;
        assert!(mean > 75.0, "{mean} triangles a cluster");
    }
}
