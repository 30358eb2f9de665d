//! `[display]`.

use super::colour;
use super::table::{Keys, Table};
use crate::description::{Background, ColourFormat, Display, PanelDithering, Stereo};
use crate::error::Error;
use crate::panel::{DITHERINGS, PANELS, Panel};

pub(super) const DISPLAY: Keys = Keys {
    known: &[
        "width",
        "height",
        "colour",
        "dithering",
        "background",
        "panel",
        "antialiasing",
        "stereo",
        "eye_angle",
    ],
    later: &[],
};

const FORMATS: &[(&str, ColourFormat)] = &[
    ("rgb888", ColourFormat::Rgb888),
    ("rgb565", ColourFormat::Rgb565),
    ("rgb444", ColourFormat::Rgb444),
    ("gray8", ColourFormat::Gray8),
    ("gray4", ColourFormat::Gray4),
    ("gray2", ColourFormat::Gray2),
    ("mono", ColourFormat::Mono),
];

/// The display: width, height and colour given one by one win over the
/// panel's.
pub(super) fn display(table: Option<&Table<'_, '_>>) -> Result<Display, Error> {
    let mut display = Display {
        width: 320,
        height: 240,
        colour: ColourFormat::Rgb565,
        dithering: PanelDithering::None,
        background: Background::Solid([0.0; 3]),
        samples: [1, 1],
        stereo: Stereo::None,
    };
    let Some(table) = table else {
        return Ok(display);
    };
    if let Some(name) = table.text("panel", "st7789-240x240")? {
        let Some(panel) = Panel::named(name) else {
            let names: Vec<_> = PANELS.iter().map(|panel| panel.name).collect();
            return Err(table.error(
                "panel",
                format!(
                    "\"{name}\" is unknown; expected one of {}",
                    names.join(", ")
                ),
            ));
        };
        (display.width, display.height, display.colour) = (panel.width, panel.height, panel.colour);
    }
    if let Some(width) = table.whole("width", 1..=2048)? {
        display.width = width;
    }
    if let Some(height) = table.whole("height", 1..=2048)? {
        display.height = height;
    }
    if let Some(colour) = table.choice("colour", FORMATS, &[])? {
        display.colour = colour;
    }
    if let Some(dithering) = table.choice("dithering", DITHERINGS, &[])? {
        if dithering != PanelDithering::None && !display.colour.is_dithered() {
            let what = "is for grey panels of few levels; expected it beside colour = \"gray4\", \
                        \"gray2\" or \"mono\" (colours are dithered by palette.dithering)";
            return Err(table.error("dithering", what));
        }
        display.dithering = dithering;
    }
    if let Some(background) = colour::background(table, "background")? {
        display.background = background;
    }
    let samples = [
        ("none", [1, 1]),
        ("2x2", [2, 2]),
        ("2x1", [2, 1]),
        ("1x2", [1, 2]),
    ];
    if let Some(samples) = table.choice("antialiasing", &samples, &[])? {
        display.samples = samples;
    }
    display.stereo = stereo(table)?;
    let across = display.samples[0] * display.stereo.joined();
    let sides = [
        ("width", across, display.width),
        ("height", display.samples[1], display.height),
    ];
    for (key, times, size) in sides {
        if size * times > 2048 {
            let most = 2048 / times;
            return Err(table.error(
                key,
                format!(
                    "{size} is too much with anti-aliasing or an anaglyph, which draw {times} \
                     times as many pixels; expected at most {most}, e.g. {key} = {most}"
                ),
            ));
        }
    }
    Ok(display)
}

fn stereo(table: &Table<'_, '_>) -> Result<Stereo, Error> {
    let eye_angle = table.number("eye_angle", 0.01..=60.0)?;
    let angle = eye_angle.unwrap_or(EYE_ANGLE);
    let ways = [
        ("none", Stereo::None),
        ("anaglyph", Stereo::Anaglyph { eye_angle: angle }),
        ("side_by_side", Stereo::SideBySide { eye_angle: angle }),
    ];
    let stereo = table.choice("stereo", &ways, &[])?.unwrap_or(Stereo::None);
    if stereo == Stereo::None && eye_angle.is_some() {
        let what = "means nothing for one eye; expected e.g. stereo = \"anaglyph\" beside it";
        return Err(table.error("eye_angle", what));
    }
    Ok(stereo)
}

/// Degrees between the eyes: VTK's.
const EYE_ANGLE: f64 = 2.0;
