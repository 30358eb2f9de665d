//! Palette and shade tables.
//!
//! The colours that a frame can hold are known beforehand. If all materials go by
//! level, they lie on ramps: each material's colour at every light level that its
//! coefficients and the scene's lights can give, and the background. The palette's
//! entries are dealt out among these ramps in proportion to their length in Oklab,
//! evenly along each. If some material goes by colour or has a texture, surfaces are
//! sampled under the scene's lights, and the palette is made by k-means in Oklab; so
//! it is if there is fog, with each sample both clear and fogged. What shows through
//! blended materials is sampled mixed.
//!
//! In: the description. Out: [`Tables`], for the blob.

mod choose;
mod direct;
mod light;
mod nearest;
mod ramp;
mod surface;
#[cfg(test)]
mod tests;
mod through;
mod way;
mod window;

use fixel_scene::{Background, Fog, Light, LightKind, Material, Rgb, Scene, Viewport};

use crate::fog::fogged_row;
pub(crate) use choose::{Sample, choose};
pub(crate) use direct::{direct, needs_palette};
use fixel::scene::layout::FOG_ROWS;
use nearest::{Nearest, lookup};
use ramp::{Ramp, asked_for, deal};
use way::Way;

/// Rows of a gradient that get their own palette index.
const GRADIENT_STEPS: usize = 256;
/// How much of a picture is background, beside 1 for all surfaces.
const BACKGROUND_WEIGHT: f64 = 0.25;

/// How much surfaces by themselves count where it is known what the picture has, beside
/// 1 for that: other frames may show them.
const BESIDE_SEEN: f64 = 1.0 / 16.0;

/// Everything that turns light into palette indices.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tables {
    pub palette: Vec<[u8; 3]>,
    /// For each material, how it gets from light to an index.
    pub paths: Vec<Path>,
    /// Of each material that goes by level, the index of each level.
    pub shades: Vec<[u8; 256]>,
    /// Of each material with a texture that goes by level, [`TEXTURE_LEVELS`] rows of
    /// an index for each base colour of the scene's textures.
    pub texture_shades: Vec<Vec<u8>>,
    /// The index of each colour of 4 bits a channel, 4096 of them: number
    /// `r << 8 | g << 4 | b` is that of the colour `(r, g, b) * 17` of 255. Empty if
    /// no material goes by colour.
    pub colours: Vec<u8>,
    /// Indices from the top of the screen to its bottom.
    pub background: Vec<u8>,
    /// The same for each viewport; empty if it has the scene's.
    pub viewport_backgrounds: Vec<Vec<u8>>,
    /// If there is fog: rows from none to nothing else, of what becomes of each index.
    pub fog: Vec<[u8; 256]>,
    /// What goes by colour is dithered over so much of a channel, 0..=1: about the
    /// distance between entries, where there are surfaces.
    pub spread: f64,
}

/// A material's way from light to an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Path {
    /// By light level, through this one of the shade tables.
    Level(u16),
    /// By colour, through the table of colours.
    Colour,
    /// By light level and the texel's base colour, through this one of the tables of
    /// texture shades.
    Textured(u16),
}

/// Rows of a table of texture shades: level `l` is in row `l * TEXTURE_LEVELS / 256`.
/// Colours are at most 2 of 255 off for it, and each table is a quarter of the size.
pub(crate) const TEXTURE_LEVELS: usize = 64;

/// `bases` are the base colours of the scene's textures; `mixed` says that colours of
/// several surfaces are mixed, so that all materials have to go by colour; `seen` are
/// colours that the picture has, if that is known.
pub(crate) fn tables(scene: &Scene, bases: &[[u8; 3]], mixed: bool, seen: &[Sample]) -> Tables {
    let background = background_colours(&scene.display.background);
    let own = |viewport: &Viewport| viewport.background.as_ref().map(background_colours);
    let own: Vec<Vec<Rgb>> = scene
        .viewports
        .iter()
        .map(|viewport| own(viewport).unwrap_or_default())
        .collect();
    let mut backgrounds = own.clone();
    backgrounds.push(background.clone());
    backgrounds.retain(|colours| !colours.is_empty());
    let ways: Vec<Way> = (0..scene.materials.len())
        .map(|material| {
            if mixed {
                Way::Colour
            } else {
                Way::of(scene, material)
            }
        })
        .collect();
    let textured = scene.materials.iter().any(|m| m.texture.is_some());
    let mut samples = if textured || ways.contains(&Way::Colour) || scene.fog.is_some() {
        surface::samples(scene)
    } else {
        Vec::new()
    };
    if !seen.is_empty() {
        for sample in &mut samples {
            sample.weight *= BESIDE_SEEN;
        }
        samples.extend(seen);
    }
    let palette = palette(scene, &backgrounds, mixed, &samples);
    let nearest = Nearest::new(&palette);
    let spread = spread(&samples, &palette, &nearest);
    let row = |material: &Material| {
        let mut row = [0; 256];
        for (level, index) in row.iter_mut().enumerate() {
            *index = nearest.index(shade(material, &scene.ambient, level));
        }
        row
    };
    let texture_shade = |material: &Material| {
        let step = 256 / TEXTURE_LEVELS;
        let index = |row: usize, base: &[u8; 3]| {
            // The middle of the row's levels.
            let level = (row * step) as f64 + (step - 1) as f64 / 2.0;
            let texel = to_unit(*base);
            nearest.index([0, 1, 2].map(|c| texel[c] * material.diffuse_colour[c] * level / 255.0))
        };
        let mut shades = Vec::new();
        for row in 0..TEXTURE_LEVELS {
            shades.extend(bases.iter().map(|base| index(row, base)));
        }
        shades
    };
    let (mut shades, mut texture_shades) = (Vec::new(), Vec::new());
    let mut path = |(material, way): (&Material, &Way)| match way {
        Way::Level if material.texture.is_some() => {
            texture_shades.push(texture_shade(material));
            Path::Textured(texture_shades.len() as u16 - 1)
        }
        Way::Level => {
            shades.push(row(material));
            Path::Level(shades.len() as u16 - 1)
        }
        Way::Colour => Path::Colour,
    };
    let paths = scene.materials.iter().zip(&ways).map(&mut path).collect();
    let colours = if ways.contains(&Way::Colour) {
        lookup(&nearest)
    } else {
        Vec::new()
    };
    Tables {
        paths,
        shades,
        texture_shades,
        colours,
        background: indices(&nearest, &background),
        fog: scene
            .fog
            .iter()
            .flat_map(|fog| fog_rows(fog, &palette, &nearest))
            .collect(),
        viewport_backgrounds: own.iter().map(|c| indices(&nearest, c)).collect(),
        palette,
        spread,
    }
}

/// Rows of the fog table.
fn fog_rows(fog: &Fog, palette: &[[u8; 3]], nearest: &Nearest) -> Vec<[u8; 256]> {
    let row = |row: usize| {
        let mut indices = [0; 256];
        for (index, colour) in indices.iter_mut().zip(palette) {
            *index = nearest.index(fogged_row(fog, to_unit(*colour), row));
        }
        indices
    };
    (0..FOG_ROWS).map(row).collect()
}

fn indices(nearest: &Nearest, colours: &[Rgb]) -> Vec<u8> {
    colours.iter().map(|c| nearest.index(*c)).collect()
}

/// The palette's entries: a file's, or those asked for and then the best for the
/// rest.
fn palette(
    scene: &Scene,
    backgrounds: &[Vec<Rgb>],
    mixed: bool,
    samples: &[Sample],
) -> Vec<[u8; 3]> {
    let wanted = &scene.palette;
    if !wanted.fixed.is_empty() {
        return wanted.fixed.clone();
    }
    let most = wanted.colours.clamp(2, 256) as usize;
    let mut palette = asked_for(&wanted.ramps);
    palette.truncate(most);
    if !samples.is_empty() {
        if mixed {
            // What rays see of a background is mixed from these.
            let ends = backgrounds.iter().flat_map(|b| [b.first(), b.last()]);
            for colour in ends.flatten().map(|colour| to_bytes(*colour)) {
                if !palette.contains(&colour) && palette.len() < most {
                    palette.push(colour);
                }
            }
        }
        if let Some(fog) = &scene.fog {
            // What is far away and the sky before which it stands are the same
            // colour if they are meant to be.
            let plain = backgrounds.iter().filter(|colours| colours.len() == 1);
            for colour in plain.flatten().chain([&fog.colour]) {
                if !palette.contains(&to_bytes(*colour)) && palette.len() < most {
                    palette.push(to_bytes(*colour));
                }
            }
        }
        let mut samples = samples.to_vec();
        for background in backgrounds {
            let weight = BACKGROUND_WEIGHT / (background.len() * backgrounds.len()) as f64;
            samples.extend(background.iter().map(|&colour| Sample { colour, weight }));
        }
        return choose(&samples, &palette, most);
    }
    if palette.len() < most {
        let mut ramps: Vec<Ramp> = backgrounds.iter().map(|b| Ramp::new(b.clone())).collect();
        for material in &scene.materials {
            let (first, last) = reachable_levels(material, scene);
            let colour = |level| shade(material, &scene.ambient, level);
            ramps.push(Ramp::new((first..=last).map(colour).collect()));
        }
        let dealt = deal(&ramps, (most - palette.len()).max(2));
        let new = dealt.into_iter().filter(|c| !palette.contains(c));
        let new: Vec<_> = new.take(most - palette.len()).collect();
        palette.extend(new);
    }
    palette
}

/// What evenly spaced entries would be apart that are off by as much in the mean: a
/// step is the root of 12 times its mean square error. At least one step of the
/// table of colours, at most half of a channel.
fn spread(samples: &[Sample], palette: &[[u8; 3]], nearest: &Nearest) -> f64 {
    let (mut sum, mut weight) = (0.0, 0.0);
    for sample in samples {
        let entry = to_unit(palette[usize::from(nearest.index(sample.colour))]);
        let off = |c: usize| (sample.colour[c].clamp(0.0, 1.0) - entry[c]).powi(2);
        sum += sample.weight * (off(0) + off(1) + off(2)) / 3.0;
        weight += sample.weight;
    }
    let mean = if weight > 0.0 { sum / weight } else { 0.0 };
    (12.0 * mean).sqrt().clamp(1.0 / 15.0, 0.5)
}

fn background_colours(background: &Background) -> Vec<Rgb> {
    match background {
        Background::Solid(colour) => vec![*colour],
        Background::Gradient { top, bottom } => (0..GRADIENT_STEPS)
            .map(|i| {
                let part = (i as f64 + 0.5) / GRADIENT_STEPS as f64;
                [0, 1, 2].map(|c| top[c] + (bottom[c] - top[c]) * part)
            })
            .collect(),
    }
}

/// The level without any directional light: of emission and grey ambient light.
pub(crate) fn ambient_level(material: &Material, ambient: &Rgb) -> f64 {
    let grey = ambient.iter().sum::<f64>() / 3.0;
    (255.0 * (material.emission + material.ambient * grey)).clamp(0.0, 255.0)
}

/// The levels that a material can have, first and last, at most 255.
fn reachable_levels(material: &Material, scene: &Scene) -> (usize, usize) {
    let first = ambient_level(material, &scene.ambient);
    let brightest: f64 = scene.lights.iter().map(brightest).sum();
    let part = material.diffuse + material.specular;
    let direct = if part > 0.0 { part * brightest } else { 0.0 };
    let last = (first + 255.0 * direct).clamp(first, 255.0);
    (first.floor() as usize, last.ceil() as usize)
}

/// The most that a grey light gives anywhere.
fn brightest(light: &Light) -> f64 {
    let full = light.intensity * light.colour[0];
    match light.kind {
        LightKind::Directional { .. } => full,
        LightKind::Point { attenuation, .. } | LightKind::Spot { attenuation, .. } => {
            // All of it may be seen from just beside it.
            if full == 0.0 {
                0.0
            } else {
                full / attenuation[0]
            }
        }
    }
}

/// A material's colour at a level: what ambient light and emission give, which no
/// surface of the material is without, and the diffuse colour for the rest.
fn shade(material: &Material, ambient: &Rgb, level: usize) -> Rgb {
    let direct = (level as f64 - ambient_level(material, ambient)) / 255.0;
    [0, 1, 2].map(|c| {
        let without = material.emission * material.diffuse_colour[c]
            + material.ambient_colour[c] * material.ambient * ambient[c];
        without + material.diffuse_colour[c] * direct
    })
}

fn to_bytes(colour: Rgb) -> [u8; 3] {
    colour.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8)
}

fn to_unit(colour: [u8; 3]) -> Rgb {
    colour.map(|c| f64::from(c) / 255.0)
}
