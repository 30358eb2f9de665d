//! `[display]`.

use super::colour;
use super::panel::PANELS;
use super::table::{Keys, Neutral, Table};
use crate::description::{Background, ColourFormat, Display};
use crate::error::Error;

pub(super) const DISPLAY: Keys = Keys {
    known: &["width", "height", "colour", "background", "panel"],
    later: &[
        ("antialiasing", Neutral::Text("none")),
        ("stereo", Neutral::Text("none")),
    ],
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
        background: Background::Solid([0.0; 3]),
    };
    let Some(table) = table else {
        return Ok(display);
    };
    if let Some(name) = table.text("panel", "st7789-240x240")? {
        let found = PANELS.iter().find(|(panel, ..)| *panel == name);
        let Some((_, width, height, colour)) = found else {
            let names: Vec<_> = PANELS.iter().map(|(panel, ..)| *panel).collect();
            return Err(table.error(
                "panel",
                format!(
                    "\"{name}\" is unknown; expected one of {}",
                    names.join(", ")
                ),
            ));
        };
        (display.width, display.height, display.colour) = (*width, *height, *colour);
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
    if let Some(background) = colour::background(table, "background")? {
        display.background = background;
    }
    Ok(display)
}
