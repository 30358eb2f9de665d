//! What an OBJ file's material libraries say of its surfaces.

use std::collections::HashMap;
use std::path::PathBuf;

use super::{Refusal, Soup, Surface, mtl};
use crate::description::Rgb;
use crate::files::Origin;
use crate::texture::{Texture, Texturing};

/// More of either is no model for a microcontroller.
const MAX_LIBRARIES: usize = 64;
const MAX_SURFACES: usize = 255;

/// The materials of a file, and which of them its vertices and triangles have.
#[derive(Debug, Default)]
pub(super) struct Materials {
    libraries: Vec<PathBuf>,
    /// Names of libraries met, also of those that cannot be had.
    met: usize,
    known: Vec<mtl::Material>,
    /// Their numbers from 1, by name.
    numbers: HashMap<String, usize>,
    /// A name was not among them.
    missed: bool,
    /// That of what follows; 0 for none.
    now: usize,
    of_vertex: Vec<usize>,
    of_triangle: Vec<usize>,
}

/// What sets surfaces apart: materials that differ in their colour only are one surface,
/// whose vertices have the colours.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Kind {
    specular: Rgb,
    specular_power: f64,
    emission: f64,
    opacity: f64,
    /// Which of the pictures.
    picture: Option<usize>,
}

/// Pictures that materials name, each with its library's number and what it is.
type Pictures = Vec<((usize, mtl::Picture), (Texture, Texturing))>;

impl Materials {
    /// `mtllib`: several files, or one with spaces in its name. One that cannot be had is
    /// left out with a note, since models are often handed on without theirs.
    pub(super) fn read(
        &mut self,
        origin: Origin<'_>,
        words: &[&str],
        soup: &mut Soup,
    ) -> Result<(), Refusal> {
        let whole = words.join(" ");
        let mut names = vec![whole.as_str()];
        if words.len() > 1 && origin.read(&whole).is_err() {
            names = words.to_vec();
        }
        self.met += names.len();
        if self.met > MAX_LIBRARIES {
            return Err(Refusal::new(format!(
                "names more than {MAX_LIBRARIES} material libraries; expected fewer"
            )));
        }
        for name in names {
            let path = origin.beside(name);
            if self.libraries.contains(&path) {
                continue;
            }
            let bytes = match origin.read(name) {
                Ok(bytes) => bytes,
                Err(what) => {
                    soup.note(&format!("materials are left out, as \"{name}\" {what}"));
                    continue;
                }
            };
            let library = Origin {
                path: &path,
                ..origin
            };
            for material in mtl::read(library, self.libraries.len(), &bytes, soup)? {
                let number = self.known.len() + 1;
                self.numbers.entry(material.name.clone()).or_insert(number);
                self.known.push(material);
            }
            self.libraries.push(path);
        }
        Ok(())
    }

    /// `usemtl`.
    pub(super) fn now(&mut self, name: &str, soup: &mut Soup) {
        self.now = self.numbers.get(name).copied().unwrap_or(0);
        // Where there is no library at all, that was said.
        if self.now == 0 && !self.libraries.is_empty() && !self.missed {
            self.missed = true;
            soup.note(&format!("no material is called \"{name}\": white instead"));
        }
    }

    /// What tells a vertex of this material from one of another.
    pub(super) fn current(&self) -> usize {
        self.now
    }

    /// All vertices and triangles since the last call have the material of now.
    pub(super) fn mark(&mut self, soup: &Soup) {
        self.of_vertex.resize(soup.positions.len(), self.now);
        self.of_triangle.resize(soup.triangles.len(), self.now);
    }

    /// Gives the soup its surfaces, in the order of their first triangles: none if no
    /// triangle has a material.
    pub(super) fn give(self, origin: Origin<'_>, soup: &mut Soup) -> Result<(), Refusal> {
        if self.of_triangle.iter().all(|material| *material == 0) {
            return Ok(());
        }
        let mut pictures = Pictures::new();
        // The kinds, each with the colour that all its triangles have, if they have one.
        let mut kinds: Vec<(Kind, Option<Rgb>)> = Vec::new();
        let mut kind_of = vec![None; self.known.len() + 1];
        for number in &self.of_triangle {
            if kind_of[*number].is_some() {
                continue;
            }
            let kind = self.kind(origin, *number, soup, &mut pictures);
            let colour = self.colour(*number);
            let at = kinds.iter().position(|(other, _)| *other == kind);
            match at {
                Some(at) if kinds[at].1 != Some(colour) => kinds[at].1 = None,
                Some(_) => {}
                None => kinds.push((kind, Some(colour))),
            }
            kind_of[*number] = Some(at.unwrap_or(kinds.len() - 1));
            if kinds.len() > MAX_SURFACES {
                return Err(Refusal::new(format!(
                    "has more than {MAX_SURFACES} materials that differ in more than their \
                     colour; expected fewer"
                )));
            }
        }
        for (vertex, number) in self.of_vertex.iter().enumerate() {
            if kind_of[*number].is_some_and(|kind| kinds[kind].1.is_none()) {
                soup.paint(vertex..vertex + 1, self.colour(*number));
            }
        }
        let of_triangle = self.of_triangle.iter();
        let surface_of = of_triangle.map(|number| kind_of[*number].unwrap_or(0) as u32);
        soup.surface_of = surface_of.collect();
        soup.surfaces = kinds
            .into_iter()
            .map(|(kind, colour)| Surface {
                colour: colour.unwrap_or([1.0; 3]),
                specular: kind.specular,
                specular_power: kind.specular_power,
                emission: kind.emission,
                opacity: kind.opacity,
                texture: kind.picture.map(|picture| pictures[picture].1.clone()),
                both_sides: false,
            })
            .collect();
        Ok(())
    }

    fn material(&self, number: usize) -> Option<&mtl::Material> {
        self.known.get(number.checked_sub(1)?)
    }

    /// White without a material.
    fn colour(&self, number: usize) -> Rgb {
        self.material(number)
            .map_or([1.0; 3], |material| material.diffuse)
    }

    /// A material's kind; reads its picture at the first use.
    fn kind(
        &self,
        origin: Origin<'_>,
        number: usize,
        soup: &mut Soup,
        pictures: &mut Pictures,
    ) -> Kind {
        let plain = Kind {
            specular: [0.0; 3],
            specular_power: 1.0,
            emission: 0.0,
            opacity: 1.0,
            picture: None,
        };
        let Some(material) = self.material(number) else {
            return plain;
        };
        Kind {
            specular: material.specular,
            specular_power: material.power,
            emission: material.emission,
            opacity: material.opacity,
            picture: self.picture(origin, material, soup, pictures),
        }
    }

    fn picture(
        &self,
        origin: Origin<'_>,
        material: &mtl::Material,
        soup: &mut Soup,
        pictures: &mut Pictures,
    ) -> Option<usize> {
        let picture = material.picture.as_ref()?;
        if soup.texture_coordinates.is_empty() {
            soup.note("a texture is left out, as there are no texture coordinates");
            return None;
        }
        let key = (material.of_library, picture.clone());
        let known = pictures.iter().position(|(other, _)| *other == key);
        if known.is_some() {
            return known;
        }
        let library = Origin {
            path: self.libraries.get(material.of_library)?,
            ..origin
        };
        match picture.read(library) {
            Ok(read) => {
                pictures.push((key, read));
                Some(pictures.len() - 1)
            }
            Err(what) => {
                let name = &picture.name;
                soup.note(&format!("a texture is left out, as \"{name}\" {what}"));
                None
            }
        }
    }
}
