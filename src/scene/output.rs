//! From the frame that is drawn to the picture that is shown: samples of a pixel,
//! and pictures for two eyes.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "samples of a pixel, 1 or 2 each way; tests stop at overflow"
)]

use super::range::{count, range};
use super::records::{i, w};
use super::{Field, Record, Scene, SceneError, Section};

/// What two eyes see of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stereo {
    /// One eye.
    None,
    /// The left eye's picture in red, the right one's in green and blue.
    Anaglyph,
    /// The left eye's picture in the left half, the right one's in the right half.
    SideBySide,
}

/// How the picture comes of the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output {
    /// Samples of a pixel, across and down: 1 or 2 each.
    pub samples: [u8; 2],
    /// Eyes.
    pub stereo: Stereo,
    /// Tangent of half the angle between the eyes, as seen from the focal point,
    /// Q30.
    pub eye_slope: i32,
}

impl Record for Output {
    type Words = [u32; 2];

    fn from_words(&[kinds, eye_slope]: &Self::Words) -> Self {
        let [across, down, stereo, _] = kinds.to_ne_bytes();
        Self {
            samples: [across, down],
            stereo: match stereo {
                0 => Stereo::None,
                1 => Stereo::Anaglyph,
                _ => Stereo::SideBySide,
            },
            eye_slope: i(eye_slope),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [across, down] = self.samples;
        let stereo = match self.stereo {
            Stereo::None => 0,
            Stereo::Anaglyph => 1,
            Stereo::SideBySide => 2,
        };
        let kinds = u32::from_ne_bytes([across, down, stereo, 0]);
        [kinds, w(self.eye_slope)]
    }
}

impl Output {
    /// The frame is the picture.
    pub const PLAIN: Self = Self {
        samples: [1, 1],
        stereo: Stereo::None,
        eye_slope: 0,
    };

    /// The largest [`Output::eye_slope`]: an angle of 60 degrees.
    pub const MOST_SLOPE: i32 = 619_925_131;

    /// Eyes.
    pub fn eyes(&self) -> u16 {
        if self.stereo == Stereo::None { 1 } else { 2 }
    }

    /// Whether the frame's pixels have to be resolved, by
    /// [`Resolve`](crate::display::Resolve), before they are shown.
    pub fn is_resolved(&self) -> bool {
        self.samples != [1, 1] || self.stereo == Stereo::Anaglyph
    }

    /// Pictures beside each other in the frame that become one.
    pub(crate) fn joined(&self) -> u16 {
        if self.stereo == Stereo::Anaglyph {
            2
        } else {
            1
        }
    }

    /// Width and height of the frame for a picture of a given size.
    pub fn frame_size(&self, (width, height): (u16, u16)) -> (u16, u16) {
        let [across, down] = self.samples.map(u16::from);
        let times = across.saturating_mul(self.joined());
        (width.saturating_mul(times), height.saturating_mul(down))
    }

    /// Width and height of the picture of a frame of a given size.
    pub fn picture_size(&self, (width, height): (u16, u16)) -> (u16, u16) {
        let [across, down] = self.samples.map(|n| u16::from(n.max(1)));
        let times = across.saturating_mul(self.joined());
        (width / times, height / down)
    }
}

impl Scene<'_> {
    /// How the picture comes of the frame.
    pub fn output(&self) -> Output {
        let words = self.output.first();
        // Without the feature there are none.
        let words = words.filter(|_| cfg!(feature = "viewports"));
        words.map_or(Output::PLAIN, Output::from_words)
    }

    /// Columns of the frame, which a [`Band`](crate::Band) has to have: more than
    /// [`Scene::width`] if the scene is anti-aliased or an anaglyph.
    pub fn frame_width(&self) -> u16 {
        self.output().frame_size((self.width(), self.height())).0
    }

    /// Rows of the frame; as many as a pose has.
    pub fn frame_height(&self) -> u16 {
        self.output().frame_size((self.width(), self.height())).1
    }

    /// Whether all is in range.
    #[deny(clippy::arithmetic_side_effects)]
    pub(super) fn check_output(&self) -> Result<(), SceneError> {
        let s = Section::Output;
        if !cfg!(feature = "viewports") {
            return Ok(());
        }
        count(s, self.output.len(), 0, 1)?;
        let output = self.output();
        for samples in output.samples {
            range(s, 0, Field::Samples, samples.into(), 1, 2)?;
        }
        let slope = i64::from(output.eye_slope);
        range(s, 0, Field::Eyes, slope, 0, Output::MOST_SLOPE.into())?;
        let stereo = self.output.first().map_or(0, |words| {
            let [kinds, _] = *words;
            let [_, _, stereo, _] = kinds.to_ne_bytes();
            stereo
        });
        range(s, 0, Field::Eyes, stereo.into(), 0, 2)?;
        let frame = [self.frame_width(), self.frame_height()];
        for size in frame {
            range(s, 0, Field::Samples, size.into(), 1, 2048)?;
        }
        Ok(())
    }
}
