//! What rays may meet, of an actor or of a tile's list.

use super::coverage::{Bits, TILE};

/// Most triangles or parts of a tile: one bit each.
pub(super) const MOST: usize = 32;

/// What a ray may meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    /// Of a mesh, a node's word for it: a triangle, or triangles of a leaf, or a node.
    pub word: u32,
    /// Of a part of a mesh.
    pub seen: Seen,
    pub actor: u16,
}

impl Candidate {
    /// All of an actor.
    pub(super) const fn all_of(actor: u16) -> Self {
        Self {
            word: 0,
            seen: Seen::UNKNOWN,
            actor,
        }
    }
}

/// Where a part is seen in a tile: the first and the last column and row, 3 bits each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen(pub u16);

const _: () = assert!(TILE == 8);

impl Seen {
    /// Not asked for.
    pub(super) const UNKNOWN: Self = Self(0);
    /// Anywhere.
    pub(super) const EVERYWHERE: Self = Self(7 << 3 | 7 << 9);

    /// Sets a bit in a tile's pixels there.
    #[inline(never)]
    pub(super) fn cover(self, bits: &mut Bits, bit: u32) {
        let [left, right, top, bottom] = [0, 3, 6, 9].map(|by| usize::from(self.0 >> by & 7));
        for row in bits.chunks_exact_mut(TILE).take(bottom + 1).skip(top) {
            for pixel in row.iter_mut().take(right + 1).skip(left) {
                *pixel |= bit;
            }
        }
    }
}

/// What one pixel's ray may meet: an iterator over words.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidates<'a> {
    /// `None`: all of an actor.
    pub of: Option<&'a [Candidate; MOST]>,
    pub bits: u32,
    /// Of meshes, single triangles, not parts.
    pub single: bool,
}

impl Candidates<'_> {
    /// All of an actor.
    pub(super) const ALL: Self = Candidates {
        of: None,
        bits: 1,
        single: false,
    };

    /// Whether there is none.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.bits == 0
    }

    /// The next actor and what is of it, which then is not here any more.
    #[inline(always)]
    pub(super) fn next_actor(&mut self) -> Option<(u16, Self)> {
        let list = self.of?;
        let actor = list.get(self.bits.trailing_zeros() as usize)?.actor;
        let all = self.bits;
        self.bits &= self.bits.wrapping_sub(1);
        while let Some(found) = list.get(self.bits.trailing_zeros() as usize)
            && found.actor == actor
        {
            self.bits &= self.bits.wrapping_sub(1);
        }
        let own = Candidates {
            of: self.of,
            bits: all ^ self.bits,
            single: self.single,
        };
        Some((actor, own))
    }
}

impl Iterator for Candidates<'_> {
    type Item = u32;

    #[inline(always)]
    fn next(&mut self) -> Option<u32> {
        let at = self.bits.trailing_zeros() as usize;
        if at >= MOST {
            return None;
        }
        self.bits &= self.bits.wrapping_sub(1);
        match self.of {
            Some(list) => Some(list.get(at)?.word),
            None => Some(0),
        }
    }
}
