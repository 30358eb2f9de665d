//! Textures, as a blob has them.

use super::Record;
use super::records::u;

/// What is beyond a picture's edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// The texels at the edge.
    Clamp,
    /// The picture again.
    Repeat,
    /// Its mirror image, then the picture again.
    Mirror,
}

impl Wrap {
    /// All, in the order of their codes.
    pub const ALL: [Self; 3] = [Self::Clamp, Self::Repeat, Self::Mirror];
}

/// A picture of base colours and how it lies on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texture {
    /// `log2` of its width and height in texels, 0..=10.
    pub size: [u8; 2],
    /// How many copies there are, each of half the width and height, the picture
    /// among them: 1..=11. They follow each other.
    pub copies: u8,
    /// Where the picture's texels start in the scene's list.
    pub first: u32,
    /// Beyond its edges.
    pub wrap: Wrap,
    /// Whether four texels are blended.
    pub bilinear: bool,
    /// Whether coordinates are interpolated in space, not along the screen.
    pub perspective: bool,
    /// Whether some texels are [`NO_TEXEL`]: their edges are outlines.
    pub cut_out: bool,
}

/// A texel of which nothing is seen.
pub const NO_TEXEL: u8 = 255;

impl Texture {
    /// `log2` of the size of a copy.
    pub fn copy_size(&self, copy: u32) -> [u32; 2] {
        self.size.map(|s| u32::from(s).saturating_sub(copy))
    }

    /// Texels of all copies.
    pub fn texels(&self) -> u32 {
        let copies = 0..u32::from(self.copies).min(12);
        let texels = copies.map(|copy| {
            let [width, height] = self.copy_size(copy);
            1u32 << width.saturating_add(height).min(24)
        });
        texels.fold(0, u32::saturating_add)
    }
}

impl Record for Texture {
    type Words = [u32; 2];

    fn from_words(&[head, first]: &Self::Words) -> Self {
        let [width, height, copies, flags] = head.to_ne_bytes();
        Self {
            size: [width, height],
            copies,
            first: u(first),
            wrap: Wrap::ALL
                .get(usize::from(flags >> 4))
                .copied()
                .unwrap_or(Wrap::Repeat),
            bilinear: flags & 1 != 0,
            perspective: flags & 2 != 0,
            cut_out: flags & 4 != 0,
        }
    }

    fn to_words(&self) -> Self::Words {
        let [width, height] = self.size;
        let flags = u8::from(self.bilinear)
            | u8::from(self.perspective) << 1
            | u8::from(self.cut_out) << 2
            | (self.wrap as u8) << 4;
        let head = u32::from_ne_bytes([width, height, self.copies, flags]);
        [head, self.first.to_le()]
    }
}
