//! The viewports of one band, one after the other: each begins with its own
//! background, over whatever earlier ones have drawn there, and ends in its fog.

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
    /// Whether there is fog already over the last one that is begun.
    fogged: bool,
}

impl<'a, P: Paint> Viewports<'a, P> {
    /// Begins a band of a frame that is `height` rows high.
    pub(super) fn new(
        paint: &'a P,
        scene: &'a Scene<'a>,
        target: &mut Target<'_, P::Stored>,
        height: u16,
    ) -> Self {
        if !scene.is_filled(target.width) {
            target.clear(|y| paint.background(scene.background(y, height)));
        }
        Self {
            paint,
            scene,
            next: 0,
            fogged: false,
        }
    }

    /// Goes on to viewport `number`; one past the last ends the band.
    pub(super) fn reach(
        &mut self,
        number: u16,
        actors: &mut Actors<'_>,
        target: &mut Target<'_, P::Stored>,
    ) {
        while self.next <= number {
            if let Some(before) = self.next.checked_sub(1) {
                self.fog(before, actors, target);
            }
            self.fogged = false;
            if self.next < self.scene.viewport_count() {
                self.begin(actors, target);
            }
            self.next += 1;
        }
    }

    /// Fog over a viewport's pixels, once: before the first of its blended surfaces, which
    /// bring their own, or at its end.
    pub(super) fn fog(
        &mut self,
        viewport: u16,
        actors: &mut Actors<'_>,
        target: &mut Target<'_, P::Stored>,
    ) {
        if self.fogged {
            return;
        }
        self.fogged = true;
        if let Some(haze) = actors.haze::<P>(viewport) {
            let rect = actors.viewport(viewport).rect;
            self.paint.fog(&mut target.part(&rect), self.scene, &haze);
        }
    }

    fn begin(&self, actors: &mut Actors<'_>, target: &mut Target<'_, P::Stored>) {
        let viewport = self.next;
        let rect = actors.viewport(viewport).rect;
        let background = self.scene.viewport_background(viewport);
        let mut part = target.part(&rect);
        part.clear(|y| self.paint.background(background.at(y, rect.height())));
    }
}
