//! Parts of the frame with cameras of their own.

use super::parse::{count, range};
use super::records::u;
use super::{Camera, CameraRecord, Field, Pose, Record, Scene, SceneError, Section, layout};
use crate::math::Rect;

/// A viewport of the scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// Left, top, right and bottom side, from the frame's top left corner, as
    /// parts of its width and height in 2^-31.
    pub sides: [u32; 4],
    /// Whether the picture is as wide and high as the whole frame's and is
    /// squeezed into the viewport; otherwise pixels stay square.
    pub stretch: bool,
    /// Its own camera; `None`: the scene's.
    pub camera: Option<CameraRecord>,
    /// Its own background: the first index in the section, and how many. 0: the
    /// scene's.
    pub background: (u16, u16),
}

/// 1 in the units of [`Viewport::sides`].
pub const FULL_SIDE: u32 = 1 << 31;

impl Record for Viewport {
    type Words = [u32; 19];

    fn from_words(words: &Self::Words) -> Self {
        let [left, top, right, bottom, flags, background, camera @ ..] = *words;
        let [stretch, own_camera, ..] = flags.to_ne_bytes();
        let background = u(background);
        Self {
            sides: [left, top, right, bottom].map(u),
            stretch: stretch != 0,
            camera: (own_camera != 0).then(|| CameraRecord::from_words(&camera)),
            background: (background as u16, (background >> 16) as u16),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [left, top, right, bottom] = self.sides.map(u32::to_le);
        let own_camera = self.camera.is_some();
        let flags = u32::from_ne_bytes([self.stretch.into(), own_camera.into(), 0, 0]);
        let (first, count) = self.background;
        let background = (u32::from(first) | u32::from(count) << 16).to_le();
        let mut words = [0; 19];
        let camera = self.camera.map_or([0; 13], |camera| camera.to_words());
        let head = [left, top, right, bottom, flags, background];
        for (word, value) in words.iter_mut().zip(head.into_iter().chain(camera)) {
            *word = value;
        }
        words
    }
}

impl Viewport {
    /// The whole frame, as the scene says.
    pub const WHOLE: Self = Self {
        sides: [0, 0, FULL_SIDE, FULL_SIDE],
        stretch: false,
        camera: None,
        background: (0, 0),
    };

    /// Its pixels in a frame of `width` x `height`: sides go to the nearest line
    /// between pixels. A thousandth of a pixel decides ties, so that the rounding
    /// of the sides does not.
    pub fn rect(&self, width: u16, height: u16) -> Rect {
        let [left, top, right, bottom] = self.sides;
        let line = |side: u32, pixels: u16| {
            let tie = (1 << 30) + (1 << 21);
            ((u64::from(side) * u64::from(pixels) + tie) >> 31).min(pixels.into()) as u16
        };
        Rect {
            left: line(left, width),
            top: line(top, height),
            right: line(right, width),
            bottom: line(bottom, height),
        }
    }
}

/// A viewport in a frame of a given size, with the camera that looks into it.
#[derive(Clone, Copy, Debug)]
pub struct PlacedViewport {
    /// Its pixels.
    pub rect: Rect,
    /// Its eye.
    pub camera: Camera,
    /// How much larger things are shown across than down: a ratio.
    pub magnified: [u32; 2],
    /// Its number in the scene file, from 0.
    pub number: u16,
}

impl<'a> Scene<'a> {
    /// Number of viewports, at least 1: a scene without any has one that fills
    /// the frame.
    pub fn viewport_count(&self) -> u16 {
        self.viewports.len().max(1) as u16
    }

    /// A viewport; later ones lie over earlier ones.
    pub fn viewport(&self, number: u16) -> Viewport {
        let words = self.viewports.get(usize::from(number));
        words.map_or(Viewport::WHOLE, Viewport::from_words)
    }

    /// Whether some viewport fills the frame, so that nothing shows between them.
    pub fn is_filled(&self) -> bool {
        let whole = |number| self.viewport(number).sides == Viewport::WHOLE.sides;
        (0..self.viewport_count()).any(whole)
    }

    /// A viewport's place and camera in a frame.
    pub fn place_viewport(
        &self,
        number: u16,
        pose: &Pose<'_>,
        width: u16,
        height: u16,
    ) -> PlacedViewport {
        let viewport = self.viewport(number);
        let rect = viewport.rect(width, height);
        let moved = pose.cameras.iter().find(|(which, _)| *which == number);
        let camera = match (moved, viewport.camera) {
            (Some((_, camera)), _) => *camera,
            (None, Some(own)) => own.camera(),
            (None, None) => pose.camera,
        };
        let magnified = if viewport.stretch {
            // A picture of the frame's shape fills the viewport.
            let part = |a: u16, b: u16| u32::from(a.max(1)) * u32::from(b.max(1));
            [part(rect.width(), height), part(rect.height(), width)]
        } else {
            [1, 1]
        };
        PlacedViewport {
            rect,
            camera,
            magnified,
            number,
        }
    }

    /// A viewport's background, from its top to its bottom.
    pub fn viewport_background(&self, number: u16) -> Gradient<'a> {
        let (first, count) = self.viewport(number).background;
        let (first, count) = (usize::from(first), usize::from(count));
        let own = self.viewport_backgrounds.get(first..first + count);
        match own {
            Some(own) if !own.is_empty() => Gradient(own),
            _ => Gradient(self.background),
        }
    }
}

/// Palette indices from the top of a picture to its bottom.
#[derive(Clone, Copy, Debug)]
pub struct Gradient<'a>(pub(super) &'a [u8]);

impl Gradient<'_> {
    /// The index in row `y` of `height`.
    pub fn at(&self, y: u16, height: u16) -> u8 {
        let at = (u32::from(y) * self.0.len() as u32) / u32::from(height).max(1);
        self.0.get(at as usize).copied().unwrap_or(0)
    }
}

impl Scene<'_> {
    /// Whether all is in range.
    pub(super) fn check_viewports(&self) -> Result<(), SceneError> {
        let s = Section::Viewports;
        count(s, self.viewports.len(), 0, layout::VIEWPORTS)?;
        let own = self.viewport_backgrounds;
        let colours = self.palette.len() as i64 - 1;
        for (i, index) in own.iter().enumerate() {
            let index = i64::from(*index);
            let s = Section::ViewportBackgrounds;
            range(s, i, Field::PaletteIndex, index, 0, colours)?;
        }
        for (i, words) in self.viewports.iter().enumerate() {
            let viewport = Viewport::from_words(words);
            let [left, top, right, bottom] = viewport.sides.map(i64::from);
            let full = FULL_SIDE.into();
            for (low, high) in [(left, right), (top, bottom)] {
                range(s, i, Field::Sides, low, 0, high)?;
                range(s, i, Field::Sides, high, 0, full)?;
            }
            let (first, count) = viewport.background;
            let last = own.len() as i64 - i64::from(count);
            range(s, i, Field::Background, first.into(), 0, last)?;
            let bad = viewport.camera.and_then(|camera| camera.out_of_range());
            if let Some((field, value)) = bad {
                return Err(SceneError::Record {
                    section: s,
                    index: i,
                    field,
                    value,
                });
            }
        }
        Ok(())
    }
}
