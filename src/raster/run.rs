//! Pixels of a surface side by side, as a shader gets them.

use crate::math::Depth;

/// Attributes that a surface has at most.
pub const MOST_ATTRIBUTES: usize = 11;

/// One number for each attribute; those past the surface's count mean nothing.
pub type Values = [i32; MOST_ATTRIBUTES];

/// Pixels in a run at most: a power of two between its ends, and the last one.
pub const LONGEST_RUN: usize = 17;

/// Fractional bits of an attribute in a [`Run`].
pub const RUN_FRACTION: u32 = 14;

/// Pixels side by side, with what is drawn there.
#[derive(Debug)]
pub struct Run<'t> {
    /// Palette indices.
    pub indices: &'t mut [u8],
    /// Depths; as many.
    pub depths: &'t mut [Depth],
    /// Screen column and row of the first pixel.
    pub place: [i32; 2],
    /// Depth of the first pixel, 16.16, and its change a pixel.
    pub depth: (u32, i32),
    /// Attributes of the first pixel, [`RUN_FRACTION`] fractional bits.
    pub from: Values,
    /// Their change a pixel.
    pub step: Values,
    /// Change of the first two from row to row at the first pixel, where asked for.
    pub down: [i32; 2],
}

impl Run<'_> {
    /// Goes through the pixels that are nearer than what stands there. `shade` gets
    /// the pixel's number in the run, the first `N` attributes and the index there,
    /// and gives the new one; the depth follows if `solid`.
    #[inline(always)]
    pub fn draw<const N: usize>(
        &mut self,
        solid: bool,
        mut shade: impl FnMut(i32, &[i32; N], u8) -> Option<u8>,
    ) {
        let (mut z, dz) = self.depth;
        let (mut values, mut steps) = ([0; N], [0; N]);
        values.iter_mut().zip(self.from).for_each(|(v, c)| *v = c);
        steps.iter_mut().zip(self.step).for_each(|(v, c)| *v = c);
        let pixels = self.indices.iter_mut().zip(self.depths.iter_mut());
        for ((pixel, depth), number) in pixels.zip(0..) {
            let here = (z >> 16) as Depth;
            if here > *depth
                && let Some(index) = shade(number, &values, *pixel)
            {
                *pixel = index;
                if solid {
                    *depth = here;
                }
            }
            z = z.wrapping_add_signed(dz);
            for (value, step) in values.iter_mut().zip(steps) {
                *value = value.wrapping_add(step);
            }
        }
    }
}
