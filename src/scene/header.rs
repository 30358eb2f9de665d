//! The first record of a blob.

use super::records::{i, u, w};
use super::{CameraRecord, Record, layout};

/// The header: all that a scene has once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Header {
    /// Bytes of the whole blob.
    pub length: u32,
    /// See [`checksum`](super::checksum).
    pub checksum: u32,
    /// Screen width in pixels, 1..=2048.
    pub width: u16,
    /// Screen height in pixels, 1..=2048.
    pub height: u16,
    /// Index into [`ColourFormat::ALL`](super::ColourFormat::ALL).
    pub colour_format: u8,
    /// World units are scene units times 2 to this power.
    pub world_exponent: i8,
    /// The world's origin, in `2^centre_exponent` scene units: not 0 only if the
    /// scene is far from its own origin.
    pub world_centre: [i32; 3],
    /// See `world_centre`.
    pub centre_exponent: i8,
    /// Frames in a full turn of every actor about its y axis; 0: none.
    pub turntable: u32,
    /// Frames after which the tracks start again; 0: never.
    pub frames: u32,
    /// Code of the [`DitherPattern`](super::DitherPattern).
    pub dither_pattern: u8,
    /// See [`Dither::spread`](super::Dither::spread).
    pub dither_spread: u16,
    /// Palette entries that go round: the first, and how many; 0: none.
    pub cycle: (u16, u16),
    /// Frames in which they go round once, at least 1 if there are any.
    pub cycle_frames: u32,
    /// Eye, raw [`World`](crate::math::World) bits.
    pub position: [i32; 3],
    /// What is in the middle of the picture.
    pub focal_point: [i32; 3],
    /// Which way is up.
    pub view_up: [i32; 3],
    /// 0: perspective, 1: parallel.
    pub projection: u8,
    /// Perspective: tangent of half the vertical angle of view, in 2^-24.
    /// Parallel: half the picture's height, raw world bits.
    pub half_height: u32,
    /// Power of two that `near` and `far` are in: 0..=11. Not 0 only where a
    /// parallel view's range is far larger than its scene.
    pub range_exponent: u8,
    /// Distance of the near plane, raw world bits; above 0 for perspective.
    pub near: i32,
    /// Distance of the far plane; `i32::MAX`: none (perspective only).
    pub far: i32,
}

impl Record for Header {
    type Words = [u32; layout::HEADER_WORDS];

    fn from_words(words: &Self::Words) -> Self {
        let [
            _,
            _,
            length,
            checksum,
            size,
            format,
            turntable,
            p0,
            p1,
            p2,
            f0,
            f1,
            f2,
            u0,
            u1,
            u2,
            projection,
            half,
            near,
            far,
            c0,
            c1,
            c2,
            frames,
            dither,
            cycle,
            cycle_frames,
        ] = *words;
        let [format, exponent, centre_exponent, range_exponent] = format.to_ne_bytes();
        Self {
            length: u(length),
            checksum: u(checksum),
            width: u(size) as u16,
            height: (u(size) >> 16) as u16,
            colour_format: format,
            world_exponent: exponent as i8,
            world_centre: [i(c0), i(c1), i(c2)],
            centre_exponent: centre_exponent as i8,
            turntable: u(turntable),
            frames: u(frames),
            dither_pattern: u(dither) as u8,
            dither_spread: (u(dither) >> 16) as u16,
            cycle: (u(cycle) as u16, (u(cycle) >> 16) as u16),
            cycle_frames: u(cycle_frames),
            position: [i(p0), i(p1), i(p2)],
            focal_point: [i(f0), i(f1), i(f2)],
            view_up: [i(u0), i(u1), i(u2)],
            projection: u(projection) as u8,
            half_height: u(half),
            range_exponent,
            near: i(near),
            far: i(far),
        }
    }

    fn to_words(&self) -> Self::Words {
        let size = u32::from(self.width) | u32::from(self.height) << 16;
        let exponents = [self.world_exponent, self.centre_exponent].map(|e| e as u8);
        let [world, centre] = exponents;
        let format = [self.colour_format, world, centre, self.range_exponent];
        let (first, count) = self.cycle;
        let cycle = u32::from(first) | u32::from(count) << 16;
        let [c0, c1, c2] = self.world_centre.map(w);
        let [p0, p1, p2] = self.position.map(w);
        let [f0, f1, f2] = self.focal_point.map(w);
        let [u0, u1, u2] = self.view_up.map(w);
        [
            layout::MAGIC.to_le(),
            layout::VERSION.to_le(),
            self.length.to_le(),
            self.checksum.to_le(),
            size.to_le(),
            u32::from_ne_bytes(format),
            self.turntable.to_le(),
            p0,
            p1,
            p2,
            f0,
            f1,
            f2,
            u0,
            u1,
            u2,
            u32::from(self.projection).to_le(),
            self.half_height.to_le(),
            w(self.near),
            w(self.far),
            c0,
            c1,
            c2,
            self.frames.to_le(),
            (u32::from(self.dither_pattern) | u32::from(self.dither_spread) << 16).to_le(),
            cycle.to_le(),
            self.cycle_frames.to_le(),
        ]
    }
}

impl Header {
    /// The scene's camera.
    pub fn camera(&self) -> CameraRecord {
        CameraRecord {
            position: self.position,
            focal_point: self.focal_point,
            view_up: self.view_up,
            projection: self.projection,
            half_height: self.half_height,
            range_exponent: self.range_exponent,
            near: self.near,
            far: self.far,
        }
    }
}
