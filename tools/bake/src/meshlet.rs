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

/// Triangles around one place that are looked at: as many as a cluster has. In a fan of very
/// many, each cluster would look at all of them.
const MOST_AROUND: usize = MESHLET_TRIANGLES;

struct Builder<'a> {
    triangles: &'a [[u32; 3]],
    centres: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// Triangles around each place; vertices at one place count as one, so that
    /// a crease does not end a cluster.
    around: Vec<Vec<u32>>,
    /// Of these, how many at the beginning are taken, and how many are free at all.
    done: Vec<usize>,
    free: Vec<usize>,
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
        let mut places: Vec<usize> = cluster.iter().flat_map(|t| builder.places(*t)).collect();
        places.sort_unstable();
        places.dedup();
        for place in places {
            border.extend(builder.free_at(place));
        }
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
            place,
            taken: vec![false; triangles.len()],
            done: vec![0; around.len()],
            free: around.iter().map(Vec::len).collect(),
            around,
            radius: (share.sqrt() * 0.5).max(f64::MIN_POSITIVE),
        }
    }

    /// Triangles around a place that are in no cluster yet, in their order: the first of them,
    /// if there are very many.
    fn free_at(&mut self, place: usize) -> impl Iterator<Item = u32> {
        let around = &self.around[place];
        let (taken, done) = (&self.taken, &mut self.done[place]);
        while around.get(*done).is_some_and(|t| taken[*t as usize]) {
            *done += 1;
        }
        let left = around[*done..].iter().copied();
        left.filter(|t| !taken[*t as usize]).take(MOST_AROUND)
    }

    fn places(&self, triangle: usize) -> [usize; 3] {
        self.triangles[triangle].map(|v| self.place[v as usize] as usize)
    }

    /// How many triangles that share a place with this one are in no cluster yet, itself
    /// among them, counted once a shared place.
    fn free_around(&self, triangle: usize) -> usize {
        let places = self.places(triangle);
        places.into_iter().map(|place| self.free[place]).sum()
    }

    fn grow(&mut self, seed: usize) -> Cluster {
        let mut cluster = Vec::new();
        let mut vertices: Vec<u32> = Vec::new();
        let mut border: Vec<u32> = Vec::new();
        let (mut centre, mut axis) = (DVec3::ZERO, DVec3::ZERO);
        let mut next = Some(seed);
        while let Some(triangle) = next {
            self.taken[triangle] = true;
            for place in self.places(triangle) {
                self.free[place] -= 1;
            }
            cluster.push(triangle);
            centre += self.centres[triangle];
            axis += self.normals[triangle];
            for v in self.triangles[triangle] {
                if !vertices.contains(&v) {
                    vertices.push(v);
                    let place = self.place[v as usize] as usize;
                    border.extend(self.free_at(place));
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

    /// Its 60,000 triangles are all around one place; by the square of that it would take
    /// minutes.
    #[test]
    fn a_fan_of_very_many_triangles_takes_no_long_time() {
        let count = 60_000;
        let rim = |i: u32| f64::from(i) / f64::from(count) * std::f64::consts::TAU;
        let mut positions = vec![DVec3::ZERO];
        positions.extend((0..=count).map(|i| DVec3::new(rim(i).cos(), rim(i).sin(), 0.0)));
        let triangles: Vec<[u32; 3]> = (1..=count).map(|i| [0, i, i + 1]).collect();
        let begun = std::time::Instant::now();
        let clusters = clusters(&positions, &triangles);
        assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
        let mut all = clusters.concat();
        all.sort_unstable();
        assert!(all.into_iter().eq(0..triangles.len()));
        // 64 vertices are 62 triangles of a fan.
        assert!(clusters.len() < 1100, "{} clusters", clusters.len());
    }
}
