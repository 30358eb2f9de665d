//! `[fog]`.

use super::colour;
use super::table::{Keys, Table};
use crate::description::{Fog, FogMode};
use crate::error::Error;

pub(super) const FOG: Keys = Keys {
    known: &["colour", "mode", "start", "end", "density"],
    later: &[],
};

#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Linear,
    Exponential,
    ExponentialSquared,
}

/// Reads the fog.
pub(super) fn fog(table: &Table<'_, '_>) -> Result<Fog, Error> {
    let modes = [
        ("linear", Mode::Linear),
        ("exponential", Mode::Exponential),
        ("exponential_squared", Mode::ExponentialSquared),
    ];
    let mode = table.choice("mode", &modes, &[])?;
    let mode = mode.unwrap_or(Mode::Linear);
    let start = table.number("start", 0.0..=super::LENGTH)?;
    let end = table.number("end", 0.0..=super::LENGTH)?;
    let density = table.number("density", super::FACTOR)?;
    let stray = match mode {
        Mode::Linear => ["density"].as_slice(),
        _ => ["start", "end"].as_slice(),
    };
    for key in stray {
        if table.has(key) {
            let expected = match mode {
                Mode::Linear => "expected e.g. start = 10, end = 100, or mode = \"exponential\"",
                _ => "expected e.g. density = 0.02, or mode = \"linear\"",
            };
            return Err(table.error(key, format!("means nothing here; {expected}")));
        }
    }
    let needed = |key: &str, value: Option<f64>, example: f64| {
        let missing = || table.error(key, format!("is missing; expected e.g. {key} = {example}"));
        value.ok_or_else(missing)
    };
    let mode = match mode {
        Mode::Linear => {
            let (start, end) = (start.unwrap_or(0.0), needed("end", end, 100.0)?);
            if end <= start {
                let what = format!("{end} is not beyond start {start}");
                let example = "start = 10, end = 100";
                return Err(table.error("end", format!("{what}; expected e.g. {example}")));
            }
            FogMode::Linear { start, end }
        }
        Mode::Exponential => FogMode::Exponential {
            density: needed("density", density, 0.02)?,
        },
        Mode::ExponentialSquared => FogMode::ExponentialSquared {
            density: needed("density", density, 0.02)?,
        },
    };
    let Some(colour) = colour::colour(table, "colour")? else {
        let what = "is missing; expected e.g. colour = \"#c0c8d0\"";
        return Err(table.error("colour", what));
    };
    Ok(Fog { colour, mode })
}
