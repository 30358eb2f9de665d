//! Scenes without a palette: all materials go by colour, and entries are those of the
//! backgrounds alone, which the blob has as indices.

use fixel_scene::{ColourFormat, Rgb, Scene, Stereo};

use super::{Nearest, Path, Sample, Tables, background_colours, choose, indices, to_bytes};

/// What of a scene does not do without a palette.
pub(crate) fn needs_palette(scene: &Scene, rays: bool) -> Option<&'static str> {
    let display = &scene.display;
    let needs = [
        (rays, "palette.direct by rays"),
        (
            display.colour != ColourFormat::Rgb565,
            "palette.direct with another display.colour than \"rgb565\"",
        ),
        (
            display.samples != [1, 1],
            "palette.direct with display.antialiasing",
        ),
        (
            matches!(display.stereo, Stereo::Anaglyph { .. }),
            "palette.direct with an anaglyph",
        ),
        (
            scene.animation.palette_cycle.is_some(),
            "palette.direct with animation.palette_cycle",
        ),
    ];
    let mut needs = needs.into_iter().filter(|(needed, _)| *needed);
    needs.next().map(|(_, what)| what)
}

/// Tables without any for surfaces. Up to 256 different colours, backgrounds are exact to
/// 8 bits.
pub(crate) fn direct(scene: &Scene) -> Tables {
    let own: Vec<Vec<Rgb>> = scene
        .viewports
        .iter()
        .map(|viewport| viewport.background.as_ref())
        .map(|background| background.map_or(Vec::new(), background_colours))
        .collect();
    let background = background_colours(&scene.display.background);
    let all: Vec<Rgb> = own.iter().flatten().chain(&background).copied().collect();
    let mut palette: Vec<[u8; 3]> = Vec::new();
    for colour in all.iter().map(|colour| to_bytes(*colour)) {
        if !palette.contains(&colour) {
            palette.push(colour);
        }
    }
    if palette.len() > 256 {
        let samples = all.iter().map(|&colour| Sample {
            colour,
            weight: 1.0,
        });
        palette = choose(&samples.collect::<Vec<_>>(), &[], 256);
    }
    while palette.len() < 2 {
        palette.push([255; 3]);
    }
    let nearest = Nearest::new(&palette);
    Tables {
        paths: vec![Path::Colour; scene.materials.len()],
        shades: Vec::new(),
        texture_shades: Vec::new(),
        colours: Vec::new(),
        background: indices(&nearest, &background),
        viewport_backgrounds: own.iter().map(|c| indices(&nearest, c)).collect(),
        fog: Vec::new(),
        palette,
        // A step of red or blue.
        spread: 1.0 / 31.0,
    }
}
