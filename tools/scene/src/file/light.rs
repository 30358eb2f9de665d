//! `[[light]]`.

use super::colour::light_colour;
use super::table::{Keys, Neutral, Table};
use crate::description::{Light, LightKind, Rgb};
use crate::error::Error;

pub(super) const LIGHT: Keys = Keys {
    known: &["kind", "direction", "colour", "intensity"],
    later: &[
        ("position", Neutral::Never),
        ("focal_point", Neutral::Never),
        ("attenuation", Neutral::Never),
        ("cone_angle", Neutral::Never),
        ("exponent", Neutral::Never),
        ("radius", Neutral::Number(0.0)),
        ("shadow", Neutral::Never),
    ],
};

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
}

/// The kind is looked at before the other keys, so that a light of a later
/// kind is named as such, not by the first of its keys.
pub(super) fn check_kind(kind: Option<&str>) -> Result<(), String> {
    match kind {
        Some(kind @ ("point" | "spot" | "area")) => Err(format!(
            "\"{kind}\" is not supported yet; expected \"directional\" or \"ambient\""
        )),
        _ => Ok(()),
    }
}

/// Reads one light.
pub(super) fn light(table: &Table<'_, '_>) -> Result<Parsed, Error> {
    let kinds = [
        ("directional", Kind::Directional),
        ("ambient", Kind::Ambient),
    ];
    let Some(kind) = table.choice("kind", &kinds, &[])? else {
        return Err(table.error(
            "kind",
            "is missing; expected kind = \"directional\" or kind = \"ambient\"",
        ));
    };
    let colour = light_colour(table, "colour")?;
    let intensity = table.number("intensity", 0.0..=100.0)?.unwrap_or(1.0);
    let example = "[1, -1, -1]";
    let direction = table.numbers::<3>("direction", super::LENGTH, example)?;
    match (kind, direction) {
        (Kind::Ambient, None) => Ok(Parsed::Ambient(colour.map(|channel| channel * intensity))),
        (Kind::Ambient, Some(_)) => Err(table.error(
            "direction",
            "an ambient light has none; expected no such key",
        )),
        (Kind::Directional, None) => Err(table.error(
            "direction",
            format!("is missing; expected the way the light travels, e.g. direction = {example}"),
        )),
        (Kind::Directional, Some([0.0, 0.0, 0.0])) => Err(table.error(
            "direction",
            format!("has length 0; expected e.g. direction = {example}"),
        )),
        (Kind::Directional, Some(direction)) => Ok(Parsed::Light(Light {
            kind: LightKind::Directional { direction },
            colour,
            intensity,
        })),
    }
}
