//! What goes into one meshlet: triangles, edges and points.

use std::collections::HashMap;

use fixel::scene::layout::MESHLET_VERTICES;

use crate::meshlet::Cluster;

/// A meshlet's contents, by their numbers in the mesh.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    /// Triangles, in drawing order.
    pub triangles: Cluster,
    /// Edges whose ends are among the vertices.
    pub edges: Vec<usize>,
    /// The vertices, in the order of their first use.
    pub vertices: Vec<u32>,
}

impl Group {
    fn add(&mut self, vertices: &[u32]) {
        for vertex in vertices {
            if !self.vertices.contains(vertex) {
                self.vertices.push(*vertex);
            }
        }
    }

    fn has_room(&self, vertices: &[u32]) -> bool {
        let new = vertices.iter().filter(|v| !self.vertices.contains(v));
        self.vertices.len() + new.count() <= MESHLET_VERTICES
    }
}

/// Clusters of triangles with the edges of each, and further groups for edges and
/// points that no triangle has. An edge is in one group only.
pub(crate) fn groups(
    triangles: &[[u32; 3]],
    clusters: Vec<Cluster>,
    edges: &[[u32; 2]],
    points: impl Iterator<Item = u32>,
) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    let mut owner: HashMap<[u32; 2], usize> = HashMap::new();
    let mut held: HashMap<u32, usize> = HashMap::new();
    for (number, cluster) in clusters.into_iter().enumerate() {
        let mut group = Group::default();
        for triangle in &cluster {
            let [a, b, c] = triangles[*triangle];
            group.add(&[a, b, c]);
            for side in [[a, b], [b, c], [c, a]] {
                owner.entry(sorted(side)).or_insert(number);
            }
        }
        held.extend(group.vertices.iter().map(|v| (*v, number)));
        group.triangles = cluster;
        groups.push(group);
    }
    let of_triangles = groups.len();
    for (number, edge) in edges.iter().enumerate() {
        if let Some(owner) = owner.get(&sorted(*edge)) {
            groups[*owner].edges.push(number);
            continue;
        }
        let group = last_with_room(&mut groups, of_triangles, edge);
        group.add(edge);
        group.edges.push(number);
        held.extend(edge.map(|v| (v, usize::MAX)));
    }
    for point in points.filter(|point| !held.contains_key(point)) {
        last_with_room(&mut groups, of_triangles, &[point]).add(&[point]);
    }
    groups
}

/// The last group if it is none of triangles and has room, or a new one.
fn last_with_room<'g>(
    groups: &'g mut Vec<Group>,
    of_triangles: usize,
    vertices: &[u32],
) -> &'g mut Group {
    let fits = groups.len() > of_triangles && groups.last().is_some_and(|g| g.has_room(vertices));
    if !fits {
        groups.push(Group::default());
    }
    let last = groups.len() - 1;
    &mut groups[last]
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
