//! What the corners of a surface's triangles have besides their place on the screen.

use super::draw::Part;
use super::triangles::Triangle;
use crate::clip::WEIGHT_BITS;
use crate::light::{Parts, Patch, face_normal, sum};
use crate::raster::{Corner, RUN_FRACTION, Values};
use crate::shade::{Lighting, Sampler, Surface};
use crate::vertex::{surface_point, vertex};
use crate::view::MeshletRows;

/// Where corners get their attributes.
pub(super) struct CornerSource<'a> {
    pub part: &'a Part<'a>,
    pub patch: Patch,
    pub rows: MeshletRows,
    pub surface: &'a Surface<'a>,
    /// The texture, if there is one.
    pub sampler: Option<&'a Sampler<'a>>,
    /// Whether attributes are interpolated in space.
    pub perspective: bool,
}

impl CornerSource<'_> {
    /// Sets the attributes of a triangle's corners, which are 0 before; of a face its light. In
    /// perspective normals are as long as they are near: linear on the screen are those, and of
    /// a normal nothing but its direction is asked for.
    pub fn set<const A: usize>(&self, triangle: &Triangle<'_>, out: &mut [Values<A>; 3]) {
        let first = self.surface.attributes.before_light();
        if self.surface.attributes.lighting == Lighting::Face {
            let Parts { body, gloss } = self.face(triangle);
            if !self.surface.attributes.textured {
                for values in out {
                    put(values, first, sum(body, gloss).map(|c| fine(c.into())));
                }
                return;
            }
            for values in out.iter_mut() {
                put(values, first, body.map(|c| fine(c.into())));
                put(values, first + 3, gloss.map(|c| fine(c.into())));
            }
        }
        for (values, index) in out.iter_mut().zip(triangle.indices) {
            self.attributes(*index, values);
        }
        if let Some(cuts) = triangle.cuts {
            let whole = *out;
            for (values, cut) in out.iter_mut().zip(cuts) {
                *values = weighted(&whole, cut.weights);
            }
        }
        if self.in_space(triangle) && self.surface.attributes.lighting == Lighting::Pixel {
            let nearness = triangle.corners.map(|corner| corner.z().to_bits());
            lengthen(out, first, nearness);
        }
    }

    /// Whether a triangle's attributes are interpolated in space. What is cut is even if the rest
    /// is not: along the screen there is nothing right for it.
    pub fn in_space(&self, triangle: &Triangle<'_>) -> bool {
        self.perspective || triangle.cuts.is_some() && self.part.view.perspective
    }

    /// The corners of a triangle.
    pub fn of<const A: usize>(&self, triangle: &Triangle<'_>) -> [Corner<A>; 3] {
        let (view, indices) = (self.part.view, triangle.indices);
        let mut whole = [[0; A]; 3];
        for (values, index) in whole.iter_mut().zip(indices) {
            self.attributes(*index, values);
        }
        let mut corners = whole.map(|attributes| Corner {
            distance: 1,
            attributes,
        });
        if let Some(cuts) = triangle.cuts {
            for (corner, cut) in corners.iter_mut().zip(cuts) {
                if self.in_space(triangle) {
                    corner.distance = cut.distance;
                }
                corner.attributes = weighted(&whole, cut.weights);
            }
        } else if self.perspective {
            let (scene, meshlet) = (self.part.scene, self.part.meshlet);
            for (corner, index) in corners.iter_mut().zip(indices) {
                corner.distance = vertex(scene, &self.rows, view, meshlet, *index).distance;
            }
        }
        corners
    }

    /// Sets a vertex's attributes, which are 0 before.
    fn attributes<const A: usize>(&self, index: u8, values: &mut Values<A>) {
        let part = self.part;
        let attributes = self.surface.attributes;
        if attributes.textured {
            let all = part
                .scene
                .meshlet_coordinates(part.meshlet, &part.view.mesh);
            let own = all.get(usize::from(index)).copied().unwrap_or_default();
            let own = own.map(i16::from_le);
            put(
                values,
                0,
                self.sampler.map_or([0; 2], |s| s.attributes(own)),
            );
        }
        let first = attributes.before_light();
        match attributes.lighting {
            Lighting::Face => {}
            Lighting::Level => {
                let kept = part.transformed.vertices.get(usize::from(index));
                let level = kept.map_or(0, |v| i32::from(v.level().to_bits()));
                // Of grey all channels are the same; a texel takes one.
                put(values, first, [fine(level); 3]);
            }
            Lighting::Colour if attributes.textured => {
                let (place, normal) = self.point(index);
                let lights = self.surface.lights;
                let parts = lights.map(|l| l.parts(normal, place, self.tint(index)));
                let Parts { body, gloss } = parts.unwrap_or_default();
                put(values, first, body.map(|c| fine(c.into())));
                if attributes.glossy {
                    put(values, first + 3, gloss.map(|c| fine(c.into())));
                }
            }
            Lighting::Colour => put(values, first, part.transformed.colour(index).map(fine)),
            Lighting::Pixel => {
                let (place, normal) = self.point(index);
                put(values, first, normal.map(fine));
                put(values, first + 3, place.map(fine));
                if attributes.tinted {
                    let tint = self.tint(index).unwrap_or([255; 3]);
                    put(values, first + 6, tint.map(|c| fine(i32::from(c) << 6)));
                }
            }
        }
    }

    /// Light of a face, at its middle.
    pub fn face(&self, triangle: &Triangle<'_>) -> Parts {
        let face = self.surface.attributes.lighting == Lighting::Face;
        let Some(lights) = self.surface.lights.filter(|_| face) else {
            return Parts::default();
        };
        let part = self.part;
        let normals = part
            .scene
            .meshlet_face_normals(part.meshlet, &part.view.mesh);
        let packed = normals.get(triangle.number).copied().unwrap_or_default();
        let mut middle = [0; 3];
        let mut tint = None;
        for index in triangle.indices {
            let (place, _) = self.point(*index);
            for (sum, c) in middle.iter_mut().zip(place) {
                *sum += c;
            }
            if let Some(own) = self.tint(*index) {
                let sums = tint.get_or_insert([0u16; 3]);
                for (sum, c) in sums.iter_mut().zip(own) {
                    *sum += u16::from(c);
                }
            }
        }
        // A third, without a divide.
        let third = |c: i32| (c * 21845 + (1 << 15)) >> 16;
        let tint = tint.map(|sums| sums.map(|c| third(c.into()) as u8));
        let normal = face_normal(u32::from_le(packed));
        lights.parts(normal, middle.map(third), tint)
    }

    /// Place and normal of a vertex.
    fn point(&self, index: u8) -> ([i32; 3], [i32; 3]) {
        let (part, index) = (self.part, usize::from(index));
        let vertices = part.scene.meshlet_vertices(part.meshlet);
        let fine = part.scene.meshlet_fine(part.meshlet, &part.view.mesh);
        let vertex = vertices.get(index).copied().unwrap_or_default();
        surface_point(&self.patch, vertex, fine.get(index))
    }

    fn tint(&self, index: u8) -> Option<[u8; 3]> {
        let part = self.part;
        let colours = part.scene.meshlet_colours(part.meshlet, &part.view.mesh);
        let [r, g, b, _] = *colours.get(usize::from(index))?;
        Some([r, g, b])
    }
}

/// The corners' attributes with weights.
pub(super) fn weighted<const A: usize>(corners: &[Values<A>; 3], weights: [i32; 3]) -> Values<A> {
    let mut values = [0; A];
    for (which, value) in values.iter_mut().enumerate() {
        let mut sum = 1i64 << (WEIGHT_BITS - 1);
        for (corner, weight) in corners.iter().zip(weights) {
            let own = corner.get(which).copied().unwrap_or(0);
            sum += i64::from(own) * i64::from(weight);
        }
        *value = (sum >> WEIGHT_BITS) as i32;
    }
    values
}

/// Multiplies three attributes by nearness, the nearest's with 14 bits.
#[inline(never)]
fn lengthen<const A: usize>(corners: &mut [Values<A>; 3], first: usize, nearness: [u32; 3]) {
    let most = nearness.iter().fold(0, |most, n| most | n);
    let up = most.leading_zeros() as i32 - 18;
    if most == 0 {
        return;
    }
    for (values, n) in corners.iter_mut().zip(nearness) {
        let n = if up >= 0 { n << up } else { n >> -up } as i32;
        for c in values.iter_mut().skip(first).take(3) {
            // 14 bits and a sign.
            *c = (*c >> RUN_FRACTION) * n;
        }
    }
}

/// Puts some attributes in their places.
#[inline(always)]
fn put<const A: usize, const N: usize>(values: &mut Values<A>, first: usize, own: [i32; N]) {
    for (value, own) in values.iter_mut().skip(first).zip(own) {
        *value = own;
    }
}

/// An attribute from a whole number of 16 bits.
fn fine(v: i32) -> i32 {
    v << RUN_FRACTION
}
