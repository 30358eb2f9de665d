//! The actors of a frame, as rays meet them, made when first asked for.

use super::actor::{GridPlace, RayActor};
use super::camera::RayCamera;
use super::coarse::{Candidates, Sphere, Unit};
use super::ray::Ray;
use crate::math::Rect;
use crate::scene::{Pose, Scene};

/// Room for one actor.
#[derive(Clone, Copy, Debug)]
pub struct RaySlot {
    actor: RayActor,
    view: View,
}

/// An actor as a viewport's camera has it.
#[derive(Clone, Copy, Debug)]
struct View {
    /// 1 more than the viewport's number; 0: none.
    viewport: u16,
    /// Where it is seen.
    bounds: Rect,
    /// The eye in its grid.
    eye: Option<GridPlace>,
    /// All of it is beyond the near plane.
    beyond_near: bool,
}

impl View {
    const NONE: Self = Self {
        viewport: 0,
        bounds: Rect::of_size(0, 0),
        eye: None,
        beyond_near: false,
    };
}

impl RaySlot {
    pub(super) const EMPTY: Self = Self {
        actor: RayActor::EMPTY,
        view: View::NONE,
    };
}

/// The actors of a frame.
pub(super) struct RayActors<'a> {
    scene: &'a Scene<'a>,
    pose: &'a Pose<'a>,
    slots: &'a mut [RaySlot],
    /// About the first actors.
    spheres: &'a mut [Sphere],
    unit: Unit,
}

impl<'a> RayActors<'a> {
    pub(super) fn new(
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        slots: &'a mut [RaySlot],
        spheres: &'a mut [Sphere],
    ) -> Self {
        for slot in &mut *slots {
            slot.actor.number = u16::MAX;
        }
        let mut actors = Self {
            scene,
            pose,
            slots,
            spheres: &mut [],
            unit: Unit::of(0),
        };
        let first = 0..actors.count();
        let mut reach = 0;
        for (number, _) in first.clone().zip(&*spheres) {
            if let Some(actor) = actors.get(number) {
                let radius = actor.radius.unsigned_abs();
                for c in actor.centre {
                    reach |= c.unsigned_abs().saturating_add(radius);
                }
            }
        }
        let unit = Unit::of(reach);
        actors.unit = unit;
        for (number, sphere) in first.zip(&mut *spheres) {
            if let Some(actor) = actors.get(number) {
                *sphere = unit.sphere(actor.centre, actor.radius);
            }
        }
        actors.spheres = spheres;
        actors
    }

    /// The actors that a ray may meet.
    #[inline(always)]
    pub(super) fn candidates(&self, ray: &Ray) -> Candidates {
        Candidates::of(ray, self.unit, self.spheres, self.count())
    }

    /// A candidate, if a ray may meet it nearer than `far`.
    #[inline(always)]
    pub(super) fn candidate(
        &mut self,
        (number, untried): (u16, bool),
        ray: &Ray,
        far: u32,
    ) -> Option<&RayActor> {
        let actor = self.get(number)?;
        let missed = untried && (actor.radius == 0 || actor.missed(ray, far));
        (!missed).then_some(actor)
    }

    /// An actor by its number; `None` without any slot.
    #[inline(always)]
    pub(super) fn get(&mut self, number: u16) -> Option<&RayActor> {
        self.slot(number).map(|slot| &slot.actor)
    }

    #[inline(always)]
    fn slot(&mut self, number: u16) -> Option<&mut RaySlot> {
        let which = if usize::from(number) < self.slots.len() {
            usize::from(number)
        } else {
            usize::from(number).checked_rem(self.slots.len())?
        };
        let slot = self.slots.get_mut(which)?;
        if slot.actor.number != number {
            fill(self.scene, self.pose, number, slot);
        }
        Some(slot)
    }

    /// Where a viewport's camera sees an actor.
    pub(super) fn bounds(&mut self, number: u16, viewport: u16, camera: &RayCamera) -> Rect {
        let scene = self.scene;
        let Some(slot) = self.slot(number) else {
            return Rect::of_size(0, 0);
        };
        if slot.view.viewport != viewport + 1 {
            let actor = &slot.actor;
            let seen = actor.radius != 0;
            slot.view = View {
                viewport: viewport + 1,
                bounds: if seen {
                    on_screen(scene, actor, camera)
                } else {
                    Rect::of_size(0, 0)
                },
                eye: camera.eye().and_then(|eye| actor.place(eye)),
                beyond_near: camera.eye().is_some()
                    && camera.is_beyond_near(actor.centre, actor.radius),
            };
        }
        slot.view.bounds
    }

    /// An actor, and where a camera's ray that starts at `origin` starts in its grid:
    /// of a perspective, as kept since [`RayActors::bounds`]; and whether all of it is beyond
    /// the near plane.
    #[inline(always)]
    pub(super) fn seen(
        &mut self,
        number: u16,
        viewport: u16,
        camera: &RayCamera,
        origin: [i32; 3],
    ) -> Option<(&RayActor, Option<GridPlace>, bool)> {
        self.bounds(number, viewport, camera);
        let slot = self.slot(number)?;
        let from = match camera.eye() {
            Some(_) => slot.view.eye,
            None => slot.actor.place(origin),
        };
        Some((&slot.actor, from, slot.view.beyond_near))
    }

    /// How many there are.
    pub(super) fn count(&self) -> u16 {
        self.scene.actor_count()
    }
}

#[inline(never)]
fn fill(scene: &Scene<'_>, pose: &Pose<'_>, number: u16, out: &mut RaySlot) {
    let actor = scene.actor(number);
    let place = pose.place(scene, number, &actor);
    out.actor = RayActor::new(scene, number, &actor, &place);
    out.view.viewport = 0;
    // Lines, marks and what lies on the screen are no surfaces.
    if scene.look(number).is_some() {
        out.actor.radius = 0;
    }
}

/// Where a camera sees an actor: what holds its sphere and its box.
fn on_screen(scene: &Scene<'_>, actor: &RayActor, camera: &RayCamera) -> Rect {
    let round = camera.bounds(actor.centre, actor.radius);
    let Some(corners) = actor.corners(scene) else {
        return round;
    };
    // What corners are off by: a step, and the roundings of a turn.
    let slack = actor.roughness().min(1 << 20) as i32 + 64;
    let mut whole: Option<Rect> = None;
    for corner in corners {
        let Some(own) = camera.bounds_ahead(corner, slack) else {
            return round;
        };
        let so_far = whole.unwrap_or(own);
        whole = Some(Rect {
            left: so_far.left.min(own.left),
            top: so_far.top.min(own.top),
            right: so_far.right.max(own.right),
            bottom: so_far.bottom.max(own.bottom),
        });
    }
    let whole = whole.unwrap_or(round);
    Rect {
        left: whole.left.max(round.left),
        top: whole.top.max(round.top),
        right: whole.right.min(round.right),
        bottom: whole.bottom.min(round.bottom),
    }
}
