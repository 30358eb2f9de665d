//! `fixel compare --report`: a page of figures and maps, for a browser.

use crate::output;
use anyhow::{Context, Result};
use fixel_reference::{Frame, Truth, heatmap};
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// What the page is about.
pub struct Page<'a> {
    /// The scene and the renderer.
    pub title: String,
    pub truth: &'a Truth,
    pub frame: &'a Frame,
    /// The figures, as `--json` has them: an object.
    pub figures: &'a Value,
}

/// A map: its file, and what is seen in it.
struct Map {
    file: &'static str,
    caption: &'static str,
    pixels: Vec<[u8; 3]>,
}

/// Writes `index.html` and its pictures into a folder, which is made if need be.
pub fn write(folder: &Path, page: &Page<'_>) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("cannot make the folder {}", folder.display()))?;
    let maps = maps(page)?;
    let Frame { width, height, .. } = *page.frame;
    for map in &maps {
        let png = output::png_rgb(width, height, &map.pixels)?;
        output::write(&folder.join(map.file), &png)?;
    }
    let html = html(page, &maps, width);
    output::write(&folder.join("index.html"), html.as_bytes())
}

fn maps(page: &Page<'_>) -> Result<Vec<Map>> {
    let heat = heatmap::draw(page.truth, page.frame)?;
    let byte = |channel: f64| (255.0 * channel).round() as u8;
    let map = |file, caption, pixels| Map {
        file,
        caption,
        pixels,
    };
    let mut maps = vec![
        map(
            "frame.png",
            "The frame, without dithering.",
            page.frame.rgb.clone(),
        ),
        map(
            "truth.png",
            "The truth, in full colour.",
            page.truth.colours().map(|c| c.map(byte)).collect(),
        ),
        map(
            "surfaces.png",
            "Surfaces: grey the same, blue equally near, red missing, magenta one too many, \
             yellow another.",
            heat.coverage,
        ),
        map(
            "depth.png",
            "Depth: black the same, white 4 units of 65535 off or more.",
            heat.depth,
        ),
        map(
            "light.png",
            "Light, where the surface is the same: black the same, white 8 of 255 off or more.",
            heat.level,
        ),
        map(
            "colour.png",
            "Colour against the truth in full colour: black the same, white 32 of 255 off or \
             more.",
            heat.colour,
        ),
    ];
    if !heat.shadow.is_empty() {
        maps.push(map(
            "shadows.png",
            "Shadows: the more lights get there the lighter, red a light missing, magenta one \
             too many.",
            heat.shadow,
        ));
    }
    Ok(maps)
}

fn html(page: &Page<'_>, maps: &[Map], width: u32) -> String {
    let title = escaped(&page.title);
    // Small pictures are shown larger, in whole steps.
    let shown = width * (480 / width).max(1);
    let mut text = format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{title}</title>\n\
         <style>\n\
         body {{ font: 15px/1.5 system-ui, sans-serif; margin: 2rem; color: #222; }}\n\
         main {{ display: flex; flex-wrap: wrap; gap: 1.5rem; }}\n\
         figure {{ margin: 0; width: {shown}px; }}\n\
         img {{ width: {shown}px; image-rendering: pixelated; display: block; }}\n\
         td {{ padding: 0 1rem 0 0; }}\n\
         td + td {{ text-align: right; font-variant-numeric: tabular-nums; }}\n\
         </style>\n<h1>{title}</h1>\n<main>\n"
    );
    for Map { file, caption, .. } in maps {
        let _ = writeln!(
            text,
            "<figure><img src=\"{file}\" alt=\"\"><figcaption>{caption}</figcaption></figure>"
        );
    }
    text += "</main>\n<h2>Figures</h2>\n<table>\n";
    for (name, value) in page.figures.as_object().into_iter().flatten() {
        let value = match value {
            Value::Array(pixels) if name == "mismatches" => format!("{} listed", pixels.len()),
            Value::String(text) => text.clone(),
            value => value.to_string(),
        };
        let _ = writeln!(text, "<tr><td>{name}</td><td>{}</td></tr>", escaped(&value));
    }
    text += "</table>\n</html>\n";
    text
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
