//! Palettes from files: GIMP's (`.gpl`), lists of hexadecimal numbers (`.hex`),
//! pictures (`.png`).

use std::path::Path;

use super::colour;
use crate::files::Origin;
use crate::mesh;
use crate::picture;

/// The colours of a palette file, 2 to 256 of them.
pub(super) fn read(origin: Origin<'_>, name: &str) -> Result<Vec<[u8; 3]>, String> {
    let bytes = || origin.read(name);
    let colours = match mesh::extension(Path::new(name)).as_str() {
        "gpl" => gimp(&bytes()?)?,
        "hex" => list(&bytes()?)?,
        "png" => pixels(&bytes()?)?,
        _ => return Err("is not a kind of palette file; expected one of .gpl, .hex, .png".into()),
    };
    match colours.len() {
        2..=256 => Ok(colours),
        count => Err(format!("has {count} colours; expected 2 to 256")),
    }
}

/// Lines of red, green, blue in 0..=255 and perhaps a name, after a first line that
/// says what it is.
fn gimp(bytes: &[u8]) -> Result<Vec<[u8; 3]>, String> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = text.lines().map(str::trim).zip(1..);
    if !lines
        .next()
        .is_some_and(|(line, _)| line.starts_with("GIMP Palette"))
    {
        return Err("is no GIMP palette; expected \"GIMP Palette\" as its first line".into());
    }
    let says_something = |(line, _): &(&str, usize)| {
        let other = ["#", "Name:", "Columns:"];
        !line.is_empty() && !other.iter().any(|start| line.starts_with(start))
    };
    let colour = |(line, number): (&str, usize)| {
        let mut words = line.split_whitespace().map(|word| word.parse().ok());
        let mut channel = || words.next().flatten();
        match (channel(), channel(), channel()) {
            (Some(red), Some(green), Some(blue)) => Ok([red, green, blue]),
            _ => Err(format!(
                "line {number}: \"{line}\" is not a colour; expected e.g. 255 136 0 Orange"
            )),
        }
    };
    lines.filter(says_something).map(colour).collect()
}

/// A line for each colour, `rrggbb`, with or without a `#` before it.
fn list(bytes: &[u8]) -> Result<Vec<[u8; 3]>, String> {
    let text = String::from_utf8_lossy(bytes);
    let lines = text.lines().map(str::trim).zip(1..);
    let colour = |(line, number): (&str, usize)| {
        let digits = line.strip_prefix('#').unwrap_or(line);
        colour::digits(digits).ok_or_else(|| {
            format!("line {number}: \"{line}\" is not a colour; expected e.g. ff8800")
        })
    };
    let says_something = |(line, _): &(&str, usize)| !line.is_empty();
    lines.filter(says_something).map(colour).collect()
}

/// The different colours of a picture, by rows from the top left.
fn pixels(bytes: &[u8]) -> Result<Vec<[u8; 3]>, String> {
    let picture = picture::decode(bytes)?;
    let mut colours = Vec::new();
    for [red, green, blue, _] in picture.pixels {
        let colour = [red, green, blue];
        if !colours.contains(&colour) {
            colours.push(colour);
        }
        if colours.len() > 256 {
            return Err("has more than 256 colours; expected 2 to 256".into());
        }
    }
    Ok(colours)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLOURS: [[u8; 3]; 2] = [[255, 136, 0], [0, 0, 17]];

    #[test]
    fn gimp_palettes() {
        let text = "GIMP Palette\r\nName: Two\nColumns: 0\n#\n255 136   0\tOrange\n  0 0 17\n";
        assert_eq!(gimp(text.as_bytes()), Ok(COLOURS.to_vec()));
        let wrong = text.replace("136", "256");
        assert_eq!(
            gimp(wrong.as_bytes()).unwrap_err(),
            "line 5: \"255 256   0\tOrange\" is not a colour; expected e.g. 255 136 0 Orange"
        );
        assert!(
            gimp(b"255 136 0")
                .unwrap_err()
                .starts_with("is no GIMP palette")
        );
    }

    #[test]
    fn hexadecimal_lists() {
        assert_eq!(list(b"ff8800\r\n\n#000011\n"), Ok(COLOURS.to_vec()));
        assert_eq!(
            list(b"ff8800\n\nblue").unwrap_err(),
            "line 3: \"blue\" is not a colour; expected e.g. ff8800"
        );
    }

    #[test]
    fn pictures() {
        let rows = [COLOURS[0], COLOURS[1], COLOURS[0]];
        let png = picture::tests::png(3, 1, rows.as_flattened(), image::ColorType::Rgb8);
        assert_eq!(pixels(&png), Ok(COLOURS.to_vec()));
        let greys: Vec<u8> = (0..=255).chain([0]).collect();
        let png = picture::tests::png(257, 1, &greys, image::ColorType::L8);
        assert_eq!(pixels(&png).map(|colours| colours.len()), Ok(256));
        let many: Vec<[u8; 3]> = (0..=256).map(|i| [i as u8, (i >> 8) as u8, 0]).collect();
        let png = picture::tests::png(257, 1, many.as_flattened(), image::ColorType::Rgb8);
        assert!(pixels(&png).unwrap_err().starts_with("has more than 256"));
    }
}
