//! What there is to choose from.

use fixel_scene::{ColourFormat, DITHERINGS, Feed, PANELS, Panel};
use serde_json::{Value, json};

use crate::boards;
use crate::samples::SAMPLES;

/// Panels that the page offers: names in the scene format, and what people call them.
const OFFERED: [(&str, &str); 9] = [
    ("st7789-240x240", "ST7789"),
    ("st7789-320x240", "ST7789"),
    ("st7735-160x128", "ST7735"),
    ("ssd1306-128x64", "SSD1306 OLED"),
    ("ssd1327-128x128", "SSD1327 OLED"),
    ("sharp-400x240", "Sharp memory LCD"),
    ("ssd1681-200x200", "E-paper, SSD1681"),
    ("gba-240x160", "Game Boy Advance"),
    ("gc9a01-240x240", "GC9A01, round"),
];

/// The two colours that a grey panel's black and white look like, for the page alone.
fn look(panel: &Panel) -> Option<[&'static str; 2]> {
    match family(panel) {
        "ssd1306" => Some(["#04070c", "#7fd8ff"]),
        "ssd1327" => Some(["#060606", "#fbf6e8"]),
        "sharp" => Some(["#1c2124", "#c3c9bd"]),
        "ssd1681" => Some(["#2a2927", "#e9e6dc"]),
        _ => None,
    }
}

/// What the panel sits in, for the page alone.
fn case(panel: &Panel) -> Option<&'static str> {
    match family(panel) {
        "ssd1681" => Some("paper"),
        "gc9a01" => Some("round"),
        boards::GBA => Some("handheld"),
        _ => None,
    }
}

/// The controller that a panel is named after.
fn family(panel: &Panel) -> &'static str {
    panel.name.split('-').next().unwrap_or_default()
}

/// Panels, boards, dithering and samples.
pub(crate) fn catalogue() -> Value {
    let panels = OFFERED.iter().filter_map(|(name, title)| {
        let panel = Panel::named(name)?;
        let (hz, settle_ms) = match panel.feed {
            Feed::Serial { hz, settle_ms, .. } => (hz, settle_ms),
            Feed::Memory { .. } => (0, 0),
        };
        Some(json!({
            "name": name,
            "title": format!("{title}, {}x{}", panel.width, panel.height),
            "width": panel.width,
            "height": panel.height,
            "colours": colours(panel.colour),
            "dithered": panel.colour.is_dithered(),
            "mono": panel.colour == ColourFormat::Mono,
            "case": case(panel),
            "look": look(panel),
            "bus_hz": hz,
            "settle_ms": settle_ms,
            "frame_bits": panel.frame_bits(),
            "frame_seconds": panel.frame_seconds(),
            "board": (family(panel) == boards::GBA).then_some(boards::GBA),
        }))
    });
    let samples = SAMPLES
        .iter()
        .map(|sample| json!({ "title": sample.title, "path": sample.path, "mono": sample.mono }));
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "boards": boards::boards(),
        "panels": panels.collect::<Vec<_>>(),
        "ditherings": DITHERINGS.iter().map(|(name, _)| *name).collect::<Vec<_>>(),
        "samples": samples.collect::<Vec<_>>(),
    })
}

fn colours(format: ColourFormat) -> &'static str {
    match format {
        ColourFormat::Rgb888 => "24-bit colour",
        ColourFormat::Rgb565 => "16-bit colour",
        ColourFormat::Rgb444 => "12-bit colour",
        ColourFormat::Gray8 => "256 greys",
        ColourFormat::Gray4 => "16 greys",
        ColourFormat::Gray2 => "4 greys",
        ColourFormat::Mono => "black and white",
    }
}

/// The panel of a name; any that scenes may name, not only those that are offered.
pub(crate) fn panel(name: &str) -> Result<Panel, String> {
    let known = || PANELS.iter().map(|panel| panel.name).collect::<Vec<_>>();
    let unknown = || {
        format!(
            "no panel is called {name}; expected one of {}",
            known().join(", ")
        )
    };
    Panel::named(name).copied().ok_or_else(unknown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_that_is_offered_is_there() {
        let catalogue = catalogue();
        let panels = catalogue["panels"].as_array().map(Vec::len);
        assert_eq!(panels, Some(OFFERED.len()));
    }
}
