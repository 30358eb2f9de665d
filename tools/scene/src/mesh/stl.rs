//! STL, binary and ASCII. Its normals are left out: they are often wrong or
//! zero, and the winding says the same.
//!
//! Own code: the `stl_io` crate names no lines, and takes a binary file whose
//! header begins with "solid" for ASCII.

use super::polygon::is_sane;
use super::{MAX_TRIANGLES, Refusal, Soup};

const HEADER: usize = 84;
const FACET: usize = 50;

pub(super) fn read(bytes: &[u8]) -> Result<Soup, Refusal> {
    let count = bytes
        .get(80..HEADER)
        .and_then(|bytes| Some(u32::from_le_bytes(bytes.try_into().ok()?) as usize));
    let needed = count.and_then(|count| count.checked_mul(FACET)?.checked_add(HEADER));
    let solid = bytes.trim_ascii_start().get(..5);
    let says_solid = solid.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    // Exporters put "solid" into binary headers too: the length tells.
    match (count, needed) {
        (Some(count), Some(needed)) if needed == bytes.len() => binary(bytes, count),
        _ if says_solid => ascii(bytes),
        (Some(count), Some(needed)) if needed < bytes.len() => binary(bytes, count),
        (Some(count), Some(needed)) => Err(Refusal::new(format!(
            "says it has {count} triangles, which take {needed} bytes, but has {} bytes",
            bytes.len()
        ))),
        _ => Err(Refusal::new(format!(
            "is no STL file; expected \"solid\" or {HEADER} bytes of header"
        ))),
    }
}

fn push(soup: &mut Soup, corners: [[f64; 3]; 3]) -> Result<(), Refusal> {
    if soup.triangles.len() == MAX_TRIANGLES {
        return Err(Refusal::too_many());
    }
    let first = soup.positions.len() as u32;
    soup.positions.extend(corners);
    soup.normals.extend([None; 3]);
    soup.triangles.push([first, first + 1, first + 2]);
    Ok(())
}

fn binary(bytes: &[u8], count: usize) -> Result<Soup, Refusal> {
    if count > MAX_TRIANGLES {
        return Err(Refusal::too_many());
    }
    let mut soup = Soup::default();
    let facets = bytes[HEADER..].chunks_exact(FACET).take(count);
    for facet in facets {
        let (words, _) = facet.as_chunks::<4>();
        let corner = |first: usize| {
            [first, first + 1, first + 2].map(|at| f64::from(f32::from_le_bytes(words[at])))
        };
        // Three words of normal come first.
        push(&mut soup, [corner(3), corner(6), corner(9)])?;
    }
    Ok(soup)
}

fn ascii(bytes: &[u8]) -> Result<Soup, Refusal> {
    let text = String::from_utf8_lossy(bytes);
    let mut soup = Soup::default();
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let mut in_solid = false;
    let mut last = 1;
    for (at, content) in text.lines().enumerate() {
        let line = at + 1;
        let mut words = content.split_whitespace();
        let Some(word) = words.next() else {
            continue;
        };
        last = line;
        match (word.to_ascii_lowercase().as_str(), in_solid) {
            ("solid", false) => in_solid = true,
            ("endsolid", true) if corners.is_empty() => in_solid = false,
            ("facet", true) if corners.is_empty() => {}
            ("outer" | "endloop", true) => {}
            ("vertex", true) => corners.push(vertex(line, words)?),
            ("endfacet", true) => {
                let Ok(triangle) = <[_; 3]>::try_from(corners.as_slice()) else {
                    return Err(Refusal::at(
                        line,
                        format!(
                            "facet: has {} vertices where 3 belong; expected e.g. vertex 0 0.5 1",
                            corners.len()
                        ),
                    ));
                };
                push(&mut soup, triangle)?;
                corners.clear();
            }
            _ => {
                let expected = if in_solid {
                    "facet, outer loop, vertex, endloop, endfacet or endsolid"
                } else {
                    "solid"
                };
                return Err(Refusal::at(
                    line,
                    format!("\"{word}\" does not belong here; expected {expected}"),
                ));
            }
        }
    }
    if in_solid {
        return Err(Refusal::at(
            last,
            "ends before endsolid; expected a whole file",
        ));
    }
    Ok(soup)
}

fn vertex<'a>(line: usize, words: impl Iterator<Item = &'a str>) -> Result<[f64; 3], Refusal> {
    let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
    match <[f64; 3]>::try_from(numbers.as_slice()) {
        Ok(position) if is_sane(&position) => Ok(position),
        _ => Err(Refusal::at(
            line,
            "vertex: is not three finite numbers within 1e9; expected e.g. vertex 0 0.5 1",
        )),
    }
}
