//! What a scene takes on a microcontroller, as far as it follows from sizes alone.

use std::mem::size_of;

use fixel::Scene;
use fixel::ray::RayScratch;
use fixel::render::Scratch;
use fixel_scene::{ColourFormat, Panel};

/// Rows in a band of the firmware that the page describes.
pub(crate) fn band_rows(rays: bool) -> u32 {
    if rays { 4 } else { 16 }
}

/// Working memory as the snippet has it. Pointers have 32 bits here as there.
pub(crate) type Work = Scratch<64, 10, 4>;
/// The same of the ray caster.
pub(crate) type RayWork = RayScratch<4>;

/// Bytes of RAM of the program that the snippet is, without the stack of its functions: a
/// band, the working memory, and what turns indices into the panel's pixels.
pub(crate) fn ram_bytes(scene: &Scene<'_>, panel: &Panel, rays: bool) -> usize {
    let (width, height) = scene
        .output()
        .frame_size((panel.width as u16, panel.height as u16));
    let rows = (band_rows(rays) as usize).min(height.into());
    let stored = if scene.is_direct() { 2 } else { 1 };
    let band = usize::from(width) * rows * (stored + 2);
    let work = if rays {
        size_of::<RayWork>()
    } else {
        size_of::<Work>()
    };
    let resolved = scene.output().is_resolved();
    let sums = if resolved {
        panel.width as usize * 4
    } else {
        0
    };
    let out = match panel.colour {
        ColourFormat::Gray4 => panel.width as usize / 2,
        ColourFormat::Mono => panel.width as usize,
        _ if scene.is_direct() => 0,
        _ if resolved => panel.width as usize * 2,
        // A colour for each index, and whether there is one.
        _ => 256 * 4,
    };
    band + work + sums + out
}
