//! What a scene's figures are held to.

use fixel_reference::Report;

use crate::problem::{Problem, Result};

/// Most pixels whose coverage may differ, as a share of the covered ones, and
/// always one pixel.
const COVERAGE_PERCENT: f64 = 0.02;
/// Most that places in textures are off in the mean, in texels.
const TEXELS: f64 = 0.25;
/// Fewest agreeing pixels, in percent, whose depth is within one unit.
const DEPTH_WITHIN_1_PERCENT: f64 = 99.9;
/// Fewest agreeing pixels, in percent, whose light is within 2 of 255.
const LEVEL_WITHIN_2_PERCENT: f64 = 99.0;
/// Least PSNR against the truth through the same palette.
const SAME_PALETTE_DB: f64 = 40.0;
/// Least PSNR against the unquantised truth: a palette without the colours that a scene
/// shows does not come near it.
const TRUE_DB: f64 = 30.0;
/// Least PSNR of a scene of one material against the unquantised truth, on a
/// display with 8 bits a channel: 16-bit colour alone costs all but 42 dB.
const PSNR_DB: f64 = 45.0;
/// Least PSNR of a scene without a palette against the unquantised truth, at 16 bits: the
/// rounding to them costs all but 42 dB, and what is mixed is rounded twice.
const DIRECT_DB: f64 = 40.0;

/// Of a scene with level of detail, whose coarser meshes are off by half a pixel: most pixels
/// whose coverage may differ, as a share of the covered ones.
const LOD_COVERAGE_PERCENT: f64 = 0.5;
/// Most that light is off in the mean there, of 255.
const LOD_LEVEL: f64 = 2.0;

/// Of the ray caster: most pixels that show another surface, as a share of the picture,
/// and always one pixel.
const RAY_SURFACE_PERCENT: f64 = 0.01;
/// Most pixels with a wrong shadow, as a share of the lit ones, and always one.
const RAY_SHADOW_PERCENT: f64 = 0.1;

/// A scene's figures, and what of the scene says which limits hold.
pub struct Held {
    /// What was compared.
    pub report: Report,
    /// PSNR against the unquantised truth on a display of 8 bits a channel.
    pub rgb888_psnr_db: f64,
    /// It has one material, in whose colours the palette can be exact.
    pub one_material: bool,
    /// Colours are as they are lit, but for what 16 bits leave of them.
    pub without_palette: bool,
    /// By triangles, it is drawn with coarser meshes from afar.
    pub lod: bool,
}

impl Held {
    /// The rasteriser's limits.
    pub fn by_triangles(&self) -> Result<()> {
        if self.lod {
            lod_limits(&self.report)
        } else {
            limits(self)
        }
    }

    /// The ray caster's; what is known of a scene counts as missing.
    pub fn by_rays(&self, scene: &str) -> Result<()> {
        ray_limits(&self.report).map_err(|problem| known(scene, problem))
    }
}

fn all_held(broken: &[String]) -> Result<()> {
    if broken.is_empty() {
        return Ok(());
    }
    Err(broken.join("; ").into())
}

/// Scenes that the ray caster cannot draw within the limits, and why.
const RAY_KNOWN: [(&str, &str); 2] = [
    (
        "mono_bunny",
        "two pixels of 8,192: of triangles smaller than a pixel so many edges pass pixels' centres \
         that one within a step of the mesh's grid is no rarity",
    ),
    (
        "suzanne",
        "a face four pixels wide that lies edge-on to the light to within a step of the mesh's \
         grid: whether it is lit at all hangs on that",
    ),
];

/// A problem that is known is none of the code as it is.
fn known(scene: &str, problem: Problem) -> Problem {
    match (RAY_KNOWN.iter().find(|(name, _)| *name == scene), problem) {
        (Some((_, why)), Problem::Failed(what)) => Problem::Missing(format!("{what}: {why}")),
        (_, problem) => problem,
    }
}

fn ray_limits(report: &Report) -> Result<()> {
    let mut broken = Vec::new();
    let share = |count: usize, percent: f64| (count as f64 * percent / 100.0).max(1.0);
    let pixels = (report.width * report.height) as usize;
    let others = report.coverage_mismatch_px + report.visible_mismatch_px;
    if others as f64 > share(pixels, RAY_SURFACE_PERCENT) {
        broken.push(format!("another surface on {others} of {pixels} pixels"));
    }
    if report.depth_within_1_percent < DEPTH_WITHIN_1_PERCENT {
        let percent = report.depth_within_1_percent;
        broken.push(format!("depth is within 1 unit on {percent:.2} % only"));
    }
    let (wrong, lit) = (report.shadow_mismatch_px, report.lit_px);
    if wrong as f64 > share(lit, RAY_SHADOW_PERCENT) {
        broken.push(format!("wrong shadows on {wrong} of {lit} lit pixels"));
    }
    if report.shadow_mismatch_clusters > 0 {
        let clusters = report.shadow_mismatch_clusters;
        broken.push(format!("{clusters} clusters of wrong shadows"));
    }
    broken.extend(far_from_truth(report));
    all_held(&broken)
}

/// Colour through the same palette, if it is broken.
fn far_from_truth(report: &Report) -> Option<String> {
    let db = report.rgb_psnr_db;
    (db < SAME_PALETTE_DB).then(|| format!("colour through the same palette at {db:.1} dB only"))
}

fn limits(held: &Held) -> Result<()> {
    let report = &held.report;
    let allowed = (report.covered_px as f64 * COVERAGE_PERCENT / 100.0).max(1.0);
    let mut broken = Vec::new();
    if report.coverage_mismatch_px as f64 > allowed {
        broken.push(format!(
            "coverage differs on {} of {} pixels",
            report.coverage_mismatch_px, report.covered_px
        ));
    }
    if report.depth_within_1_percent < DEPTH_WITHIN_1_PERCENT {
        broken.push(format!(
            "depth is within 1 unit on {:.2} % only",
            report.depth_within_1_percent
        ));
    }
    if report.level_within_2_percent < LEVEL_WITHIN_2_PERCENT {
        broken.push(format!(
            "light is within 2 of 255 on {:.2} % only",
            report.level_within_2_percent
        ));
    }
    broken.extend(far_from_truth(report));
    if report.rgb_psnr_true_db < TRUE_DB {
        let db = report.rgb_psnr_true_db;
        broken.push(format!(
            "colour at {db:.1} dB of the unquantised truth only"
        ));
    }
    if report.texel_mean > TEXELS {
        broken.push(format!(
            "places in textures are {:.2} texels off",
            report.texel_mean
        ));
    }
    if held.one_material && held.rgb888_psnr_db < PSNR_DB {
        broken.push(format!("colour at {:.1} dB only", held.rgb888_psnr_db));
    }
    let true_db = report.rgb_psnr_true_db;
    if held.without_palette && true_db < DIRECT_DB {
        broken.push(format!("colour without a palette at {true_db:.1} dB only"));
    }
    all_held(&broken)
}

/// Of a scene with level of detail: depth and light are those of other surfaces.
fn lod_limits(report: &Report) -> Result<()> {
    let mut broken = Vec::new();
    if report.coverage_mismatch_percent > LOD_COVERAGE_PERCENT {
        let percent = report.coverage_mismatch_percent;
        broken.push(format!("coverage differs on {percent:.2} %"));
    }
    if report.level_mean > LOD_LEVEL {
        let mean = report.level_mean;
        broken.push(format!("light is off by {mean:.2} of 255 in the mean"));
    }
    broken.extend(far_from_truth(report));
    all_held(&broken)
}

#[cfg(test)]
mod tests;
