//! Matrices of the actors of a frame, made when first asked for.

use crate::scene::{Pose, Scene};
use crate::view::{ActorView, ViewFrame};

/// Room for one actor's matrices.
#[derive(Clone, Copy, Debug)]
pub struct ActorSlot {
    /// 1 + the actor's index; 0: none.
    held: u32,
    view: ActorView,
}

impl ActorSlot {
    pub(super) const EMPTY: Self = Self {
        held: 0,
        view: ActorView::ZERO,
    };
}

/// The actors of a frame.
pub(super) struct Actors<'a> {
    scene: &'a Scene<'a>,
    pose: &'a Pose<'a>,
    frame: &'a ViewFrame,
    slots: &'a mut [ActorSlot],
}

impl<'a> Actors<'a> {
    pub(super) fn new(
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        frame: &'a ViewFrame,
        slots: &'a mut [ActorSlot],
    ) -> Self {
        for slot in &mut *slots {
            slot.held = 0;
        }
        Self {
            scene,
            pose,
            frame,
            slots,
        }
    }

    /// The matrices of actor `index`; `None` without a slot.
    pub(super) fn get(&mut self, index: u16) -> Option<&ActorView> {
        let which = usize::from(index).checked_rem(self.slots.len())?;
        let slot = self.slots.get_mut(which)?;
        let number = u32::from(index) + 1;
        if slot.held != number {
            let actor = self.scene.actor(index);
            let placement = self.pose.placement(index, &actor);
            slot.view = ActorView::new(self.frame, self.scene, &actor, &placement);
            slot.held = number;
        }
        Some(&slot.view)
    }
}
