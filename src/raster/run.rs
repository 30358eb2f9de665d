//! Pixels of a surface side by side, as a shader gets them.

use super::cubic::Cubic;
use super::footprint::Footprint;
use crate::math::Depth;

/// Attributes that a surface has at most.
pub const MOST_ATTRIBUTES: usize = 11;

/// One number for each attribute; those past the surface's count mean nothing. `A` is
/// [`MOST_ATTRIBUTES`], or fewer for kernels of their own.
pub type Values<const A: usize> = [i32; A];

/// Pixels in a run at most: those from its first to the next one's, and the last one.
pub const LONGEST_RUN: usize = 65;

/// Fractional bits of an attribute in a [`Run`].
pub const RUN_FRACTION: u32 = 14;

/// What is done with runs. Not a closure, because that is not inlined where it is called.
pub trait Shade<const A: usize, C = u8> {
    /// Draws one from its first pixel on; gives how many pixels it drew, at least one. The
    /// others come again.
    fn run(&self, run: Run<'_, A, C>) -> usize;

    /// Whether all pixels that are nearer than what stands there are drawn, whatever their
    /// attributes: their depths are put in place before, along whole spans.
    #[inline(always)]
    fn solid(&self) -> bool {
        false
    }

    /// Whether [`Self::cubic`] is worth asking.
    #[inline(always)]
    fn cubics(&self) -> bool {
        false
    }

    /// What [`Self::cubic`] needs to know of pixels, from the first one's footprint and its change
    /// from pixel to pixel; and of how many of the first ones this is so, at least one.
    #[inline(always)]
    fn alike(&self, _footprint: &Footprint, _step: &Footprint, pixels: usize) -> (usize, usize) {
        (0, pixels)
    }

    /// Draws pixels that go along cubics; `false` if they are to be drawn as runs.
    #[inline(always)]
    fn cubic(&self, _pixels: Cubic<'_, A, C>) -> bool {
        false
    }
}

/// Attributes of pixels side by side.
#[derive(Clone, Copy, Debug)]
pub struct Path<const A: usize> {
    /// Of the first pixel, [`RUN_FRACTION`] fractional bits.
    pub from: Values<A>,
    /// Their change from the first to the second.
    pub step: Values<A>,
    /// How that changes from pixel to pixel.
    pub bend: Values<A>,
}

/// Pixels side by side, with what is drawn there.
#[derive(Debug)]
pub struct Run<'t, const A: usize, C = u8> {
    /// Palette indices, or what else is [`Stored`](crate::frame::Stored).
    pub indices: &'t mut [C],
    /// Depths; as many.
    pub depths: &'t mut [Depth],
    /// Screen column and row of the first pixel.
    pub place: [i32; 2],
    /// Depth of the first pixel, 16.16, and its change a pixel.
    pub depth: (u32, i32),
    /// How many of the first pixels are seen and have their depths in place, if the
    /// shader is solid; of the others nothing is known.
    pub seen: usize,
    /// Attributes.
    pub path: Path<A>,
    /// The first pixel's footprint, where asked for.
    pub footprint: Footprint,
    /// How that changes from pixel to pixel.
    pub footprint_step: Footprint,
}

impl<const A: usize, C: Copy> Run<'_, A, C> {
    /// Leaves out the pixels after the first `count`.
    #[inline(always)]
    pub fn cut(self, count: usize) -> Self {
        let (len, depths) = (self.indices.len(), self.depths.len());
        Run {
            indices: self.indices.get_mut(..count.min(len)).unwrap_or_default(),
            depths: self.depths.get_mut(..count.min(depths)).unwrap_or_default(),
            seen: self.seen.min(count),
            ..self
        }
    }

    /// The same with nothing where pixels are seen, for those who go by depths alone.
    pub fn unplaced(self) -> Self {
        if let Some(seen) = self.depths.get_mut(..self.seen) {
            seen.fill(0);
        }
        Run { seen: 0, ..self }
    }

    /// The same run.
    pub fn again(&mut self) -> Run<'_, A, C> {
        Run {
            indices: self.indices,
            depths: self.depths,
            ..*self
        }
    }

    /// Goes through the pixels that are nearer than what stands there. `shade` gets
    /// the pixel's number in the run, the first `N` attributes and the index there,
    /// and gives the new one; the depth follows if `solid`.
    #[inline(always)]
    pub fn draw<const N: usize>(
        self,
        solid: bool,
        mut shade: impl FnMut(i32, &[i32; N], C) -> Option<C>,
    ) {
        let (mut z, dz) = self.depth;
        let Path { from, step, bend } = self.path;
        let [mut values, mut steps, bends] = [from, step, bend].map(first::<A, N>);
        let pixels = self.indices.iter_mut().zip(self.depths);
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
            for (value, (step, bend)) in values.iter_mut().zip(steps.iter_mut().zip(bends)) {
                *value = value.wrapping_add(*step);
                *step = step.wrapping_add(bend);
            }
        }
    }
}

/// The first of some values.
#[inline(always)]
fn first<const A: usize, const N: usize>(values: Values<A>) -> Values<N> {
    let mut first = [0; N];
    first.iter_mut().zip(values).for_each(|(v, c)| *v = c);
    first
}
