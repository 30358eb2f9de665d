//! The RAM of a demo.

use fixel::Scratch;

/// All the RAM that drawing needs, whatever the mesh and the panel's height: put it into a
/// `static`. A band has `PIXELS` pixels, at least one row of the panel; `MESHLETS`, `SLOTS`
/// and `ACTORS` are those of [`Scratch`]. All zero, so that it takes no flash.
#[derive(Debug)]
pub struct Memory<
    const PIXELS: usize,
    const MESHLETS: usize = 64,
    const SLOTS: usize = 10,
    const ACTORS: usize = 4,
> {
    pub(crate) index: [u8; PIXELS],
    pub(crate) depth: [u16; PIXELS],
    pub(crate) scratch: Scratch<MESHLETS, SLOTS, ACTORS>,
}

impl<const PIXELS: usize, const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize>
    Memory<PIXELS, MESHLETS, SLOTS, ACTORS>
{
    /// Ready for the first frame.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self {
            index: [0; PIXELS],
            depth: [0; PIXELS],
            scratch: Scratch::new(),
        }
    }
}
