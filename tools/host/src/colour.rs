//! What a panel of a given colour depth makes of a colour.

use fixel::Scene;
use fixel::palette::{luma, rgb565};
use fixel::scene::{ColourFormat, PanelDithering};

/// The colours that a palette has for indices.
pub(crate) fn pixels(palette: &[[u8; 3]], indices: &[u8]) -> Vec<[u8; 3]> {
    let colour = |i: &u8| palette.get(usize::from(*i)).copied().unwrap_or_default();
    indices.iter().map(colour).collect()
}

/// The colour that the panel shows for an 8-bit colour, as 8 bits a channel.
pub fn shown(format: ColourFormat, colour: [u8; 3]) -> [u8; 3] {
    match format {
        ColourFormat::Rgb888 => colour,
        ColourFormat::Rgb565 => widened(rgb565(colour)),
        ColourFormat::Rgb444 => colour.map(|c| step(c, 15)),
        ColourFormat::Gray8 => [luma(colour); 3],
        ColourFormat::Gray4 => [step(luma(colour), 15); 3],
        ColourFormat::Gray2 => [step(luma(colour), 3); 3],
        ColourFormat::Mono => [step(luma(colour), 1); 3],
    }
}

/// A colour of 5, 6 and 5 bits as 8 bits a channel.
pub(crate) fn widened(bits: u16) -> [u8; 3] {
    let widen = |v: u16, most: u16| ((v * 255 + most / 2) / most) as u8;
    [
        widen(bits >> 11, 31),
        widen(bits >> 5 & 63, 63),
        widen(bits & 31, 31),
    ]
}

/// What the panel shows for each palette index in a frame of the animation.
pub fn colours(scene: &Scene<'_>, frame: u32) -> Vec<[u8; 3]> {
    let pose = scene.pose(frame);
    let palette = fixel::render::palette(scene, &pose);
    let format = scene.colour_format();
    palette.entries().map(|c| shown(format, c)).collect()
}

/// The same as it is held against the reference: on a panel that is dithered the grey from
/// which its pixels are made, as one of them alone says nothing.
pub(crate) fn before_dithering(scene: &Scene<'_>, frame: u32) -> Vec<[u8; 3]> {
    if scene.panel_dithering() == PanelDithering::None {
        return colours(scene, frame);
    }
    let pose = scene.pose(frame);
    let palette = fixel::render::palette(scene, &pose);
    let grey = |colour| shown(ColourFormat::Gray8, colour);
    palette.entries().map(grey).collect()
}

/// The nearest of `most + 1` steps.
pub(crate) fn step(c: u8, most: u32) -> u8 {
    ((u32::from(c) * most + 127) / 255 * 255 / most) as u8
}
