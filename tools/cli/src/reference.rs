//! The f64 reference, with progress.

use crate::progress::Progress;
use fixel_reference::{Options, Truth};
use fixel_scene::Scene;

/// Renders the truth.
pub fn render(scene: &Scene, options: Options) -> Truth {
    let progress = Progress::new("reference", u64::from(options.height));
    fixel_reference::render_watched(scene, options, &|| progress.step())
}

/// Renders the truth about what rays see.
pub fn render_rays(scene: &Scene, options: Options) -> Truth {
    let progress = Progress::new("ray reference", u64::from(options.height));
    fixel_reference::render_rays_watched(scene, options, &|| progress.step())
}

/// Samples of a pixel, across and down, that stand for all of it.
const MANY: [u32; 2] = [8, 8];

/// The true picture: of an anti-aliased scene with 64 samples a pixel, otherwise that
/// of `truth`.
pub fn picture(scene: &Scene, options: Options, truth: &Truth) -> Vec<[u8; 3]> {
    if scene.display.samples == [1, 1] {
        return truth.picture();
    }
    let mut scene = scene.clone();
    scene.display.samples = MANY;
    render(&scene, options).picture()
}
