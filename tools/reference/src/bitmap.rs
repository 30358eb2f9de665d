//! The pixels of marks: shapes, pictures of one bit, letters. In: a [`Mark`]. Out: a
//! [`Bitmap`], which `overlay` puts at each point.

use crate::letters;
use fixel_scene::{Mark, Shape};

/// A mark's pixels.
pub(crate) struct Bitmap {
    /// Added to a point's place, what the first column and row round down from.
    pub corner: [f64; 2],
    pub pixels: Vec<[i64; 2]>,
}

pub(crate) fn bitmap(mark: &Mark) -> Bitmap {
    match mark {
        Mark::Shape { shape, size } => {
            let half = f64::from(*size) / 2.0;
            let all =
                (0..i64::from(*size)).flat_map(|y| (0..i64::from(*size)).map(move |x| [x, y]));
            Bitmap {
                corner: [0.5 - half; 2],
                pixels: all
                    .filter(|[x, y]| {
                        let from_middle = |c: i64| c as f64 + 0.5 - half;
                        in_shape(*shape, f64::from(*size), from_middle(*x), from_middle(*y))
                    })
                    .collect(),
            }
        }
        Mark::Bitmap { size, offset, rows } => {
            let bytes = rows.chunks(usize::from(size[0]).div_ceil(8).max(1));
            let mut pixels = Vec::new();
            for (y, row) in bytes.enumerate() {
                let on = |x: &u16| row[usize::from(x / 8)] & (0x80 >> (x % 8)) != 0;
                let columns = (0..size[0]).filter(on);
                pixels.extend(columns.map(|x| [i64::from(x), y as i64]));
            }
            Bitmap {
                corner: offset.map(|c| f64::from(c) / 2.0),
                pixels,
            }
        }
        Mark::Text { text, font, anchor } => {
            let (corner, pixels) = letters::letters(text, *font, *anchor);
            Bitmap { corner, pixels }
        }
    }
}

/// Whether a pixel belongs to a shape whose middle is so far to its left and above.
fn in_shape(shape: Shape, size: f64, x: f64, y: f64) -> bool {
    let stroke = (size / 5.0).floor().max(1.0);
    let radius = size / 2.0;
    match shape {
        Shape::Dot => x * x + y * y < radius * radius,
        Shape::Square => true,
        Shape::Plus => x.abs().min(y.abs()) <= stroke / 2.0,
        Shape::Cross => (x.abs() - y.abs()).abs() <= stroke / 2.0,
        Shape::Circle => {
            let inner = radius - stroke;
            let distance = x * x + y * y;
            distance < radius * radius && (inner < 0.0 || distance >= inner * inner)
        }
        Shape::Diamond => x.abs() + y.abs() <= radius - 0.5,
        Shape::Triangle => 2.0 * x.abs() <= y + radius,
    }
}
