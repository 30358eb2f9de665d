//! `[[viewport]]`.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::camera::Shape;
use super::table::{Keys, Table};
use super::{camera, colour, many};
use crate::description::{Animation, Aspect, Camera, Target, Viewport};
use crate::error::Error;
use crate::framing::Bounds;

pub(super) const VIEWPORT: Keys = Keys {
    known: &["rectangle", "camera", "background", "aspect"],
    later: &[],
};

/// Most viewports of a scene.
const MOST: usize = 8;

const EXAMPLE: &str = "[0.7, 0.7, 0.3, 0.3]";

/// All viewports of a file, in its order.
pub(super) fn viewports(
    root: &Table<'_, '_>,
    bounds: &Bounds,
    shape: Shape,
    animation: &Animation,
) -> Result<Vec<Viewport>, Error> {
    let mut viewports = Vec::new();
    for (table, header) in many(root, "viewport")? {
        let start = header.start;
        let table = Table::new(root.source, "viewport", table, header, &VIEWPORT)?;
        if viewports.len() == MOST {
            let what = format!("viewport: is one too many; expected at most {MOST} [[viewport]]");
            return Err(root.source.error(start, what));
        }
        let target = Target::Viewport(viewports.len());
        viewports.push(viewport(&table, bounds, shape, (animation, target))?);
    }
    Ok(viewports)
}

/// Whether each viewport has a camera of its own.
pub(super) fn own_cameras(root: &Table<'_, '_>) -> Result<Vec<bool>, Error> {
    let viewports = many(root, "viewport")?;
    let own = |(table, _): &(&DeTable<'_>, Range<usize>)| table.contains_key("camera");
    Ok(viewports.iter().map(own).collect())
}

fn viewport(
    table: &Table<'_, '_>,
    bounds: &Bounds,
    shape: Shape,
    moves: (&Animation, Target),
) -> Result<Viewport, Error> {
    let rectangle = rectangle(table)?;
    let aspects = [("keep", Aspect::Keep), ("stretch", Aspect::Stretch)];
    let aspect = table.choice("aspect", &aspects, &[])?;
    let aspect = aspect.unwrap_or(Aspect::Keep);
    let [_, _, width, height] = match aspect {
        Aspect::Keep => rectangle,
        Aspect::Stretch => [0.0, 0.0, 1.0, 1.0],
    };
    let shape = Shape {
        aspect: shape.aspect * width / height,
        ..shape
    };
    Ok(Viewport {
        rectangle,
        camera: own_camera(table, bounds, shape, moves)?,
        background: colour::background(table, "background")?,
        aspect,
    })
}

fn own_camera(
    table: &Table<'_, '_>,
    bounds: &Bounds,
    shape: Shape,
    (animation, target): (&Animation, Target),
) -> Result<Option<Camera>, Error> {
    let Some(value) = table.get("camera") else {
        return Ok(None);
    };
    let DeValue::Table(inner) = value.get_ref() else {
        let what = "is not a table; expected [viewport.camera] below its [[viewport]]";
        return Err(table.error("camera", what));
    };
    let keys = &camera::CAMERA;
    let inner = Table::new(table.source, "viewport.camera", inner, value.span(), keys)?;
    camera::camera(Some(&inner), bounds, shape, animation, target).map(Some)
}

/// Within the picture, and not empty.
fn rectangle(table: &Table<'_, '_>) -> Result<[f64; 4], Error> {
    let expected = format!(
        "expected [x, y, width, height] in 0..=1 from the picture's lower left corner, \
         e.g. rectangle = {EXAMPLE}"
    );
    let Some(rectangle) = table.numbers("rectangle", super::LENGTH, EXAMPLE)? else {
        return Ok([0.0, 0.0, 1.0, 1.0]);
    };
    let [x, y, width, height] = rectangle;
    // 0.7 + 0.3 may be more than 1 in the last bit.
    let most = 1.0 + 1e-9;
    let wrong = if width <= 0.0 || height <= 0.0 {
        format!("{width} x {height} has no area")
    } else if x < 0.0 || y < 0.0 || x + width > most || y + height > most {
        format!("{rectangle:?} reaches beyond the picture")
    } else {
        return Ok(rectangle);
    };
    Err(table.error("rectangle", format!("{wrong}; {expected}")))
}
