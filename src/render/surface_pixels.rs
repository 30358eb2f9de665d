//! Pixels of a surface's triangle one by one: from attributes to indices. Of a textured one the
//! first two attributes are the texture's coordinates.

use super::paint::Paint;
use super::surface_runs::{Others, Runs, Texels, Through, Way};
use crate::frame::Stored;
use crate::light::{Parts, sum};
use crate::math::{Depth, SUBPX_BITS};
use crate::raster::{Change, ShadePixel, Values};
use crate::shade::{Lookup, Pixel, Sampler, SmallPicture, SmallTexture, channel, on_texel};

/// Whether a texture may be had pixel by pixel: not over many columns, and not in a sliver, of
/// less than a 32nd of a pixel, whose depth may leave that of its corners.
#[inline(always)]
fn suits_textures(columns: i32, area: u64) -> bool {
    columns < 32 && area >= 1 << (2 * SUBPX_BITS - 4)
}

impl<P: Paint> Runs<'_, P> {
    /// Sets the attributes of corners of which the first two are texture coordinates, if those
    /// can be had pixel by pixel.
    fn set_textured<const A: usize>(
        &self,
        sampler: &Sampler<'_>,
        corners: &mut [Values<A>; 3],
    ) -> Option<SmallTexture> {
        let (source, triangle) = (self.source, self.triangle);
        source.set(triangle, corners);
        let depths = source
            .in_space(triangle)
            .then(|| triangle.corners.map(|corner| corner.z().to_bits()));
        let places = corners.each_mut().map(|corner| corner.as_mut_slice());
        SmallTexture::new(sampler, places, depths)
    }

    /// By how much light may differ between corners, if that is not what it does on the screen.
    fn contrast<const A: usize>(&self, corners: &[Values<A>; 3]) -> u32 {
        if self.source.in_space(self.triangle) {
            self.surface.contrast(corners)
        } else {
            0
        }
    }
}

impl<'a, P: Paint> ShadePixel<3, u8> for Texels<'a, P> {
    type Corners = SmallTexture;
    type Begun = SmallPicture<'a>;

    #[inline(always)]
    fn set(&self, corners: &mut [Values<3>; 3]) -> Option<SmallTexture> {
        self.runs.set_textured(self.sampler, corners)
    }

    #[inline(always)]
    fn pixel(
        &self,
        picture: &Self::Begun,
        place: [i32; 2],
        depth: u32,
        values: &Values<3>,
        _: u8,
    ) -> Option<u8> {
        let [u, v, level] = *values;
        let at = picture.place(depth, [u, v]);
        let pixel = Pixel {
            lookup: Lookup::Texel(self.shades, picture.nearest(at)?),
            lit: [channel(level); 3],
            place,
            texel: at,
        };
        self.runs.paint.surface(&pixel, self.runs.ids).index()
    }

    fn hides(&self) -> bool {
        true
    }

    #[inline(never)]
    fn contrast(&self, corners: &[Values<3>; 3]) -> u32 {
        self.runs.contrast(corners)
    }

    #[inline(always)]
    fn suits(columns: i32, area: u64) -> bool {
        suits_textures(columns, area)
    }

    #[inline(always)]
    fn begin(
        &self,
        small: &SmallTexture,
        depth: Change,
        [u, v, _]: [Change; 3],
    ) -> Option<Self::Begun> {
        small.begin(self.sampler, depth, [u, v])
    }
}

impl<const A: usize, P: Paint> ShadePixel<A, P::Stored> for Others<'_, P> {
    type Corners = ();
    type Begun = ();

    #[inline(never)]
    fn set(&self, corners: &mut [Values<A>; 3]) -> Option<()> {
        self.runs.source.set(self.runs.triangle, corners);
        Some(())
    }

    fn begin(&self, (): &(), _: Change, _: [Change; A]) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn pixel(
        &self,
        (): &(),
        place: [i32; 2],
        depth: u32,
        values: &Values<A>,
        behind: P::Stored,
    ) -> Option<P::Stored> {
        if !self.shows(place) {
            return None;
        }
        let lookup = match self.way {
            Way::Levels(shades) => Lookup::Levels(shades),
            Way::Colours(colours) => Lookup::Colours(colours),
            // Those have a texture.
            Way::Texels(_) => return None,
        };
        let Parts { body, gloss } = self.runs.surface.light_of_all(values);
        let pixel = Pixel {
            lookup,
            lit: sum(body, gloss),
            place,
            texel: [0; 2],
        };
        Some(self.stored(pixel, depth, behind))
    }

    #[inline(always)]
    fn hides(&self) -> bool {
        !matches!(self.through, Through::Blend(_))
    }

    #[inline(never)]
    fn contrast(&self, corners: &[Values<A>; 3]) -> u32 {
        self.runs.contrast(corners)
    }
}

/// Those of the others that have a texture.
pub(super) struct Textured<'b, 'a, P> {
    pub others: &'b Others<'a, P>,
    pub sampler: &'a Sampler<'a>,
}

impl<'a, const A: usize, P: Paint> ShadePixel<A, P::Stored> for Textured<'_, 'a, P> {
    type Corners = SmallTexture;
    type Begun = SmallPicture<'a>;

    #[inline(always)]
    fn suits(columns: i32, area: u64) -> bool {
        suits_textures(columns, area)
    }

    #[inline(always)]
    fn set(&self, corners: &mut [Values<A>; 3]) -> Option<SmallTexture> {
        self.others.runs.set_textured(self.sampler, corners)
    }

    #[inline(always)]
    fn begin(
        &self,
        small: &SmallTexture,
        depth: Change,
        values: [Change; A],
    ) -> Option<Self::Begun> {
        let places = values.first_chunk()?;
        small.begin(self.sampler, depth, *places)
    }

    #[inline(always)]
    fn pixel(
        &self,
        picture: &Self::Begun,
        place: [i32; 2],
        depth: u32,
        values: &Values<A>,
        behind: P::Stored,
    ) -> Option<P::Stored> {
        let others = self.others;
        if !others.shows(place) {
            return None;
        }
        let texel = picture.place(depth, *values.first_chunk()?);
        let light = || others.runs.surface.light_of_all(values);
        let (lookup, lit) = match others.way {
            Way::Colours(colours) => {
                let colour = picture.colour(self.sampler, texel)?;
                (Lookup::Colours(colours), on_texel(light(), colour))
            }
            Way::Texels(shades) => (Lookup::Texel(shades, picture.nearest(texel)?), light().body),
            // Those have no texture.
            Way::Levels(_) => return None,
        };
        let pixel = Pixel {
            lookup,
            lit,
            place,
            texel,
        };
        Some(others.stored(pixel, depth, behind))
    }

    #[inline(always)]
    fn hides(&self) -> bool {
        !matches!(self.others.through, Through::Blend(_))
    }

    #[inline(never)]
    fn contrast(&self, corners: &[Values<A>; 3]) -> u32 {
        self.others.runs.contrast(corners)
    }
}

impl<P: Paint> Others<'_, P> {
    /// Whether a screen door has a pixel there, if there is one.
    #[inline(always)]
    fn shows(&self, place: [i32; 2]) -> bool {
        match self.through {
            Through::Door(door) => door.shows(place),
            _ => true,
        }
    }

    /// A pixel as it is stored, at a depth of 16.16.
    #[inline(always)]
    fn stored(&self, pixel: Pixel<'_>, depth: u32, behind: P::Stored) -> P::Stored {
        match &self.through {
            Through::Blend(blend) => self.over(blend, pixel, (depth >> 16) as Depth, behind),
            _ => self.runs.paint.surface(&pixel, self.runs.ids),
        }
    }
}
