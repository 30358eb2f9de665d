//! Wavefront OBJ: positions, with the red, green and blue in 0..=1 that some
//! programs write after them (display-encoded), texture coordinates, normals and
//! faces with their materials; curves, points and lines are left out.
//!
//! Own code, not the `tobj` crate, because that one names no lines, panics
//! on an `f` without vertices, and mixes up normals when only some faces
//! have them.

use std::collections::HashMap;

use super::obj_surface::Materials;
use super::polygon::{self, Polygons};
use super::{MAX_TEXTURE_COORDINATE, MAX_TRIANGLES, MAX_VERTICES, Refusal, Soup};
use crate::description::Rgb;
use crate::files::Origin;

const FACE: &str = "expected e.g. f 1 2 3 or f 1/1 2/2 3/3 or f 1//1 2//2 3//3";

pub(super) fn read(origin: Origin<'_>, bytes: &[u8]) -> Result<Soup, Refusal> {
    let text = String::from_utf8_lossy(bytes);
    let mut soup = Soup::default();

    // Faces may come before the vertices and the materials that they name.
    let mut materials = Materials::default();
    let mut positions = Vec::new();
    let mut normals = Vec::new();
    let mut colours: Vec<Option<Rgb>> = Vec::new();
    let mut coordinates = Vec::new();
    for (line, words) in statements(&text) {
        match words.first().copied() {
            Some("v") => {
                positions.push(numbers(line, "v", &words)?);
                colours.push(colour(line, &words)?);
            }
            Some("vn") => normals.push(numbers(line, "vn", &words)?),
            Some("vt") => coordinates.push(texture_coordinates(line, &words)?),
            Some("mtllib") => materials.read(origin, &words[1..], &mut soup)?,
            _ => {}
        }
        for (what, count) in [
            ("v", positions.len()),
            ("vn", normals.len()),
            ("vt", coordinates.len()),
        ] {
            if count > MAX_VERTICES {
                return Err(Refusal::too_many_of(what));
            }
        }
    }

    let coloured = colours.iter().any(Option::is_some);
    let mut vertices = HashMap::new();
    let mut polygons = Polygons::default();
    let (mut positions_so_far, mut coordinates_so_far, mut normals_so_far) = (0, 0, 0);
    for (line, words) in statements(&text) {
        match words.first().copied() {
            Some("v") => positions_so_far += 1,
            Some("vt") => coordinates_so_far += 1,
            Some("vn") => normals_so_far += 1,
            Some("usemtl") => materials.now(&words[1..].join(" "), &mut soup),
            Some("f") => {
                let mut corners = Vec::with_capacity(words.len() - 1);
                for word in &words[1..] {
                    let mut parts = word.split('/');
                    let position = parts.next().unwrap_or_default();
                    let place = parts.next().filter(|part| !part.is_empty());
                    let normal = parts.next().filter(|part| !part.is_empty());
                    let position =
                        index(line, "vertex", position, positions_so_far, positions.len())?;
                    let place = place
                        .map(|place| {
                            let count = coordinates.len();
                            index(line, "texture", place, coordinates_so_far, count)
                        })
                        .transpose()?;
                    let normal = normal
                        .map(|normal| index(line, "normal", normal, normals_so_far, normals.len()))
                        .transpose()?;
                    let next = soup.positions.len() as u32;
                    let key = (position, place, normal, materials.current());
                    let vertex = *vertices.entry(key).or_insert(next);
                    if vertex == next {
                        soup.positions.push(positions[position]);
                        if coloured {
                            soup.colours.push(colours[position].unwrap_or([1.0; 3]));
                        }
                        if !coordinates.is_empty() {
                            let place = place.map_or([0.0; 2], |place| coordinates[place]);
                            soup.texture_coordinates.push(place);
                        }
                        soup.normals.push(normal.map(|normal| normals[normal]));
                    }
                    corners.push(vertex);
                }
                if corners.len() < 3 {
                    let count = corners.len();
                    return Err(Refusal::at(
                        line,
                        format!("f: has {count} vertices where at least 3 belong; {FACE}"),
                    ));
                }
                polygons.push(&mut soup, &corners);
                materials.mark(&soup);
                if soup.triangles.len() > MAX_TRIANGLES {
                    return Err(Refusal::too_many());
                }
            }
            _ => {}
        }
    }
    materials.give(origin, &mut soup)?;
    Ok(soup)
}

/// The first two numbers of a `vt`; a second that is missing is 0.
fn texture_coordinates(line: usize, words: &[&str]) -> Result<[f64; 2], Refusal> {
    let number = |word: &&str| {
        let number = word.parse::<f64>().ok();
        number.filter(|number| number.abs() <= MAX_TEXTURE_COORDINATE)
    };
    let v = words.get(2).map_or(Some(0.0), number);
    match (words.get(1).and_then(number), v) {
        (Some(u), Some(v)) => Ok([u, v]),
        _ => Err(Refusal::at(
            line,
            "vt: is not two numbers within 10000; expected e.g. vt 0.5 1",
        )),
    }
}

/// Statements with the line that each starts on: words without comments, a
/// backslash at the end of a line joins the next one to it.
pub(super) fn statements(text: &str) -> impl Iterator<Item = (usize, Vec<&str>)> {
    let mut lines = text.lines().enumerate();
    std::iter::from_fn(move || {
        let (number, mut line) = lines.next()?;
        let mut words = Vec::new();
        loop {
            let code = line.split('#').next().unwrap_or_default().trim_end();
            let joined = code.strip_suffix('\\');
            words.extend(joined.unwrap_or(code).split_whitespace());
            match joined.and_then(|_| lines.next()) {
                Some((_, next)) => line = next,
                None => return Some((number + 1, words)),
            }
        }
    })
}

/// The colour after a vertex's position, if there is one; a weight before it is
/// left out, as is a weight alone.
fn colour(line: usize, words: &[&str]) -> Result<Option<Rgb>, Refusal> {
    let first = match words.len() {
        7 => 4,
        8 => 5,
        _ => return Ok(None),
    };
    let channel = |at: usize| {
        let number = words[at].parse::<f64>().ok();
        number.filter(|number| (0.0..=1.0).contains(number))
    };
    match [channel(first), channel(first + 1), channel(first + 2)] {
        [Some(red), Some(green), Some(blue)] => Ok(Some([red, green, blue])),
        _ => Err(Refusal::at(
            line,
            "v: has a colour out of range; expected red, green and blue in 0..=1, \
             e.g. v 0 0.5 1 1 0.5 0",
        )),
    }
}

/// The first three numbers of a statement.
fn numbers(line: usize, key: &str, words: &[&str]) -> Result<[f64; 3], Refusal> {
    let wrong =
        |what: String| Refusal::at(line, format!("{key}: {what}; expected e.g. {key} 0 0.5 1"));
    let mut numbers = [0.0; 3];
    for (index, number) in numbers.iter_mut().enumerate() {
        let Some(word) = words.get(index + 1) else {
            return Err(wrong(format!("has {index} numbers where 3 belong")));
        };
        *number = match word.parse::<f64>() {
            Ok(number) => number,
            Err(_) => return Err(wrong(format!("\"{word}\" is not a number"))),
        };
    }
    // A normal that is not finite is made anew; a position cannot be.
    if key == "v" && !polygon::is_sane(&numbers) {
        return Err(wrong("is not finite, or beyond 1e9".to_owned()));
    }
    Ok(numbers)
}

/// An index from 1, or from the last one so far backwards, as one from 0.
fn index(
    line: usize,
    what: &str,
    word: &str,
    so_far: usize,
    count: usize,
) -> Result<usize, Refusal> {
    let wrong = |problem: &str| Err(Refusal::at(line, format!("f: {problem}; {FACE}")));
    let Ok(number) = word.parse::<i64>() else {
        return wrong(&format!("\"{word}\" is not a {what} index"));
    };
    let index = match number {
        0 => None,
        1.. => usize::try_from(number - 1).ok(),
        _ => usize::try_from(number.unsigned_abs())
            .ok()
            .and_then(|back| so_far.checked_sub(back)),
    };
    match index {
        Some(index) if index < count => Ok(index),
        _ => wrong(&format!(
            "{what} index {number} is out of range (the file has {count})"
        )),
    }
}
