//! Materials, as a blob has them.

use super::Record;
use super::records::u;

/// Where a material is lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Once a face.
    Flat,
    /// At the vertices, interpolated.
    Gouraud,
    /// At each pixel.
    Phong,
}

impl Shading {
    /// All, in the order of their codes.
    pub const ALL: [Self; 3] = [Self::Flat, Self::Gouraud, Self::Phong];
}

/// Which faces are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cull {
    /// Those seen from behind.
    Back,
    /// Those seen from the front.
    Front,
    /// None.
    None,
}

impl Cull {
    /// All, in the order of their codes.
    pub const ALL: [Self; 3] = [Self::Back, Self::Front, Self::None];
}

/// What a level or a colour is made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Channels {
    /// Without any light that has a direction or a place: ambient light and
    /// emission. In 1/64 of a level, at most 255 levels.
    pub constant: [u16; 3],
    /// Diffuse colour times coefficient; the same unit and range.
    pub diffuse: [u16; 3],
    /// Specular colour times coefficient; the same unit and range.
    pub specular: [u16; 3],
}

/// How much of what is behind a surface shows through it, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transparency {
    /// Nothing does.
    Opaque,
    /// Some pixels are the surface's, the others are not drawn.
    ScreenDoor {
        /// Where in the pattern's 64 thresholds those of the surface begin, 0..=63.
        first: u8,
        /// How many of 64 pixels are the surface's, 0..=64.
        pixels: u8,
    },
    /// Colours are mixed. The material goes by colour.
    Blend {
        /// The surface's part in 256, 0..=256.
        opacity: u16,
    },
}

/// A surface's answer to light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Material {
    /// Where it is lit.
    pub shading: Shading,
    /// Which faces are left out.
    pub cull: Cull,
    /// Row of the shade table.
    pub shade: u16,
    /// Level without any light that has a direction: ambient and emission, in
    /// 1/64 of a level, at most 255 levels.
    pub ambient: u16,
    /// Diffuse coefficient in 2^-16, at most 1.
    pub diffuse: u32,
    /// Whether more than levels from grey directional lights is needed: see
    /// `channels`.
    pub full: bool,
    /// Whether it goes by colour, through the look-up of colours, instead of by
    /// level.
    pub coloured: bool,
    /// Its texture, if it has one: then `shade` is its table of texture shades.
    pub texture: Option<u8>,
    /// Sharpness of highlights, 8 fractional bits, 1..=128.
    pub power: u16,
    /// If `full`, what it is made of; of a material that goes by level the first
    /// channel counts.
    pub channels: Channels,
    /// How what is behind it shows through.
    pub transparency: Transparency,
}

/// How colours between palette entries are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dither {
    /// By which pattern.
    pub pattern: DitherPattern,
    /// From the least to the largest threshold, in 1/64 of a level: about the
    /// distance of palette entries.
    pub spread: u16,
}

impl Dither {
    /// Each colour is shown by the nearest entry.
    pub const NONE: Self = Self {
        pattern: DitherPattern::None,
        spread: 0,
    };
}

/// A pattern of thresholds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DitherPattern {
    /// None.
    None,
    /// 4 by 4 pixels.
    Bayer4,
    /// 8 by 8 pixels.
    Bayer8,
}

impl DitherPattern {
    /// All, in the order of their codes.
    pub const ALL: [Self; 3] = [Self::None, Self::Bayer4, Self::Bayer8];
}

impl Material {
    /// Black, lit at the vertices.
    pub const PLAIN: Self = Self {
        shading: Shading::Gouraud,
        cull: Cull::Back,
        shade: 0,
        ambient: 0,
        diffuse: 0,
        full: false,
        coloured: false,
        texture: None,
        power: 1 << 8,
        channels: Channels {
            constant: [0; 3],
            diffuse: [0; 3],
            specular: [0; 3],
        },
        transparency: Transparency::Opaque,
    };

    /// Whether its triangles need more than a flat or a Gouraud fill.
    pub fn is_surface(&self) -> bool {
        self.coloured
            || self.texture.is_some()
            || self.shading == Shading::Phong
            || self.full && self.shading == Shading::Flat
            || self.transparency != Transparency::Opaque
    }

    /// Whether its colours are mixed with what is behind it, so that it is drawn after
    /// all that hides it or that it shows.
    pub fn is_blended(&self) -> bool {
        cfg!(feature = "transparency") && matches!(self.transparency, Transparency::Blend { .. })
    }
}

impl Record for Material {
    type Words = [u32; 9];

    fn from_words(words: &Self::Words) -> Self {
        let [head, ambient, diffuse, rest @ ..] = *words;
        let [shading, cull, low, high] = head.to_ne_bytes();
        let [ambient_low, ambient_high, flags, texture] = ambient.to_ne_bytes();
        let [r, g, b, s, t, through] = rest.map(halves);
        let ([r0, r1], [g0, g1], [b0, b1], [s0, s1], [power, s2]) = (r, g, b, s, t);
        let [through, opacity] = through;
        let [kind, first] = through.to_le_bytes();
        Self {
            shading: pick(&Shading::ALL, shading, Shading::Gouraud),
            cull: pick(&Cull::ALL, cull, Cull::None),
            shade: u16::from_le_bytes([low, high]),
            ambient: u16::from_le_bytes([ambient_low, ambient_high]),
            diffuse: u(diffuse),
            full: flags & 1 != 0,
            coloured: flags & 2 != 0,
            // 1 more than its index, so that 0 is none.
            texture: texture.checked_sub(1),
            power,
            channels: Channels {
                constant: [r0, g0, b0],
                diffuse: [r1, g1, b1],
                specular: [s0, s1, s2],
            },
            transparency: match kind {
                0 => Transparency::Opaque,
                1 => Transparency::ScreenDoor {
                    first,
                    pixels: opacity.min(64) as u8,
                },
                _ => Transparency::Blend { opacity },
            },
        }
    }

    fn to_words(&self) -> Self::Words {
        let [low, high] = self.shade.to_le_bytes();
        let head = [self.shading as u8, self.cull as u8, low, high];
        let [ambient_low, ambient_high] = self.ambient.to_le_bytes();
        let flags = u8::from(self.full) | u8::from(self.coloured) << 1;
        let texture = self.texture.map_or(0, |t| t.saturating_add(1));
        let Channels {
            constant: [r0, g0, b0],
            diffuse: [r1, g1, b1],
            specular: [s0, s1, s2],
        } = self.channels;
        let (kind, first, opacity) = match self.transparency {
            Transparency::Opaque => (0, 0, 0),
            Transparency::ScreenDoor { first, pixels } => (1, first, u16::from(pixels)),
            Transparency::Blend { opacity } => (2, 0, opacity),
        };
        [
            u32::from_ne_bytes(head),
            u32::from_ne_bytes([ambient_low, ambient_high, flags, texture]),
            self.diffuse.to_le(),
            join([r0, r1]),
            join([g0, g1]),
            join([b0, b1]),
            join([s0, s1]),
            join([self.power, s2]),
            join([u16::from_le_bytes([kind, first]), opacity]),
        ]
    }
}

fn pick<T: Copy>(all: &[T], code: u8, other: T) -> T {
    all.get(usize::from(code)).copied().unwrap_or(other)
}

/// The low and the high half of a word.
fn halves(word: u32) -> [u16; 2] {
    [u(word) as u16, (u(word) >> 16) as u16]
}

fn join([low, high]: [u16; 2]) -> u32 {
    (u32::from(low) | u32::from(high) << 16).to_le()
}
