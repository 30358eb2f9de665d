//! Meshlets of materials that need more than a level a corner.

use core::cell::Cell;

use super::corner_source::CornerSource;
use super::draw::Part;
use super::paint::Paint;
use super::stats::FrameStats;
use super::surface_pixels::Textured;
use super::surface_runs::{Others, Runs, Texels, Through, Way};
use super::triangles::{Done, Draw, Triangle, triangles};
use crate::frame::{Stored, Target};
use crate::light::{Parts, Patch, SurfaceLights, sum};
use crate::math::FineLevel;
use crate::raster::{Drawn, How, MOST_ATTRIBUTES, Shade, ShadePixel, Sides, SurfaceKind};
use crate::raster::{draw_shaded, draw_surface, draw_triangle};
use crate::scene::Transparency;
use crate::scene::layout::TEXTURE_SHADES;
use crate::shade::{Attributes, Blend, Lighting, Sampler, ScreenDoor, Surface};
use crate::view::{MeshletRows, round_level};

/// Draws the triangles of such a meshlet.
#[inline(never)]
pub(super) fn draw_surface_meshlet<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    done: &mut Done,
    target: &mut Target<'_, P::Stored>,
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
    // Half a kilobyte: made where they stay.
    let mut lights = lit_here.then_some(SurfaceLights::NONE);
    if let Some(lights) = &mut lights {
        lights.set(scene, view, &patch);
    }
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
        sampler: sampler.as_ref(),
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
        corners: &corners,
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
        let mut done = Done::NONE;
        triangles(part, &mut done, stats, &mut surfaces);
        surfaces.sides = Sides { front, back: false };
    }
    triangles(part, done, stats, &mut surfaces);
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
struct Surfaces<'a, 't, P: Paint> {
    paint: &'a P,
    target: &'a mut Target<'t, P::Stored>,
    corners: &'a CornerSource<'a>,
    way: Way<'a>,
    kind: SurfaceKind,
    sides: Sides,
    through: Through<'a>,
}

impl<P: Paint> Draw for Surfaces<'_, '_, P> {
    fn draw(&mut self, triangle: &Triangle<'_>) -> Drawn {
        let part = self.corners.part;
        let attributes = &self.corners.surface.attributes;
        let (lighting, through) = (attributes.lighting, self.through);
        if let (Way::Levels(shades), Lighting::Face, Through::Nothing) =
            (self.way, lighting, through)
        {
            let fill = || {
                let Parts { body, gloss } = self.corners.face(triangle);
                let [level, ..] = sum(body, gloss);
                let level = round_level(FineLevel::from_bits(level));
                self.paint
                    .fill(shades, Some(level), part.ids(triangle.number))
            };
            let perspective = part.view.perspective;
            let Some(target) = P::Stored::indices(self.target) else {
                return Drawn::NOTHING;
            };
            return draw_triangle(target, triangle.corners, self.sides, perspective, fill);
        }
        let runs = Runs::new(self.paint, self.corners, triangle);
        if let (Way::Texels(shades), Some(sampler), Through::Nothing) =
            (self.way, self.corners.sampler, through)
        {
            match lighting {
                Lighting::Face => return self.texels::<2>(runs, shades, sampler),
                Lighting::Level => return self.texels::<3>(runs, shades, sampler),
                Lighting::Colour | Lighting::Pixel => {}
            }
        }
        let (way, sampler) = (self.way, self.corners.sampler);
        let others = Others {
            runs,
            way,
            sampler,
            through,
            fog_row: Cell::default(),
        };
        let drawn = match (lighting, sampler) {
            // Of what the scene does not have, there are no coordinates either.
            (_, None) if attributes.textured => None,
            (Lighting::Pixel, None) => self.shaded::<9>(triangle, &others),
            (_, None) => self.shaded::<3>(triangle, &others),
            (lighting, Some(sampler)) => {
                let others = &others;
                let textured = Textured { others, sampler };
                if lighting == Lighting::Pixel {
                    self.shaded::<11>(triangle, &textured)
                } else {
                    self.shaded::<8>(triangle, &textured)
                }
            }
        };
        if let Some(drawn) = drawn {
            return drawn;
        }
        let (kind, sides) = (self.kind, self.sides);
        draw_runs::<MOST_ATTRIBUTES, _, _>(self.target, &others.runs, sides, kind, &others)
    }

    #[inline(always)]
    fn drawn(&self, triangle: &Triangle<'_>, how: How) {
        let ids = self.corners.part.ids(triangle.number);
        self.paint.drawn(self.target, triangle.corners, how, ids);
    }
}

impl<P: Paint> Surfaces<'_, '_, P> {
    /// Draws a triangle pixel by pixel, if that is enough.
    fn shaded<const A: usize>(
        &mut self,
        triangle: &Triangle<'_>,
        shade: &impl ShadePixel<A, P::Stored>,
    ) -> Option<Drawn> {
        draw_shaded(self.target, triangle.corners, self.sides, shade)
    }

    fn texels<const A: usize>(
        &mut self,
        runs: Runs<'_, P>,
        shades: &[u8; TEXTURE_SHADES],
        sampler: &Sampler<'_>,
    ) -> Drawn {
        let texels = Texels {
            runs,
            shades,
            sampler,
        };
        match P::Stored::indices(self.target) {
            Some(target) => {
                let corners = texels.runs.triangle.corners;
                if let Some(drawn) = draw_shaded(target, corners, self.sides, &texels) {
                    return drawn;
                }
                draw_runs::<A, _, _>(target, &texels.runs, self.sides, self.kind, &texels)
            }
            None => Drawn::NOTHING,
        }
    }
}

/// Draws a triangle run by run.
fn draw_runs<const A: usize, C: Stored, P: Paint>(
    target: &mut Target<'_, C>,
    runs: &Runs<'_, P>,
    sides: Sides,
    kind: SurfaceKind,
    shade: &impl Shade<A, C>,
) -> Drawn {
    let corners = &mut || runs.corners();
    draw_surface(target, runs.triangle.corners, sides, kind, corners, shade)
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
