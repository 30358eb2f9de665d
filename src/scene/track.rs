//! Key frames: what moves, and where it is in a frame.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "keys' values of 32 bits between frames of 32, in 64; tests stop at overflow"
)]

use super::range::{last, range};
use super::records::{i, u, w};
use super::{Field, Record, Scene, SceneError, Section, layout};
use crate::math::{Angle, Factor};

/// What a track moves. Each has its numbers in one format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Place of an actor's pivot in its parent's space, or of the eye: raw world
    /// bits.
    Position,
    /// The camera's focal point: raw world bits.
    FocalPoint,
    /// An actor's turns about x, y, z: 2^-24 turns.
    Orientation,
    /// A factor of an actor's size: 2^-24, one number.
    Scale,
    /// See [`Camera::azimuth`](super::Camera::azimuth): 2^-24 turns, one number.
    Azimuth,
    /// See [`Camera::elevation`](super::Camera::elevation): 2^-24 turns, one number.
    Elevation,
    /// See [`Camera::roll`](super::Camera::roll): 2^-24 turns, one number.
    Roll,
    /// See [`Camera::dolly`](super::Camera::dolly): 2^-24, one number.
    Dolly,
    /// See [`Camera::zoom`](super::Camera::zoom): 2^-24, one number.
    Zoom,
    /// See [`Camera::pan`](super::Camera::pan): raw world bits, two numbers.
    Pan,
}

impl Quantity {
    /// All, in the order of their codes; those of an actor first but for the
    /// focal point.
    pub const ALL: [Self; 10] = [
        Self::Position,
        Self::FocalPoint,
        Self::Orientation,
        Self::Scale,
        Self::Azimuth,
        Self::Elevation,
        Self::Roll,
        Self::Dolly,
        Self::Zoom,
        Self::Pan,
    ];

    fn of_actor(self) -> bool {
        matches!(self, Self::Position | Self::Orientation | Self::Scale)
    }

    fn of_camera(self) -> bool {
        !matches!(self, Self::Orientation | Self::Scale)
    }

    fn is_factor(self) -> bool {
        matches!(self, Self::Scale | Self::Dolly | Self::Zoom)
    }
}

/// One quantity of one actor or of the camera over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Track {
    /// The actor's index, or [`CAMERA`](layout::CAMERA).
    pub target: u16,
    /// Of the camera: whose own it is, if not the scene's.
    pub viewport: Option<u8>,
    /// What of it.
    pub quantity: Quantity,
    /// Its first key in the scene's list.
    pub first_key: u32,
    /// How many keys, at least 1.
    pub keys: u32,
}

impl Record for Track {
    type Words = [u32; 3];

    fn from_words(words: &Self::Words) -> Self {
        let [ids, first_key, keys] = words.map(u);
        let code = usize::from((ids >> 16) as u8);
        let quantity = Quantity::ALL.get(code).copied();
        Self {
            target: ids as u16,
            viewport: ((ids >> 24) as u8).checked_sub(1),
            quantity: quantity.unwrap_or(Quantity::Position),
            first_key,
            keys,
        }
    }

    fn to_words(&self) -> Self::Words {
        let viewport = self.viewport.map_or(0, |viewport| u32::from(viewport) + 1);
        let ids = u32::from(self.target) | (self.quantity as u32) << 16 | viewport << 24;
        [ids, self.first_key, self.keys].map(u32::to_le)
    }
}

/// A track's value in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// The frame.
    pub frame: u32,
    /// The value, in the format of its track's [`Quantity`].
    pub values: [i32; 3],
}

impl Record for Key {
    type Words = [u32; 4];

    fn from_words(&[frame, a, b, c]: &Self::Words) -> Self {
        Self {
            frame: u(frame),
            values: [i(a), i(b), i(c)],
        }
    }

    fn to_words(&self) -> Self::Words {
        let [a, b, c] = self.values.map(w);
        [self.frame.to_le(), a, b, c]
    }
}

/// A value between two keys, with 8 bits below those of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Between([i64; 3]);

impl Between {
    /// In the units of a key, rounded to nearest.
    pub fn rounded(self) -> [i32; 3] {
        self.0.map(|v| ((v + 128) >> 8) as i32)
    }

    /// 2^-24 turns as 2^-32 turns, whole turns left out.
    pub fn turns(self) -> [u32; 3] {
        self.0.map(|v| v as u32)
    }

    /// The first number as an angle.
    pub fn angle(self) -> Angle {
        let [turns, ..] = self.turns();
        Angle::from_bits(turns)
    }

    /// The first number as a factor.
    pub fn factor(self) -> Factor {
        let [factor, ..] = self.rounded();
        Factor::from_bits(factor as u32)
    }
}

impl Scene<'_> {
    /// Number of tracks.
    pub fn track_count(&self) -> usize {
        self.tracks.len()
    }

    /// All tracks.
    pub fn tracks(&self) -> impl ExactSizeIterator<Item = Track> + use<'_> {
        self.tracks.iter().map(Track::from_words)
    }

    /// The tracks of an actor, or of the [`CAMERA`](layout::CAMERA).
    pub(super) fn moving(&self, target: u16) -> impl Iterator<Item = Track> + use<'_> {
        // Without the feature there are none.
        let tracks = cfg!(feature = "animation").then(|| self.tracks());
        let tracks = tracks.into_iter().flatten();
        tracks.filter(move |track| track.target == target)
    }

    /// A track's keys, in the order of their frames.
    pub fn keys(&self, track: &Track) -> impl ExactSizeIterator<Item = Key> + use<'_> {
        self.key_words(track).iter().map(Key::from_words)
    }

    fn key_words(&self, track: &Track) -> &[<Key as Record>::Words] {
        let first = track.first_key as usize;
        let end = first.saturating_add(track.keys as usize);
        self.keys.get(first..end).unwrap_or_default()
    }

    /// A track's value in frame `frame`: linear between its keys, the first one's
    /// before them, the last one's after them; rounded to nearest.
    pub(super) fn between(&self, track: &Track, frame: u32) -> Between {
        let words = self.key_words(track);
        let next = words.partition_point(|key| Key::from_words(key).frame <= frame);
        let key = |at: usize| words.get(at).map(Key::from_words);
        let before = key(next.wrapping_sub(1)).or(key(next));
        let Some(from) = before else {
            return Between([0; 3]);
        };
        let to = key(next).unwrap_or(from);
        let span = i64::from(to.frame.wrapping_sub(from.frame)).max(1);
        let part = i64::from(frame.saturating_sub(from.frame)).min(span);
        let mut values = from.values.map(|v| i64::from(v) << 8);
        for (value, (a, b)) in values.iter_mut().zip(from.values.iter().zip(to.values)) {
            // 33 bits, 8 more, and 17 of a frame's number.
            let way = ((i64::from(b) - i64::from(*a)) << 8) * part;
            *value += (way + span / 2).div_euclid(span);
        }
        Between(values)
    }

    /// Whose each track is and what it moves, and keys in the order of frames.
    #[deny(clippy::arithmetic_side_effects)]
    pub(super) fn check_tracks(&self) -> Result<(), SceneError> {
        if !cfg!(feature = "animation") {
            return Ok(());
        }
        for (i, (track, words)) in self.tracks().zip(self.tracks).enumerate() {
            let s = Section::Tracks;
            let camera = track.target == layout::CAMERA;
            if !camera {
                let actors = self.actors.len();
                range(s, i, Field::Target, track.target.into(), 0, last(actors, 1))?;
            }
            if let Some(viewport) = track.viewport {
                let viewports = if camera { self.viewports.len() } else { 0 };
                range(s, i, Field::Target, viewport.into(), 0, last(viewports, 1))?;
            }
            let code = words.first().map_or(0, |w| u32::from_le(*w) >> 16 & 255);
            let known = last(Quantity::ALL.len(), 1);
            range(s, i, Field::Quantity, code.into(), 0, known)?;
            let has = if camera {
                track.quantity.of_camera()
            } else {
                track.quantity.of_actor()
            };
            if !has {
                range(s, i, Field::Quantity, code.into(), -1, -1)?;
            }
            let (first, keys) = (i64::from(track.first_key), i64::from(track.keys));
            let all = self.keys.len();
            range(s, i, Field::Count, keys, 1, last(all, 0))?;
            range(s, i, Field::FirstKey, first, 0, last(all, keys))?;
            let mut least = 0;
            for (j, key) in self.keys(&track).enumerate() {
                let (s, j) = (Section::Keys, (first as usize).saturating_add(j));
                range(s, j, Field::Frame, key.frame.into(), least, MOST_FRAMES)?;
                least = i64::from(key.frame).saturating_add(1);
                let [value, ..] = key.values;
                if track.quantity.is_factor() {
                    range(
                        s,
                        j,
                        Field::Scale,
                        value.into(),
                        LEAST_FACTOR,
                        i32::MAX.into(),
                    )?;
                }
            }
        }
        Ok(())
    }
}

/// The largest number of a frame.
const MOST_FRAMES: i64 = 1 << 17;
/// The least factor: 2^-10.
const LEAST_FACTOR: i64 = 1 << 14;
