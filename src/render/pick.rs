//! What is at a pixel: its row is drawn with the numbers of actors and triangles in
//! place of colours, a byte at a time.

use core::convert::Infallible;

use super::frame::render_rows_with;
use super::paint::{Paint, PaintActor, PaintTriangle};
use super::scratch::Workspace;
use crate::display::Display;
use crate::frame::{Band, BandRows};
use crate::palette::Palette;
use crate::scene::{Pose, Scene};

/// What is at a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picked {
    /// The actor; of one that has several parts, the whole.
    pub actor: u16,
    /// The triangle's place in the scene's list.
    pub triangle: u32,
    /// Its depth there.
    pub depth: u16,
}

/// The actor and the triangle that the pixel in column `x` and row `y` shows; `None`
/// where nothing but the background is. Blended surfaces hide nothing and are not
/// picked. Draws one row six times; `band` is as wide as
/// the frame, and a single row will do.
pub fn pick(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut Workspace<'_>,
    band: &mut Band<'_>,
    x: u16,
    y: u16,
) -> Option<Picked> {
    let mut at = At {
        scene,
        pose,
        work,
        band,
        x,
        y,
    };
    let mut actor = [0; 2];
    for (byte, value) in (0..).zip(&mut actor) {
        (*value, _) = at.draw(&PaintActor { byte })?;
    }
    let (mut triangle, mut depth) = ([0; 4], 0);
    for (byte, value) in (0..).zip(&mut triangle) {
        (*value, depth) = at.draw(&PaintTriangle { byte })?;
    }
    Some(Picked {
        actor: scene.whole(u16::from_le_bytes(actor)),
        triangle: u32::from_le_bytes(triangle),
        depth,
    })
}

/// Where to look.
struct At<'a, 's, 'p, 'w, 'b> {
    scene: &'a Scene<'s>,
    pose: &'a Pose<'p>,
    work: &'a mut Workspace<'w>,
    band: &'a mut Band<'b>,
    x: u16,
    y: u16,
}

impl At<'_, '_, '_, '_, '_> {
    /// Index and depth of the pixel, if something is there.
    fn draw<P: Paint<Stored = u8>>(&mut self, paint: &P) -> Option<(u8, u16)> {
        let mut pixel = Pixel {
            x: self.x.into(),
            shown: None,
        };
        let rows = self.y..self.y.saturating_add(1);
        let (scene, pose) = (self.scene, self.pose);
        let Ok(_) = render_rows_with(paint, scene, pose, self.work, self.band, rows, &mut pixel);
        pixel.shown.filter(|(_, depth)| *depth != 0)
    }
}

/// Keeps one pixel of one row.
struct Pixel {
    x: usize,
    shown: Option<(u8, u16)>,
}

impl Display for Pixel {
    type Error = Infallible;

    fn begin(&mut self, _: &Palette<'_>) -> Result<(), Infallible> {
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        let (index, depth) = (rows.indices.get(self.x), rows.depths.get(self.x));
        self.shown = index.copied().zip(depth.copied());
        Ok(())
    }
}
