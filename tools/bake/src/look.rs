//! How actors are drawn that are not surfaces: looks and marks of the blob.

use embedded_graphics::geometry::{OriginDimensions, Point};
use embedded_graphics::image::GetPixel;
use embedded_graphics::mono_font::{MonoFont, iso_8859_1};
use embedded_graphics::pixelcolor::BinaryColor;
use fixel::scene::{self as core_scene, Cull, Representation, Shading};
use fixel_scene::{Font, Look, Mark, Scene, Shape, Side, Space};

/// Looks and the rows of their marks.
#[derive(Default)]
pub(crate) struct Looks {
    pub looks: Vec<core_scene::Look>,
    pub marks: Vec<u8>,
    /// For each actor, its material in the blob.
    pub materials: Vec<u16>,
}

/// The looks of all actors. To `materials` are added those that lines and points
/// need: lit at vertices and seen from both sides.
pub(crate) fn looks(scene: &Scene, materials: &mut Vec<core_scene::Material>) -> Looks {
    let mut all = Looks::default();
    for (number, actor) in scene.actors.iter().enumerate() {
        let Some(representation) = representation(&actor.look) else {
            all.materials.push(actor.material as u16);
            continue;
        };
        let wanted = core_scene::Material {
            shading: Shading::Gouraud,
            cull: Cull::None,
            ..materials[actor.material]
        };
        let known = materials.iter().position(|m| *m == wanted);
        let material = known.unwrap_or_else(|| {
            materials.push(wanted);
            materials.len() - 1
        });
        all.materials.push(material as u16);
        let mark = Bitmap::of(&actor.look.mark);
        let first = all
            .marks
            .windows(mark.rows.len().max(1))
            .position(|known| known == mark.rows);
        let first_mark = first.unwrap_or_else(|| {
            all.marks.extend(&mark.rows);
            all.marks.len() - mark.rows.len()
        });
        all.looks.push(core_scene::Look {
            actor: number as u16,
            representation,
            depth_test: actor.look.depth_test,
            on_screen: actor.look.space == Space::Screen,
            line_width: actor.look.line_width as u8,
            bias: actor.look.bias as u16,
            mark_size: mark.size,
            mark_offset: mark.offset,
            first_mark: first_mark as u32,
        });
    }
    all
}

/// What of an actor the core draws; `None`: its surface.
fn representation(look: &Look) -> Option<Representation> {
    match look.representation {
        fixel_scene::Representation::Surface => None,
        fixel_scene::Representation::Wireframe => Some(Representation::Wireframe),
        fixel_scene::Representation::HiddenLine => Some(Representation::HiddenLine),
        fixel_scene::Representation::Points => Some(Representation::Points),
    }
}

/// A mark as the core draws it.
#[derive(Debug, PartialEq)]
struct Bitmap {
    size: [u16; 2],
    /// In half pixels.
    offset: [i16; 2],
    /// Each row from a byte's highest bit on.
    rows: Vec<u8>,
}

impl Bitmap {
    fn of(mark: &Mark) -> Self {
        match mark {
            Mark::Shape { shape, size } => {
                let size = *size as i32;
                let offset = (1 - size) as i16;
                Self::new([size as u16; 2], [offset; 2], |x, y| {
                    // From the middle, in half pixels.
                    let from_middle = |c: u16| 2 * i32::from(c) + 1 - size;
                    in_shape(*shape, size, from_middle(x), from_middle(y))
                })
            }
            Mark::Text { text, font, anchor } => {
                let font = mono_font(*font);
                let lines: Vec<Vec<char>> = text.split('\n').map(|l| l.chars().collect()).collect();
                let columns = lines.iter().map(Vec::len).max().unwrap_or(0) as u16;
                let letter = font.character_size;
                let letter = [letter.width as u16, letter.height as u16];
                let size = [columns * letter[0], lines.len() as u16 * letter[1]];
                let offset = |side: Side, length: u16| {
                    let pixels = match side {
                        Side::Start => 0,
                        Side::Middle => length / 2,
                        Side::End => length,
                    };
                    -2 * pixels as i16
                };
                let offset = [
                    offset(anchor.horizontal, size[0]),
                    offset(anchor.vertical, size[1]),
                ];
                Self::new(size, offset, |x, y| {
                    let line = &lines[usize::from(y / letter[1])];
                    let place = [x % letter[0], y % letter[1]];
                    let letter = line.get(usize::from(x / letter[0]));
                    letter.is_some_and(|letter| is_on(font, *letter, place))
                })
            }
            Mark::Bitmap { size, offset, rows } => Self {
                size: *size,
                offset: *offset,
                rows: rows.clone(),
            },
        }
    }

    fn new(size: [u16; 2], offset: [i16; 2], on: impl Fn(u16, u16) -> bool) -> Self {
        let mut rows = Vec::new();
        for y in 0..size[1] {
            for first in (0..size[0]).step_by(8) {
                let bit = |x: u16| u8::from(x < size[0] && on(x, y)) << (7 - (x - first));
                rows.push((first..first + 8).map(bit).sum());
            }
        }
        Self { size, offset, rows }
    }
}

/// See [`Shape`]: a pixel's middle is `u` and `v` half pixels from the square's.
fn in_shape(shape: Shape, size: i32, u: i32, v: i32) -> bool {
    let stroke = (size / 5).max(1);
    let distance = u * u + v * v;
    match shape {
        Shape::Dot => distance < size * size,
        Shape::Square => true,
        Shape::Plus => u.abs() <= stroke || v.abs() <= stroke,
        Shape::Cross => (u.abs() - v.abs()).abs() <= stroke,
        Shape::Circle => {
            let inner = (size - 2 * stroke).max(0);
            (inner * inner..size * size).contains(&distance)
        }
        Shape::Diamond => u.abs() + v.abs() < size,
        Shape::Triangle => 2 * u.abs() <= v + size,
    }
}

fn mono_font(font: Font) -> &'static MonoFont<'static> {
    match font {
        Font::F4x6 => &iso_8859_1::FONT_4X6,
        Font::F5x8 => &iso_8859_1::FONT_5X8,
        Font::F6x10 => &iso_8859_1::FONT_6X10,
        Font::F7x13 => &iso_8859_1::FONT_7X13,
        Font::F9x15 => &iso_8859_1::FONT_9X15,
        Font::F10x20 => &iso_8859_1::FONT_10X20,
    }
}

/// Whether a pixel of a letter is on: letters stand row by row in a font's image.
fn is_on(font: &MonoFont<'_>, letter: char, [x, y]: [u16; 2]) -> bool {
    let number = font.glyph_mapping.index(letter) as u32;
    let (size, image) = (font.character_size, font.image);
    let columns = image.size().width / size.width;
    let corner = [
        number % columns * size.width,
        number / columns * size.height,
    ];
    let at = Point::new(
        corner[0] as i32 + i32::from(x),
        corner[1] as i32 + i32::from(y),
    );
    image.pixel(at) == Some(BinaryColor::On)
}
