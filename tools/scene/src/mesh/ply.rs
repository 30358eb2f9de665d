//! PLY, ASCII and binary of both byte orders: vertices with x, y, z and
//! nx, ny, nz and red, green, blue (display-encoded; integers over their type's
//! largest, floats in 0..=1) and s, t or u, v, faces as polygons, and triangle strips. All else
//! is left out.

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Encoding, Property, PropertyAccess, PropertyAccessResult};

use super::polygon::{self, Polygons};
use super::{MAX_TEXTURE_COORDINATE, MAX_TRIANGLES, MAX_VERTICES, Refusal, Soup};

/// One vertex, face or strip: the properties that matter of any of them.
#[derive(Debug, Default)]
struct Item {
    position: [Option<f64>; 3],
    normal: [Option<f64>; 3],
    colour: [Option<f64>; 3],
    coordinates: [Option<f64>; 2],
    indices: Option<Vec<i64>>,
}

impl PropertyAccess for Item {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let slot = match name {
            "x" => &mut self.position[0],
            "y" => &mut self.position[1],
            "z" => &mut self.position[2],
            "nx" => &mut self.normal[0],
            "ny" => &mut self.normal[1],
            "nz" => &mut self.normal[2],
            "s" | "u" | "texture_u" => &mut self.coordinates[0],
            "t" | "v" | "texture_v" => &mut self.coordinates[1],
            "vertex_indices" | "vertex_index" => {
                self.indices = integers(&property);
                return match self.indices {
                    Some(_) => PropertyAccessResult::Set,
                    None => PropertyAccessResult::UnsupportedType,
                };
            }
            "red" | "r" | "diffuse_red" => return set(&mut self.colour[0], share(&property)),
            "green" | "g" | "diffuse_green" => return set(&mut self.colour[1], share(&property)),
            "blue" | "b" | "diffuse_blue" => return set(&mut self.colour[2], share(&property)),
            _ => return PropertyAccessResult::Ignored,
        };
        set(slot, number(&property))
    }
}

fn set(slot: &mut Option<f64>, number: Option<f64>) -> PropertyAccessResult {
    *slot = number;
    match slot {
        Some(_) => PropertyAccessResult::Set,
        None => PropertyAccessResult::UnsupportedType,
    }
}

fn number(property: &Property) -> Option<f64> {
    match property {
        Property::Float(number) => Some((*number).into()),
        Property::Double(number) => Some(*number),
        Property::Char(number) => Some((*number).into()),
        Property::UChar(number) => Some((*number).into()),
        Property::Short(number) => Some((*number).into()),
        Property::UShort(number) => Some((*number).into()),
        Property::Int(number) => Some((*number).into()),
        Property::UInt(number) => Some((*number).into()),
        _ => None,
    }
}

/// A colour's channel, 1 for the largest of an integer type.
fn share(property: &Property) -> Option<f64> {
    let most = match property {
        Property::Char(_) => i8::MAX.into(),
        Property::UChar(_) => u8::MAX.into(),
        Property::Short(_) => i16::MAX.into(),
        Property::UShort(_) => u16::MAX.into(),
        Property::Int(_) => i32::MAX.into(),
        Property::UInt(_) => u32::MAX.into(),
        _ => 1.0,
    };
    Some(number(property)? / most)
}

fn integers(property: &Property) -> Option<Vec<i64>> {
    fn wide<T: Copy + Into<i64>>(list: &[T]) -> Option<Vec<i64>> {
        Some(list.iter().map(|&number| number.into()).collect())
    }
    match property {
        Property::ListChar(list) => wide(list),
        Property::ListUChar(list) => wide(list),
        Property::ListShort(list) => wide(list),
        Property::ListUShort(list) => wide(list),
        Property::ListInt(list) => wide(list),
        Property::ListUInt(list) => wide(list),
        _ => None,
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<Soup, Refusal> {
    let parser = Parser::<Item>::new();
    let mut reader = Reader::new(bytes);
    let header = parser
        .read_header(&mut reader)
        .map_err(|e| refusal(&e, true))?;
    let ascii = header.encoding == Encoding::Ascii;
    let mut soup = Soup::default();
    let mut polygons = Polygons::default();
    let mut vertices_read = false;
    for (name, element) in &header.elements {
        // Every item takes a byte at least; this also stops at endless items
        // without properties.
        if element.count > bytes.len() {
            let count = element.count;
            return Err(Refusal::new(format!(
                "says it has {count} items of \"{name}\", more than its bytes"
            )));
        }
        if element.count > MAX_VERTICES {
            return Err(Refusal::too_many_of(name));
        }
        let first_line = reader.line();
        let items = parser
            .read_payload_for_element(&mut reader, element, &header)
            .map_err(|e| refusal(&e, ascii))?;
        for (at, item) in items.into_iter().enumerate() {
            let line = ascii.then_some(first_line + at);
            let wrong = |what: String| Refusal {
                line,
                ..Refusal::new(format!("{name} {at}: {what}"))
            };
            match name.as_str() {
                "vertex" => {
                    vertices_read = true;
                    push_vertex(&mut soup, &item).map_err(wrong)?;
                }
                "face" | "tristrips" if !vertices_read => {
                    return Err(wrong("comes before any vertex".to_owned()));
                }
                "face" => {
                    let corners = item.indices.unwrap_or_default();
                    if corners.len() < 3 {
                        let count = corners.len();
                        return Err(wrong(format!(
                            "has {count} vertices where at least 3 belong"
                        )));
                    }
                    let corners = indices(&soup, &corners).map_err(wrong)?;
                    polygons.push(&mut soup, &corners);
                }
                "tristrips" => {
                    for strip in item.indices.unwrap_or_default().split(|i| *i == -1) {
                        let strip = indices(&soup, strip).map_err(wrong)?;
                        polygon::strip(&strip, &mut soup.triangles);
                    }
                }
                _ => {}
            }
            if soup.triangles.len() > MAX_TRIANGLES {
                return Err(Refusal::too_many());
            }
        }
    }
    Ok(soup)
}

fn push_vertex(soup: &mut Soup, item: &Item) -> Result<(), String> {
    let [Some(x), Some(y), Some(z)] = item.position else {
        return Err("lacks a property; expected x, y and z".to_owned());
    };
    if !polygon::is_sane(&[x, y, z]) {
        return Err("is not finite, or beyond 1e9".to_owned());
    }
    soup.positions.push([x, y, z]);
    soup.normals.push(match item.normal {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    });
    if let [Some(u), Some(v)] = item.coordinates {
        if !(u.abs() <= MAX_TEXTURE_COORDINATE && v.abs() <= MAX_TEXTURE_COORDINATE) {
            return Err("has texture coordinates that are not within 10000".to_owned());
        }
        soup.texture_coordinates.push([u, v]);
    }
    match item.colour {
        [Some(red), Some(green), Some(blue)] => {
            let colour = [red, green, blue];
            if !colour.iter().all(|channel| (0.0..=1.0).contains(channel)) {
                return Err("has a colour out of range; expected red, green and blue \
                            in 0..=255 as uchar, or in 0..=1 as float"
                    .to_owned());
            }
            soup.colours.push(colour);
        }
        [None, None, None] => {}
        _ if soup.notes.is_empty() => {
            let note = "vertex colours are left out, as red, green or blue is missing";
            soup.notes.push(note.to_owned());
        }
        _ => {}
    }
    let vertices = soup.positions.len();
    let none_or_all = |count: usize| count == 0 || count == vertices;
    if none_or_all(soup.colours.len()) && none_or_all(soup.texture_coordinates.len()) {
        Ok(())
    } else {
        let what = "has a colour or texture coordinates where others have none, \
                    or the other way round";
        Err(what.to_owned())
    }
}

fn indices(soup: &Soup, indices: &[i64]) -> Result<Vec<u32>, String> {
    let count = soup.positions.len();
    let index = |index: &i64| match u32::try_from(*index) {
        Ok(index) if (index as usize) < count => Ok(index),
        _ => Err(format!(
            "vertex index {index} is out of range (the file has {count})"
        )),
    };
    indices.iter().map(index).collect()
}

/// The crate's message without the lines that it quotes; in a binary file
/// its line means nothing after the header.
fn refusal(error: &ParseError, has_lines: bool) -> Refusal {
    let text = error.to_string();
    let first = text.lines().next().unwrap_or_default();
    let message = match first.split_once(": ") {
        Some((start, rest)) if start.starts_with("Line ") => rest,
        _ => first,
    };
    Refusal {
        line: error.line().filter(|_| has_lines),
        ..Refusal::new(format!("no valid PLY: {message}"))
    }
}
