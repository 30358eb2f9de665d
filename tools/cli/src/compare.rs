//! `fixel compare`.

use crate::args::{Destination, Tested};
use crate::{args, input, output, raster, reference};
use anyhow::{Context, Result};
use fixel_reference::Report;
use fixel_report::Page;
use serde::Serialize;

/// A report and what it is about.
#[derive(Serialize)]
struct Comparison<'a> {
    scene: String,
    renderer: &'static str,
    frame: u32,
    /// The picture as the panel shows it against the true one (of an anti-aliased
    /// scene, with 64 samples a pixel).
    picture_psnr_db: f64,
    #[serde(flatten)]
    report: &'a Report,
}

/// Renders a frame twice and reports how they differ.
pub fn run(args: &args::Compare) -> Result<()> {
    let renderer = match args.renderer {
        Tested::Raster => "raster",
        Tested::Ray => "ray",
    };
    let json = args.json.as_ref().and_then(Destination::file);
    let input = input::load(&args.input, &[json])?;
    let at = input::options(&input.scene, &args.frame);
    let options = raster::Options {
        rays: args.renderer == Tested::Ray,
        width: at.width,
        height: at.height,
        frame: at.frame,
        bands: args.bands,
    };
    let name = || args.input.scene.display().to_string();
    let scene = input.scene.clone();
    let truth = match args.renderer {
        Tested::Raster => reference::render(&scene, at),
        Tested::Ray => reference::render_rays(&scene, at),
    };
    let rendered = raster::render(input, options)?;
    let report = fixel_reference::compare(&truth, &rendered.frame).with_context(name)?;
    let true_picture = reference::picture(&scene, at, &truth);
    let picture_psnr_db = fixel_reference::psnr_db(&rendered.picture, &true_picture);
    let comparison = Comparison {
        scene: name(),
        renderer,
        frame: at.frame,
        picture_psnr_db,
        report: &report,
    };
    if let Some(destination) = &args.json {
        output::json(destination, &comparison)?;
    }
    if let Some(folder) = &args.report {
        let page = fixel_report::page(&Page {
            title: format!("{} by {renderer}, frame {}", name(), at.frame),
            truth: &truth,
            frame: &rendered.frame,
            figures: &serde_json::to_value(&comparison)?,
            index: None,
        })?;
        std::fs::create_dir_all(folder)
            .with_context(|| format!("cannot make the folder {}", folder.display()))?;
        let path = folder.join("index.html");
        output::write(&path, page.as_bytes())?;
        eprintln!("wrote {}", path.display());
    }
    if args.json == Some(Destination::Stdout) {
        Ok(())
    } else {
        let picture = format!("picture     {picture_psnr_db:.2} dB as the panel shows it\n");
        output::stdout(&(summary(&report) + &picture))
    }
}

/// The figures for a reader.
fn summary(report: &Report) -> String {
    let at = |at: Option<[u32; 2]>| at.map_or(String::new(), |[x, y]| format!(" at {x}, {y}"));
    let mut text = format!(
        "size        {} x {} px, {} covered\n\
         coverage    {} px differ ({:.4} %)\n\
         visible     {} px show another triangle\n\
         lines       {} px hang on rounding, left out\n\
         depth       max {:.2}{}, mean {:.3}, {:.2} % within 1 of 65535\n\
         light       max {:.2}{}, mean {:.3}, {:.2} % within 2 of 255\n\
         colour      {:.2} dB, {:.2} dB against the unquantised truth\n\
         index       {:.2} % equal\n",
        report.width,
        report.height,
        report.covered_px,
        report.coverage_mismatch_px,
        report.coverage_mismatch_percent,
        report.visible_mismatch_px,
        report.line_doubt_px,
        report.depth_max_lsb,
        at(report.depth_max_at),
        report.depth_mean_lsb,
        report.depth_within_1_percent,
        report.level_max,
        at(report.level_max_at),
        report.level_mean,
        report.level_within_2_percent,
        report.rgb_psnr_db,
        report.rgb_psnr_true_db,
        report.index_equal_percent,
    );
    if report.texel_max > 0.0 {
        text += &format!(
            "texture     max {:.3}, mean {:.4} texels off\n",
            report.texel_max, report.texel_mean
        );
    }
    if report.lit_px > 0 {
        text += &format!(
            "shadows     {} of {} lit px differ, {} clusters\n",
            report.shadow_mismatch_px, report.lit_px, report.shadow_mismatch_clusters
        );
    }
    let shown = |what: Option<[usize; 2]>| match what {
        Some([actor, triangle]) => format!("triangle {triangle} of actor {actor}"),
        None => "nothing".into(),
    };
    for m in &report.mismatches {
        text += &format!(
            "  {:?} at {}, {}: the reference shows {}, the frame {}\n",
            m.kind,
            m.x,
            m.y,
            shown(m.truth),
            shown(m.frame)
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn report() -> Report {
        serde_json::from_value(json!({
            "width": 8, "height": 4, "covered_px": 16, "coverage_mismatch_px": 1,
            "depth_max_lsb": 1.25, "depth_mean_lsb": 0.25, "visible_mismatch_px": 2,
            "level_max": 3.5, "level_mean": 0.5, "rgb_psnr_db": 999.0,
            "rgb_psnr_true_db": 48.5, "index_equal_percent": 93.75, "agreeing_px": 13,
            "coverage_mismatch_percent": 6.25, "depth_within_1_percent": 90.0,
            "level_within_2_percent": 80.0, "rgb_psnr_true_covered_db": 47.0,
            "depth_max_at": [3, 2], "level_max_at": null,
            "texel_max": 0.5, "texel_mean": 0.125,
            "lit_px": 12, "shadow_mismatch_px": 5, "shadow_mismatch_clusters": 1,
            "mismatches": [{
                "x": 5, "y": 1, "kind": "extra", "truth": null, "frame": [0, 7],
                "truth_depth_lsb": 0.0, "frame_depth_lsb": 99
            }]
        }))
        .unwrap()
    }

    #[test]
    fn json_is_one_flat_object() {
        let report = report();
        let comparison = Comparison {
            scene: "a.toml".into(),
            renderer: "raster",
            frame: 3,
            picture_psnr_db: 40.0,
            report: &report,
        };
        let object = serde_json::to_value(&comparison).unwrap();
        assert_eq!(object["scene"], "a.toml");
        assert_eq!(
            (&object["frame"], &object["covered_px"]),
            (&json!(3), &json!(16))
        );
        assert_eq!(object["rgb_psnr_db"], 999.0);
    }

    #[test]
    fn the_summary_has_every_figure() {
        let text = summary(&report());
        for wanted in [
            "8 x 4 px, 16 covered",
            "1 px differ (6.2500 %)",
            "2 px show another triangle",
            "max 1.25 at 3, 2, mean 0.250, 90.00 % within 1",
            "max 3.50, mean 0.500, 80.00 % within 2",
            "999.00 dB, 48.50 dB",
            "93.75 % equal",
            "max 0.500, mean 0.1250 texels",
            "5 of 12 lit px differ, 1 clusters",
            "Extra at 5, 1: the reference shows nothing, the frame triangle 7 of actor 0",
        ] {
            assert!(text.contains(wanted), "{wanted} in {text}");
        }
    }
}
