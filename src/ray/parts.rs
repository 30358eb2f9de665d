//! The parts of a mesh that a tile's rays may meet, where its triangles are too many for a
//! list: the hierarchy is opened from its root, level by level, for as long as there is room.
//! A pixel's ray begins at the parts that it may meet, not at the root (after Reshetov, Soupikov
//! and Hurley, "Multi-level ray tracing algorithm", 2005).

use super::beam::Beam;
use super::candidates::{Candidate, MOST, Seen};
use super::coverage::{self, FINE};
use super::hierarchy::Hierarchy;
use crate::math::{mul_high, reciprocal};
use crate::scene::{Node, Record};

/// What the side of a box may be off in `2^-FINE` pixels.
const OFF: i32 = 4;

/// Parts in a list, with how near each is.
struct Parts<'a> {
    list: &'a mut [Candidate],
    near: [u32; MOST],
    count: usize,
}

impl Parts<'_> {
    /// Puts a part in a place of the list; nothing happens beyond its end.
    fn set(&mut self, at: usize, part: Candidate, near: u32) {
        let slots = self.list.get_mut(at).zip(self.near.get_mut(at));
        if let Some((slot, own)) = slots {
            (*slot, *own) = (part, near);
        }
    }

    /// Adds a part, if there is room.
    fn add(&mut self, part: Candidate, near: u32) {
        self.set(self.count, part, near);
        self.count = (self.count + 1).min(self.list.len());
    }

    /// Takes a part away: the last one takes its place.
    fn remove(&mut self, at: usize) {
        self.count = self.count.saturating_sub(1);
        let last = self.list.get(self.count).zip(self.near.get(self.count));
        if let Some((&part, &near)) = last {
            self.set(at, part, near);
        }
    }

    /// Brings the nearest to the front: of so few, each goes forward as far as it can.
    fn sort(&mut self) {
        for end in 1..self.count {
            let mut at = end;
            while let Some([before, near]) = self.near.get_mut(at.wrapping_sub(1)..=at)
                && *before > *near
                && let Some([first, second]) = self.list.get_mut(at.wrapping_sub(1)..=at)
            {
                core::mem::swap(before, near);
                core::mem::swap(first, second);
                at = at.wrapping_sub(1);
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
        let mut parts = Parts {
            list,
            near: [0; MOST],
            count: 0,
        };
        parts.add(candidate(0, Seen::EVERYWHERE), 0);
        let mut opened = true;
        while opened {
            opened = false;
            let mut at = 0;
            // A level of the hierarchy, or so.
            while at < parts.count {
                let word = parts.list.get(at).map_or(0, |part| part.word);
                if word >> 31 != 0 {
                    at += 1;
                    continue;
                }
                // One goes, up to four come.
                if parts.count + 3 > parts.list.len() {
                    opened = false;
                    break;
                }
                opened = true;
                let mut is_first = true;
                for (word, seen, near) in self.seen_in(tree, word, size) {
                    let part = candidate(word, seen);
                    if is_first {
                        parts.set(at, part, near);
                    } else {
                        parts.add(part, near);
                    }
                    is_first = false;
                }
                if is_first {
                    parts.remove(at);
                } else {
                    at += 1;
                }
            }
        }
        parts.sort();
        parts.count
    }

    /// What a tile's rays may meet in a node: words, where they see it, and how near it is.
    #[inline(always)]
    fn seen_in(
        &self,
        tree: &Hierarchy<'_>,
        number: u32,
        size: [u16; 2],
    ) -> impl Iterator<Item = (u32, Seen, u32)> {
        let words = tree.node_words(number);
        let (met, children) = self.boxes(tree, number).unwrap_or((0, &[0; 4]));
        let met = children
            .iter()
            .enumerate()
            .filter(move |(child, _)| met >> child & 1 != 0);
        met.filter_map(move |(child, word)| {
            let (seen, near) = self.seen(words?, child, size)?;
            Some((u32::from_le(*word), seen, near))
        })
    }

    /// Where a tile's rays see a box of a node, and how near it is; `None` if none does.
    fn seen(
        &self,
        words: &<Node as Record>::Words,
        child: usize,
        size: [u16; 2],
    ) -> Option<(Seen, u32)> {
        let [o0, o1, o2, rest @ ..] = words;
        let origin = [*o0, *o1, *o2].map(|word| u32::from_le(word) as i32);
        let exponent = (origin[0] & 31) + self.from.fraction;
        if exponent < 0 {
            return Some((Seen::EVERYWHERE, 0));
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
            return Some((Seen::EVERYWHERE, 0));
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
        let seen = left | right << 3 | top << 6 | bottom << 9;
        Some((Seen(seen as u16), nearest as u32))
    }
}
