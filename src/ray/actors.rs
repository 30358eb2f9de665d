//! The actors of a frame, as rays meet them, made when first asked for.

use super::actor::{GridPlace, RayActor};
use super::camera::RayCamera;
use super::coarse::{Candidates, Unit};
use super::known::Known;
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
}

impl View {
    const NONE: Self = Self {
        viewport: 0,
        bounds: Rect::of_size(0, 0),
        eye: None,
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
    /// Where the first actors are.
    known: &'a mut [Known],
    /// 1 more than the number of the viewport that they are known to be seen in; 0: none.
    looked: u16,
    /// Of their spheres.
    unit: Unit,
}

impl<'a> RayActors<'a> {
    pub(super) fn new(
        scene: &'a Scene<'a>,
        pose: &'a Pose<'a>,
        slots: &'a mut [RaySlot],
        known: &'a mut [Known],
    ) -> Self {
        for slot in &mut *slots {
            slot.actor.number = u16::MAX;
        }
        let mut actors = Self {
            scene,
            pose,
            slots,
            known: &mut [],
            looked: 0,
            unit: Unit::of(0),
        };
        let first = 0..actors.count();
        let mut reach = 0;
        for (number, _) in first.clone().zip(&*known) {
            if let Some(actor) = actors.get(number) {
                let radius = actor.radius.unsigned_abs();
                for c in actor.centre {
                    reach |= c.unsigned_abs().saturating_add(radius);
                }
            }
        }
        let unit = Unit::of(reach);
        actors.unit = unit;
        for (number, known) in first.zip(&mut *known) {
            if let Some(actor) = actors.get(number) {
                known.place(unit, actor.centre, actor.radius);
            }
        }
        actors.known = known;
        actors
    }

    /// Looks from a viewport's camera where the first actors are seen.
    #[inline(never)]
    fn look_at_known(&mut self, viewport: u16, camera: &RayCamera) {
        for number in 0..self.count() {
            let bounds = self.bounds(number, viewport, camera);
            let Some(known) = self.known.get_mut(usize::from(number)) else {
                break;
            };
            known.see(&bounds);
        }
        self.looked = viewport + 1;
    }

    /// Lists the actors that a viewport's camera may see in a tile; says how many that are, of
    /// which the list holds the first.
    pub(super) fn list(
        &mut self,
        listed: &mut [u16],
        (viewport, camera): (u16, &RayCamera),
        tile: &Rect,
    ) -> usize {
        if self.looked != viewport + 1 {
            self.look_at_known(viewport, camera);
        }
        let mut count = 0;
        for number in 0..self.count() {
            let known = self.known.get(usize::from(number));
            if known.is_some_and(|known| known.is_off(tile)) {
                continue;
            }
            let bounds = self.bounds(number, viewport, camera);
            let across = bounds.left < tile.right && bounds.right > tile.left;
            let down = bounds.top < tile.bottom && bounds.bottom > tile.top;
            if across && down {
                if let Some(slot) = listed.get_mut(count) {
                    *slot = number;
                }
                count += 1;
            }
        }
        count
    }

    /// Whether a ray surely passes by an actor of which it is known where it is.
    #[inline(never)]
    pub(super) fn passes_by(&self, number: u16, ray: &Ray) -> bool {
        let known = self.known.get(usize::from(number));
        known.is_some_and(|known| self.unit.passes_by(ray, known.as_ref()))
    }

    /// The actors that a ray may meet that is as thick as `around`, raw world bits.
    #[inline(always)]
    pub(super) fn candidates(&self, ray: &Ray, around: u32) -> Candidates {
        Candidates::of(ray, around, self.unit, self.known, self.count())
    }

    /// All actors.
    pub(super) fn all(&self) -> Candidates {
        Candidates::all(self.count())
    }

    /// The unit of the spheres about actors.
    pub(super) fn unit(&self) -> Unit {
        self.unit
    }

    /// A candidate, if a ray may meet it nearer than `far`.
    #[inline(always)]
    pub(super) fn candidate(
        &mut self,
        (number, untried): (u16, bool),
        ray: &Ray,
        far: u32,
    ) -> Option<&RayActor> {
        if untried && self.passes_by(number, ray) {
            return None;
        }
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
            // Aside by about a half each time, so that actors beside each other in rows seldom
            // have the same slot.
            let (number, slots) = (usize::from(number), self.slots.len());
            let rounds = number.checked_div(slots)?;
            (number + ((slots / 2) | 1) * rounds).checked_rem(slots)?
        };
        let slot = self.slots.get_mut(which)?;
        if slot.actor.number != number {
            fill(self.scene, self.pose, number, slot);
        }
        Some(slot)
    }

    /// An actor as a viewport's camera sees it.
    #[inline(always)]
    fn viewed(&mut self, number: u16, viewport: u16, camera: &RayCamera) -> Option<&RaySlot> {
        let scene = self.scene;
        let slot = self.slot(number)?;
        if slot.view.viewport != viewport + 1 {
            look(scene, slot, viewport, camera);
        }
        Some(slot)
    }

    /// Where a viewport's camera sees an actor.
    pub(super) fn bounds(&mut self, number: u16, viewport: u16, camera: &RayCamera) -> Rect {
        let slot = self.viewed(number, viewport, camera);
        slot.map_or(Rect::of_size(0, 0), |slot| slot.view.bounds)
    }

    /// An actor, and where a perspective's rays start in its grid.
    #[inline(always)]
    pub(super) fn seen(
        &mut self,
        number: u16,
        viewport: u16,
        camera: &RayCamera,
    ) -> Option<(&RayActor, Option<&GridPlace>)> {
        let slot = self.viewed(number, viewport, camera)?;
        Some((&slot.actor, slot.view.eye.as_ref()))
    }

    /// How many there are.
    pub(super) fn count(&self) -> u16 {
        self.scene.actor_count()
    }
}

/// Finds how a viewport's camera sees an actor.
#[inline(never)]
fn look(scene: &Scene<'_>, slot: &mut RaySlot, viewport: u16, camera: &RayCamera) {
    let actor = &slot.actor;
    let bounds = if actor.radius == 0 {
        Rect::of_size(0, 0)
    } else {
        on_screen(scene, actor, camera)
    };
    slot.view = View {
        viewport: viewport + 1,
        bounds,
        eye: camera.eye().and_then(|eye| actor.place(eye)),
    };
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
#[inline(never)]
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
