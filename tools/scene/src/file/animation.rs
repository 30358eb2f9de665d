//! `[animation]` and its `[[animation.key]]`.

use std::collections::BTreeMap;

use super::actor::find;
use super::camera::{MOVES, move_number, pan};
use super::many;
use super::table::{Keys, Table};
use toml::de::DeValue;

use crate::description::{Actor, Animation, Key, Palette, PaletteCycle, Quantity, Target, Track};
use crate::error::Error;

pub(super) const ANIMATION: Keys = Keys {
    known: &["turntable", "frames", "key", "palette_cycle"],
    later: &[],
};

pub(super) const KEY: Keys = Keys {
    known: &[
        "actor",
        "viewport",
        "frame",
        "position",
        "focal_point",
        "orientation",
        "scale",
        "azimuth",
        "elevation",
        "roll",
        "dolly",
        "zoom",
        "pan",
    ],
    later: &[],
};

pub(super) const CYCLE: Keys = Keys {
    known: &["first", "last", "frames"],
    later: &[],
};

/// Most frames of an animation.
const MOST: u32 = 100_000;
/// What a key calls the camera.
const CAMERA: &str = "camera";

/// Keys as they come, by what they move.
type Found = BTreeMap<(Target, Quantity), Vec<Key>>;

/// What moves; nothing by default. `own` says of each viewport whether it has a camera
/// of its own.
pub(super) fn animation(
    table: Option<&Table<'_, '_>>,
    actors: &[Actor],
    own: &[bool],
    palette: &Palette,
) -> Result<Animation, Error> {
    let Some(table) = table else {
        return Ok(Animation::default());
    };
    let turntable = table.whole("turntable", 1..=MOST)?;
    let frames = table.whole("frames", 1..=MOST)?;
    let mut found = Found::new();
    for (key, header) in many(table, "key")? {
        let key = Table::new(table.source, "animation.key", key, header, &KEY)?;
        read(&key, frames.unwrap_or(MOST), actors, own, &mut found)?;
    }
    let last = found.values().flatten().map(|key| key.frame).max();
    let track = |((target, quantity), mut keys): (_, Vec<Key>)| {
        keys.sort_by_key(|key| key.frame);
        Track {
            target,
            quantity,
            keys,
        }
    };
    Ok(Animation {
        turntable,
        frames: frames.or(last.map(|last| last + 1)),
        tracks: found.into_iter().map(track).collect(),
        palette_cycle: palette_cycle(table, palette)?,
    })
}

fn palette_cycle(table: &Table<'_, '_>, palette: &Palette) -> Result<Option<PaletteCycle>, Error> {
    let Some(value) = table.get("palette_cycle") else {
        return Ok(None);
    };
    let example = "{ first = 0, last = 15, frames = 32 }";
    let DeValue::Table(inner) = value.get_ref() else {
        let what = format!("is not a table; expected e.g. palette_cycle = {example}");
        return Err(table.error("palette_cycle", what));
    };
    let name = "animation.palette_cycle";
    let inner = Table::new(table.source, name, inner, value.span(), &CYCLE)?;
    let need = |key, range| {
        let missing = || {
            let what = format!("is missing; expected e.g. palette_cycle = {example}");
            inner.error(key, what)
        };
        inner.whole(key, range)?.ok_or_else(missing)
    };
    let most = palette.colours - 1;
    let first = need("first", 0..=most - 1)?;
    Ok(Some(PaletteCycle {
        first,
        last: need("last", first + 1..=most)?,
        frames: need("frames", 1..=MOST)?,
    }))
}

/// One key: each thing that it names is a key of its own track.
fn read(
    table: &Table<'_, '_>,
    frames: u32,
    actors: &[Actor],
    own: &[bool],
    found: &mut Found,
) -> Result<(), Error> {
    let Some(name) = table.text("actor", "arm")? else {
        let what = "is missing; expected the name of an [[actor]], or actor = \"camera\"";
        return Err(table.error("actor", what));
    };
    let target = match viewport(table, own)? {
        Some(viewport) if name == CAMERA => Target::Viewport(viewport),
        Some(_) => {
            let what = "says nothing of an actor; expected it beside actor = \"camera\"";
            return Err(table.error("viewport", what));
        }
        None if name == CAMERA => Target::Camera,
        None => Target::Actor(find(table, "actor", name, actors)?),
    };
    if name == CAMERA && actors.iter().any(|actor| actor.name == CAMERA) {
        let what = "is the name of an actor and means the camera; expected another name for it";
        return Err(table.error("actor", format!("\"{CAMERA}\" {what}")));
    }
    let Some(frame) = table.whole("frame", 0..=frames)? else {
        return Err(table.error("frame", "is missing; expected e.g. frame = 12"));
    };
    let mut values: Vec<(&str, Quantity, [f64; 3])> = Vec::new();
    for (key, quantity, limit, example) in [
        ("position", Quantity::Position, super::LENGTH, "[0, 1, 5]"),
        (
            "focal_point",
            Quantity::FocalPoint,
            super::LENGTH,
            "[0, 1, 0]",
        ),
        (
            "orientation",
            Quantity::Orientation,
            super::TURNS,
            "[0, 90, 0]",
        ),
    ] {
        let numbers = table.numbers::<3>(key, limit, example)?;
        values.extend(numbers.map(|value| (key, quantity, value)));
    }
    for (key, quantity) in [("scale", Quantity::Scale)].into_iter().chain(MOVES) {
        let number = move_number(table, key, quantity)?;
        values.extend(number.map(|number| (key, quantity, [number, 0.0, 0.0])));
    }
    let pan = pan(table)?;
    values.extend(pan.map(|[right, up]| ("pan", Quantity::Pan, [right, up, 0.0])));
    if values.is_empty() {
        return Err(table.error("frame", "a key that moves nothing; expected e.g. position"));
    }
    for (key, quantity, value) in values {
        let of_actor = matches!(
            quantity,
            Quantity::Position | Quantity::Orientation | Quantity::Scale
        );
        let of_camera = !matches!(quantity, Quantity::Orientation | Quantity::Scale);
        let (has, whose) = match target {
            Target::Camera | Target::Viewport(_) => (of_camera, "the camera"),
            Target::Actor(_) => (of_actor, "an actor"),
        };
        if !has {
            return Err(table.error(key, format!("{whose} has none; expected no such key")));
        }
        let keys = found.entry((target, quantity)).or_default();
        if keys.iter().any(|key| key.frame == frame) {
            let what = format!("\"{name}\" has it in frame {frame} already; expected it once");
            return Err(table.error(key, what));
        }
        keys.push(Key { frame, value });
    }
    Ok(())
}

/// The viewport whose camera a key moves, if it is not the scene's.
fn viewport(table: &Table<'_, '_>, own: &[bool]) -> Result<Option<usize>, Error> {
    let Some(number) = table.whole("viewport", 0..=MOST)? else {
        return Ok(None);
    };
    let wrong = match own.get(number as usize) {
        Some(true) => return Ok(Some(number as usize)),
        Some(false) => "has no camera of its own; expected [viewport.camera] below it".to_owned(),
        None => format!(
            "is not there, the file has {}; expected e.g. viewport = 0 for the first [[viewport]]",
            own.len()
        ),
    };
    Err(table.error("viewport", format!("viewport {number} {wrong}")))
}
