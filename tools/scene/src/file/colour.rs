//! Colours as a scene file writes them.

use toml::Spanned;
use toml::de::DeValue;

use super::table::Table;
use crate::description::{Background, Rgb};
use crate::error::Error;

/// `"#rrggbb"` as display-encoded red, green, blue in 0..=1.
fn parse(text: &str) -> Option<Rgb> {
    let bytes = digits(text.strip_prefix('#')?)?;
    Some(bytes.map(|byte| f64::from(byte) / 255.0))
}

/// `"rrggbb"` as 8 bits a channel.
pub(super) fn digits(digits: &str) -> Option<[u8; 3]> {
    if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let value = u32::from_str_radix(digits, 16).ok()?;
    Some([16, 8, 0].map(|shift| (value >> shift) as u8))
}

/// A colour as a scene file writes it.
pub(super) fn text(colour: Rgb) -> String {
    let [red, green, blue] = colour.map(|channel| (channel * 255.0).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn value(table: &Table<'_, '_>, key: &str, value: &DeValue<'_>) -> Result<Rgb, Error> {
    let found = match value {
        DeValue::String(text) => match parse(text) {
            Some(colour) => return Ok(colour),
            None => format!("\"{text}\" is not a colour"),
        },
        _ => "is not a colour".to_owned(),
    };
    Err(table.error(key, format!("{found}; expected e.g. {key} = \"#ff8800\"")))
}

/// A colour.
pub(super) fn colour(table: &Table<'_, '_>, key: &str) -> Result<Option<Rgb>, Error> {
    table
        .get(key)
        .map(|found| value(table, key, found.get_ref()))
        .transpose()
}

/// One colour, or two for a vertical gradient.
pub(super) fn background(table: &Table<'_, '_>, key: &str) -> Result<Option<Background>, Error> {
    let Some(found) = table.get(key) else {
        return Ok(None);
    };
    let DeValue::Array(array) = found.get_ref() else {
        return Ok(Some(Background::Solid(value(table, key, found.get_ref())?)));
    };
    let ends: Vec<_> = array.iter().map(Spanned::get_ref).collect();
    let [top, bottom] = ends[..] else {
        return Err(table.error(
            key,
            format!(
                "has {} colours where 2 belong; expected e.g. {key} = [\"#204060\", \"#000000\"]",
                ends.len()
            ),
        ));
    };
    Ok(Some(Background::Gradient {
        top: value(table, key, top)?,
        bottom: value(table, key, bottom)?,
    }))
}
