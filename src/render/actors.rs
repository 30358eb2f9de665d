//! Viewports of a frame and matrices of its actors, made when first asked for.

use super::lines;
use super::paint::Paint;
use crate::fog::{FogDepths, Haze};
use crate::scene::{Fog, PlacedViewport, Pose, Scene};
use crate::view::{ActorView, ViewFrame};

/// Room for one actor's matrices.
#[derive(Clone, Copy, Debug)]
pub struct ActorSlot {
    /// 1 + the actor's index, and the viewport in the upper half; 0: none.
    held: u32,
    view: ActorView,
}

impl ActorSlot {
    pub(super) const EMPTY: Self = Self {
        held: 0,
        view: ActorView::ZERO,
    };
}

/// The actors of a frame, in the viewport that was asked for last.
#[derive(Debug)]
pub(super) struct Actors<'a> {
    scene: &'a Scene<'a>,
    pose: &'a Pose<'a>,
    /// Width and height of the frame.
    size: (u16, u16),
    viewport: PlacedViewport,
    view: ViewFrame,
    /// Set when the viewport's fog is asked for.
    fog: Option<FogDepths>,
    slots: &'a mut [ActorSlot],
}

impl<'a> Actors<'a> {
    #[inline(never)]
    pub(super) fn new(
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        size: (u16, u16),
        slots: &'a mut [ActorSlot],
    ) -> Self {
        for slot in &mut *slots {
            slot.held = 0;
        }
        let viewport = scene.place_viewport(0, pose, size.0, size.1);
        Self {
            scene,
            pose,
            size,
            viewport,
            view: ViewFrame::of(&viewport),
            fog: None,
            slots,
        }
    }

    /// A viewport of the frame.
    pub(super) fn viewport(&mut self, number: u16) -> &PlacedViewport {
        if self.viewport.number != number {
            self.go_to(number);
        }
        &self.viewport
    }

    #[inline(never)]
    fn go_to(&mut self, number: u16) {
        let (width, height) = self.size;
        self.viewport = self.scene.place_viewport(number, self.pose, width, height);
        self.view = ViewFrame::of(&self.viewport);
        self.fog = None;
    }

    /// Which depths of a viewport are how foggy.
    pub(super) fn fog(&mut self, viewport: u16, fog: &Fog) -> &FogDepths {
        self.viewport(viewport);
        let depths = || FogDepths::new(&self.view, &fog.distances);
        self.fog.get_or_insert_with(depths)
    }

    /// A viewport's fog, if `P` shows any.
    pub(super) fn haze<P: Paint>(&mut self, viewport: u16) -> Option<Haze> {
        if !(cfg!(feature = "fog") && P::FOGGED) {
            return None;
        }
        let fog = self.scene.fog()?;
        Some(Haze {
            depths: *self.fog(viewport, &fog),
            colour: fog.colour,
        })
    }

    /// The matrices of actor `index` in a viewport; `None` without a slot.
    pub(super) fn get(&mut self, viewport: u16, index: u16) -> Option<&ActorView> {
        let which = usize::from(viewport) * usize::from(self.scene.actor_count());
        let which = (which + usize::from(index)).checked_rem(self.slots.len())?;
        let number = u32::from(viewport) << 16 | u32::from(index);
        if self.slots.get(which)?.held != number + 1 {
            self.viewport(viewport);
            let slot = self.slots.get_mut(which)?;
            let actor = self.scene.actor(index);
            let look = lines::look(self.scene, index);
            if look.is_some_and(|look| look.on_screen) {
                slot.view.set_on_screen(&self.view, self.scene, &actor);
            } else {
                let place = self.pose.place(self.scene, index, &actor);
                slot.view.set(&self.view, self.scene, &actor, &place);
            }
            slot.held = number + 1;
        }
        Some(&self.slots.get(which)?.view)
    }
}
