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
    /// Index into [`PanelDithering::ALL`](super::PanelDithering::ALL).
    pub panel_dithering: u8,
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
    /// See [`Scene::is_direct`](super::Scene::is_direct).
    pub direct: bool,
    /// Palette entries that go round: the first, and how many; 0: none.
    pub cycle: (u16, u16),
    /// Frames in which they go round once, at least 1 if there are any.
    pub cycle_frames: u32,
    /// Most that a level of a mesh may be seen off the mesh, raw sub-pixels of the frame; see
    /// [`Mesh::levels`](super::Mesh::levels).
    pub level_error: u16,
    /// Cargo features of this crate that the scene needs: `lod` in the lowest bit, then
    /// `texture`, `lines`, `viewports`, `animation`, `fog`, `light`, `gouraud`, `transparency`.
    /// What is baked for rays can be drawn without them.
    pub features: u16,
    /// The scene's camera.
    pub camera: CameraRecord,
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
            c0,
            c1,
            c2,
            frames,
            dither,
            cycle,
            cycle_frames,
            level,
            camera @ ..,
        ] = words;
        let [format, exponent, centre_exponent, panel_dithering] = format.to_ne_bytes();
        Self {
            length: u(*length),
            checksum: u(*checksum),
            width: u(*size) as u16,
            height: (u(*size) >> 16) as u16,
            colour_format: format,
            panel_dithering,
            world_exponent: exponent as i8,
            world_centre: [i(*c0), i(*c1), i(*c2)],
            centre_exponent: centre_exponent as i8,
            turntable: u(*turntable),
            frames: u(*frames),
            dither_pattern: u(*dither) as u8,
            dither_spread: (u(*dither) >> 16) as u16,
            direct: u(*dither) >> 8 & 1 != 0,
            cycle: (u(*cycle) as u16, (u(*cycle) >> 16) as u16),
            cycle_frames: u(*cycle_frames),
            level_error: u(*level) as u16,
            features: (u(*level) >> 16) as u16,
            camera: CameraRecord::from_words(camera),
        }
    }

    fn to_words(&self) -> Self::Words {
        let size = u32::from(self.width) | u32::from(self.height) << 16;
        let [world, centre] = [self.world_exponent, self.centre_exponent].map(|e| e as u8);
        let format = [self.colour_format, world, centre, self.panel_dithering];
        let (first, count) = self.cycle;
        let cycle = u32::from(first) | u32::from(count) << 16;
        let dither = u32::from(self.dither_pattern)
            | u32::from(self.direct) << 8
            | u32::from(self.dither_spread) << 16;
        let level = u32::from(self.level_error) | u32::from(self.features) << 16;
        let [c0, c1, c2] = self.world_centre.map(w);
        let own = [
            layout::MAGIC.to_le(),
            layout::VERSION.to_le(),
            self.length.to_le(),
            self.checksum.to_le(),
            size.to_le(),
            u32::from_ne_bytes(format),
            self.turntable.to_le(),
            c0,
            c1,
            c2,
            self.frames.to_le(),
            dither.to_le(),
            cycle.to_le(),
            self.cycle_frames.to_le(),
            level.to_le(),
        ];
        let mut words = [0; layout::HEADER_WORDS];
        let all = own.into_iter().chain(self.camera.to_words());
        words
            .iter_mut()
            .zip(all)
            .for_each(|(word, own)| *word = own);
        words
    }
}
