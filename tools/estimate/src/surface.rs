//! The work that a triangle of a surface is: how its attributes get to its pixels, and what is
//! done there.

use fixel::shade::Lighting;
use fixel::vertex::ScreenVertex;

use crate::bend::{bend, levels_differ, textures_bend};
use crate::kernel::{Lights, Surface};
use crate::seen::Seen;
use crate::span::{LONGEST_RUN_PX, LONGEST_TEXELS_PX, RunKind, RunPx};
use crate::term::{Term, Work};

/// Columns of triangles that textures are had pixel by pixel for.
const WIDEST_PX: f64 = 32.0;

impl Surface {
    /// Counts a triangle under lights, of a mesh that is tinted or not.
    pub fn count(
        &self,
        work: &mut Work,
        (seen, corners): (&Seen, [&ScreenVertex; 3]),
        (lights, tinted): (Lights, bool),
        perspective: bool,
    ) {
        let shaded = self.is_shaded((seen, corners), lights, perspective);
        if shaded {
            self.shaded(work, seen);
        } else {
            let cut_out = self.cut_out;
            let kind = match self.is_texels() {
                true => RunKind::Texels { cut_out },
                false if cut_out => RunKind::CutOut,
                false => RunKind::Any,
            };
            let runs = if perspective {
                let longest = RunPx::new(corners, kind);
                seen.runs(|middle| longest.at(middle))
            } else if self.is_texels() {
                seen.runs(|_| LONGEST_TEXELS_PX)
            } else {
                seen.runs(|_| LONGEST_RUN_PX)
            };
            self.runs(work, seen, runs, perspective);
        }
        self.pixels(work, seen, (lights, tinted), shaded);
    }

    /// Whether a triangle is drawn pixel by pixel.
    fn is_shaded(
        &self,
        (seen, corners): (&Seen, [&ScreenVertex; 3]),
        lights: Lights,
        perspective: bool,
    ) -> bool {
        let full = f64::from(255 << 6);
        let most = match self.lighting {
            Lighting::Face => 0.0,
            Lighting::Level | Lighting::Colour => levels_differ(corners),
            Lighting::Pixel if lights.cones > 0.0 => full,
            // The core goes by places, which nobody is told of here.
            Lighting::Pixel if lights.placed + lights.gloss > 0.0 => full / 4.0,
            Lighting::Pixel => 0.0,
        };
        let bent = perspective && bend(corners, most);
        // Nobody is told here how large texels are.
        let texels =
            seen.width < WIDEST_PX && !self.cut_out && !(perspective && textures_bend(corners));
        !bent && (texels || !self.textured)
    }

    fn shaded(&self, work: &mut Work, seen: &Seen) {
        if self.copies {
            work.add(Term::CopiesShaded, 1.0);
        }
        if self.is_texels() {
            work.add(Term::TexelShaded, 1.0);
            work.add(Term::TexelShadedRow, seen.rows);
            work.add(Term::TexelShadedPx, seen.px);
            work.add(Term::TexelShadedPxInFront, seen.in_front);
            return;
        }
        if self.textured {
            let attributes = match self.lighting {
                Lighting::Pixel => 11.0,
                _ => 8.0,
            };
            work.add(Term::TexturedShaded, 1.0);
            work.add(Term::TexturedShadedAttribute, attributes);
            work.add(Term::TexturedShadedRow, seen.rows);
            work.add(Term::TexturedShadedPx, seen.px);
            work.add(Term::TexturedShadedPxInFront, self.shown(seen));
            return;
        }
        let attributes = match self.lighting {
            Lighting::Pixel => 9.0,
            _ => 3.0,
        };
        let triangle = if seen.small {
            Term::SmallShaded
        } else {
            Term::LargeShaded
        };
        work.add(triangle, 1.0);
        work.add(Term::ShadedAttribute, attributes);
        work.add(Term::ShadedRow, seen.rows);
        work.add(Term::ShadedRowAttribute, seen.rows * attributes);
        work.add(Term::ShadedPx, seen.px);
        work.add(Term::ShadedPxAttribute, seen.px * attributes);
        work.add(Term::ShadedPxInFront, self.shown(seen));
    }

    fn runs(&self, work: &mut Work, seen: &Seen, runs: f64, perspective: bool) {
        let Self { attributes, .. } = *self;
        work.add(Term::SurfaceTriangle, 1.0);
        work.add(Term::SurfaceTriangleAttribute, attributes);
        work.add(Term::SurfaceRow, seen.rows);
        work.add(Term::SurfaceRowAttribute, seen.rows * attributes);
        work.add(Term::SurfacePx, seen.px);
        let texels = self.is_texels();
        if texels {
            work.add(Term::TexelSpan, seen.spans());
            work.add(Term::TexelRun, runs);
        } else {
            work.add(Term::SurfaceRun, runs);
            work.add(Term::SurfaceRunAttribute, runs * attributes);
        }
        if perspective && texels {
            work.add(Term::PerspectiveTexelRun, runs);
        } else if perspective {
            work.add(Term::PerspectiveSurfaceRun, runs);
            work.add(Term::PerspectiveSurfaceRunAttribute, runs * attributes);
        }
        if self.copies {
            work.add(Term::CopiesTriangle, 1.0);
            work.add(Term::CopiesRun, runs);
            work.add(Term::CopiesPx, seen.px);
        }
        if self.cut_out {
            work.add(Term::CutOutPx, seen.px);
        }
        if !texels {
            let shown = self.shown(seen);
            work.add(Term::SurfacePxInFront, shown);
            work.add(Term::SurfacePxAttribute, shown * attributes);
        }
    }

    /// What is done at a surface's pixels, however its attributes get there.
    fn pixels(&self, work: &mut Work, seen: &Seen, (lights, tinted): (Lights, bool), shaded: bool) {
        let shown = self.shown(seen);
        let by_face = self.lighting == Lighting::Face;
        let lit = match self.lighting {
            Lighting::Face => 1.0,
            Lighting::Pixel => shown,
            Lighting::Level | Lighting::Colour => 0.0,
        };
        let what = match self.lighting {
            Lighting::Pixel => Term::LitPixel,
            _ => Term::Lit,
        };
        lights.shine(work, what, lit, tinted);
        if self.is_texels() {
            if shaded {
                return;
            }
            let texel = if by_face {
                Term::FaceTexelPx
            } else {
                Term::LevelTexelPx
            };
            work.add(texel, shown);
            return;
        }
        if self.coloured {
            let colour = if by_face {
                Term::FaceColourPx
            } else {
                Term::ColourPx
            };
            work.add(colour, shown);
        }
        if self.dithered {
            work.add(Term::DitheredPx, shown);
        }
        if self.textured && self.bilinear {
            work.add(Term::BilinearPx, shown);
        } else if self.textured {
            work.add(Term::ColourTexelPx, shown);
        }
        if self.blended {
            work.add(Term::BlendedPx, shown);
            if self.fogged {
                work.add(Term::FoggedBlendedPx, shown);
            }
        }
        if self.door {
            work.add(Term::DoorPx, seen.px);
        }
    }
}
