//! One scene by one renderer.

use fixel_reference::heatmap::{self, COLOUR_FULL, DEPTH_FULL, LEVEL_FULL};
use fixel_reference::{Frame, FrameError, Truth};
use serde_json::Value;

use crate::histogram::histogram;
use crate::picture::address;
use crate::style::head;
use crate::{escaped, figures};

/// What the page is about.
#[derive(Debug)]
pub struct Page<'a> {
    /// The scene and the renderer.
    pub title: String,
    /// What is right.
    pub truth: &'a Truth,
    /// What was drawn.
    pub frame: &'a Frame,
    /// The figures, as `fixel compare --json` has them: an object.
    pub figures: &'a Value,
    /// Where the index is, if there is one.
    pub index: Option<&'a str>,
}

/// The page.
///
/// # Errors
/// If frame and truth do not fit together.
pub fn page(page: &Page<'_>) -> Result<String, FrameError> {
    let mut html = head(&escaped(&page.title));
    html += "<p>A frame in fixed point against a reference in double precision. Point at a \
             picture to see the other of frame and truth in its place.</p>\n";
    if let Some(index) = page.index {
        html += &format!("<p><a href=\"{}\">All scenes</a></p>\n", escaped(index));
    }
    html += &keys(page.figures);
    html += "<main>\n";
    html += &pictures(page)?;
    html += "</main>\n<h2>How far off how many pixels are</h2>\n\
             <p>Bars grow with the logarithm of the count; the last one holds all that is \
             farther off. Point at a bar for its figures.</p>\n<main>\n";
    html += &histograms(page)?;
    html += "</main>\n<h2>Figures</h2>\n<div class=\"scroll\">\n";
    html += &figures::table(page.figures);
    html += "</div>\n";
    html += &figures::mismatches(page.figures);
    Ok(html + "</html>\n")
}

/// The figures that one looks for first.
fn keys(figures: &Value) -> String {
    let all = [
        ("coverage_mismatch_px", "px differ in coverage", 0),
        ("visible_mismatch_px", "px show another triangle", 0),
        (
            "depth_within_1_percent",
            "% with depth within 1 of 65535",
            2,
        ),
        ("level_within_2_percent", "% with light within 2 of 255", 2),
        ("shadow_mismatch_px", "px with a wrong shadow", 0),
        ("rgb_psnr_true_db", "dB against full colour", 1),
    ];
    let mut html = String::from("<div class=\"key\">");
    for (name, what, digits) in all {
        if name == "shadow_mismatch_px" && figures["lit_px"] == 0 {
            continue;
        }
        if let Some(value) = figures::shown(&figures[name], digits) {
            html += &format!("<div><b>{value}</b><span>{what}</span></div>");
        }
    }
    html + "</div>\n"
}

fn pictures(page: &Page<'_>) -> Result<String, FrameError> {
    let Frame { width, height, .. } = *page.frame;
    let heat = heatmap::draw(page.truth, page.frame)?;
    let byte = |channel: f64| (255.0 * channel).round() as u8;
    let truth: Vec<[u8; 3]> = page.truth.colours().map(|c| c.map(byte)).collect();
    let address = |rgb: &[[u8; 3]]| address(width, height, rgb);
    let (frame, truth) = (address(&page.frame.rgb), address(&truth));
    let image = |name: &str, address: &str| {
        format!("<img src=\"{address}\" width=\"{width}\" height=\"{height}\" alt=\"{name}\">")
    };
    let both = |name: &str, caption: &str, first: &str, second: &str| {
        format!(
            "<figure><div class=\"both\" tabindex=\"0\">{}{}</div>\
             <figcaption><b>{name}.</b> {caption}</figcaption></figure>\n",
            image(name, first),
            image("The other one", second)
        )
    };
    let mut html = both("Frame", "Without dithering.", &frame, &truth);
    html += &both("Truth", "In full colour.", &truth, &frame);
    let ramp = |full: f64, of: &str| {
        format!("<span class=\"ramp\"></span> from the same to {full} of {of} off or more.")
    };
    let dot = |colour: &str, what: &str| {
        format!("<span class=\"dot\" style=\"background:{colour}\"></span> {what} ")
    };
    let surfaces = dot("#46464c", "the same,")
        + &dot("#3c5aa0", "equally near,")
        + &dot("#ff3c28", "missing,")
        + &dot("#ff00ff", "one too many,")
        + &dot("#ffd200", "another.");
    let lights = dot("#c8c8c8", "the more lights the lighter,")
        + &dot("#ff3c28", "a light missing,")
        + &dot("#ff00ff", "one too many.");
    let colour = ramp(COLOUR_FULL, "255") + " Against full colour.";
    let maps = [
        ("Surfaces", surfaces, &heat.coverage),
        ("Depth", ramp(DEPTH_FULL, "65535"), &heat.depth),
        ("Light", ramp(LEVEL_FULL, "255"), &heat.level),
        ("Colour", colour, &heat.colour),
        ("Shadows", lights, &heat.shadow),
    ];
    for (name, caption, rgb) in maps.iter().filter(|(.., rgb)| !rgb.is_empty()) {
        html += &format!(
            "<figure>{}<figcaption><b>{name}.</b> {caption}</figcaption></figure>\n",
            image(name, &address(rgb))
        );
    }
    Ok(html)
}

fn histograms(page: &Page<'_>) -> Result<String, FrameError> {
    let off = heatmap::differences(page.truth, page.frame)?;
    let depth = histogram(off.depth.into_iter().flatten(), DEPTH_FULL, "of 65535");
    let light = histogram(off.level.into_iter().flatten(), LEVEL_FULL, "of 255");
    let colour = histogram(off.colour.into_iter(), COLOUR_FULL, "of 255");
    let all = [
        (
            "Depth",
            "units of 65535, where both show the same triangle",
            depth,
        ),
        ("Light", "of 255, where both show the same triangle", light),
        ("Colour", "the worst channel, of 255, on all pixels", colour),
    ];
    let figure = |(name, caption, svg): &(&str, &str, String)| {
        format!("<figure>{svg}<figcaption><b>{name}</b>: {caption}.</figcaption></figure>\n")
    };
    Ok(all.iter().map(figure).collect())
}
