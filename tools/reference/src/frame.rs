//! A picture from the renderer under test, as plain arrays.

use crate::bases::{Lights, Nearest};
use crate::hit::Hit;
use crate::path::Path;
use crate::truth::Truth;
use fixel_scene::Rgb;
use std::fmt;

/// How many colours a [`Lookup`] tells apart: 4 bits a channel.
pub const COLOURS: usize = 1 << 12;

/// [`Frame::triangle`] where nothing is seen, or what is seen is a simpler mesh in the
/// place of an actor's own: which agrees with the truth where that shows the same actor.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// What the renderer under test drew. Pixels go by rows from the top left;
/// each array has `width * height` elements.
#[derive(Clone, Debug, PartialEq)]
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
    /// the baked order); or [`NO_TRIANGLE`].
    pub triangle: Vec<u32>,
    /// Light before it is looked up: of a material that goes by level
    /// ([`Path::Level`], [`Path::Textured`]) three times its level, of one that goes by colour
    /// ([`Path::Colour`], [`Path::TexturedColour`]) red, green and blue, each 0..=255; any where nothing is
    /// seen.
    pub light: Vec<[u8; 3]>,
    /// Palette index.
    pub index: Vec<u8>,
    /// The colour shown, 8 bits a channel.
    pub rgb: Vec<[u8; 3]>,
    /// The place in the texture, in texels from its top left corner, before wrapping,
    /// where there is a texture; of all pixels, or of none if it is not known.
    pub texture_place: Vec<[f64; 2]>,
    /// Which of the scene's first 8 lights get to what the pixel's centre shows, a bit
    /// each, the first light's the lowest: from any place on the light, through whatever
    /// is not opaque; not where the surface is turned away. Empty of a renderer without
    /// shadows.
    pub lit: Vec<u8>,
    /// How the renderer gets from light to a colour.
    pub lookup: Lookup,
}

/// From light to a palette index, and on to a colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lookup {
    /// The colours, at most 256, as the panel shows them, 8 bits a channel.
    pub palette: Vec<[u8; 3]>,
    /// There is no palette: colours are rounded to 5, 6 and 5 bits, and indices mean
    /// nothing.
    pub direct: bool,
    /// For each material of the scene, its way.
    pub paths: Vec<Path>,
    /// The palette index of each colour of 4 bits a channel: [`COLOURS`] of them,
    /// red in the highest bits, blue in the lowest; empty if no material goes by
    /// colour. A colour is rounded to the nearest of 0, 1/15, .. 1 in each
    /// channel; what a renderer dithers is held against the undithered.
    pub colours: Vec<u8>,
    /// Rows of what becomes of each index, from no fog to nothing else, in even
    /// steps; empty without fog.
    pub fog: Vec<[u8; 256]>,
    /// For each pixel of the picture, the palette index of the background.
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
        let lights = lookup.lights();
        let light = hits()
            .map(|p| p.map_or([0; 3], |hit| lights.of(&hit).map(|l| l.round() as u8)))
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
            light,
            rgb: index
                .iter()
                .map(|i| lookup.palette[usize::from(*i)])
                .collect(),
            index,
            texture_place: hits()
                .map(|p| p.and_then(|hit| hit.texture_place).unwrap_or_default())
                .collect(),
            lit: truth.lit(),
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
            ("light", self.light.len(), pixels),
            ("index", self.index.len(), pixels),
            ("rgb", self.rgb.len(), pixels),
            ("background", lookup.background.len(), pixels),
            ("paths", lookup.paths.len().min(materials), materials),
            ("colours", lookup.colours.len(), lookup.colours_needed()),
        ];
        let shades = lookup.paths.iter().filter_map(Path::shade_lengths);
        let places = Some(self.texture_place.len()).filter(|count| *count > 0);
        let places = places.map(|count| ("texture_place", count, pixels));
        let lit = Some(self.lit.len()).filter(|count| *count > 0);
        let lit = lit.map(|count| ("lit", count, pixels));
        let lengths = lengths.into_iter().chain(shades).chain(places).chain(lit);
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
        let levels = lookup.paths.iter().filter_map(|path| match path {
            Path::Level(indices) => Some(&indices[..]),
            Path::Textured { shade, .. } => Some(&shade[..]),
            Path::Colour | Path::TexturedColour { .. } => None,
        });
        let others = lookup.colours.iter().chain(&lookup.background);
        let others = others.chain(lookup.fog.iter().flatten());
        match levels
            .flatten()
            .chain(others)
            .find(|i| usize::from(**i) >= colours)
        {
            Some(&index) => Err(FrameError::Colour { index, colours }),
            None => Ok(()),
        }
    }
}

impl Lookup {
    /// The truth's colours as the renderer's way leads to them, without dithering: through
    /// its palette, whose `indices` are given, or, without one, rounded to 16 bits.
    pub(crate) fn shown(&self, truth: &Truth, indices: &[u8]) -> Vec<[u8; 3]> {
        if !self.direct {
            let colour = |index: &u8| self.palette[usize::from(*index)];
            return indices.iter().map(colour).collect();
        }
        let rounded = |c: f64, most: f64| ((c * most).round() / most * 255.0).round() as u8;
        let colour = |[r, g, b]: Rgb| [rounded(r, 31.0), rounded(g, 63.0), rounded(b, 31.0)];
        truth.colours().map(colour).collect()
    }

    /// The palette index of every pixel of the truth, without dithering.
    pub(crate) fn indices(&self, truth: &Truth) -> Vec<u8> {
        let bases: Vec<Nearest> = self.paths.iter().map(Nearest::of).collect();
        let index = |(i, pixel): (usize, &Option<Hit>)| {
            let behind = match pixel {
                Some(hit) => self.index(hit, &bases, self.background[i]),
                None if truth.is_resampled(i) => self.colour_index(truth.background[i]),
                None => self.background[i],
            };
            // Only entries of the palette can be kept from layer to layer.
            truth.layers[i].iter().fold(behind, |behind, layer| {
                let colour = self.palette[usize::from(behind)].map(|c| f64::from(c) / 255.0);
                self.colour_index(layer.over(colour))
            })
        };
        truth.pixels.iter().enumerate().map(index).collect()
    }

    fn index(&self, hit: &Hit, bases: &[Nearest], background: u8) -> u8 {
        let clear = match &self.paths[hit.material] {
            _ if hit.hidden => background,
            Path::Level(indices) => indices[hit.level.round() as usize],
            Path::Colour | Path::TexturedColour { .. } => {
                self.colour_index(bases[hit.material].colour(hit))
            }
            Path::Textured { shade, .. } => {
                let nearest = &bases[hit.material];
                let base = nearest.index(hit.texel.unwrap_or([1.0; 3]));
                let rows = shade.len() / nearest.len();
                shade[hit.level.round() as usize * rows / 256 * nearest.len() + base]
            }
        };
        match self.fog.len().checked_sub(1) {
            Some(last) => self.fog[(hit.fog * last as f64).round() as usize][usize::from(clear)],
            None => clear,
        }
    }

    fn colour_index(&self, colour: Rgb) -> u8 {
        let step = |channel: f64| (15.0 * channel).round() as usize;
        let [red, green, blue] = colour.map(step);
        self.colours[red << 8 | green << 4 | blue]
    }

    /// The light of the truth as [`Frame::light`] has it.
    pub(crate) fn lights(&self) -> Lights<'_> {
        Lights::new(&self.paths)
    }

    /// The length that the table of colours has to have.
    fn colours_needed(&self) -> usize {
        let coloured = |path: &Path| matches!(path, Path::Colour | Path::TexturedColour { .. });
        let needed = !self.colours.is_empty() || self.paths.iter().any(coloured);
        if needed { COLOURS } else { 0 }
    }
}
