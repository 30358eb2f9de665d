//! A triangle as its surface is asked for. Neighbouring rays mostly meet the same one, so the
//! last is kept.

use super::actor::{GridPlace, RayActor};
use super::triangle::{Corners, Points, TriangleHit};
use crate::light::vertex_normal;
use crate::math::{Unit3, product, unit_vector};
use crate::scene::{Mesh, Meshlet, Record, Scene};

/// What a surface is wanted for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Need {
    /// The place.
    pub place: bool,
    /// The face's normal.
    pub face: bool,
    /// It is lit with the face's normal.
    pub flat: bool,
}

/// See the module. Lengths are in `2^-fraction` grid steps.
#[derive(Debug)]
pub(super) struct Facet {
    key: Key,
    /// The first corner, from the middle of the grid.
    first: [i32; 3],
    /// From the first corner to the others.
    pub edges: [[i32; 3]; 2],
    /// The face's normal, outward, in the world; 0 where nobody asks for it.
    pub face: Unit3,
    /// The vertices' normals in the grid, 14 fractional bits; 0 where the face's lights it.
    pub normals: [[i16; 3]; 3],
    /// The vertices' numbers in the meshlet.
    pub corners: [u8; 3],
    /// The mesh has neither colours nor texture coordinates.
    pub is_plain: bool,
}

/// Whose a facet is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Key {
    /// Of the actor's mesh.
    meshlet: u32,
    actor: u16,
    /// Of the meshlet.
    triangle: u8,
    /// In which units.
    fraction: i8,
}

impl Key {
    #[inline(always)]
    fn new(actor: &RayActor, (meshlet, triangle): (u32, u8), from: &GridPlace) -> Self {
        Self {
            meshlet,
            actor: actor.number,
            triangle,
            // -20..=8.
            fraction: from.fraction as i8,
        }
    }
}

impl Facet {
    /// All zero, so that working memory starts as zeros: a frame begins by clearing it.
    pub(super) const EMPTY: Self = Self {
        key: Key {
            meshlet: 0,
            actor: 0,
            triangle: 0,
            fraction: 0,
        },
        first: [0; 3],
        edges: [[0; 3]; 2],
        face: [0; 3],
        normals: [[0; 3]; 3],
        corners: [0; 3],
        is_plain: false,
    };

    /// Nothing is kept from one frame to the next.
    pub(super) fn clear(&mut self) {
        // No mesh has so many meshlets.
        self.key.meshlet = u32::MAX;
    }

    /// The triangle that a ray from a place in the actor's grid has met; `None` of one without
    /// a face. What is needed has to be the same for all of an actor, in one frame.
    #[inline(always)]
    pub(super) fn find(
        &mut self,
        (scene, actor): (&Scene<'_>, &RayActor),
        from: &GridPlace,
        hit: &TriangleHit,
        need: Need,
    ) -> Option<&Self> {
        let key = Key::new(actor, (hit.meshlet, hit.triangle), from);
        if self.key != key {
            self.clear();
            self.make((scene, actor), from, hit, need)?;
            self.key = key;
        }
        Some(self)
    }

    /// Its corners as they are off a place in the actor's grid, if it is this triangle.
    #[inline(always)]
    pub(super) fn corners_off(
        &self,
        actor: &RayActor,
        number: (u32, u8),
        from: &GridPlace,
    ) -> Option<Corners> {
        if self.key != Key::new(actor, number, from) {
            return None;
        }
        let first = self.off(from);
        let [ab, ac] = self.edges;
        Some([first, plus(first, ab), plus(first, ac)])
    }

    /// The first corner as it is off a place.
    #[inline(always)]
    pub(super) fn off(&self, from: &GridPlace) -> [i32; 3] {
        minus(self.first, from.place)
    }

    #[inline(never)]
    fn make(
        &mut self,
        (scene, actor): (&Scene<'_>, &RayActor),
        from: &GridPlace,
        hit: &TriangleHit,
        need: Need,
    ) -> Option<()> {
        let mesh = scene.mesh(actor.mesh);
        let meshlet = Meshlet::from_words(scene.meshlets_of(&mesh).get(hit.meshlet as usize)?);
        let points = Points::new(scene, &mesh, meshlet, from);
        let corners = points.corners(hit.triangle);
        let [a, b, c] = corners.map(|corner| points.off(corner));
        // Differences are the same from any place.
        let (ab, ac) = (minus(b, a), minus(c, a));
        let mut first = a;
        for (c, from) in first.iter_mut().zip(from.place) {
            *c = c.wrapping_add(from);
        }
        (self.first, self.edges) = (first, [ab, ac]);
        self.face = [0; 3];
        if need.face || need.flat {
            let in_grid = unit_vector(cross(ab, ac))?;
            self.face = actor.direction_to_world(in_grid).map(|c| c << 2);
        }
        self.normals = [[0; 3]; 3];
        if !need.flat {
            self.normals = normals(scene, &mesh, &meshlet, corners);
        }
        self.corners = corners.map(|corner| corner as u8);
        self.is_plain = scene.meshlet_colours(&meshlet, &mesh).is_empty()
            && scene.meshlet_coordinates(&meshlet, &mesh).is_empty();
        Some(())
    }
}

/// The normals of a triangle's vertices, 14 fractional bits.
fn normals(
    scene: &Scene<'_>,
    mesh: &Mesh,
    meshlet: &Meshlet,
    corners: [usize; 3],
) -> [[i16; 3]; 3] {
    let all = scene.meshlet_vertices(meshlet);
    let fine = scene.meshlet_fine(meshlet, mesh);
    corners.map(|corner| {
        let [.., code] = all.get(corner).copied().unwrap_or_default();
        let low = fine.get(corner).map(|[.., low]| *low);
        vertex_normal(i16::from_le(code), low).map(|c| c as i16)
    })
}

fn plus([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i32; 3] {
    [
        ax.wrapping_add(bx),
        ay.wrapping_add(by),
        az.wrapping_add(bz),
    ]
}

fn minus([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i32; 3] {
    [
        ax.wrapping_sub(bx),
        ay.wrapping_sub(by),
        az.wrapping_sub(bz),
    ]
}

/// The cross product of two vectors, brought to 30 bits.
fn cross(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    // 31 bits by 31.
    let area = |p: i32, q: i32, r: i32, s: i32| product(p, q).wrapping_sub(product(r, s));
    let wide = [
        area(ay, bz, az, by),
        area(az, bx, ax, bz),
        area(ax, by, ay, bx),
    ];
    let most = wide.iter().fold(1, |m, c| m | c.unsigned_abs());
    let down = 34u32.saturating_sub(most.leading_zeros());
    wide.map(|c| (c >> down) as i32)
}
