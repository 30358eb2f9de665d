//! Matrices of the actors of a frame, made when first asked for.

use crate::scene::{Pose, Scene};
use crate::view::{ActorView, ViewFrame};

/// Room for one actor's matrices.
#[derive(Clone, Copy, Debug)]
pub struct ActorSlot {
    view: Option<(u16, ActorView)>,
}

impl ActorSlot {
    pub(super) const EMPTY: Self = Self { view: None };
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
        slots.fill(ActorSlot::EMPTY);
        Self {
            scene,
            pose,
            frame,
            slots,
        }
    }

    /// Whether all actors of the scene have a slot of their own.
    pub(super) fn all_fit(&self) -> bool {
        usize::from(self.scene.actor_count()) <= self.slots.len()
    }

    /// The matrices of actor `index`; `None` without a slot.
    pub(super) fn get(&mut self, index: u16) -> Option<&ActorView> {
        let which = usize::from(index).checked_rem(self.slots.len())?;
        let slot = self.slots.get_mut(which)?;
        if !matches!(slot.view, Some((held, _)) if held == index) {
            let actor = self.scene.actor(index);
            let placement = self.pose.placement(index, &actor);
            slot.view = Some((
                index,
                ActorView::new(self.frame, self.scene, &actor, &placement),
            ));
        }
        slot.view.as_ref().map(|(_, view)| view)
    }
}
