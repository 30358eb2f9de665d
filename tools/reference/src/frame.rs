//! A picture from the renderer under test, as plain arrays.

use crate::truth::Truth;
use std::fmt;

/// [`Frame::triangle`] where nothing is seen.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// What the renderer under test drew. Pixels go by rows from the top left;
/// each array has `width * height` elements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The depth buffer; 0 where nothing is seen.
    pub depth: Vec<u16>,
    /// 0 where nothing is seen, otherwise 1 + the actor's index in the scene.
    pub actor: Vec<u16>,
    /// Index of the triangle in the actor's mesh ([`fixel_scene::Mesh`], not
    /// the baked order); [`NO_TRIANGLE`] where nothing is seen.
    pub triangle: Vec<u32>,
    /// Light level, 0..=255; any where nothing is seen.
    pub level: Vec<u8>,
    /// Palette index.
    pub index: Vec<u8>,
    /// The colour shown, 8 bits a channel.
    pub rgb: Vec<[u8; 3]>,
    /// How the renderer gets from a level to a colour.
    pub lookup: Lookup,
}

/// From a material's light level to a palette index, and on to a colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lookup {
    /// The colours, at most 256, as the panel shows them, 8 bits a channel.
    pub palette: Vec<[u8; 3]>,
    /// For each material of the scene, the palette index of each level.
    pub shade: Vec<[u8; 256]>,
    /// For each row of the picture, the palette index of the background.
    pub background: Vec<u8>,
}

/// Why a frame cannot be compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FrameError {
    /// The two pictures differ in size (width, height in pixels).
    Size {
        /// Of the truth.
        truth: (u32, u32),
        /// Of the frame.
        frame: (u32, u32),
    },
    /// An array has the wrong length.
    Length {
        /// Its name.
        array: &'static str,
        /// The length it needs.
        needed: usize,
        /// The length it has.
        found: usize,
    },
    /// A table of the look-up names a colour that the palette does not have.
    Colour {
        /// The palette index.
        index: u8,
        /// How many colours there are.
        colours: usize,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size {
                truth: (tw, th),
                frame: (fw, fh),
            } => {
                write!(f, "the frame is {fw}x{fh} pixels, the reference {tw}x{th}")
            }
            Self::Length {
                array,
                needed,
                found,
            } => {
                write!(
                    f,
                    "the frame's {array} has {found} elements instead of {needed}"
                )
            }
            Self::Colour { index, colours } => {
                write!(
                    f,
                    "the look-up names colour {index} of a palette of {colours}"
                )
            }
        }
    }
}

impl std::error::Error for FrameError {}

impl Frame {
    /// The best frame that 16 bits of depth, 8 bits of light and the given
    /// look-up allow: the truth, rounded to the nearest. What [`crate::compare()`]
    /// says about it is the bound that no renderer with this palette beats.
    ///
    /// # Panics
    /// If a table of the look-up is too short for the scene or the picture.
    pub fn from_truth(truth: &Truth, lookup: Lookup) -> Self {
        let hits = || truth.pixels().iter();
        let level: Vec<u8> = hits()
            .map(|p| p.map_or(0, |hit| level8(hit.level)))
            .collect();
        let index = lookup.indices(truth);
        Self {
            width: truth.width(),
            height: truth.height(),
            depth: truth.depth16(),
            actor: truth.actor_ids(),
            triangle: hits()
                .map(|p| p.map_or(NO_TRIANGLE, |hit| hit.triangle as u32))
                .collect(),
            level,
            rgb: index
                .iter()
                .map(|i| lookup.palette[usize::from(*i)])
                .collect(),
            index,
            lookup,
        }
    }

    /// Checks every size against the truth's, and every palette index.
    pub(crate) fn check(&self, truth: &Truth, materials: usize) -> Result<(), FrameError> {
        let (truth_size, size) = ((truth.width, truth.height), (self.width, self.height));
        if truth_size != size {
            return Err(FrameError::Size {
                truth: truth_size,
                frame: size,
            });
        }
        let pixels = truth.pixels.len();
        let lookup = &self.lookup;
        let lengths = [
            ("depth", self.depth.len(), pixels),
            ("actor", self.actor.len(), pixels),
            ("triangle", self.triangle.len(), pixels),
            ("level", self.level.len(), pixels),
            ("index", self.index.len(), pixels),
            ("rgb", self.rgb.len(), pixels),
            ("background", lookup.background.len(), self.height as usize),
            ("shade", lookup.shade.len().min(materials), materials),
        ];
        for (array, found, needed) in lengths {
            if found != needed {
                return Err(FrameError::Length {
                    array,
                    needed,
                    found,
                });
            }
        }
        let colours = lookup.palette.len();
        let mut named = lookup.shade.iter().flatten().chain(&lookup.background);
        match named.find(|i| usize::from(**i) >= colours) {
            Some(&index) => Err(FrameError::Colour { index, colours }),
            None => Ok(()),
        }
    }
}

impl Lookup {
    /// The palette index of every pixel of the truth, without dithering.
    pub(crate) fn indices(&self, truth: &Truth) -> Vec<u8> {
        let width = truth.width as usize;
        let index = |(i, pixel): (usize, &Option<crate::Hit>)| match pixel {
            Some(hit) => self.shade[hit.material][usize::from(level8(hit.level))],
            None => self.background[i / width],
        };
        truth.pixels.iter().enumerate().map(index).collect()
    }
}

/// A level in 0..=255, rounded to the nearest.
fn level8(level: f64) -> u8 {
    level.round() as u8
}
