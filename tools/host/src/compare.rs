//! A frame in the shape that is held against the reference.

use fixel::Scene;
use fixel::render::Ids;
use fixel::scene::layout::BASES;
use fixel::scene::{Dither, Material};
use fixel_bake::Baked;
use fixel_reference::{Frame, Lookup, NO_TRIANGLE, Path};

use crate::Planes;
use crate::colour::{before_dithering, pixels};
use crate::direct::direct;
use crate::planes::{self, Options};

/// Renders every plane of a baked scene.
pub fn frame(baked: &Baked, scene: &Scene<'_>, options: &Options) -> (Frame, Planes) {
    let drawn = planes::render(scene, options);
    let there: Vec<bool> = drawn.depth.iter().map(|d| *d != 0).collect();
    let actor = planes::actors(scene, options).into_iter().zip(&there);
    let triangle = planes::triangles(scene, options).into_iter().zip(&there);
    let source = |id: u32| {
        let sources = &baked.sources;
        let (of, number) = if id & Ids::POINT != 0 {
            (&sources.vertices, id - Ids::POINT)
        } else if id & Ids::EDGE != 0 {
            (&sources.edges, id - Ids::EDGE)
        } else {
            (&sources.triangles, id)
        };
        of.get(number as usize).map_or(NO_TRIANGLE, |s| s.triangle)
    };
    // What dithers is held against the reference as it is without.
    let index = planes::undithered(scene, options);
    let frame = Frame {
        width: drawn.size.0.into(),
        height: drawn.size.1.into(),
        actor: actor
            .map(|(id, there)| if *there { id + 1 } else { 0 })
            .collect(),
        triangle: triangle
            .map(|(id, there)| if *there { source(id) } else { NO_TRIANGLE })
            .collect(),
        light: planes::light(scene, options),
        rgb: if scene.is_direct() {
            let rows = options.band_rows.unwrap_or(drawn.size.1);
            direct(scene, drawn.size, rows, options.frame, Dither::NONE)
        } else {
            pixels(&before_dithering(scene, options.frame), &index)
        },
        index,
        depth: drawn.depth.clone(),
        texture_place: planes::texture_place(scene, options),
        lit: Vec::new(),
        lookup: lookup(scene, options, drawn.size),
    };
    (frame, drawn)
}

/// The ways from light to the indices of a frame.
pub(crate) fn lookup(scene: &Scene<'_>, options: &Options, size: (u16, u16)) -> Lookup {
    let coloured = (0..scene.material_count()).any(|m| scene.material(m).coloured);
    let path = |m| {
        let material = scene.material(m);
        if material.coloured && material.texture.is_some() {
            let bases = scene.bases().to_vec();
            Path::TexturedColour { bases }
        } else if material.coloured {
            Path::Colour
        } else if material.texture.is_some() {
            textured(scene, &material)
        } else {
            Path::Level(Box::new(*scene.shade(&material)))
        }
    };
    Lookup {
        paths: (0..scene.material_count()).map(path).collect(),
        direct: scene.is_direct(),
        colours: if coloured {
            scene.colours().to_vec()
        } else {
            Vec::new()
        },
        fog: scene.fog_table().map_or(Vec::new(), |table| table.to_vec()),
        background: backgrounds(scene, options, size),
        palette: before_dithering(scene, options.frame),
    }
}

/// The way of a material with a texture that goes by level: the core's tables have
/// longer rows.
fn textured(scene: &Scene<'_>, material: &Material) -> Path {
    let bases = scene.bases().to_vec();
    let rows = scene.texture_shades(material).chunks(BASES);
    Path::Textured {
        shade: rows.flat_map(|row| row[..bases.len()].to_vec()).collect(),
        bases,
    }
}

/// The background's palette index at each pixel, viewports on top of each other.
fn backgrounds(scene: &Scene<'_>, options: &Options, (width, height): (u16, u16)) -> Vec<u8> {
    let mut all = Vec::new();
    for y in 0..height {
        all.resize(all.len() + usize::from(width), scene.background(y, height));
    }
    let pose = scene.pose(options.frame);
    for number in 0..scene.viewport_count() {
        let rect = scene.place_viewport(number, &pose, width, height).rect;
        let background = scene.viewport_background(number);
        for y in rect.top..rect.bottom {
            let row = usize::from(y) * usize::from(width);
            let index = background.at(y - rect.top, rect.height());
            all[row + usize::from(rect.left)..row + usize::from(rect.right)].fill(index);
        }
    }
    all
}
