//! Parts of the frame with cameras of their own.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "columns and rows of 16 bits, in wider integers; tests stop at overflow"
)]

use super::range::{count, last, range};
use super::records::u;
use super::{
    Camera, CameraRecord, Field, Pose, Record, Scene, SceneError, Section, Stereo, layout,
};
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
    /// Its number in the frame, from 0.
    pub number: u16,
    /// How much further right things appear with each unit of distance, beyond
    /// those at the focal point: Q30. Not 0 for one of two eyes.
    pub shear: i32,
}

impl<'a> Scene<'a> {
    /// Number of viewports in the scene file, at least 1: a scene without any has
    /// one that fills the frame.
    pub fn viewports_an_eye(&self) -> u16 {
        // Without the feature there is none in the file.
        if cfg!(feature = "viewports") {
            self.viewports.len().max(1) as u16
        } else {
            1
        }
    }

    /// Number of viewports in a frame: of all eyes.
    pub fn viewport_count(&self) -> u16 {
        self.viewports_an_eye() * self.output().eyes()
    }

    /// A viewport; later ones lie over earlier ones. Those of the right eye come
    /// after those of the left one.
    pub fn viewport(&self, number: u16) -> Viewport {
        let number = number.checked_rem(self.viewports_an_eye()).unwrap_or(0);
        let words = self.viewports.get(usize::from(number));
        let words = words.filter(|_| cfg!(feature = "viewports"));
        words.map_or(Viewport::WHOLE, Viewport::from_words)
    }

    /// Whether some viewport fills a frame of this width, for each eye, so that
    /// nothing shows between them.
    pub fn is_filled(&self, width: u16) -> bool {
        let output = self.output();
        let (columns, _) = output.picture_size((width, 1));
        let halves = output.stereo != Stereo::SideBySide || columns.is_multiple_of(2);
        let whole = |number| self.viewport(number).sides == Viewport::WHOLE.sides;
        halves && (0..self.viewports_an_eye()).any(whole)
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
        let output = self.output();
        let eye = number.checked_div(self.viewports_an_eye()).unwrap_or(0);
        let [across, down] = output.samples.map(|n| u16::from(n.max(1)));
        // In whole pixels of the picture, then in samples.
        let (columns, rows) = (width / across, height / down);
        let eye_columns = columns / output.eyes();
        let corner = eye * (columns - eye_columns);
        let rect = viewport.rect(eye_columns, rows);
        let rect = Rect {
            left: (corner + rect.left) * across,
            top: rect.top * down,
            right: (corner + rect.right) * across,
            bottom: rect.bottom * down,
        };
        let number_in_file = number.checked_rem(self.viewports_an_eye()).unwrap_or(0);
        let given = pose
            .cameras
            .iter()
            .find(|(which, _)| *which == number_in_file);
        let camera = match (given, viewport.camera) {
            (Some((_, camera)), _) => *camera,
            (None, Some(own)) => {
                let number = Some(number_in_file as u8);
                self.moved_camera(own.camera(), number, pose.frame)
            }
            (None, None) => pose.camera,
        };
        let magnified = if viewport.stretch {
            // A picture of the whole picture's shape fills the viewport.
            let (columns, rows) = output.picture_size((width, height));
            let part = |a: u16, b: u16| u32::from(a.max(1)) * u32::from(b.max(1));
            [part(rect.width(), rows), part(rect.height(), columns)]
        } else {
            [across.into(), down.into()]
        };
        let shear = match (output.stereo, eye) {
            (Stereo::None, _) => 0,
            (_, 0) => output.eye_slope.wrapping_neg(),
            _ => output.eye_slope,
        };
        PlacedViewport {
            rect,
            camera,
            magnified,
            number,
            shear,
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

    /// The first and the last.
    pub fn ends(&self) -> [u8; 2] {
        [self.0.first(), self.0.last()].map(|index| index.copied().unwrap_or(0))
    }
}

impl Scene<'_> {
    /// Whether all is in range.
    #[deny(clippy::arithmetic_side_effects)]
    pub(super) fn check_viewports(&self) -> Result<(), SceneError> {
        let s = Section::Viewports;
        if !cfg!(feature = "viewports") {
            return Ok(());
        }
        count(s, self.viewports.len(), 0, layout::VIEWPORTS)?;
        let own = self.viewport_backgrounds;
        let colours = last(self.palette.len(), 1);
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
            let last = last(own.len(), count.into());
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
