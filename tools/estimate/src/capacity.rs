//! What the measured firmware has room for.

use fixel::Renderer;

/// Meshlets that the measured firmware lists.
pub(crate) const MESHLETS: usize = 64;
/// Meshlets that it keeps transformed.
pub(crate) const SLOTS: usize = 10;
/// Actors whose matrices it keeps.
pub(crate) const ACTORS: usize = 4;

/// They are what a [`Renderer`] has if its application says nothing.
const _: fn(Renderer<1, 1>) -> Renderer<1, 1, MESHLETS, SLOTS, ACTORS> = |same| same;
