//! Depths of pixels side by side, put in place as long as all are nearer than what stands
//! there: what is most often drawn, with nothing else in the way of the loop.

use crate::math::{Depth, keep_rolled};

/// Whether two depths are compared and stored as a word: where words may lie at any
/// address.
pub(super) const BY_WORDS: bool = !cfg!(narrow_multiply) && !cfg!(target_arch = "riscv32");

/// Puts depths, from `z` on in steps of `dz` (16.16), in place by fours, as long as all four
/// are nearer than what stands there, and the last ones if those are; gives how many.
#[inline(never)]
pub(super) fn put_nearer(depths: &mut [Depth], mut z: u32, dz: i32) -> usize {
    let count = depths.len();
    let (mut fours, rest) = depths.as_chunks_mut::<4>();
    while let Some((four, others)) = fours.split_first_mut() {
        if put_four(four, z, dz).is_none() {
            return count - rest.len() - 4 * (others.len() + 1);
        }
        z = z.wrapping_add_signed(dz << 2);
        fours = others;
        keep_rolled();
    }
    let first = z;
    for depth in &*rest {
        if (z >> 16) as Depth <= *depth {
            return count - rest.len();
        }
        z = z.wrapping_add_signed(dz);
    }
    z = first;
    for depth in rest {
        *depth = (z >> 16) as Depth;
        z = z.wrapping_add_signed(dz);
    }
    count
}

/// The same by fours alone, each pixel with an index.
#[inline(never)]
pub(super) fn put_nearer_of(
    index: u8,
    indices: &mut [u8],
    depths: &mut [Depth],
    mut z: u32,
    dz: i32,
) -> usize {
    let (fours, _) = indices.as_chunks_mut::<4>();
    let (four_depths, _) = depths.as_chunks_mut::<4>();
    let mut drawn = 0;
    for (pixels, depths) in fours.iter_mut().zip(four_depths) {
        if put_four(depths, z, dz).is_none() {
            break;
        }
        *pixels = [index; 4];
        z = z.wrapping_add_signed(dz << 2);
        drawn += 4;
        keep_rolled();
    }
    drawn
}

#[inline(always)]
fn put_four(depths: &mut [Depth; 4], z: u32, dz: i32) -> Option<()> {
    let b = z.wrapping_add_signed(dz);
    let c = b.wrapping_add_signed(dz);
    let d = c.wrapping_add_signed(dz);
    if BY_WORDS {
        put_pairs(depths, [[z, b], [c, d]])
    } else {
        put_each(depths, [z, b, c, d])
    }
}

#[inline(always)]
fn put_pairs(depths: &mut [Depth; 4], [[a, b], [c, d]]: [[u32; 2]; 2]) -> Option<()> {
    let [first, second] = bytemuck::cast::<_, [u32; 2]>(*depths).map(ordered);
    let new = [nearer([a, b], first)?, nearer([c, d], second)?];
    *depths = bytemuck::cast(new.map(ordered));
    Some(())
}

/// Two depths as a word, if both are nearer than those of another.
#[inline(always)]
fn nearer([first, second]: [u32; 2], behind: u32) -> Option<u32> {
    let both = second & 0xffff_0000 | first >> 16;
    // Of the second, whose half is the upper one, whatever is below.
    (both > behind | 0xffff && first >> 16 > behind & 0xffff).then_some(both)
}

/// Two depths in memory as a word, or back: the first is in the lower half.
#[inline(always)]
const fn ordered(depths: u32) -> u32 {
    if cfg!(target_endian = "big") {
        depths.rotate_left(16)
    } else {
        depths
    }
}

#[inline(always)]
fn put_each(depths: &mut [Depth; 4], z: [u32; 4]) -> Option<()> {
    let new = z.map(|z| (z >> 16) as Depth);
    let ([a, b, c, d], [na, nb, nc, nd]) = (*depths, new);
    if na <= a || nb <= b || nc <= c || nd <= d {
        return None;
    }
    *depths = new;
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_four_or_none() {
        for (z, dz) in [
            (0x8_ffffu32, 1 << 16),
            (9 << 16, -0x8000),
            (0xffff << 16, 5),
        ] {
            let z = [0, 1, 2, 3].map(|number: i32| z.wrapping_add_signed(dz * number));
            let [a, b, c, d] = z;
            for depths in
                (0..256).map(|bits| [0, 2, 4, 6].map(|at| [0, 8, 9, 0xffff][bits >> at & 3]))
            {
                let (mut pairs, mut each) = (depths, depths);
                let drawn = put_pairs(&mut pairs, [[a, b], [c, d]]);
                assert_eq!(drawn, put_each(&mut each, z));
                assert_eq!(pairs, each);
                let new = z.map(|z| (z >> 16) as Depth);
                assert_eq!(pairs, if drawn.is_some() { new } else { depths });
            }
        }
    }

    #[test]
    fn as_many_as_are_nearer() {
        for (count, behind) in (0..12).flat_map(|count| (0..=count).map(move |b| (count, b))) {
            let mut depths = [0; 12];
            if let Some(depth) = depths.get_mut(behind..count) {
                depth.fill(50);
            }
            let put = put_nearer(&mut depths[..count], 10 << 16, 1 << 16);
            let wanted = if behind == count {
                count
            } else {
                behind / 4 * 4
            };
            assert_eq!(put, wanted, "{count} {behind}");
            let far = depths.iter().zip(10..).take(put);
            assert!(far.clone().all(|(depth, new)| *depth == new));
        }
    }
}
