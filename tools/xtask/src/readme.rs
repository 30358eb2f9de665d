//! The README's tables, made from the figures.

use std::fs;

use serde_json::Value;

use crate::problem::Result;
use crate::report::{Tally, table};
use crate::{accuracy, bench, footprint, paths, peers, scene};

/// Takes all figures and writes the README's tables anew, between the comments
/// that name them.
pub fn run() -> Result<()> {
    let mut tally = Tally::default();
    let bench = bench::run(&mut tally, &[])?;
    let footprint = footprint::run(&mut tally)?;
    let accuracy = accuracy::run(&mut tally, None)?;
    let parts = [
        ("summary", summary(&bench, &footprint, &accuracy)),
        ("bench", bench::markdown(&bench)),
        ("accuracy", accuracy::markdown(&accuracy)),
        ("footprint", footprint::markdown(&footprint)),
    ];
    for (name, part) in parts {
        replace("README.md", name, &part)?;
    }
    eprintln!("{}", tally.summary());
    tally.result()
}

/// Writes a part of a page anew, between the comments that name it.
pub fn replace(page: &str, name: &str, part: &str) -> Result<()> {
    let path = paths::root().join(page);
    let text = fs::read_to_string(&path).map_err(|error| format!("{page}: {error}"))?;
    let text = replaced(&text, name, part)?;
    Ok(fixel_output::write(&path, text.as_bytes())?)
}

/// The text with what stands between a part's comments replaced.
fn replaced(text: &str, name: &str, part: &str) -> Result<String> {
    let (begin, end) = (
        format!("<!-- {name} -->"),
        format!("<!-- end of {name} -->"),
    );
    let cut = || {
        let (before, rest) = text.split_once(&begin)?;
        let (_, after) = rest.split_once(&end)?;
        Some(format!(
            "{before}{begin}\n{}\n{end}{after}",
            part.trim_end()
        ))
    };
    cut().ok_or_else(|| format!("there is no part between `{begin}` and `{end}`").into())
}

/// The first screen's table: speed, RAM and accuracy beside the alternatives.
fn summary(bench: &Value, footprint: &Value, accuracy: &Value) -> String {
    let name = "w3_bunny_gouraud";
    let millions =
        |board: &str, field: &str| bench[name][board][field].as_f64().unwrap_or_default() / 1e6;
    let speed = |board: &str| {
        let (whole, bands) = ("instructions", "instructions_bands16");
        format!(
            "{:.2} ({:.2} in 16-row bands)",
            millions(board, whole),
            millions(board, bands)
        )
    };
    let peer = peers::find(name);
    let peer_speed = |m4f: bool| {
        let text = peer.map(|p| if m4f { p.cortex_m4f } else { p.cortex_m0plus });
        text.unwrap_or("-").to_owned()
    };
    let kilobytes = |field: &str| {
        let bytes = footprint[name]["cortex-m0plus"][field]
            .as_f64()
            .unwrap_or_default();
        format!("{:.1} KB", bytes / 1000.0)
    };
    // Levels of detail show other surfaces than the reference, on purpose.
    let whole = |name: &str| {
        let scene = fixel_scene::load(&scene::file(name));
        scene.is_ok_and(|scene| scene.lod.is_none())
    };
    let scenes = accuracy.as_object().into_iter().flatten();
    let scenes: Vec<&Value> = scenes
        .filter(|(name, _)| whole(name))
        .map(|(_, figures)| &figures["raster"])
        .collect();
    let wrong: Vec<u64> = scenes
        .iter()
        .filter_map(|s| s["coverage_mismatch_px"].as_u64())
        .collect();
    let within = scenes
        .iter()
        .filter_map(|s| s["depth_within_1_percent"].as_f64());
    let rows = [
        [
            "**Speed**, bunny, Gouraud, 320x240, Cortex-M4F: millions of instructions a frame"
                .to_owned(),
            speed("cortex-m4f"),
            peer_speed(true),
        ],
        [
            "the same on Cortex-M0+".into(),
            speed("cortex-m0plus"),
            peer_speed(false),
        ],
        [
            "**RAM** for a 320x240 frame with depth, M0+".into(),
            format!(
                "{} + {} stack",
                kilobytes("static_ram_bytes"),
                kilobytes("stack_bytes")
            ),
            "231 to 462 KB".into(),
        ],
        [
            "**Code** and tables, M0+".into(),
            kilobytes("code_bytes"),
            "6.3 to 8.2 KB small3dlib, 35 to 50 KB tgx, 63 KB embedded-3dgfx".into(),
        ],
        [
            format!(
                "**Coverage**, {} scenes without level of detail against an f64 reference",
                wrong.len()
            ),
            match wrong.iter().max() {
                None | Some(0) => "no wrong pixel in any".into(),
                Some(most) => format!(
                    "no wrong pixel in {}, at most {most} in the others",
                    wrong.iter().filter(|n| **n == 0).count()
                ),
            },
            "1.4 % too many (embedded-3dgfx)".into(),
        ],
        [
            "**Depth** within 1 of 65,535".into(),
            format!(
                "{:.2} % of the pixels or more",
                within.fold(100.0, f64::min)
            ),
            "".into(),
        ],
    ];
    let rows: Vec<Vec<String>> = rows.into_iter().map(Vec::from).collect();
    table(&["", "fixel today", "the best alternative"], &rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_replaced_and_the_rest_stays() {
        let text = "a\n<!-- x -->\nold\n<!-- end of x -->\nb\n";
        let new = replaced(text, "x", "new\n");
        assert_eq!(
            new.ok().as_deref(),
            Some("a\n<!-- x -->\nnew\n<!-- end of x -->\nb\n")
        );
        assert!(replaced(text, "y", "new").is_err());
    }
}
