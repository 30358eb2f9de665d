//! How a material gets from light to a colour.

/// A material's way from light to a palette index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Path {
    /// By its light level, as [`crate::Hit::level`] defines it: the palette index
    /// of each.
    Level(Box<[u8; 256]>),
    /// By its colour, through [`Lookup::colours`](crate::Lookup::colours).
    Colour,
    /// By light level and texel: a texel's colour becomes the nearest base colour in
    /// Oklab.
    Textured {
        /// Base colours, at least one.
        bases: Vec<[u8; 3]>,
        /// The palette index of each base colour in each range of levels: `R` rows of
        /// a base each, `R` a power of two up to 256; level `l` is in row
        /// `l * R / 256`, rounded down.
        shade: Vec<u8>,
    },
    /// By its colour, through [`Lookup::colours`](crate::Lookup::colours), of a texture whose texels are base
    /// colours: each becomes the nearest in Oklab before it is blended and lit.
    TexturedColour {
        /// Base colours, at least one.
        bases: Vec<[u8; 3]>,
    },
}

impl Path {
    /// The table of shades, its length and what that should be.
    pub(crate) fn shade_lengths(&self) -> Option<(&'static str, usize, usize)> {
        let Self::Textured { bases, shade } = self else {
            return None;
        };
        let columns = bases.len().max(1);
        let rows = shade.len().div_ceil(columns).next_power_of_two();
        Some(("shade", shade.len(), rows.min(256) * columns))
    }
}
