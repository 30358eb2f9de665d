//! `[palette]`.

use toml::Spanned;
use toml::de::DeValue;

use super::table::{Keys, Table};
use super::{colour::colour, many, palette_file};
use crate::description::{Dithering, Palette, Ramp};
use crate::error::Error;

pub(super) const PALETTE: Keys = Keys {
    known: &["colours", "file", "ramps", "dithering", "direct"],
    later: &[],
};

pub(super) const RAMP: Keys = Keys {
    known: &["from", "to", "steps"],
    later: &[],
};

const RAMP_EXAMPLE: &str = "{ from = \"#000000\", to = \"#ff8800\", steps = 16 }";

/// The palette; 256 entries of the baker's choice by default.
pub(super) fn palette(table: Option<&Table<'_, '_>>) -> Result<Palette, Error> {
    let mut palette = Palette::default();
    let Some(table) = table else {
        return Ok(palette);
    };
    palette.direct = table.boolean("direct")?.unwrap_or(false);
    if palette.direct
        && let Some(key) = ["colours", "file", "ramps"]
            .into_iter()
            .find(|key| table.has(key))
    {
        let what = "does not go with direct = true, which has no palette; expected one of the two";
        return Err(table.error(key, what));
    }
    let example = "palettes/warm.gpl";
    if let Some(name) = table.text("file", example)? {
        if let Some(key) = ["colours", "ramps"].into_iter().find(|key| table.has(key)) {
            let what = "does not go with file, which has all entries; expected one of the two";
            return Err(table.error(key, what));
        }
        palette.fixed = palette_file::read(table.source.origin, name)
            .map_err(|what| table.file_error("file", name, &what, example))?;
        palette.colours = palette.fixed.len() as u32;
    }
    if let Some(colours) = table.whole("colours", 2..=256)? {
        palette.colours = colours;
    }
    palette.ramps = ramps(table)?;
    let steps: u32 = palette.ramps.iter().map(|ramp| ramp.steps).sum();
    if steps > palette.colours {
        let most = palette.colours;
        let what = format!("have {steps} steps together; expected at most {most}, as colours says");
        return Err(table.error("ramps", what));
    }
    let words = [
        ("none", Dithering::None),
        ("bayer4", Dithering::Bayer4),
        ("bayer8", Dithering::Bayer8),
    ];
    if let Some(dithering) = table.choice("dithering", &words, &[])? {
        palette.dithering = dithering;
    }
    Ok(palette)
}

fn ramps(table: &Table<'_, '_>) -> Result<Vec<Ramp>, Error> {
    let is_list = |value: &Spanned<DeValue<'_>>| matches!(value.get_ref(), DeValue::Array(_));
    if table.get("ramps").is_some_and(|value| !is_list(value)) {
        let what = format!("is not a list; expected e.g. ramps = [{RAMP_EXAMPLE}]");
        return Err(table.error("ramps", what));
    }
    let ramp = |(ramp, header)| {
        let ramp = Table::new(table.source, "palette.ramps", ramp, header, &RAMP)?;
        let missing = |key| ramp.error(key, format!("is missing; expected e.g. {RAMP_EXAMPLE}"));
        Ok(Ramp {
            from: colour(&ramp, "from")?.ok_or_else(|| missing("from"))?,
            to: colour(&ramp, "to")?.ok_or_else(|| missing("to"))?,
            steps: ramp
                .whole("steps", 2..=256)?
                .ok_or_else(|| missing("steps"))?,
        })
    };
    many(table, "ramps")?.into_iter().map(ramp).collect()
}
