//! Meshlets of materials that need more than a level a corner.

use super::draw::Part;
use super::paint::Paint;
use super::stats::FrameStats;
use super::triangles::{Triangle, triangles};
use crate::clip::WEIGHT_BITS;
use crate::frame::Target;
use crate::light::{Lit, Patch, SurfaceLights, face_normal};
use crate::raster::{
    Corner, Fill, MOST_ATTRIBUTES, SurfaceKind, Values, draw_surface, draw_triangle,
};
use crate::shade::{Attributes, Lighting, Lookup, Surface};
use crate::vertex::{surface_point, vertex};
use crate::view::MeshletRows;

/// Draws the triangles of such a meshlet.
#[inline(never)]
pub(super) fn draw_surface_meshlet<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    target: &mut Target<'_>,
    stats: &mut FrameStats,
) {
    let view = part.view;
    let (scene, meshlet, material) = (part.scene, part.meshlet, &view.material);
    let patch = Patch::new(meshlet, &view.mesh);
    let tinted = !scene.meshlet_colours(meshlet, &view.mesh).is_empty();
    let attributes = Attributes::new(material, tinted);
    // Corners are lit already, if they are what is lit.
    let lit_here = matches!(attributes.lighting, Lighting::Face | Lighting::Pixel);
    let lights = lit_here.then(|| SurfaceLights::new(scene, view, &patch));
    let surface = Surface {
        attributes,
        lights: lights.as_ref(),
    };
    let corners = CornerSource {
        part,
        patch,
        rows: MeshletRows::new(view, meshlet),
        attributes: surface.attributes,
    };
    let lookup = if material.coloured {
        Lookup::Colours(scene.colours())
    } else {
        Lookup::Levels(scene.shade(material))
    };
    let kind = SurfaceKind {
        attributes: surface.attributes.count(),
        footprint: false,
    };
    let sides = part.sides();
    triangles(scene, view, meshlet, part.transformed, stats, |triangle| {
        let ids = part.ids(triangle.number);
        if attributes.lighting == Lighting::Face && !material.coloured {
            let fill = || {
                let lit = corners.face(&triangle, &surface);
                Fill::Flat(paint.surface(lookup, lit, [0; 2], ids))
            };
            return draw_triangle(target, triangle.corners, sides, view.perspective, fill);
        }
        let mut face = None;
        draw_surface(
            target,
            triangle.corners,
            sides,
            kind,
            &mut || corners.of(&triangle),
            &mut |run| {
                let face = *face.get_or_insert_with(|| corners.face(&triangle, &surface));
                let [_, row] = run.place;
                run.draw(true, |column, values, _| {
                    let lit = surface.light(values, face);
                    Some(paint.surface(lookup, lit, [column, row], ids))
                });
            },
        )
    });
}

/// Where corners get their attributes.
struct CornerSource<'a> {
    part: &'a Part<'a>,
    patch: Patch,
    rows: MeshletRows,
    attributes: Attributes,
}

impl CornerSource<'_> {
    /// The corners of a triangle.
    fn of(&self, triangle: &Triangle<'_>) -> [Corner; 3] {
        let (view, indices) = (self.part.view, triangle.indices);
        let whole = indices.map(|index| self.attributes(index));
        match triangle.cuts {
            None => {
                let mut corners = whole.map(|attributes| Corner {
                    distance: 1,
                    attributes,
                });
                if view.perspective {
                    for (corner, index) in corners.iter_mut().zip(indices) {
                        let (scene, meshlet) = (self.part.scene, self.part.meshlet);
                        let vertex = vertex(scene, &self.rows, view, meshlet, *index);
                        corner.distance = vertex.distance;
                    }
                }
                corners
            }
            Some(cuts) => cuts.map(|cut| Corner {
                distance: if view.perspective { cut.distance } else { 1 },
                attributes: weighted(&whole, cut.weights),
            }),
        }
    }

    /// A vertex's attributes.
    fn attributes(&self, index: u8) -> Values {
        let mut values = [0; MOST_ATTRIBUTES];
        let part = self.part;
        match self.attributes.lighting {
            Lighting::Face => {}
            Lighting::Level => {
                let kept = part.transformed.vertices.get(usize::from(index));
                let [level, ..] = &mut values;
                *level = kept.map_or(0, |v| i32::from(v.level.to_bits()));
            }
            Lighting::Colour => {
                let colour = part.transformed.colour(index);
                values.iter_mut().zip(colour).for_each(|(v, c)| *v = c);
            }
            Lighting::Pixel => {
                let ([x, y, z], [nx, ny, nz]) = self.point(index);
                let [r, g, b] = match self.tint(index) {
                    Some(tint) if self.attributes.tinted => tint.map(|c| i32::from(c) << 6),
                    _ => [0; 3],
                };
                let all = [nx, ny, nz, x, y, z, r, g, b];
                values.iter_mut().zip(all).for_each(|(v, c)| *v = c);
            }
        }
        values
    }

    /// Light of a face, at its middle.
    fn face(&self, triangle: &Triangle<'_>, surface: &Surface<'_>) -> Lit {
        let Some(lights) = surface
            .lights
            .filter(|_| self.attributes.lighting == Lighting::Face)
        else {
            return [0; 3];
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
        lights.shine(normal, middle.map(third), tint)
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
fn weighted(corners: &[Values; 3], weights: [i32; 3]) -> Values {
    let mut values = [0; MOST_ATTRIBUTES];
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
