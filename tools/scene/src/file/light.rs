//! `[[light]]`.

use std::ops::RangeInclusive;

use super::annotation::places;
use super::colour::colour;
use super::table::{Keys, Neutral, Table};
use crate::description::{Attenuation, Light, LightKind, Rgb};
use crate::error::Error;

pub(super) const LIGHT: Keys = Keys {
    known: &[
        "kind",
        "direction",
        "position",
        "colour",
        "intensity",
        "attenuation",
        "cone_angle",
        "exponent",
        "edges",
    ],
    later: &[("focal_point", Neutral::Never)],
};

/// A cone of 90 degrees or more is not VTK's spot any more.
const CONE_ANGLE: RangeInclusive<f64> = 1.0..=89.0;
/// OpenGL's and VTK's narrowest beam.
const EXPONENT: RangeInclusive<f64> = 0.0..=128.0;
/// Attenuation's coefficients are at most this.
const ATTENUATION: f64 = 1e6;

/// One `[[light]]`.
pub(super) enum Parsed {
    /// Adds to the scene's ambient light.
    Ambient(Rgb),
    /// Any other.
    Light(Light),
}

#[derive(Clone, Copy)]
enum Kind {
    Directional,
    Ambient,
    Point,
    Spot,
}

impl Kind {
    const WORDS: [(&str, Self); 4] = [
        ("directional", Self::Directional),
        ("ambient", Self::Ambient),
        ("point", Self::Point),
        ("spot", Self::Spot),
    ];

    /// How a message calls a light of this kind, and the keys that it has no
    /// use for.
    fn useless(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Directional => (
                "a directional light",
                &["position", "attenuation", "cone_angle", "exponent", "edges"],
            ),
            Self::Ambient => (
                "an ambient light",
                &[
                    "direction",
                    "position",
                    "attenuation",
                    "cone_angle",
                    "exponent",
                    "edges",
                ],
            ),
            Self::Point => ("a point light", &["direction", "cone_angle", "exponent"]),
            Self::Spot => ("a spot light", &[]),
        }
    }
}

/// Reads one light.
pub(super) fn light(table: &Table<'_, '_>) -> Result<Parsed, Error> {
    let Some(kind) = table.choice("kind", &Kind::WORDS, &[])? else {
        let what = "is missing; expected e.g. kind = \"directional\" or kind = \"ambient\"";
        return Err(table.error("kind", what));
    };
    let (name, useless) = kind.useless();
    if let Some(key) = useless.iter().find(|key| table.has(key)) {
        return Err(table.error(key, format!("{name} has none; expected no such key")));
    }
    let colour = colour(table, "colour")?.unwrap_or([1.0; 3]);
    let intensity = table.number("intensity", 0.0..=32.0)?.unwrap_or(1.0);
    let kind = match kind {
        Kind::Ambient => return Ok(Parsed::Ambient(colour.map(|channel| channel * intensity))),
        Kind::Directional => LightKind::Directional {
            direction: direction(table)?,
        },
        Kind::Point => LightKind::Point {
            position: position(table)?,
            attenuation: attenuation(table)?,
        },
        Kind::Spot => LightKind::Spot {
            position: position(table)?,
            direction: direction(table)?,
            attenuation: attenuation(table)?,
            cone_angle: table.number("cone_angle", CONE_ANGLE)?.unwrap_or(30.0),
            exponent: table.number("exponent", EXPONENT)?.unwrap_or(1.0),
        },
    };
    Ok(Parsed::Light(Light {
        kind,
        colour,
        intensity,
        edges: edges(table)?,
    }))
}

fn direction(table: &Table<'_, '_>) -> Result<[f64; 3], Error> {
    let example = "[1, -1, -1]";
    match table.numbers("direction", super::LENGTH, example)? {
        None => Err(table.error(
            "direction",
            format!("is missing; expected the way the light travels, e.g. direction = {example}"),
        )),
        Some([0.0, 0.0, 0.0]) => Err(table.error(
            "direction",
            format!("has length 0; expected e.g. direction = {example}"),
        )),
        Some(direction) => Ok(direction),
    }
}

fn position(table: &Table<'_, '_>) -> Result<[f64; 3], Error> {
    let example = "[0, 4, 2]";
    table
        .numbers("position", super::LENGTH, example)?
        .ok_or_else(|| {
            table.error(
                "position",
                format!("is missing; expected the light's place, e.g. position = {example}"),
            )
        })
}

fn edges(table: &Table<'_, '_>) -> Result<Option<[[f64; 3]; 2]>, Error> {
    let example = "[[1, 0, 0], [0, 0, 1]]";
    if !table.has("edges") {
        return Ok(None);
    }
    let found = places(table, "edges", (3, super::LENGTH), example)?;
    match found.as_slice() {
        [first, second] => Ok(Some([*first, *second])),
        _ => {
            let what = format!("has {} edges where 2 belong", found.len());
            Err(table.error("edges", format!("{what}; expected e.g. edges = {example}")))
        }
    }
}

fn attenuation(table: &Table<'_, '_>) -> Result<Attenuation, Error> {
    let example = "[1, 0, 0.1]";
    let Some(found) = table.numbers("attenuation", ATTENUATION, example)? else {
        return Ok([1.0, 0.0, 0.0]);
    };
    let expected = format!(
        "expected [constant, linear, quadratic] of 1 / (c + l d + q d^2), \
         e.g. attenuation = {example}"
    );
    if let Some(negative) = found.iter().find(|number| **number < 0.0) {
        return Err(table.error(
            "attenuation",
            format!("{negative} is less than 0; {expected}"),
        ));
    }
    if found == [0.0; 3] {
        return Err(table.error(
            "attenuation",
            format!("all three are 0, which is light without end; {expected}"),
        ));
    }
    Ok(found)
}
