//! Bytes become a scene: everything is checked here, once, so that drawing
//! never has to.

use bytemuck::try_cast_slice;

use super::layout;
use super::range::{count, last, range};
use super::sections::find_sections;
use super::{
    ColourFormat, DitherPattern, Field, Header, PanelDithering, Record, Scene, SceneError, Section,
    checksum,
};

impl<'a> Scene<'a> {
    /// Checks a baked scene from wherever it comes: every number of it. The bytes must start
    /// at a multiple of 4. For what the program's own build has baked, [`Scene::embedded`].
    ///
    /// # Errors
    /// Says what is wrong and where; see [`SceneError`].
    #[inline(never)]
    pub fn parse(bytes: &'a [u8]) -> Result<Self, SceneError> {
        let scene = Self::intact(bytes)?;
        check_header(&scene.header)?;
        scene.check_features()?;
        scene.check_colours()?;
        scene.check_lights()?;
        scene.check_textures()?;
        scene.check_materials()?;
        scene.check_actors()?;
        scene.check_looks()?;
        scene.check_meshes()?;
        scene.check_viewports()?;
        scene.check_tracks()?;
        scene.check_fog()?;
        scene.check_output()?;
        scene.check_rays()?;
        Ok(scene)
    }

    /// A scene that the program's own build has baked, such as
    /// [`include_scene!`](crate::include_scene) embeds. The bytes must start at a multiple of 4.
    ///
    /// The baker has checked every number by [`Scene::parse`], so firmware need not link those
    /// checks again, 5 KB on a Cortex-M0+. Here it is made sure that the bytes are those that it
    /// wrote (version, length, checksum), that the program has what they need, and that rays'
    /// hierarchies end. Bytes that pass although no baker wrote them are drawn as nonsense: no
    /// panic, no read beyond them, and every frame comes to an end.
    ///
    /// # Errors
    /// Says what is wrong; see [`SceneError`].
    #[inline(never)]
    pub fn embedded(bytes: &'a [u8]) -> Result<Self, SceneError> {
        let scene = Self::intact(bytes)?;
        scene.check_rays()?;
        Ok(scene)
    }

    /// As it was baked, for a program that has what it needs.
    fn intact(bytes: &'a [u8]) -> Result<Self, SceneError> {
        if bytes.len() < layout::PREFIX_BYTES {
            return Err(SceneError::TooShort { bytes: bytes.len() });
        }
        let whole_words = bytes.get(..bytes.len() & !3).unwrap_or_default();
        let words: &[u32] = try_cast_slice(whole_words).map_err(|_| SceneError::Misaligned)?;
        let (first, rest) = words
            .split_first_chunk::<{ layout::HEADER_WORDS }>()
            .ok_or(SceneError::TooShort { bytes: bytes.len() })?;
        let [magic, version, ..] = *first;
        if u32::from_le(magic) != layout::MAGIC {
            return Err(SceneError::NotAScene);
        }
        if u32::from_le(version) != layout::VERSION {
            return Err(SceneError::Version {
                found: u32::from_le(version),
            });
        }
        let header = Header::from_words(first);
        if header.length as usize != bytes.len() || !bytes.len().is_multiple_of(4) {
            return Err(SceneError::Length {
                stated: header.length,
                bytes: bytes.len(),
            });
        }
        let found = checksum(words.get(layout::CHECKED_FROM / 4..).unwrap_or_default());
        if found != header.checksum {
            return Err(SceneError::Checksum {
                stated: header.checksum,
                found,
            });
        }
        for (field, size) in [(Field::Width, header.width), (Field::Height, header.height)] {
            check_header_field(field, size.into(), 1, 2048)?;
        }

        let mut parts: [&[u8]; layout::SECTIONS] = [&[]; layout::SECTIONS];
        find_sections(bytes, rest, &mut parts)?;
        let scene = Self::of(header, &parts);
        scene.check_program()?;
        Ok(scene)
    }

    /// Palette entries in use and the indices that point to them.
    fn check_colours(&self) -> Result<(), SceneError> {
        let colours = self.palette.len();
        count(Section::Palette, colours, 2, 256)?;
        let (first, cycled) = self.header.cycle;
        let end = usize::from(first).saturating_add(cycled.into());
        if end > colours || (cycled != 0 && self.header.cycle_frames == 0) {
            return Err(SceneError::Header {
                field: Field::PaletteCycle,
                value: end as i64,
            });
        }
        count(Section::Background, self.background.len(), 1, 65535)?;
        let index_ok = |section, i, value: &u8| {
            range(
                section,
                i,
                Field::PaletteIndex,
                i64::from(*value),
                0,
                last(colours, 1),
            )
        };
        for (i, index) in self.background.iter().enumerate() {
            index_ok(Section::Background, i, index)?;
        }
        for (i, index) in self.shades.as_flattened().iter().enumerate() {
            index_ok(Section::Shades, i / 256, index)?;
        }
        count(Section::Colours, self.colours.len(), 0, 1)?;
        for (i, index) in self.colours.as_flattened().iter().enumerate() {
            index_ok(Section::Colours, i, index)?;
        }
        Ok(())
    }
}

fn check_header_field(field: Field, value: i64, least: i64, most: i64) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(SceneError::Header { field, value })
    }
}

fn check_header(header: &Header) -> Result<(), SceneError> {
    let check = check_header_field;
    let formats = ColourFormat::ALL.len();
    check(
        Field::ColourFormat,
        header.colour_format.into(),
        0,
        last(formats, 1),
    )?;
    let ways = PanelDithering::ALL.len();
    let way = header.panel_dithering.into();
    check(Field::PanelDithering, way, 0, last(ways, 1))?;
    let patterns = DitherPattern::ALL.len();
    let (pattern, spread) = (header.dither_pattern.into(), header.dither_spread.into());
    check(Field::Dither, pattern, 0, last(patterns, 1))?;
    check(Field::Dither, spread, 0, 128 << 6)?;
    match header.camera.out_of_range() {
        Some((field, value)) => Err(SceneError::Header { field, value }),
        None => Ok(()),
    }
}
