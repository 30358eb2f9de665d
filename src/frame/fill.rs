//! Filling memory.

use bytemuck::{AnyBitPattern, NoUninit};

/// Words of a block.
const BLOCK: usize = 8;

/// Fills a slice by blocks of words. The compiler's own `memset` takes three
/// instructions a word on a Cortex-M, this less than one.
#[inline(never)]
pub(crate) fn fill<T: Copy + NoUninit + AnyBitPattern>(slice: &mut [T], value: T, word: u32) {
    let (before, blocks, after) = bytemuck::pod_align_to_mut::<T, [u32; BLOCK]>(slice);
    before.fill(value);
    // Not known to the compiler, which would call `memset` if it were.
    let block = [core::hint::black_box(word); BLOCK];
    for words in blocks {
        *words = block;
    }
    after.fill(value);
}
