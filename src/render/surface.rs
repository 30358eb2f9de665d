//! Meshlets of materials that need more than a level a corner.

use core::cell::OnceCell;

use super::draw::Part;
use super::paint::{Ids, Paint};
use super::stats::FrameStats;
use super::triangles::{Draw, Triangle, triangles};
use crate::clip::WEIGHT_BITS;
use crate::fog::Haze;
use crate::frame::Target;
use crate::light::{Parts, Patch, SurfaceLights, face_normal, sum};
use crate::math::{Depth, FineLevel};
use crate::raster::{
    Corner, Drawn, MOST_ATTRIBUTES, Run, Sides, SurfaceKind, Values, draw_surface, draw_triangle,
};
use crate::scene::layout::{COLOURS, TEXTURE_SHADES};
use crate::scene::{NO_TEXEL, Transparency};
use crate::shade::{
    Attributes, Blend, Lighting, Lookup, Pixel, Sampler, ScreenDoor, Surface, on_texel,
};
use crate::vertex::{surface_point, vertex};
use crate::view::{MeshletRows, round_level};

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
    // Corners are lit already, if they are what is lit and highlights are not asked
    // for by themselves.
    let lit_here = matches!(attributes.lighting, Lighting::Face | Lighting::Pixel)
        || attributes.textured && attributes.lighting == Lighting::Colour;
    let lights = lit_here.then(|| SurfaceLights::new(scene, view, &patch));
    let surface = Surface {
        attributes,
        lights: lights.as_ref(),
    };
    let sampler = sampler(part);
    let in_space = sampler.as_ref().is_none_or(|s| s.texture.perspective);
    let corners = CornerSource {
        part,
        patch,
        rows: MeshletRows::new(view, meshlet),
        surface: &surface,
        perspective: view.perspective && in_space,
    };
    let way = if material.coloured {
        Way::Colours(scene.colours())
    } else if attributes.textured {
        Way::Texels(scene.texture_shades(material))
    } else {
        Way::Levels(scene.shade(material))
    };
    let mut surfaces = Surfaces {
        paint,
        target,
        surface: &surface,
        corners: &corners,
        sampler: sampler.as_ref(),
        way,
        kind: SurfaceKind {
            attributes: attributes.count(),
            footprint: sampler.as_ref().is_some_and(|s| s.texture.copies > 1),
            outlined: sampler.as_ref().is_some_and(|s| s.texture.cut_out),
        },
        sides: part.sides(),
        through: Through::of(part),
    };
    let Sides { front, back } = surfaces.sides;
    if let Through::Blend(_) = surfaces.through
        && front
        && back
    {
        // What faces away lies behind what faces the eye, at least in one meshlet of a
        // convex thing.
        surfaces.sides.front = false;
        triangles(scene, view, meshlet, part.transformed, stats, &mut surfaces);
        surfaces.sides = Sides { front, back: false };
    }
    triangles(scene, view, meshlet, part.transformed, stats, &mut surfaces);
}

/// How what is behind a surface shows through.
#[derive(Clone, Copy)]
enum Through<'a> {
    Nothing,
    Door(ScreenDoor),
    Blend(Blend<'a>),
}

impl<'a> Through<'a> {
    fn of(part: &Part<'a>) -> Self {
        if !cfg!(feature = "transparency") {
            return Self::Nothing;
        }
        match part.view.material.transparency {
            Transparency::Opaque => Self::Nothing,
            Transparency::ScreenDoor { first, pixels } => Self::Door(ScreenDoor { first, pixels }),
            Transparency::Blend { opacity } => Self::Blend(Blend {
                opacity,
                palette: part.scene.palette(),
            }),
        }
    }
}

/// What the triangles of such a meshlet have in common.
struct Surfaces<'a, 't, P> {
    paint: &'a P,
    target: &'a mut Target<'t>,
    surface: &'a Surface<'a>,
    corners: &'a CornerSource<'a>,
    sampler: Option<&'a Sampler<'a>>,
    way: Way<'a>,
    kind: SurfaceKind,
    sides: Sides,
    through: Through<'a>,
}

impl<P: Paint> Draw for Surfaces<'_, '_, P> {
    fn draw(&mut self, triangle: &Triangle<'_>) -> Drawn {
        let part = self.corners.part;
        let ids = part.ids(triangle.number);
        let lighting = self.surface.attributes.lighting;
        let through = self.through;
        if let (Way::Levels(shades), Lighting::Face, Through::Nothing) =
            (self.way, lighting, through)
        {
            let fill = || {
                let Parts { body, gloss } = self.corners.face(triangle);
                let [level, ..] = sum(body, gloss);
                let level = round_level(FineLevel::from_bits(level));
                self.paint.fill(shades, Some(level), ids)
            };
            let perspective = part.view.perspective;
            return draw_triangle(self.target, triangle.corners, self.sides, perspective, fill);
        }
        let corners = self.corners;
        let face = OnceCell::new();
        let face = || *face.get_or_init(|| corners.face(triangle));
        let (paint, way, surface) = (self.paint, self.way, self.surface);
        let (sampler, target) = (self.sampler, &mut *self.target);
        let whole = |run: &mut Run<'_>| {
            draw_run(paint, ids, way, surface, sampler, face(), run);
        };
        // Kernels are linked once, whoever calls them.
        let whole: &dyn Fn(&mut Run<'_>) = &whole;
        let (behind_door, mixed);
        let shade: &dyn Fn(&mut Run<'_>) = match through {
            Through::Nothing => whole,
            Through::Door(door) => {
                behind_door = move |run: &mut Run<'_>| door.shade(run, whole);
                &behind_door
            }
            Through::Blend(blend) => {
                mixed = move |run: &mut Run<'_>| {
                    blend_run(
                        paint,
                        (&blend, part.haze),
                        way,
                        surface,
                        sampler,
                        face(),
                        run,
                    );
                };
                &mixed
            }
        };
        draw_surface(
            target,
            triangle.corners,
            self.sides,
            self.kind,
            &mut || corners.of(triangle),
            shade,
        )
    }
}

/// The way from light to an index.
#[derive(Clone, Copy)]
enum Way<'a> {
    Levels(&'a [u8; 256]),
    Colours(&'a [u8; COLOURS]),
    Texels(&'a [u8; TEXTURE_SHADES]),
}

/// The material's texture on the mesh.
fn sampler<'a>(part: &Part<'a>) -> Option<Sampler<'a>> {
    if !cfg!(feature = "texture") {
        return None;
    }
    let texture = part.scene.texture(part.view.material.texture?)?;
    Some(Sampler::new(
        part.scene,
        texture,
        part.view.mesh.coordinates?,
    ))
}

/// Draws a run of pixels.
fn draw_run<P: Paint>(
    paint: &P,
    ids: Ids,
    way: Way<'_>,
    surface: &Surface<'_>,
    sampler: Option<&Sampler<'_>>,
    face: Parts,
    run: &mut Run<'_>,
) {
    let [left, row] = run.place;
    let index = |lookup, number, lit, texel| {
        let place = [left + number, row];
        let pixel = Pixel {
            lookup,
            lit,
            place,
            texel,
        };
        Some(paint.surface(&pixel, ids))
    };
    match (sampler, way) {
        (Some(sampler), Way::Texels(shades)) => {
            let path = sampler.path(run);
            let texel = |number| {
                let at = path.at(number);
                let texel = sampler.nearest(&path, at);
                (texel != NO_TEXEL).then(|| (path.in_picture(at), texel))
            };
            match surface.attributes.lighting {
                Lighting::Face => run.draw::<0>(true, |number, _, _| {
                    let (at, base) = texel(number)?;
                    index(Lookup::Texel(shades, base), number, face.body, at)
                }),
                Lighting::Level => run.draw::<3>(true, |number, values, _| {
                    let (at, base) = texel(number)?;
                    let lit = surface.light(values, face).body;
                    index(Lookup::Texel(shades, base), number, lit, at)
                }),
                Lighting::Colour | Lighting::Pixel => {
                    run.draw::<MOST_ATTRIBUTES>(true, |number, values, _| {
                        let (at, base) = texel(number)?;
                        let lit = surface.light(values, face).body;
                        index(Lookup::Texel(shades, base), number, lit, at)
                    });
                }
            }
        }
        (Some(sampler), Way::Colours(colours)) => {
            let path = sampler.path(run);
            run.draw::<MOST_ATTRIBUTES>(true, |number, values, _| {
                let at = path.at(number);
                let texel = sampler.colour(&path, at)?;
                let lit = on_texel(surface.light(values, face), texel);
                index(Lookup::Colours(colours), number, lit, path.in_picture(at))
            });
        }
        (_, Way::Colours(colours)) => {
            run.draw::<9>(true, |number, values, _| {
                let Parts { body, gloss } = surface.light(values, face);
                index(Lookup::Colours(colours), number, sum(body, gloss), [0; 2])
            });
        }
        (_, Way::Levels(shades)) => {
            run.draw::<9>(true, |number, values, _| {
                let Parts { body, gloss } = surface.light(values, face);
                index(Lookup::Levels(shades), number, sum(body, gloss), [0; 2])
            });
        }
        (None, Way::Texels(_)) => {}
    }
}

/// Mixes a run of pixels with what is behind them, which stays as near as it is.
#[inline(never)]
fn blend_run<P: Paint>(
    paint: &P,
    (blend, haze): (&Blend<'_>, Option<&Haze>),
    way: Way<'_>,
    surface: &Surface<'_>,
    sampler: Option<&Sampler<'_>>,
    face: Parts,
    run: &mut Run<'_>,
) {
    // Blended materials go by colour.
    let Way::Colours(colours) = way else { return };
    let [left, row] = run.place;
    let textured = sampler.map(|sampler| (sampler, sampler.path(run)));
    let ((z, dz), mut fog_row) = (run.depth, 0);
    run.draw::<MOST_ATTRIBUTES>(false, |number, values, behind| {
        let light = surface.light(values, face);
        let (lit, texel) = match &textured {
            None => (sum(light.body, light.gloss), [0; 2]),
            Some((sampler, path)) => {
                let at = path.at(number);
                let lit = on_texel(light, sampler.colour(path, at)?);
                (lit, path.in_picture(at))
            }
        };
        let lit = match haze {
            Some(haze) => {
                let depth = z.wrapping_add_signed(dz.wrapping_mul(number)) >> 16;
                haze.over(lit, depth as Depth, &mut fog_row)
            }
            None => lit,
        };
        let pixel = Pixel {
            lookup: Lookup::Colours(colours),
            lit,
            place: [left + number, row],
            texel,
        };
        Some(paint.blend(&pixel, behind, blend))
    });
}

/// Where corners get their attributes.
struct CornerSource<'a> {
    part: &'a Part<'a>,
    patch: Patch,
    rows: MeshletRows,
    surface: &'a Surface<'a>,
    /// Whether attributes are interpolated in space.
    perspective: bool,
}

impl CornerSource<'_> {
    /// The corners of a triangle.
    fn of(&self, triangle: &Triangle<'_>) -> [Corner; 3] {
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
    fn attributes(&self, index: u8) -> (u8, Values) {
        let mut values = [0; MOST_ATTRIBUTES];
        let mut slots = values.iter_mut();
        let mut put = |list: &[i32]| slots.by_ref().zip(list).for_each(|(slot, v)| *slot = *v);
        let part = self.part;
        let attributes = self.surface.attributes;
        if attributes.textured {
            let all = part
                .scene
                .meshlet_coordinates(part.meshlet, &part.view.mesh);
            let own = all.get(usize::from(index)).copied().unwrap_or_default();
            put(&own.map(|c| i32::from(i16::from_le(c))));
        }
        match attributes.lighting {
            Lighting::Face => {}
            Lighting::Level => {
                let kept = part.transformed.vertices.get(usize::from(index));
                put(&[kept.map_or(0, |v| i32::from(v.level().to_bits()))]);
            }
            Lighting::Colour if attributes.textured => {
                let (place, normal) = self.point(index);
                let lights = self.surface.lights;
                let parts = lights.map(|l| l.parts(normal, place, self.tint(index)));
                let Parts { body, gloss } = parts.unwrap_or_default();
                put(&body.map(i32::from));
                if attributes.glossy {
                    put(&gloss.map(i32::from));
                }
            }
            Lighting::Colour => put(&part.transformed.colour(index)),
            Lighting::Pixel => {
                let (place, normal) = self.point(index);
                put(&normal);
                put(&place);
                if attributes.tinted {
                    let tint = self.tint(index).unwrap_or([255; 3]);
                    put(&tint.map(|c| i32::from(c) << 6));
                }
            }
        }
        (index, values)
    }

    /// Light of a face, at its middle.
    fn face(&self, triangle: &Triangle<'_>) -> Parts {
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
