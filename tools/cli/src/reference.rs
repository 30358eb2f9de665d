//! The f64 reference, with progress.

use crate::progress::Progress;
use fixel_reference::{Options, Truth};
use fixel_scene::Scene;

/// Renders the truth.
pub fn render(scene: &Scene, options: Options) -> Truth {
    let progress = Progress::new("reference", u64::from(options.height));
    fixel_reference::render_watched(scene, options, &|| progress.step())
}
