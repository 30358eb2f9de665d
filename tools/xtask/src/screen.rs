//! Pictures of a screen, and of what should be on it.

use std::fs;
use std::path::Path;

use crate::problem::Result;

/// Pixels by rows from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Red, green, blue.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    fn height(&self) -> usize {
        self.pixels.len() / self.width.max(1)
    }

    fn row(&self, y: usize, from: usize, count: usize) -> Option<&[[u8; 3]]> {
        let start = y * self.width + from;
        let fits = from + count <= self.width;
        self.pixels.get(start..start + count).filter(|_| fits)
    }

    /// Each pixel so many times across and down.
    pub fn enlarged(&self, times: usize) -> Self {
        let mut pixels = Vec::new();
        for row in self.pixels.chunks(self.width.max(1)) {
            let row: Vec<_> = row
                .iter()
                .flat_map(|p| std::iter::repeat_n(*p, times))
                .collect();
            for _ in 0..times {
                pixels.extend_from_slice(&row);
            }
        }
        Self {
            width: self.width * times,
            pixels,
        }
    }

    /// The part as large as `other` with a corner at `x, y`.
    pub fn part(&self, [x, y]: [usize; 2], other: &Self) -> Self {
        let rows = (y..y + other.height()).filter_map(|y| self.row(y, x, other.width));
        Self {
            width: other.width,
            pixels: rows.flatten().copied().collect(),
        }
    }

    /// Where another picture is in this one, pixel by pixel.
    pub fn find(&self, wanted: &Self) -> Option<[usize; 2]> {
        let height = wanted.height();
        // Rows in the middle tell more than those at the edge.
        let order: Vec<usize> = (height / 2..height).chain(0..height / 2).collect();
        let is_at = |x: usize, y: usize| {
            let same = |row: &usize| {
                self.row(y + row, x, wanted.width) == wanted.row(*row, 0, wanted.width)
            };
            order.iter().all(same)
        };
        let down = (self.height() + 1).saturating_sub(height);
        let across = (self.width + 1).saturating_sub(wanted.width);
        let places = (0..down).flat_map(|y| (0..across).map(move |x| (x, y)));
        let found = places.into_iter().find(|(x, y)| is_at(*x, *y));
        found.map(|(x, y)| [x, y])
    }
}

/// A PNG of 8 bits a channel.
pub fn read_png(path: &Path) -> Result<Picture> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let file = fs::File::open(path).map_err(|error| fail(&error))?;
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().map_err(|error| fail(&error))?;
    let size = reader
        .output_buffer_size()
        .ok_or_else(|| fail(&"is too large"))?;
    let mut bytes = vec![0; size];
    let info = reader
        .next_frame(&mut bytes)
        .map_err(|error| fail(&error))?;
    if info.color_type != png::ColorType::Rgb {
        return Err(fail(&"is not red, green and blue").into());
    }
    Ok(Picture {
        width: info.width as usize,
        pixels: bytes.as_chunks().0.to_vec(),
    })
}

/// A screen that Xvfb keeps in a file: an X window dump of 32 bits a pixel, lowest byte
/// first (`X11/XWDFile.h`).
pub fn read_xwd(path: &Path) -> Result<Picture> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    parse_xwd(&bytes).ok_or_else(|| {
        let name = path.display();
        format!("{name}: not an X window dump of 32 bits a pixel").into()
    })
}

fn parse_xwd(bytes: &[u8]) -> Option<Picture> {
    let word = |number: usize| {
        let bytes = bytes.get(4 * number..4 * number + 4)?;
        Some(u32::from_be_bytes(bytes.try_into().ok()?) as usize)
    };
    let (header, width, height) = (word(0)?, word(4)?, word(5)?);
    let (order, bits, stride, colours) = (word(7)?, word(11)?, word(12)?, word(19)?);
    if (order, bits) != (0, 32) {
        return None;
    }
    let start = header + 12 * colours;
    let mut pixels = Vec::with_capacity(width * height);
    for y in 0..height {
        let row = bytes.get(start + y * stride..start + y * stride + 4 * width)?;
        let (words, _) = row.as_chunks::<4>();
        pixels.extend(
            words
                .iter()
                .map(|[blue, green, red, _]| [*red, *green, *blue]),
        );
    }
    Some(Picture { width, pixels })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: usize, greys: &[u8]) -> Picture {
        let pixels = greys.iter().map(|grey| [*grey; 3]).collect();
        Picture { width, pixels }
    }

    #[test]
    fn a_picture_is_found_in_another() {
        let screen = picture(4, &[0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0]);
        let wanted = picture(1, &[1]).enlarged(2);
        assert_eq!(screen.find(&wanted), Some([1, 1]));
        assert_eq!(screen.part([1, 1], &wanted), wanted);
        assert_eq!(screen.find(&picture(2, &[1, 2])), None);
        assert_eq!(screen.find(&picture(5, &[0; 5])), None);
        // Rows do not go on in the next one.
        assert_eq!(screen.find(&picture(2, &[1, 0])), Some([2, 1]));
        assert_eq!(picture(2, &[0, 1, 0, 1]).find(&picture(2, &[1, 0])), None);
    }

    #[test]
    fn a_dump_is_read() {
        let mut words = [0_u32; 25];
        (words[0], words[4], words[5]) = (100, 1, 2);
        (words[11], words[12], words[19]) = (32, 8, 1);
        let mut bytes: Vec<u8> = words.iter().flat_map(|word| word.to_be_bytes()).collect();
        bytes.extend([0; 12]);
        bytes.extend([3, 2, 1, 0, 9, 9, 9, 9, 6, 5, 4, 0, 9, 9, 9, 9]);
        let read = parse_xwd(&bytes).expect("a dump");
        assert_eq!(read.pixels, [[1, 2, 3], [4, 5, 6]]);
        assert!(parse_xwd(&bytes[..116]).is_none());
    }
}
