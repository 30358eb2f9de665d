//! The palette.

use super::Rgb;

/// How the palette is made, and how colours find their entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// Most entries, 2..=256. Default 256.
    pub colours: u32,
    /// The entries if they come from a file, 8 bits a channel, 2..=256 of them: used
    /// as they are and in that order. If empty, they are chosen from the colours
    /// that the scene can show.
    pub fixed: Vec<[u8; 3]>,
    /// Entries 0, 1, 2, ..: the steps of these ramps one after the other, before
    /// those that are chosen, so that a program knows where they are (to cycle them,
    /// say). All steps together are at most `colours`.
    pub ramps: Vec<Ramp>,
    /// Of what goes by colour; what goes by light level is never dithered.
    pub dithering: Dithering,
    /// None: a band holds colours of 16 bits, as they are lit. Default: off.
    pub direct: bool,
}

impl Default for Palette {
    fn default() -> Self {
        Self {
            colours: 256,
            fixed: Vec::new(),
            ramps: Vec::new(),
            dithering: Dithering::default(),
            direct: false,
        }
    }
}

/// Palette entries from one colour to another, evenly spaced in Oklab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// The first entry.
    pub from: Rgb,
    /// The last entry.
    pub to: Rgb,
    /// Entries, 2..=256.
    pub steps: u32,
}

/// What is added to a colour before its 4 bits a channel are looked up in the
/// palette: a pattern of thresholds that repeats over the screen (Bayer, 1973).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dithering {
    /// Nothing.
    None,
    /// 4 by 4 pixels (the default).
    #[default]
    Bayer4,
    /// 8 by 8 pixels.
    Bayer8,
}
