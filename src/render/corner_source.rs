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
    /// The attributes of a triangle's corners, of a face its light.
    pub fn values<const A: usize>(&self, triangle: &Triangle<'_>) -> [Values<A>; 3] {
        if self.surface.attributes.lighting == Lighting::Face {
            let Parts { body, gloss } = self.face(triangle);
            let mut values = [0; A];
            for (value, c) in values.iter_mut().zip(sum(body, gloss)) {
                *value = fine(c.into());
            }
            return [values; 3];
        }
        let whole = triangle.indices.map(|index| self.attributes(index).1);
        match triangle.cuts {
            None => whole,
            Some(cuts) => cuts.map(|cut| weighted(&whole, cut.weights)),
        }
    }

    /// The corners of a triangle.
    pub fn of<const A: usize>(&self, triangle: &Triangle<'_>) -> [Corner<A>; 3] {
        let (view, indices) = (self.part.view, triangle.indices);
        let whole = indices.map(|index| self.attributes(index));
        let Some(cuts) = triangle.cuts else {
            return whole.map(|(index, attributes)| Corner {
                distance: if self.perspective {
                    let (scene, meshlet) = (self.part.scene, self.part.meshlet);
                    vertex(scene, &self.rows, view, meshlet, index).distance
                } else {
                    1
                },
                attributes,
            });
        };
        let whole = whole.map(|(_, attributes)| attributes);
        cuts.map(|cut| Corner {
            // What is cut is interpolated in space even if the rest is not: along
            // the screen there is nothing right for it.
            distance: if view.perspective { cut.distance } else { 1 },
            attributes: weighted(&whole, cut.weights),
        })
    }

    /// A vertex and its attributes.
    fn attributes<const A: usize>(&self, index: u8) -> (u8, Values<A>) {
        let mut values = [0; A];
        let mut slots = values.iter_mut();
        let mut put = |list: &[i32]| {
            slots.by_ref().zip(list).for_each(|(slot, v)| *slot = *v);
        };
        let part = self.part;
        let attributes = self.surface.attributes;
        if attributes.textured {
            let all = part
                .scene
                .meshlet_coordinates(part.meshlet, &part.view.mesh);
            let own = all.get(usize::from(index)).copied().unwrap_or_default();
            let own = own.map(i16::from_le);
            put(&self.sampler.map_or([0; 2], |s| s.attributes(own)));
        }
        match attributes.lighting {
            Lighting::Face => {}
            Lighting::Level => {
                let kept = part.transformed.vertices.get(usize::from(index));
                // Of grey all channels are the same; a texel takes one.
                put(&[fine(kept.map_or(0, |v| i32::from(v.level().to_bits()))); 3]);
            }
            Lighting::Colour if attributes.textured => {
                let (place, normal) = self.point(index);
                let lights = self.surface.lights;
                let parts = lights.map(|l| l.parts(normal, place, self.tint(index)));
                let Parts { body, gloss } = parts.unwrap_or_default();
                put(&body.map(|c| fine(c.into())));
                if attributes.glossy {
                    put(&gloss.map(|c| fine(c.into())));
                }
            }
            Lighting::Colour => put(&part.transformed.colour(index).map(fine)),
            Lighting::Pixel => {
                let (place, normal) = self.point(index);
                put(&normal.map(fine));
                put(&place.map(fine));
                if attributes.tinted {
                    let tint = self.tint(index).unwrap_or([255; 3]);
                    put(&tint.map(|c| fine(i32::from(c) << 6)));
                }
            }
        }
        (index, values)
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

/// An attribute from a whole number of 16 bits.
fn fine(v: i32) -> i32 {
    v << RUN_FRACTION
}
