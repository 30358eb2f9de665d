//! The parts of a mesh that a tile's rays may meet, where its triangles are too many for a
//! list: the hierarchy is opened from its root, level by level, for as long as there is room.
//! A pixel's ray begins at the parts that it may meet, not at the root (after Reshetov, Soupikov
//! and Hurley, "Multi-level ray tracing algorithm", 2005).

use super::beam::Beam;
use super::coverage::{self, Bits, FINE, TILE};
use super::gather::Candidate;
use super::hierarchy::Hierarchy;
use crate::math::{mul_high, reciprocal};
use crate::scene::{Node, Record};

/// What the side of a box may be off in `2^-FINE` pixels.
const OFF: i32 = 4;

/// Where a part is seen in a tile, by which parts are ordered: how near it is, and below the first
/// and the last column and row, 3 bits each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Seen(u32);

const _: () = assert!(TILE == 8);

impl Seen {
    /// Anywhere.
    pub(super) const EVERYWHERE: Self = Self(7 << 3 | 7 << 9);

    /// Sets a bit in a tile's pixels there.
    #[inline(never)]
    pub(super) fn cover(self, bits: &mut Bits, bit: u32) {
        let [left, right, top, bottom] = [0, 3, 6, 9].map(|by| (self.0 >> by & 7) as usize);
        for row in bits.chunks_exact_mut(TILE).take(bottom + 1).skip(top) {
            for pixel in row.iter_mut().take(right + 1).skip(left) {
                *pixel |= bit;
            }
        }
    }
}

impl Beam {
    /// Lists parts of a mesh's hierarchy that hold all that a tile's rays may meet of it, the
    /// nearest first, and says how many; there is room for at least one.
    #[inline(never)]
    pub(super) fn parts(
        &self,
        tree: &Hierarchy<'_>,
        actor: u16,
        size: [u16; 2],
        list: &mut [Candidate],
    ) -> usize {
        let candidate = |word, seen| Candidate { word, seen, actor };
        let mut count = 0;
        add(list, &mut count, candidate(0, Seen::EVERYWHERE));
        let mut opened = true;
        while opened {
            opened = false;
            let mut at = 0;
            // A level of the hierarchy, or so.
            while let Some(part) = list.get(at).copied().filter(|_| at < count) {
                at += 1;
                if part.word >> 31 != 0 {
                    continue;
                }
                // One goes, up to four come.
                if count + 3 > list.len() {
                    opened = false;
                    break;
                }
                opened = true;
                let Some(words) = tree.node_words(part.word) else {
                    continue;
                };
                let (met, children) = self.boxes(tree, part.word).unwrap_or((0, &[0; 4]));
                let mut first = true;
                for (child, word) in children.iter().enumerate() {
                    if met >> child & 1 == 0 {
                        continue;
                    }
                    let Some(seen) = self.seen(words, child, size) else {
                        continue;
                    };
                    let found = candidate(u32::from_le(*word), seen);
                    if first && let Some(slot) = list.get_mut(at - 1) {
                        *slot = found;
                        first = false;
                    } else {
                        add(list, &mut count, found);
                    }
                }
                if first {
                    // There is nothing in it: the last one takes its place.
                    count -= 1;
                    at -= 1;
                    let last = list.get(count).copied();
                    if let (Some(slot), Some(last)) = (list.get_mut(at), last) {
                        *slot = last;
                    }
                }
            }
        }
        sort(list.get_mut(..count).unwrap_or_default());
        count
    }

    /// Where a tile's rays see a box of a node; `None` if none does.
    fn seen(&self, words: &<Node as Record>::Words, child: usize, size: [u16; 2]) -> Option<Seen> {
        let [o0, o1, o2, rest @ ..] = words;
        let origin = [*o0, *o1, *o2].map(|word| u32::from_le(word) as i32);
        let exponent = (origin[0] & 31) + self.from.fraction;
        if exponent < 0 {
            return Some(Seen::EVERYWHERE);
        }
        let off = self.from.off(origin.map(|c| c >> 5));
        let sides: &[[u8; 4]; 6] = bytemuck::cast_ref(rest.first_chunk::<6>()?);
        let mut boxes = [[0; 2]; 3];
        let pairs = sides.chunks_exact(2);
        for ((out, off), pair) in boxes.iter_mut().zip(off).zip(pairs) {
            for (out, side) in out.iter_mut().zip(pair) {
                let steps = i32::from(side.get(child).copied().unwrap_or(0));
                *out = off.wrapping_add(steps.wrapping_shl(exponent as u32));
            }
        }
        // The least and the most of a row's product with what is in the box.
        let ends = |row: [i32; 3]| {
            let (mut least, mut most) = (0i32, 0i32);
            for (c, [low, high]) in row.into_iter().zip(boxes) {
                let (low, high) = (mul_high(c, low), mul_high(c, high));
                least = least.wrapping_add(low.min(high));
                most = most.wrapping_add(low.max(high));
            }
            [least, most]
        };
        let screen = &self.screen;
        let [nearest, farthest] = ends(screen.z);
        let ahead = |z: i32| z >> (screen.up.max(0) + 8) > 0;
        if !ahead(nearest) {
            // Too near to tell.
            return Some(Seen::EVERYWHERE);
        }
        let recips = [nearest, farthest].map(|z| reciprocal(z as u32));
        // As corners of triangles are brought to the screen.
        let place = |c: i32, outward: bool| {
            let [near, far] = recips;
            let recip = if (c >= 0) == outward { near } else { far };
            let down = 30 - recip.shift as i32 - screen.up - FINE;
            mul_high(c, recip.mantissa) >> down.clamp(0, 31)
        };
        let span = |row: [i32; 3], size: u16| {
            let [least, most] = ends(row);
            let (low, high) = (place(least, false), place(most, true));
            coverage::pixels(
                low.saturating_sub(OFF),
                high.saturating_add(OFF),
                size.into(),
            )
        };
        let [width, height] = size;
        let [left, right] = span(screen.x, width)?;
        let [top, bottom] = span(screen.y, height)?;
        let near = (nearest as u32) >> 11 << 12;
        Some(Seen(near | left | right << 3 | top << 6 | bottom << 9))
    }
}

/// Brings the nearest to the front.
fn sort(list: &mut [Candidate]) {
    for end in 1..list.len() {
        let mut at = end;
        while let Some([before, here]) = list.get_mut(at.wrapping_sub(1)..=at)
            && before.seen > here.seen
        {
            core::mem::swap(before, here);
            at -= 1;
        }
    }
}

/// Adds to a list that has room.
fn add(list: &mut [Candidate], count: &mut usize, part: Candidate) {
    if let Some(slot) = list.get_mut(*count) {
        *slot = part;
        *count += 1;
    }
}
