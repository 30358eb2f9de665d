//! Viewports in the blob's records.

use fixel::scene::{self as core_scene, FULL_SIDE};
use fixel_scene::{Aspect, Scene};

use crate::BakeError;
use crate::records::camera;
use crate::units::Units;

/// Each viewport's record; `backgrounds` are their own ones' indices, which stand
/// one after the other in a section.
pub(crate) fn viewports(
    scene: &Scene,
    units: &Units,
    backgrounds: &[Vec<u8>],
) -> Result<Vec<core_scene::Viewport>, BakeError> {
    let mut first = 0;
    let mut all = Vec::new();
    for (viewport, background) in scene.viewports.iter().zip(backgrounds) {
        let [x, y, width, height] = viewport.rectangle;
        // From the lower left corner to the upper left one.
        let sides = [x, 1.0 - (y + height), x + width, 1.0 - y];
        let part = |side: f64| (side.clamp(0.0, 1.0) * f64::from(FULL_SIDE)).round() as u32;
        let own = viewport.camera.as_ref();
        all.push(core_scene::Viewport {
            sides: sides.map(part),
            stretch: viewport.aspect == Aspect::Stretch,
            camera: own.map(|own| camera(own, units)).transpose()?,
            background: (first, background.len() as u16),
        });
        first += background.len() as u16;
    }
    Ok(all)
}
