//! What of an actor is drawn: keys that `[[actor]]` and the annotations share.

use super::table::Table;
use crate::error::Error;
use crate::look::{Anchor, Font, Look, Mark, Representation, Shape, Side};

/// Depth units that annotations lie nearer than they are, if the file does not
/// say: what lies on a surface differs from it by the rounding of both.
pub(super) const BIAS: u32 = 2;

/// An actor's look.
pub(super) fn look(table: &Table<'_, '_>) -> Result<Look, Error> {
    let representations = [
        ("surface", Representation::Surface),
        ("wireframe", Representation::Wireframe),
        ("hidden_line", Representation::HiddenLine),
        ("points", Representation::Points),
    ];
    let mut look = Look::default();
    if let Some(representation) = table.choice("representation", &representations, &[])? {
        look.representation = representation;
    }
    for (key, needed) in [
        ("line_width", ["wireframe", "hidden_line"].as_slice()),
        ("point_size", &["points"]),
        ("point_shape", &["points"]),
    ] {
        let named = |(word, which): &(&str, Representation)| {
            *which == look.representation && needed.contains(word)
        };
        if table.has(key) && !representations.iter().any(named) {
            let needed = needed.join("\" or representation = \"");
            return Err(table.error(
                key,
                format!("says nothing here; expected it with representation = \"{needed}\""),
            ));
        }
    }
    look.line_width = table.whole("line_width", 1..=16)?.unwrap_or(1);
    look.mark = shape(table, "point_shape", "point_size", (Shape::Square, 2))?;
    Ok(look)
}

/// A marker's shape and size.
pub(super) fn shape(
    table: &Table<'_, '_>,
    shape_key: &str,
    size_key: &str,
    (shape, size): (Shape, u32),
) -> Result<Mark, Error> {
    let shapes = [
        ("dot", Shape::Dot),
        ("square", Shape::Square),
        ("plus", Shape::Plus),
        ("cross", Shape::Cross),
        ("circle", Shape::Circle),
        ("diamond", Shape::Diamond),
        ("triangle", Shape::Triangle),
    ];
    Ok(Mark::Shape {
        shape: table.choice(shape_key, &shapes, &[])?.unwrap_or(shape),
        size: table.whole(size_key, 1..=32)?.unwrap_or(size),
    })
}

/// A text's letters and anchor.
pub(super) fn text(table: &Table<'_, '_>, text: &str) -> Result<Mark, Error> {
    let fonts = [
        ("6x10", Font::F6x10),
        ("4x6", Font::F4x6),
        ("5x8", Font::F5x8),
        ("7x13", Font::F7x13),
        ("9x15", Font::F9x15),
        ("10x20", Font::F10x20),
    ];
    let anchor = |horizontal, vertical| Anchor {
        horizontal,
        vertical,
    };
    let (start, middle, end) = (Side::Start, Side::Middle, Side::End);
    let anchors = [
        ("top_left", anchor(start, start)),
        ("top", anchor(middle, start)),
        ("top_right", anchor(end, start)),
        ("left", anchor(start, middle)),
        ("centre", anchor(middle, middle)),
        ("right", anchor(end, middle)),
        ("bottom_left", anchor(start, end)),
        ("bottom", anchor(middle, end)),
        ("bottom_right", anchor(end, end)),
    ];
    let font = table.choice("font", &fonts, &[])?;
    let place = table.choice("anchor", &anchors, &[])?;
    Ok(Mark::Text {
        text: text.to_owned(),
        font: font.unwrap_or(Font::F6x10),
        anchor: place.unwrap_or(anchor(start, start)),
    })
}
