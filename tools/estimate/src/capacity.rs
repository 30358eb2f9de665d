//! How many of what a renderer keeps: the application's choice, of which some are reckoned
//! with here.

use fixel::Renderer;
use fixel::render::Scratch;

use crate::parts::Parts;

/// Bytes of a slot that only linked light needs.
const LIGHT_A_SLOT: u64 = 296;

/// Lengths of a renderer's lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lists {
    /// What a [`Renderer`] has if its application says nothing, and the measured firmware.
    Usual,
    /// For some 32 KB of RAM.
    Short,
    /// For some 16 KB.
    Shortest,
}

impl Lists {
    /// All of them, the longest first.
    pub const ALL: [Self; 3] = [Self::Usual, Self::Short, Self::Shortest];

    /// Meshlets listed at once, meshlets kept transformed, actors whose matrices are kept.
    pub const fn lengths(self) -> [usize; 3] {
        match self {
            Self::Usual => [64, 10, 4],
            Self::Short => [32, 4, 2],
            Self::Shortest => [32, 2, 1],
        }
    }

    /// Bytes of RAM, where so much is linked.
    pub fn bytes(self, parts: Parts) -> u64 {
        let with_light = match self {
            Self::Usual => size_of::<Scratch<64, 10, 4>>(),
            Self::Short => size_of::<Scratch<32, 4, 2>>(),
            Self::Shortest => size_of::<Scratch<32, 2, 1>>(),
        } as u64;
        let [_, slots, _] = self.lengths();
        match parts {
            Parts::Triangles => with_light,
            Parts::Flat | Parts::Gouraud => with_light - LIGHT_A_SLOT * slots as u64,
        }
    }
}

const _: fn(Renderer<1, 1>) -> Renderer<1, 1, 64, 10, 4> = |same| same;

#[cfg(test)]
mod tests {
    use super::*;

    /// As docs/choosing-numbers.md has it.
    #[test]
    fn bytes() {
        assert_eq!(Lists::Usual.bytes(Parts::Triangles), 13_584);
        assert_eq!(Lists::Usual.bytes(Parts::Flat), 10_624);
        assert_eq!(Lists::Shortest.bytes(Parts::Gouraud), 2_448);
        for lists in Lists::ALL {
            let [meshlets, slots, actors] = lists.lengths();
            let bytes = 12 * meshlets + 1096 * slots + 464 * actors;
            assert_eq!(lists.bytes(Parts::Triangles), bytes as u64, "{lists:?}");
        }
    }
}
