//! The core's pictures held against the f64 reference, on every scene.

use std::fs;
use std::path::{Path, PathBuf};

use fixel_bake::BakeError;
use fixel_reference::Report;
use fixel_scene::{ColourFormat, Scene};
use serde_json::{Map, Value, json};

use crate::problem::{Problem, Result};
use crate::report::{Tally, table};
use crate::{parallel, paths};

/// Most pixels whose coverage may differ, as a share of the covered ones, and
/// always one pixel.
const COVERAGE_PERCENT: f64 = 0.02;
/// Most that places in textures are off in the mean, in texels.
const TEXELS: f64 = 0.25;
/// Fewest agreeing pixels, in percent, whose depth is within one unit.
const DEPTH_WITHIN_1_PERCENT: f64 = 99.9;
/// Least PSNR of a scene of one material against the unquantised truth, on a
/// display with 8 bits a channel: 16-bit colour alone costs all but 42 dB.
const PSNR_DB: f64 = 45.0;

/// A scene's figures.
struct Compared {
    report: Report,
    /// The PSNR that is held to a limit, if it is.
    rgb888_psnr_db: f64,
    one_material: bool,
}

/// Compares every scene in `scenes/`, `scenes/bench/` and `scenes/ray/`, frame 0, at its own
/// size. Gives `{"scene": {"raster": {...}}}` with the fields of `fixel
/// compare --json`, and `rgb888_psnr_true_db`, the colour on a display with 8
/// bits a channel. Each scene is held to limits.
pub fn run(tally: &mut Tally) -> Result<Value> {
    let files = files()?;
    let compared = parallel::map(&files, |file| compare(file));
    let mut all = Map::new();
    for (file, compared) in files.iter().zip(compared) {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let what = format!("accuracy of {name}");
        let Some(compared) = tally.need(&what, compared) else {
            continue;
        };
        tally.check(&what, limits(&compared));
        let report = serde_json::to_value(&compared.report);
        let mut report = report.map_err(|error| error.to_string())?;
        report["rgb888_psnr_true_db"] = json!(compared.rgb888_psnr_db);
        all.insert(name.into(), json!({ "raster": report }));
    }
    Ok(all.into())
}

/// Scene files, by name.
fn files() -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for folder in ["scenes", "scenes/bench", "scenes/ray"] {
        let folder = paths::root().join(folder);
        let fail = |error| format!("{}: {error}", folder.display());
        for entry in fs::read_dir(&folder).map_err(fail)? {
            let path = entry.map_err(fail)?.path();
            if path
                .extension()
                .is_some_and(|extension| extension == "toml")
            {
                files.push(path);
            }
        }
    }
    files.sort_by_key(|file| file.file_stem().map(ToOwned::to_owned));
    Ok(files)
}

fn compare(file: &Path) -> Result<Compared> {
    let mut scene = fixel_scene::load(file).map_err(|error| error.to_string())?;
    let in_file = |problem: Problem| match problem {
        Problem::Missing(text) => Problem::Missing(format!("{}: {text}", file.display())),
        Problem::Failed(text) => Problem::Failed(format!("{}: {text}", file.display())),
    };
    let report = report(&scene).map_err(in_file)?;
    scene.display.colour = ColourFormat::Rgb888;
    let rgb888 = self::report(&scene).map_err(in_file)?;
    Ok(Compared {
        report,
        rgb888_psnr_db: rgb888.rgb_psnr_true_db,
        one_material: scene.materials.len() == 1,
    })
}

fn report(scene: &Scene) -> Result<Report> {
    let baked = fixel_bake::bake(scene).map_err(|error| match error {
        BakeError::NotYet { .. } => Problem::Missing(error.to_string()),
        _ => Problem::Failed(error.to_string()),
    })?;
    let core = fixel::Scene::parse(baked.bytes()).map_err(|error| error.to_string())?;
    let options = fixel_host::Options::of(&core);
    let (frame, _) = fixel_host::frame(&baked, &core, &options);
    let at = fixel_reference::Options {
        width: options.width.into(),
        height: options.height.into(),
        frame: options.frame,
    };
    let truth = fixel_reference::render(scene, at);
    let report = fixel_reference::compare(&truth, &frame).map_err(|error| error.to_string())?;
    Ok(report)
}

fn limits(compared: &Compared) -> Result<()> {
    let report = &compared.report;
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
    if report.texel_mean > TEXELS {
        broken.push(format!(
            "places in textures are {:.2} texels off",
            report.texel_mean
        ));
    }
    if compared.one_material && compared.rgb888_psnr_db < PSNR_DB {
        broken.push(format!("colour at {:.1} dB only", compared.rgb888_psnr_db));
    }
    if broken.is_empty() {
        Ok(())
    } else {
        Err(broken.join("; ").into())
    }
}

/// The README's table.
pub fn markdown(figures: &Value) -> String {
    let scenes = figures.as_object().into_iter().flatten();
    let rows: Vec<Vec<String>> = scenes
        .map(|(name, figures)| {
            let field = |field: &str| &figures["raster"][field];
            let whole = |name| field(name).as_u64().unwrap_or_default().to_string();
            let real = |name| format!("{:.2}", field(name).as_f64().unwrap_or_default());
            vec![
                name.clone(),
                whole("covered_px"),
                whole("coverage_mismatch_px"),
                whole("visible_mismatch_px"),
                real("depth_max_lsb"),
                real("depth_within_1_percent"),
                real("level_max"),
                real("rgb_psnr_true_db"),
                real("rgb888_psnr_true_db"),
            ]
        })
        .collect();
    let head = [
        "scene",
        "covered px",
        "coverage differs, px",
        "other triangle, px",
        "depth, max of 65535",
        "within 1, %",
        "light, max of 255",
        "colour, dB",
        "with 8 bits a channel",
    ];
    format!(
        "Against the f64 reference; `cargo xtask accuracy`.\n\n{}",
        table(&head, &rows)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compared(mismatch: usize, depth: f64, psnr: f64) -> Compared {
        let report = json!({
            "width": 320, "height": 240, "covered_px": 20_000,
            "coverage_mismatch_px": mismatch, "depth_max_lsb": 1.0, "depth_mean_lsb": 0.25,
            "visible_mismatch_px": 0, "level_max": 1.0, "level_mean": 0.3,
            "rgb_psnr_db": 60.0, "rgb_psnr_true_db": psnr, "index_equal_percent": 90.0,
            "agreeing_px": 20_000, "coverage_mismatch_percent": 0.0,
            "depth_within_1_percent": depth, "level_within_2_percent": 100.0,
            "rgb_psnr_true_covered_db": psnr, "depth_max_at": null, "level_max_at": null,
            "mismatches": [],
        });
        Compared {
            report: serde_json::from_value(report).expect("every field is there"),
            rgb888_psnr_db: psnr,
            one_material: true,
        }
    }

    #[test]
    fn each_limit_can_be_broken() {
        assert!(limits(&compared(4, 99.9, 45.0)).is_ok());
        assert!(limits(&compared(5, 99.9, 45.0)).is_err());
        assert!(limits(&compared(4, 99.8, 45.0)).is_err());
        assert!(limits(&compared(4, 99.9, 44.9)).is_err());
    }
}
