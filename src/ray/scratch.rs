//! The ray caster's working memory.

use super::actors::RaySlot;
use super::facet::Facet;
use super::gather::Gathered;
use super::known::{KNOWN_A_SLOT, Known};
use super::light::RayLights;
use super::shades::Shades;
use super::waiting::WaitingRays;
use super::windows::Windows;

/// Working memory of a fixed size; put it into a `static`. `ACTORS` whose places are kept,
/// about 0.2 KB each, at least 1. If a scene has more, they are made again when they are needed:
/// the picture is the same. Of six times as many it is kept for the frame where they are, so that
/// few are needed; with more than that it is slow.
#[derive(Debug)]
pub struct RayScratch<const ACTORS: usize> {
    slots: [RaySlot; ACTORS],
    known: [[Known; KNOWN_A_SLOT]; ACTORS],
    listed: [u16; ACTORS],
    gathered: Gathered,
    windows: Windows,
    shades: Shades,
    facet: Facet,
    lights: RayLights,
    waiting: WaitingRays,
}

impl<const ACTORS: usize> RayScratch<ACTORS> {
    const SOME: () = assert!(ACTORS > 0);

    /// Empty.
    pub const fn new() -> Self {
        let () = Self::SOME;
        Self {
            slots: [RaySlot::EMPTY; ACTORS],
            known: [[Known::EMPTY; KNOWN_A_SLOT]; ACTORS],
            listed: [0; ACTORS],
            gathered: Gathered::EMPTY,
            windows: Windows::EMPTY,
            shades: Shades::NONE,
            facet: Facet::EMPTY,
            lights: RayLights::NONE,
            waiting: WaitingRays::NONE,
        }
    }

    /// The memory without its size, for [`render_frame`](super::render_frame).
    pub fn workspace(&mut self) -> RayWorkspace<'_> {
        RayWorkspace {
            slots: &mut self.slots,
            known: self.known.as_flattened_mut(),
            listed: &mut self.listed,
            gathered: &mut self.gathered,
            windows: &mut self.windows,
            shades: &mut self.shades,
            facet: &mut self.facet,
            lights: &mut self.lights,
            waiting: &mut self.waiting,
        }
    }
}

impl<const ACTORS: usize> Default for RayScratch<ACTORS> {
    fn default() -> Self {
        Self::new()
    }
}

/// A [`RayScratch`] of any size.
#[derive(Debug)]
pub struct RayWorkspace<'a> {
    pub(super) slots: &'a mut [RaySlot],
    /// Where the first actors are.
    pub(super) known: &'a mut [Known],
    /// Actors that a tile's rays may meet.
    pub(super) listed: &'a mut [u16],
    /// Triangles that they may meet.
    pub(super) gathered: &'a mut Gathered,
    /// Triangles that rays to a light may meet.
    pub(super) windows: &'a mut Windows,
    /// Actors that they may meet.
    pub(super) shades: &'a mut Shades,
    /// The triangle that was lit last.
    pub(super) facet: &'a mut Facet,
    pub(super) lights: &'a mut RayLights,
    pub(super) waiting: &'a mut WaitingRays,
}
