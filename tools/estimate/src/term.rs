//! What a frame's work is counted in.

/// Declares the terms, and lists them.
macro_rules! terms {
    ($($(#[doc = $doc:literal])* $term:ident,)*) => {
        /// A kind of work, of which a frame has some amount, and which takes so many
        /// instructions each.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Term { $($(#[doc = $doc])* $term,)* }

        impl Term {
            /// All, in order.
            pub const ALL: &[Self] = &[$(Self::$term,)*];

            /// As in the file of coefficients.
            pub fn name(self) -> &'static str {
                match self { $(Self::$term => stringify!($term),)* }
            }
        }
    };
}

terms! {
    /// The frame itself.
    Frame,
    /// A band.
    Band,
    /// A viewport in a band.
    ViewportInBand,
    /// A pixel emptied.
    ClearedPx,
    /// Four pixels that go to the panel and are as the four before.
    RepeatedFour,
    /// Four that are not.
    OtherFour,
    /// A pixel of the frame that is a sample of one of the picture's.
    SamplePx,
    /// Matrices and lights of an actor in a viewport.
    ActorView,
    /// A meshlet's bounds looked at.
    Meshlet,
    /// A meshlet listed.
    MeshletListed,
    /// A meshlet for which another falls out of a full list.
    MeshletDisplaced,
    /// A meshlet drawn in a band.
    MeshletInBand,
    /// A meshlet transformed.
    MeshletTransformed,
    /// A light brought to a meshlet.
    MeshletLight,
    /// A vertex transformed.
    Vertex,
    /// Of these, one of a mesh with finer positions.
    FineVertex,
    /// Of these, one that distance makes smaller.
    PerspectiveVertex,
    /// A vertex lit in grey from infinitely far.
    PlainLitVertex,
    /// A light on such a vertex.
    PlainVertexLight,
    /// A triangle looked at.
    Triangle,
    /// A triangle that shows the side that is not drawn.
    TriangleAway,
    /// A triangle that has no pixel in the band.
    TriangleMissed,
    /// A triangle clipped.
    TriangleClipped,
    /// A triangle of at most 16 by 16 pixels, of one colour.
    SmallFlat,
    /// The same with a level a corner.
    SmallGouraud,
    /// A row of such a triangle, of one colour.
    SmallFlatRow,
    /// The same with a level a corner.
    SmallGouraudRow,
    /// A pixel of such a triangle, of one colour.
    SmallFlatPx,
    /// The same with a level a corner.
    SmallGouraudPx,
    /// A pixel of such a triangle that is in front, of one colour.
    SmallFlatPxInFront,
    /// The same with a level a corner.
    SmallGouraudPxInFront,
    /// A triangle of a pixel or two.
    Tiny,
    /// A pixel of the box around such a triangle.
    TinyBoxPx,
    /// A pixel of such a triangle.
    TinyPx,
    /// A larger triangle of one colour.
    LargeFlat,
    /// The same with a level a corner.
    LargeGouraud,
    /// The same with levels that are divided by distance.
    LargePerspective,
    /// A row of a larger triangle of one colour.
    LargeFlatRow,
    /// The same with a level a corner.
    LargeGouraudRow,
    /// A pixel of a larger triangle of one colour.
    LargeFlatPx,
    /// Such a pixel that is in front.
    LargeFlatPxInFront,
    /// A pixel of a larger triangle with a level a corner.
    LargeGouraudPx,
    /// Such a pixel that is in front.
    LargeGouraudPxInFront,
    /// Sixteen pixels of a row whose levels are divided by distance.
    PerspectiveRun,
    /// A face lit in grey from infinitely far.
    PlainLitFace,
    /// A light on such a face.
    PlainFaceLight,
    /// A triangle that hides what is behind it and shows nothing.
    HidingTriangle,
    /// A row of such a triangle.
    HidingRow,
    /// A pixel of such a triangle.
    HidingPx,
    /// A surface's triangle of at most 16 by 16 pixels whose pixels are shaded one by one.
    SmallShaded,
    /// A larger one.
    LargeShaded,
    /// An attribute of one of these.
    ShadedAttribute,
    /// A row of one.
    ShadedRow,
    /// An attribute in such a row.
    ShadedRowAttribute,
    /// A pixel of one.
    ShadedPx,
    /// An attribute at such a pixel.
    ShadedPxAttribute,
    /// Such a pixel that is in front, but for what follows.
    ShadedPxInFront,
    /// A triangle with a texture by colour whose pixels are shaded one by one.
    TexturedShaded,
    /// An attribute of one.
    TexturedShadedAttribute,
    /// A row of one.
    TexturedShadedRow,
    /// A pixel of one.
    TexturedShadedPx,
    /// Such a pixel that is in front, but for light and texel.
    TexturedShadedPxInFront,
    /// A triangle of texels by level whose pixels are shaded one by one.
    TexelShaded,
    /// A row of one.
    TexelShadedRow,
    /// A pixel of one.
    TexelShadedPx,
    /// Such a pixel that is in front.
    TexelShadedPxInFront,
    /// A triangle of either kind that has smaller copies of its texture.
    CopiesShaded,
    /// A triangle with any few attributes, in runs.
    SurfaceTriangle,
    /// An attribute of such a triangle.
    SurfaceTriangleAttribute,
    /// A row of such a triangle.
    SurfaceRow,
    /// An attribute in such a row.
    SurfaceRowAttribute,
    /// A run of at most 32 pixels of such a row.
    SurfaceRun,
    /// An attribute in such a run.
    SurfaceRunAttribute,
    /// Such a run that distance bends.
    PerspectiveSurfaceRun,
    /// An attribute in it.
    PerspectiveSurfaceRunAttribute,
    /// A row of a triangle of texels by level, which are drawn by kernels of their own.
    TexelSpan,
    /// A run of such a row.
    TexelRun,
    /// Such a run that distance bends.
    PerspectiveTexelRun,
    /// A triangle with smaller copies of its texture.
    CopiesTriangle,
    /// A run of such a triangle.
    CopiesRun,
    /// A pixel of such a triangle.
    CopiesPx,
    /// A pixel of such a triangle.
    SurfacePx,
    /// Such a pixel that is in front, but for what follows.
    SurfacePxInFront,
    /// An attribute at such a pixel.
    SurfacePxAttribute,
    /// A texel by the face's level.
    FaceTexelPx,
    /// A texel by an interpolated level.
    LevelTexelPx,
    /// A pixel of a triangle whose texture cuts out pixels.
    CutOutPx,
    /// A texel by colour.
    ColourTexelPx,
    /// Four texels blended.
    BilinearPx,
    /// A pixel by the face's colour.
    FaceColourPx,
    /// A pixel by an interpolated colour.
    ColourPx,
    /// A pixel by colour that is dithered.
    DitheredPx,
    /// A pixel mixed with what is behind it.
    BlendedPx,
    /// Of these, one that fog lies over.
    FoggedBlendedPx,
    /// A pixel of a screen door.
    DoorPx,
    /// A vertex or a face lit with everything that the model of light has.
    Lit,
    /// A pixel lit so, whose normal is interpolated.
    LitPixel,
    /// A light from infinitely far on one of these.
    LitDirectional,
    /// A light with a place on one.
    LitPlaced,
    /// Of these, one that is weaker with distance.
    LitFalling,
    /// Of these, one that shines in a cone.
    LitCone,
    /// A colour of its own on one.
    LitTint,
    /// A highlight on one.
    LitGloss,
    /// A line looked at.
    Line,
    /// A line that has pixels in the band.
    LineInBand,
    /// Such a line by colour.
    ColouredLineInBand,
    /// A step along such a line, by level.
    LineStep,
    /// The same by colour.
    ColouredLineStep,
    /// A pixel beside such a step, of a wider line.
    WideLinePx,
    /// A mark.
    Mark,
    /// A mark by colour.
    ColouredMark,
    /// A pixel of a mark.
    MarkPx,
    /// A pixel that fog lies over.
    FoggedPx,
    /// The same without a palette.
    DirectFoggedPx,
    /// Pixels of a row that are as foggy.
    FogRun,
    /// A step from one degree of fog to the next.
    FogStep,
    /// A pixel with nothing to fog.
    UnfoggedPx,
    /// A pixel held as its colour.
    DirectPx,
}

/// So much of each term.
#[derive(Clone, Debug, PartialEq)]
pub struct Work(Vec<f64>);

impl Default for Work {
    fn default() -> Self {
        Self(vec![0.0; Term::ALL.len()])
    }
}

impl Work {
    /// How much of a term there is.
    pub fn of(&self, term: Term) -> f64 {
        self.0[term as usize]
    }

    /// Adds to a term.
    pub fn add(&mut self, term: Term, amount: f64) {
        self.0[term as usize] += amount;
    }

    /// All, in the order of [`Term::ALL`].
    pub fn all(&self) -> &[f64] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_are_in_order() {
        let mut work = Work::default();
        for (place, &term) in Term::ALL.iter().enumerate() {
            assert_eq!(term as usize, place);
            work.add(term, place as f64);
        }
        assert_eq!(work.of(Term::Band), 1.0);
    }
}
