//! Edges that become points, the cheapest first.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;

use super::quadric::{Fit, Quadric};
use super::surface::{Freedom, Surface};

/// Least cosine between a face's normals before and after one of its corners has moved.
const TURN: f64 = 0.2;
/// Least height of a face over its longest side, unless it was as flat before.
const FLAT: f64 = 0.01;

/// An edge in the queue: the bits of its cost (which is not negative, so they have its
/// order), its places, and how often each had changed.
type Candidate = Reverse<(u64, [u32; 2], [u32; 2])>;

/// What an edge would become.
struct Collapse {
    /// The place that stays and the one that goes.
    edge: [u32; 2],
    to: DVec3,
    cost: f64,
    /// The faces that go.
    faces: Vec<usize>,
    /// Corners of the place that stays, and the corner of the other that each takes in.
    merged: Vec<[u32; 2]>,
}

/// Collapses edges until there is none left that may be.
pub(super) struct Collapser {
    pub surface: Surface,
    queue: BinaryHeap<Candidate>,
    changes: Vec<u32>,
}

impl Collapser {
    pub(super) fn new(surface: Surface) -> Self {
        let mut new = Self {
            changes: vec![0; surface.positions.len()],
            queue: BinaryHeap::new(),
            surface,
        };
        for place in 0..new.surface.positions.len() as u32 {
            for neighbour in new.surface.neighbours(place) {
                if place < neighbour {
                    new.push([place, neighbour]);
                }
            }
        }
        new
    }

    fn push(&mut self, edge: [u32; 2]) {
        if let Some(collapse) = self.surface.collapse(edge) {
            let changes = edge.map(|v| self.changes[v as usize]);
            let cost = (collapse.cost + 0.0).to_bits();
            self.queue.push(Reverse((cost, edge, changes)));
        }
    }

    /// Goes on until at most `most` faces are left, or none of the edges may go.
    pub(super) fn down_to(&mut self, most: usize) {
        while self.surface.living > most {
            let Some(Reverse((_, edge, changes))) = self.queue.pop() else {
                return;
            };
            if edge.map(|v| self.changes[v as usize]) != changes {
                continue;
            }
            let Some(collapse) = self.surface.collapse(edge) else {
                continue;
            };
            if !self.surface.keeps_its_shape(&collapse) {
                continue;
            }
            let [stays, goes] = collapse.edge;
            self.surface.apply(&collapse);
            self.changes[stays as usize] += 1;
            self.changes[goes as usize] += 1;
            for neighbour in self.surface.neighbours(stays) {
                self.push([stays.min(neighbour), stays.max(neighbour)]);
            }
        }
    }
}

impl Surface {
    /// What an edge becomes; `None` if borders, seams or the surface's connections would
    /// not stay what they are.
    fn collapse(&self, [u, v]: [u32; 2]) -> Option<Collapse> {
        let freedom = |place: u32| self.freedoms[place as usize];
        let [stays, goes] = if freedom(u) >= freedom(v) {
            [u, v]
        } else {
            [v, u]
        };
        let edge = [stays, goes];
        let faces: Vec<usize> = self.faces_at(edge).collect();
        if faces.is_empty() || faces.len() > 2 {
            return None;
        }
        // Two ends of borders or seams must not meet across a face.
        let bound = [stays, goes].map(|v| freedom(v) != Freedom::Free);
        if bound == [true, true] && !self.is_feature(edge, &faces) {
            return None;
        }
        if freedom(goes) == Freedom::Fixed || !self.is_linked_by(edge, &faces) {
            return None;
        }
        let merged = self.merged(edge, &faces)?;

        let mut area = 0.0;
        let mut cost = self.features[stays as usize];
        cost += self.features[goes as usize];
        for (place, index) in [(stays, 0), (goes, 1)] {
            for corner in self.corners_at(place) {
                let with = merged.iter().find(|pair| pair[index] == corner);
                let fit = match with {
                    Some(pair) if index == 0 => self.joined(pair),
                    Some(_) => continue,
                    None => self.fits[corner as usize],
                };
                cost += fit.quadric(self.count);
                area += fit.area();
            }
        }
        let [from, other] = edge.map(|v| self.positions[v as usize]);
        let to = match (freedom(stays), freedom(goes)) {
            (Freedom::Free, _) | (Freedom::Feature, Freedom::Feature) => {
                best_place(&cost, from, other)
            }
            _ => from,
        };
        // Between the sum and the mean of squares over the area: by the sum, small faces go
        // far off, which counts where the worst place does.
        let cost = cost.at(to) / area.max(f64::MIN_POSITIVE).sqrt();
        Some(Collapse {
            edge,
            to,
            cost,
            faces,
            merged,
        })
    }

    /// A place's corners, each once, in order.
    fn corners_at(&self, place: u32) -> Vec<u32> {
        let faces = self.faces_around(place);
        let mut all: Vec<u32> = faces.map(|(f, _)| self.corner(f, place)).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn joined(&self, pair: &[u32; 2]) -> Fit {
        let mut fit = self.fits[pair[0] as usize];
        fit += self.fits[pair[1] as usize];
        fit
    }

    /// Whether the ends have no neighbours in common but those of the faces that go: else
    /// the surface would touch itself afterwards.
    fn is_linked_by(&self, edge: [u32; 2], faces: &[usize]) -> bool {
        let [of_one, of_other] = edge.map(|v| self.neighbours(v));
        let common = of_one.iter().filter(|v| of_other.contains(v)).count();
        common == faces.len() && of_one.len() + of_other.len() > 6
    }

    /// Which corners become one, by the faces that go; `None` if two of one place would.
    fn merged(&self, edge: [u32; 2], faces: &[usize]) -> Option<Vec<[u32; 2]>> {
        let mut merged: Vec<[u32; 2]> = Vec::new();
        for face in faces {
            let pair = edge.map(|v| self.corner(*face, v));
            let clash = |held: &[u32; 2]| (held[0] == pair[0]) != (held[1] == pair[1]);
            if merged.iter().any(clash) {
                return None;
            }
            if !merged.contains(&pair) {
                merged.push(pair);
            }
        }
        Some(merged)
    }

    /// Whether no face turns over or becomes a needle.
    fn keeps_its_shape(&self, collapse: &Collapse) -> bool {
        let [stays, goes] = collapse.edge;
        let moved = |v: u32| {
            if v == stays || v == goes {
                collapse.to
            } else {
                self.positions[v as usize]
            }
        };
        let around = [stays, goes].into_iter().flat_map(|v| self.faces_around(v));
        let mut left = around.filter(|(f, _)| !collapse.faces.contains(f));
        left.all(|(_, face)| {
            let (before, was_flat) = shape(face.map(|v| self.positions[v as usize]));
            let (after, is_flat) = shape(face.map(moved));
            let turns = after.dot(before) < TURN * after.length() * before.length();
            after != DVec3::ZERO && !turns && (is_flat >= FLAT || is_flat >= was_flat)
        })
    }

    fn apply(&mut self, collapse: &Collapse) {
        let [stays, goes] = collapse.edge;
        for face in &collapse.faces {
            self.faces[*face] = None;
        }
        self.living -= collapse.faces.len();
        let moved: Vec<usize> = self.faces_around(goes).map(|(f, _)| f).collect();
        for face in &moved {
            let Some(at) = &mut self.faces[*face] else {
                continue;
            };
            for (place, corner) in at.iter_mut().zip(&mut self.corners[*face]) {
                if *place == goes {
                    *place = stays;
                    let pair = collapse.merged.iter().find(|pair| pair[1] == *corner);
                    *corner = pair.map_or(*corner, |pair| pair[0]);
                }
            }
        }
        let mut around: Vec<u32> = self.faces_around(stays).map(|(f, _)| f as u32).collect();
        around.extend(moved.iter().map(|f| *f as u32));
        self.around[stays as usize] = around;
        self.around[goes as usize] = Vec::new();
        let features = self.features[goes as usize];
        self.features[stays as usize] += features;
        self.positions[stays as usize] = collapse.to;
        for pair in &collapse.merged {
            let fit = self.joined(pair);
            let kept = pair[0] as usize;
            self.fits[kept] = fit;
            self.attributes[kept] = fit.attributes(collapse.to, &self.attributes[kept]);
        }
    }
}

/// A face's normal, not of length 1, and its height over its longest side.
fn shape([p, q, r]: [DVec3; 3]) -> (DVec3, f64) {
    let across = (q - p).cross(r - p);
    let sides = [q - p, r - q, p - r].map(DVec3::length_squared);
    let longest = sides.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    (across, across.length() / longest)
}

/// Where an edge costs least: where the quadric says, unless that is farther off than the
/// edge is long, or one of three places on the edge.
fn best_place(cost: &Quadric, from: DVec3, to: DVec3) -> DVec3 {
    let middle = (from + to) / 2.0;
    let near = |place: &DVec3| place.distance_squared(middle) <= from.distance_squared(to);
    let least = cost.least(middle).filter(near);
    let mut best = least.unwrap_or(middle);
    for place in [middle, from, to] {
        if cost.at(place) < cost.at(best) {
            best = place;
        }
    }
    best
}
