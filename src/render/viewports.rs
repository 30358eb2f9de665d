//! The viewports of one band, one after the other: each begins with its own
//! background, over whatever earlier ones have drawn there.

use super::actors::Actors;
use super::paint::Paint;
use crate::frame::Target;
use crate::scene::Scene;

/// How far a band has come.
pub(super) struct Viewports<'a, P> {
    paint: &'a P,
    scene: &'a Scene<'a>,
    /// The first one that is not begun.
    next: u16,
}

impl<'a, P: Paint> Viewports<'a, P> {
    /// Begins a band of a frame that is `height` rows high.
    pub(super) fn new(
        paint: &'a P,
        scene: &'a Scene<'a>,
        target: &mut Target<'_>,
        height: u16,
    ) -> Self {
        if !scene.is_filled() {
            target.clear(|y| paint.background(scene.background(y, height)));
        }
        Self {
            paint,
            scene,
            next: 0,
        }
    }

    /// Goes on to viewport `number`; one past the last ends the band.
    pub(super) fn reach(&mut self, number: u16, actors: &mut Actors<'_>, target: &mut Target<'_>) {
        while self.next <= number {
            if self.next < self.scene.viewport_count() {
                self.begin(actors, target);
            }
            self.next += 1;
        }
    }

    fn begin(&self, actors: &mut Actors<'_>, target: &mut Target<'_>) {
        let viewport = self.next;
        let rect = actors.viewport(viewport).rect;
        let background = self.scene.viewport_background(viewport);
        let mut part = target.part(&rect);
        part.clear(|y| self.paint.background(background.at(y, rect.height())));
    }
}
