//! All that a frame needs but the scene and the display.

use super::bands::Bands;
use super::frame::{palette, render_frame};
use super::scratch::{Scratch, Workspace};
use super::stats::FrameStats;
use crate::display::{Display, Ink, Overlay};
use crate::frame::Band;
use crate::math::Depth;
use crate::scene::{Pose, Scene};

/// Draws frames of `WIDTH` columns in bands of `ROWS` rows, whatever the screen's height:
/// owns the band (3 bytes a pixel) and the working memory ([`Scratch`], whose sizes
/// `MESHLETS`, `SLOTS` and `ACTORS` are; the defaults are 13 KB). Put it into a `static`:
/// all zero, it takes no flash.
///
/// ```
/// # use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, pixelcolor::Rgb565};
/// # use fixel::{DrawTargetDisplay, Renderer, Scene};
/// # fn show<D: DrawTarget<Color = Rgb565>>(scene: &Scene<'_>, lcd: D) -> Result<(), D::Error> {
/// let mut renderer = Renderer::<240, 16>::new();
/// let mut panel = DrawTargetDisplay::new(lcd, Point::zero());
/// for frame in 0..100 {
///     renderer.draw(scene, &scene.pose(frame), &mut panel)?;
/// }
/// # Ok(())
/// # }
/// ```
///
/// What it does is [`render_frame`] and, under [`draw_over`](Self::draw_over), [`Bands`], both
/// open to those who keep their memory elsewhere.
#[derive(Debug)]
pub struct Renderer<
    const WIDTH: usize,
    const ROWS: usize,
    const MESHLETS: usize = 64,
    const SLOTS: usize = 10,
    const ACTORS: usize = 4,
> {
    indices: [[u8; WIDTH]; ROWS],
    depths: [[Depth; WIDTH]; ROWS],
    scratch: Scratch<MESHLETS, SLOTS, ACTORS>,
}

impl<
    const WIDTH: usize,
    const ROWS: usize,
    const MESHLETS: usize,
    const SLOTS: usize,
    const ACTORS: usize,
> Renderer<WIDTH, ROWS, MESHLETS, SLOTS, ACTORS>
{
    /// Ready for the first frame.
    pub const fn new() -> Self {
        Self {
            indices: [[0; WIDTH]; ROWS],
            depths: [[0; WIDTH]; ROWS],
            scratch: Scratch::new(),
        }
    }

    /// Draws a frame of `pose.height` rows; see [`render_frame`].
    ///
    /// # Errors
    /// Those of the display; drawing itself cannot fail.
    pub fn draw<D: Display>(
        &mut self,
        scene: &Scene<'_>,
        pose: &Pose<'_>,
        display: &mut D,
    ) -> Result<FrameStats, D::Error> {
        let (mut work, mut band) = self.parts();
        render_frame(scene, pose, &mut work, &mut band, display)
    }

    /// Draws a frame and over it, in two dimensions, what `over` does with `embedded-graphics`.
    /// It is called for each band and draws all each time: what lies in the band appears.
    /// Colours become the nearest ones of the palette.
    ///
    /// # Errors
    /// Those of the display; drawing itself cannot fail.
    pub fn draw_over<C: Ink, D: Display>(
        &mut self,
        scene: &Scene<'_>,
        pose: &Pose<'_>,
        display: &mut D,
        mut over: impl FnMut(&mut Overlay<'_, '_, C>),
    ) -> Result<FrameStats, D::Error> {
        let palette = palette(scene, pose);
        let (mut work, mut band) = self.parts();
        let mut bands = Bands::new(scene, pose, &mut work, &mut band);
        display.begin(&palette)?;
        while let Some(mut rows) = bands.next_target() {
            over(&mut Overlay::new(&mut rows, palette));
            display.show(rows.into_finished())?;
        }
        Ok(bands.stats())
    }

    /// The working memory and the band, for [`Bands`] and the other functions that take them.
    pub fn parts(&mut self) -> (Workspace<'_>, Band<'_>) {
        let band = Band::of_rows(&mut self.indices, &mut self.depths);
        (self.scratch.workspace(), band)
    }
}

impl<
    const WIDTH: usize,
    const ROWS: usize,
    const MESHLETS: usize,
    const SLOTS: usize,
    const ACTORS: usize,
> Default for Renderer<WIDTH, ROWS, MESHLETS, SLOTS, ACTORS>
{
    fn default() -> Self {
        Self::new()
    }
}
