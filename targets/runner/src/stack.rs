//! Stack high-water mark: paint the unused stack, run, and look how far down
//! the paint is gone.

use core::ptr;

/// The paint. Not a plausible address, small number or zero.
const PAINT: u32 = 0xA5C3_5AC3;
/// How far below the stack pointer the paint reaches, in bytes. No target has
/// this much stack to spend, and it bounds the time that painting takes.
const DEPTH: usize = 256 * 1024;
/// Left alone below the caller's frame, for the painting function's own.
const MARGIN: usize = 256;

/// A painted piece of stack.
#[derive(Debug)]
pub struct Stack {
    /// Lowest painted address.
    low: usize,
    /// One past the highest painted address.
    painted_to: usize,
    /// Where the stack starts, one past its highest address.
    top: usize,
}

impl Stack {
    /// Paints from `bottom`, or from as far down as the paint reaches, up to
    /// just below the present stack pointer. `top` is where the stack starts.
    ///
    /// # Safety
    /// `bottom..top` is the region that the stack alone uses, the caller runs
    /// on it, and `bottom` is a multiple of 4.
    #[inline(never)]
    pub unsafe fn paint(bottom: usize, top: usize) -> Self {
        let here = 0u32;
        let pointer = ptr::from_ref(core::hint::black_box(&here)) as usize;
        let painted_to = pointer.saturating_sub(MARGIN) & !3;
        let low = bottom.max(painted_to.saturating_sub(DEPTH));
        let mut address = low;
        while address < painted_to {
            // SAFETY: by the caller's promise the address is in the stack's
            // region, aligned, and below every live frame.
            unsafe { ptr::write_volatile(address as *mut u32, PAINT) };
            address += 4;
        }
        Self {
            low,
            painted_to,
            top,
        }
    }

    /// Most bytes of stack in use since the paint, counted from the stack's
    /// start, or `None` if all of the paint is gone: then the true figure is
    /// larger than what was painted, or the stack has overflowed.
    #[inline(never)]
    pub fn used_bytes(&self) -> Option<usize> {
        let mut address = self.low;
        while address < self.painted_to {
            // SAFETY: `paint` wrote this very address.
            if unsafe { ptr::read_volatile(address as *const u32) } != PAINT {
                break;
            }
            address += 4;
        }
        (address > self.low).then(|| self.top.wrapping_sub(address))
    }
}
