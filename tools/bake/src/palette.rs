//! Palette and shade tables.
//!
//! The colours that a frame can hold are known beforehand: each material's
//! colour at every light level that its coefficients and the scene's lights can
//! give, and the background. The palette's entries are dealt out among these
//! ramps in proportion to their length in Oklab, evenly along each.

use fixel_scene::{Background, Light, Material, Rgb, Scene};

use crate::oklab::{Lab, distance2, from_rgb};

/// Rows of a gradient that get their own palette index.
const GRADIENT_STEPS: usize = 256;

/// Everything that turns light into palette indices.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tables {
    pub palette: Vec<[u8; 3]>,
    /// For each material, the index of each level.
    pub shades: Vec<[u8; 256]>,
    /// Indices from the top of the screen to its bottom.
    pub background: Vec<u8>,
}

/// A line of colours, as fine as levels are.
struct Ramp {
    colours: Vec<Rgb>,
    /// Length in Oklab from the start to each colour.
    along: Vec<f64>,
}

impl Ramp {
    fn new(colours: Vec<Rgb>) -> Self {
        let lab: Vec<Lab> = colours.iter().map(|c| from_rgb(*c)).collect();
        let mut sum = 0.0;
        let mut along = vec![0.0];
        for pair in lab.windows(2) {
            sum += distance2(pair[0], pair[1]).sqrt();
            along.push(sum);
        }
        Self { colours, along }
    }

    fn length(&self) -> f64 {
        self.along.last().copied().unwrap_or(0.0)
    }

    /// `count` colours, evenly spaced, both ends among them if there are two.
    fn spread(&self, count: usize) -> Vec<[u8; 3]> {
        let last = self.colours.len() - 1;
        (0..count)
            .map(|i| {
                let part = if count > 1 {
                    i as f64 / (count - 1) as f64
                } else {
                    0.5
                };
                let target = part * self.length();
                let at = self.along.partition_point(|a| *a < target).min(last);
                let before = at.saturating_sub(1);
                let step = self.along[at] - self.along[before];
                let way = if step > 0.0 {
                    (target - self.along[before]) / step
                } else {
                    1.0
                };
                let (a, b) = (self.colours[before], self.colours[at]);
                to_bytes([0, 1, 2].map(|c| a[c] + (b[c] - a[c]) * way))
            })
            .collect()
    }
}

pub(crate) fn tables(scene: &Scene) -> Tables {
    let wanted = scene.palette.colours.clamp(2, 256) as usize;
    let background = background_colours(&scene.display.background);
    let mut ramps = vec![Ramp::new(background.clone())];
    for material in &scene.materials {
        let (first, last) = reachable_levels(material, scene);
        let colour = |level| shade(material, &scene.ambient, level);
        ramps.push(Ramp::new((first..=last).map(colour).collect()));
    }

    let palette = deal(&ramps, wanted);
    let lab: Vec<Lab> = palette.iter().map(|c| from_rgb(to_unit(*c))).collect();
    let nearest = |colour: Rgb| -> u8 {
        let target = from_rgb(colour);
        let distance = |i: &usize| distance2(lab[*i], target);
        (0..lab.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0) as u8
    };
    let row = |material: &Material| {
        let mut row = [0; 256];
        for (level, index) in row.iter_mut().enumerate() {
            *index = nearest(shade(material, &scene.ambient, level));
        }
        row
    };
    Tables {
        shades: scene.materials.iter().map(row).collect(),
        background: background.iter().map(|c| nearest(*c)).collect(),
        palette,
    }
}

/// At most `wanted` different colours from all ramps, at least 2.
fn deal(ramps: &[Ramp], wanted: usize) -> Vec<[u8; 3]> {
    let total: f64 = ramps.iter().map(Ramp::length).sum();
    // Ramps often share colours or have fewer than their share: the density is
    // raised as long as the palette stays within bounds.
    let at_density = |density: f64| {
        let mut palette: Vec<[u8; 3]> = Vec::new();
        for ramp in ramps {
            let count = 1 + (ramp.length() * density) as usize;
            for colour in ramp.spread(count) {
                if !palette.contains(&colour) {
                    palette.push(colour);
                }
            }
        }
        palette
    };
    let (mut low, mut high) = (0.0, 8.0 * wanted as f64 / total.max(1e-6));
    let mut best = at_density(0.0);
    for _ in 0..24 {
        let middle = (low + high) / 2.0;
        let palette = at_density(middle);
        if palette.len() <= wanted {
            low = middle;
            if palette.len() >= best.len() || best.len() > wanted {
                best = palette;
            }
        } else {
            high = middle;
        }
    }
    best.truncate(wanted);
    while best.len() < 2 {
        best.push([255, 255, 255]);
    }
    best
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

fn reachable_levels(material: &Material, scene: &Scene) -> (usize, usize) {
    let first = ambient_level(material, &scene.ambient);
    let intensity = |light: &Light| light.intensity * light.colour[0];
    let direct: f64 = scene.lights.iter().map(intensity).sum();
    let last = (first + 255.0 * material.diffuse * direct).clamp(first, 255.0);
    (first.floor() as usize, last.ceil() as usize)
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
