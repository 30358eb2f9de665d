//! Viewports in the blob's records.

use fixel::scene::{self as core_scene, FULL_SIDE, Output};
use fixel_scene::{Aspect, Display, Element, Scene, Stereo};

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
    for (number, (viewport, background)) in scene.viewports.iter().zip(backgrounds).enumerate() {
        let [x, y, width, height] = viewport.rectangle;
        // From the lower left corner to the upper left one.
        let sides = [x, 1.0 - (y + height), x + width, 1.0 - y];
        let part = |side: f64| (side.clamp(0.0, 1.0) * f64::from(FULL_SIDE)).round() as u32;
        let own = viewport.camera.as_ref();
        all.push(core_scene::Viewport {
            sides: sides.map(part),
            stretch: viewport.aspect == Aspect::Stretch,
            camera: own
                .map(|own| camera(own, Element::Viewport(number), units))
                .transpose()?,
            background: (first, background.len() as u16),
        });
        first += background.len() as u16;
    }
    Ok(all)
}

/// How the picture comes of the frame; nothing if it is the frame.
pub(crate) fn output(scene: &Scene) -> Option<Output> {
    let Display {
        samples, stereo, ..
    } = scene.display;
    let slope = libm::tan((stereo.eye_angle() / 2.0).to_radians());
    let output = Output {
        samples: samples.map(|n| n as u8),
        stereo: match stereo {
            Stereo::None => core_scene::Stereo::None,
            Stereo::Anaglyph { .. } => core_scene::Stereo::Anaglyph,
            Stereo::SideBySide { .. } => core_scene::Stereo::SideBySide,
        },
        eye_slope: ((slope * f64::from(1 << 30)).round() as i32).min(Output::MOST_SLOPE),
    };
    (output != Output::PLAIN).then_some(output)
}
