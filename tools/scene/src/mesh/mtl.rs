//! Material libraries of OBJ files: colours, highlights, opacity, and the picture on the
//! surface. Own code, as for OBJ itself: mistakes are told with their lines.

use super::obj::statements;
use super::{Refusal, Soup};
use crate::description::Rgb;
use crate::files::Origin;
use crate::picture;
use crate::texture::{Texture, Texturing, Wrap};

/// The sharpest highlight of a scene's materials.
const MOST_POWER: f64 = 128.0;
/// Highlights go by the angle between normal and half-way vector there, by that between
/// mirrored light and eye here, which is twice as wide: they look alike at a quarter.
const POWERS: f64 = 4.0;

/// A `newmtl` and what follows it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Material {
    pub name: String,
    /// The library, among those of the OBJ file.
    pub of_library: usize,
    /// `Kd`, display-encoded.
    pub diffuse: Rgb,
    /// `Ks`; black if there are no highlights.
    pub specular: Rgb,
    /// `Ns`, as scenes count it.
    pub power: f64,
    /// `Ke`, its brightest channel.
    pub emission: f64,
    /// `d`, or 1 less `Tr`.
    pub opacity: f64,
    /// `map_Kd`.
    pub picture: Option<Picture>,
    /// `map_d`.
    mask: Option<Picture>,
    /// `illum` of 0 or 1: without highlights.
    dull: bool,
}

/// A picture that a material names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Picture {
    pub name: String,
    /// `-clamp on`: it does not repeat.
    pub clamp: bool,
    /// `map_d` names it, too: what has no alpha is cut out.
    pub cut_out: bool,
}

impl Picture {
    /// Reads it, from beside its library.
    pub(super) fn read(&self, library: Origin<'_>) -> Result<(Texture, Texturing), String> {
        let picture = library
            .read(&self.name)
            .and_then(|bytes| picture::decode(&bytes))?;
        let mut how = Texturing::new(0);
        if self.clamp {
            how.wrap = Wrap::Clamp;
        }
        if self.cut_out {
            how.alpha_test = 0.5;
        }
        Ok((picture.texture(&self.name), how))
    }
}

/// The materials of a library, which is the so-manieth of its OBJ file. Mistakes have the
/// library's lines and path.
pub(super) fn read(
    origin: Origin<'_>,
    library: usize,
    bytes: &[u8],
    soup: &mut Soup,
) -> Result<Vec<Material>, Refusal> {
    let text = String::from_utf8_lossy(bytes);
    let mut materials: Vec<Material> = Vec::new();
    for (line, words) in statements(&text) {
        let Some((key, values)) = words.split_first() else {
            continue;
        };
        if *key == "newmtl" {
            materials.push(Material::named(values.join(" "), library));
        } else if let Some(material) = materials.last_mut() {
            let read = material.take(key, values, soup);
            read.map_err(|what| Refusal::at(line, format!("{key}: {what}")).of(origin.path))?;
        }
    }
    for material in &mut materials {
        material.settle(soup);
    }
    Ok(materials)
}

impl Material {
    fn named(name: String, library: usize) -> Self {
        Self {
            name,
            of_library: library,
            diffuse: [1.0; 3],
            specular: [0.0; 3],
            power: 1.0,
            emission: 0.0,
            opacity: 1.0,
            picture: None,
            mask: None,
            dull: false,
        }
    }

    /// What several statements say together, in whatever order.
    fn settle(&mut self, soup: &mut Soup) {
        if self.dull {
            self.specular = [0.0; 3];
        }
        if self.specular == [0.0; 3] {
            self.power = 1.0;
        }
        match (&mut self.picture, self.mask.take()) {
            (Some(picture), Some(mask)) if picture.name == mask.name => picture.cut_out = true,
            (_, Some(_)) => {
                soup.note("a picture of opacity (map_d) is left out, as it is not the colour's");
            }
            (_, None) => {}
        }
    }

    /// Takes one statement in.
    fn take(&mut self, key: &str, values: &[&str], soup: &mut Soup) -> Result<(), String> {
        match key {
            "Kd" => self.diffuse = colour(key, values, soup)?.unwrap_or(self.diffuse),
            "Ks" => self.specular = colour(key, values, soup)?.unwrap_or(self.specular),
            "Ke" => {
                let own = colour(key, values, soup)?.unwrap_or_default();
                self.emission = own.into_iter().fold(0.0, f64::max);
            }
            "Ns" => self.power = (number(key, values)? / POWERS).clamp(1.0, MOST_POWER),
            "d" => {
                let values = values.strip_prefix(&["-halo"]).unwrap_or(values);
                self.opacity = number(key, values)?.clamp(0.0, 1.0);
            }
            "Tr" => self.opacity = 1.0 - number(key, values)?.clamp(0.0, 1.0),
            "illum" => self.dull = number(key, values)? < 2.0,
            "map_Kd" => self.picture = Some(map(values, soup)?),
            "map_d" => self.mask = Some(map(values, soup)?),
            _ if key.starts_with("map_") || ["bump", "disp", "decal", "refl"].contains(&key) => {
                soup.note("pictures but for those of colours (map_Kd) are left out");
            }
            _ => {}
        }
        Ok(())
    }
}

/// A finite number.
fn number(key: &str, values: &[&str]) -> Result<f64, String> {
    let word = values.first().copied().unwrap_or_default();
    let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| format!("\"{word}\" is not a number; expected e.g. {key} 0.5"))
}

/// Red, green and blue, each held to 0..=1; grey if there is only one number. None if it is
/// written in another way.
fn colour(key: &str, values: &[&str], soup: &mut Soup) -> Result<Option<Rgb>, String> {
    if let Some("spectral" | "xyz") = values.first().copied() {
        soup.note("colours by spectrum or as X, Y and Z are left out");
        return Ok(None);
    }
    let rgb = match values {
        [grey] => [*grey; 3],
        [red, green, blue, ..] => [*red, *green, *blue],
        _ => {
            let count = values.len();
            let what = format!("has {count} numbers where 3 belong; expected e.g. {key} 0.8 0.4 0");
            return Err(what);
        }
    };
    let mut channels = [0.0; 3];
    for (channel, word) in channels.iter_mut().zip(rgb) {
        *channel = number(key, &[word])?.clamp(0.0, 1.0);
    }
    Ok(Some(channels))
}

/// Options of a picture's statement, and the most values that each takes.
const OPTIONS: [(&str, usize); 12] = [
    ("-blendu", 1),
    ("-blendv", 1),
    ("-bm", 1),
    ("-boost", 1),
    ("-cc", 1),
    ("-clamp", 1),
    ("-imfchan", 1),
    ("-mm", 2),
    ("-o", 3),
    ("-s", 3),
    ("-t", 3),
    ("-texres", 1),
];

/// A picture's name and options. Folders are divided by either slash.
fn map(mut values: &[&str], soup: &mut Soup) -> Result<Picture, String> {
    let mut clamp = false;
    while let Some((option, rest)) = values.split_first() {
        let Some((_, most)) = OPTIONS.iter().find(|(name, _)| name == option) else {
            break;
        };
        // Words for those that take one; as many numbers as there are for the others.
        let numbers = rest.iter().take_while(|word| word.parse::<f64>().is_ok());
        let count = match most {
            1 => rest.len().min(1),
            _ => numbers.take(*most).count(),
        };
        match *option {
            "-clamp" => clamp = rest.first() == Some(&"on"),
            "-o" | "-s" | "-t" | "-mm" => {
                soup.note("where and how brightly a texture lies (-o, -s, -t, -mm) is left out");
            }
            _ => {}
        }
        values = &rest[count..];
    }
    if values.is_empty() {
        return Err("names no picture; expected e.g. map_Kd wood.png".to_owned());
    }
    Ok(Picture {
        name: values.join(" ").replace('\\', "/"),
        clamp,
        cut_out: false,
    })
}
