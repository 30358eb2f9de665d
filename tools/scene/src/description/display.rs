//! The screen.

use super::Rgb;

/// The screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Display {
    /// Width in pixels, 1..=2048.
    pub width: u32,
    /// Height in pixels, 1..=2048.
    pub height: u32,
    /// What the panel can show.
    pub colour: ColourFormat,
    /// How the levels of a grey panel with few of them are mixed.
    pub dithering: PanelDithering,
    /// What is seen where nothing is drawn.
    pub background: Background,
    /// Samples of a pixel, across and down, whose display-encoded colours are
    /// averaged: 1 or 2 each (the reference takes any number).
    pub samples: [u32; 2],
    /// Pictures for two eyes.
    pub stereo: Stereo,
}

/// Pictures for two eyes. Each eye is moved aside and looks parallel to the camera's
/// line of sight; its picture is sheared so that what is as far away as the focal
/// point is in the same place for both (as VTK does it).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stereo {
    /// One eye (the default).
    None,
    /// The left eye's picture in red, the right one's in green and blue.
    Anaglyph {
        /// Degrees between the two lines from the eyes to the focal point.
        eye_angle: f64,
    },
    /// The left eye's picture in the left half of the display, the right one's in
    /// the right half.
    SideBySide {
        /// As for an anaglyph.
        eye_angle: f64,
    },
}

impl Stereo {
    /// The angle between the eyes in degrees, 0 for one eye.
    pub fn eye_angle(&self) -> f64 {
        match *self {
            Self::None => 0.0,
            Self::Anaglyph { eye_angle } | Self::SideBySide { eye_angle } => eye_angle,
        }
    }

    /// How many eyes.
    pub fn eyes(&self) -> u32 {
        if *self == Self::None { 1 } else { 2 }
    }

    /// How many pictures stand beside each other in the frame and become one.
    pub fn joined(&self) -> u32 {
        if matches!(self, Self::Anaglyph { .. }) {
            2
        } else {
            1
        }
    }
}

/// The panel's colour depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourFormat {
    /// 8 bits a channel.
    Rgb888,
    /// 5, 6, 5 bits.
    Rgb565,
    /// 4 bits a channel.
    Rgb444,
    /// 256 greys.
    Gray8,
    /// 16 greys.
    Gray4,
    /// 4 greys.
    Gray2,
    /// Black and white.
    Mono,
}

impl ColourFormat {
    /// Whether it has so few greys that [`PanelDithering`] is for it.
    pub fn is_dithered(self) -> bool {
        matches!(self, Self::Gray4 | Self::Gray2 | Self::Mono)
    }
}

/// How a panel of 2, 4 or 16 greys shows a grey between two of them: pixels of both, so
/// many that their light together is its light (taken as the square of the
/// display-encoded value). The [`Dithering`](super::Dithering) of the palette is another
/// thing: it is about colours between palette entries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PanelDithering {
    /// The nearest of the two (the default).
    #[default]
    None,
    /// Bayer's pattern of 4 by 4 pixels.
    Bayer4,
    /// Bayer's pattern of 8 by 8 pixels.
    Bayer8,
    /// Void and cluster, 32 by 32 pixels.
    BlueNoise,
    /// Error diffusion by Floyd and Steinberg, every other row from right to left.
    FloydSteinberg,
}

/// The background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// One colour.
    Solid(Rgb),
    /// From the top edge of the picture to its bottom edge. A pixel row `y`
    /// of `height` has the colour at `(y + 0.5) / height` of the way.
    Gradient {
        /// At the top edge.
        top: Rgb,
        /// At the bottom edge.
        bottom: Rgb,
    },
}
