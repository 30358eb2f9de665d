//! Colours without a palette: what a pixel is lit by is what the band holds.

use super::bands::Bands;
use super::paint::{Ids, Paint};
use super::scratch::Workspace;
use crate::fog::{self, Haze};
use crate::frame::{Band, Target};
use crate::light::Lit;
use crate::math::Level;
use crate::palette::{light_of_rgb565, rgb565, rgb565_of_light};
use crate::raster::Fill;
use crate::scene::{Dither, Pose, Scene};
use crate::shade::{Blend, Pixel};

/// The scene's colours, each channel rounded to what the panel has: for bands of 16 bits
/// a pixel, 5 of red, 6 of green and 5 of blue, high byte first. All that lights a
/// surface goes by colour, so a frame is dearer than one through a palette; for that,
/// colours are as they are lit, however many there are.
#[derive(Clone, Copy, Debug)]
pub struct Direct<'a> {
    /// Colours of backgrounds, which the blob has as indices.
    palette: &'a [[u8; 3]],
    /// Of red and blue; of green, which has twice as many steps, half as much.
    dither: Dither,
}

impl<'a, 'b> Bands<'a, 'b, Direct<'a>> {
    /// A frame of `pose.height` rows as wide as the band, from its top on, without a
    /// palette; `None` of a scene that is not baked for that (`[palette] direct = true`).
    /// `dither` is how surfaces' colours between the panel's are shown:
    /// [`Scene::dither`] as the scene says, [`Dither::NONE`] by the nearest.
    ///
    /// ```
    /// # use fixel::{Band, Pose, Scene, Scratch, render::Bands};
    /// # fn draw(scene: &Scene<'_>, pose: &Pose<'_>, mut send: impl FnMut(&[u8])) {
    /// let mut scratch = Scratch::<64, 8, 4>::new();
    /// let (mut colours, mut depths) = ([0u16; 320 * 16], [0; 320 * 16]);
    /// let mut band = Band::new(320, &mut colours, &mut depths).unwrap();
    /// let mut work = scratch.workspace();
    /// let bands = Bands::direct(scene, pose, scene.dither(), &mut work, &mut band);
    /// let mut bands = bands.expect("a scene that is baked for it");
    /// while let Some(rows) = bands.next() {
    ///     send(bytemuck::cast_slice(rows.indices));
    /// }
    /// # }
    /// ```
    pub fn direct(
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        dither: Dither,
        work: &'a mut Workspace<'_>,
        band: &'a mut Band<'b, u16>,
    ) -> Option<Self> {
        let (paint, rows) = (Direct::new(scene, dither)?, 0..pose.height);
        Some(Self::with(paint, scene, pose, work, band, rows))
    }
}

impl<'a> Direct<'a> {
    /// Of a scene that is baked for it; `dither` as with [`Bands::direct`].
    pub fn new(scene: &Scene<'a>, dither: Dither) -> Option<Self> {
        let palette = scene.palette();
        scene.is_direct().then_some(Self { palette, dither })
    }
}

fn stored(lit: Lit) -> u16 {
    rgb565_of_light(lit).to_be()
}

impl Direct<'_> {
    /// A surface's light at a place on the screen.
    #[inline(always)]
    fn dithered(&self, lit: Lit, place: [i32; 2]) -> u16 {
        let offset = self.dither.offset(place);
        let mut all = lit;
        for (c, offset) in all.iter_mut().zip([offset, offset >> 1, offset]) {
            *c = (i32::from(*c) + offset).clamp(0, 255 << 6) as u16;
        }
        stored(all)
    }
}

fn light(stored: u16) -> Lit {
    light_of_rgb565(u16::from_be(stored))
}

impl Paint for Direct<'_> {
    type Stored = u16;

    const FOGGED: bool = true;

    /// Not asked for: every material goes by colour.
    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, _: Ids) -> Fill<'a> {
        Fill::Depth
    }

    fn hidden<'a>(&self, _: Ids) -> Fill<'a> {
        Fill::Depth
    }

    fn background(&self, index: u8) -> u16 {
        let colour = self.palette.get(usize::from(index));
        rgb565(colour.copied().unwrap_or_default()).to_be()
    }

    #[inline(always)]
    fn surface(&self, pixel: &Pixel<'_>, _: Ids) -> u16 {
        self.dithered(pixel.lit, pixel.place)
    }

    #[inline(always)]
    fn blend(&self, pixel: &Pixel<'_>, behind: u16, blend: &Blend<'_>) -> u16 {
        self.dithered(blend.over(pixel.lit, light(behind)), pixel.place)
    }

    fn fog(&self, target: &mut Target<'_, u16>, _: &Scene<'_>, haze: &Haze) {
        fog::each(target, |pixel, depth, row| {
            *pixel = stored(haze.over(light(*pixel), depth, row));
        });
    }
}
