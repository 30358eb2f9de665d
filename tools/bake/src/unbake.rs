//! The way back: a blob becomes a description, so that a baked scene can be
//! held against the reference too.
//!
//! What baking rounds stays rounded: places are grid points, normals are
//! octahedral, a material's colour is the palette's at full light.

use fixel::Scene as Blob;
use fixel::math::{SUBPX_BITS, Scaled};
use fixel::scene as core_scene;
use fixel::scene::layout::CHAINED;
use fixel_scene::{
    Actor, Aspect, Background, Camera, ColourFormat, Cull, Display, Light, LightKind, Lod, Look,
    Mark, Material, Mesh, Palette, PanelDithering, Projection, Ray, Representation, Rgb, Scene,
    Shading, Source, Space, Stereo, Viewport,
};

use crate::normal;
use crate::records::PANEL_DITHERING;
use motion::Places;

mod motion;
mod texture;

/// The description of a baked scene.
pub fn unbake(blob: &Blob<'_>) -> Scene {
    let header = blob.header();
    let places = Places::of(blob);
    let camera = camera(&header.camera, &places);
    let colours = |index: u8| colour(blob, index);
    let rows = blob.height();
    let ends = [0, rows.saturating_sub(1)].map(|y| colours(blob.background(y, rows)));
    // A single one that says nothing is one that the blob does not have.
    let viewports = match blob.viewports_an_eye() {
        1 if blob.viewport(0) == core_scene::Viewport::WHOLE => 0..0,
        count => 0..count,
    };
    Scene {
        display: Display {
            width: header.width.into(),
            height: header.height.into(),
            colour: colour_format(blob.colour_format()),
            dithering: panel_dithering(blob.panel_dithering()),
            background: background(ends),
            samples: blob.output().samples.map(u32::from),
            stereo: stereo(&blob.output()),
        },
        camera,
        viewports: viewports
            .map(|number| viewport(blob, number, &places))
            .collect(),
        ambient: [1.0; 3],
        lights: blob
            .lights()
            .map(|l| {
                light(
                    &l,
                    places.length(1 << 16),
                    places.point(l.position).to_array(),
                )
            })
            .collect(),
        textures: texture::textures(blob),
        materials: (0..blob.material_count())
            .map(|i| {
                material(
                    blob,
                    i,
                    &blob.material(i),
                    colours(blob.shade(&blob.material(i))[255]),
                )
            })
            .collect(),
        meshes: meshes(blob),
        actors: motion::actors(blob, &places)
            .into_iter()
            .zip(0..)
            .map(|(actor, i)| Actor {
                look: look(blob, i),
                ..actor
            })
            .collect(),
        fog: blob
            .fog()
            .map(|fog| crate::fog::unbake(&fog, |bits| places.length(bits))),
        animation: motion::animation(blob, &places),
        lod: lod(blob),
        ray: Ray::default(),
        source: Source::default(),
        palette: if blob.is_direct() {
            Palette {
                direct: true,
                ..Palette::default()
            }
        } else {
            Palette {
                colours: blob.palette().len() as u32,
                fixed: blob.palette().to_vec(),
                ..Palette::default()
            }
        },
    }
}

fn camera(record: &core_scene::CameraRecord, places: &Places) -> Camera {
    let length = |bits: i32| places.length(bits);
    let point = |bits: [i32; 3]| places.point(bits).to_array();
    Camera {
        position: point(record.position),
        focal_point: point(record.focal_point),
        view_up: record.view_up.map(|c| f64::from(c) / f64::exp2(30.0)),
        projection: if record.projection == 0 {
            let tangent = f64::from(record.half_height) / f64::exp2(24.0);
            Projection::Perspective {
                view_angle: 2.0 * tangent.atan().to_degrees(),
            }
        } else {
            Projection::Parallel {
                parallel_scale: length(record.half_height as i32),
            }
        },
        clipping_range: [record.near, record.far]
            .map(|d| length(d) * f64::exp2(record.range_exponent.into())),
    }
}

fn viewport(blob: &Blob<'_>, number: u16, places: &Places) -> Viewport {
    let record = blob.viewport(number);
    let [left, top, right, bottom] = record
        .sides
        .map(|side| f64::from(side) / f64::from(core_scene::FULL_SIDE));
    let rows = blob.height();
    let gradient = blob.viewport_background(number);
    let ends = [0, rows.saturating_sub(1)].map(|y| colour(blob, gradient.at(y, rows)));
    Viewport {
        rectangle: [left, 1.0 - bottom, right - left, bottom - top],
        camera: record.camera.map(|c| camera(&c, places)),
        background: (record.background.1 != 0).then(|| background(ends)),
        aspect: if record.stretch {
            Aspect::Stretch
        } else {
            Aspect::Keep
        },
    }
}

/// How much detail may be left out.
fn lod(blob: &Blob<'_>) -> Option<Lod> {
    let sub_pixels = f64::from(blob.header().level_error) / f64::from(1 << SUBPX_BITS);
    let [across, down] = blob.output().samples.map(f64::from);
    let error = sub_pixels / across.min(down);
    (error > 0.0).then_some(Lod { error })
}

fn colour(blob: &Blob<'_>, index: u8) -> Rgb {
    let colour = blob.palette().get(usize::from(index)).copied();
    colour.unwrap_or_default().map(|c| f64::from(c) / 255.0)
}

fn stereo(output: &core_scene::Output) -> Stereo {
    let slope = f64::from(output.eye_slope) / f64::from(1 << 30);
    let eye_angle = 2.0 * slope.atan().to_degrees();
    match output.stereo {
        core_scene::Stereo::None => Stereo::None,
        core_scene::Stereo::Anaglyph => Stereo::Anaglyph { eye_angle },
        core_scene::Stereo::SideBySide => Stereo::SideBySide { eye_angle },
    }
}

pub(crate) fn colour_format(format: core_scene::ColourFormat) -> ColourFormat {
    match format {
        core_scene::ColourFormat::Rgb888 => ColourFormat::Rgb888,
        core_scene::ColourFormat::Rgb565 => ColourFormat::Rgb565,
        core_scene::ColourFormat::Rgb444 => ColourFormat::Rgb444,
        core_scene::ColourFormat::Gray8 => ColourFormat::Gray8,
        core_scene::ColourFormat::Gray4 => ColourFormat::Gray4,
        core_scene::ColourFormat::Gray2 => ColourFormat::Gray2,
        core_scene::ColourFormat::Mono => ColourFormat::Mono,
    }
}

pub(crate) fn panel_dithering(way: core_scene::PanelDithering) -> PanelDithering {
    let found = PANEL_DITHERING.iter().find(|(_, core)| *core == way);
    found.map_or(PanelDithering::None, |(own, _)| *own)
}

fn background([top, bottom]: [Rgb; 2]) -> Background {
    if top == bottom {
        Background::Solid(top)
    } else {
        Background::Gradient { top, bottom }
    }
}

fn light(light: &core_scene::Light, scene_unit: f64, position: [f64; 3]) -> Light {
    let direction = light.towards.map(|c| -f64::from(c));
    let strength = light.colour.map(|c| f64::from(c) / 65536.0);
    let intensity = strength.into_iter().fold(0.0, f64::max);
    let scaled = |s: Scaled| f64::from(s.mantissa()) * f64::exp2(f64::from(s.exponent()));
    let [c, l, q] = light.attenuation.map(scaled);
    let attenuation = [c, l / scene_unit, q / (scene_unit * scene_unit)];
    Light {
        kind: match light.kind {
            core_scene::LightKind::Directional => LightKind::Directional { direction },
            core_scene::LightKind::Point => LightKind::Point {
                position,
                attenuation,
            },
            core_scene::LightKind::Spot => LightKind::Spot {
                position,
                direction,
                attenuation,
                cone_angle: (f64::from(light.cone) / f64::exp2(30.0))
                    .acos()
                    .to_degrees(),
                exponent: f64::from(light.exponent) / 256.0,
            },
        },
        colour: strength.map(|c| if intensity > 0.0 { c / intensity } else { 1.0 }),
        intensity,
        edges: None,
    }
}

fn material(
    blob: &Blob<'_>,
    number: u16,
    material: &core_scene::Material,
    colour: Rgb,
) -> Material {
    let unit = |level: u16| f64::from(level) / (64.0 * 255.0);
    let channels = material.channels;
    let (opacity, transparency) = crate::transparency::unbake(material.transparency);
    let [specular, ..] = channels.specular;
    let by_level = Material {
        ambient_colour: colour,
        diffuse_colour: colour,
        specular_colour: colour,
        ambient: unit(material.ambient),
        diffuse: f64::from(material.diffuse) / 65536.0,
        specular: unit(specular),
        ..Material::default()
    };
    let by_colour = || Material {
        ambient_colour: channels.constant.map(unit),
        diffuse_colour: channels.diffuse.map(unit),
        specular_colour: channels.specular.map(unit),
        ambient: 1.0,
        specular: 1.0,
        ..Material::default()
    };
    Material {
        name: format!("material {}", number + 1),
        specular_power: f64::from(material.power) / 256.0,
        opacity,
        transparency,
        texture: material.texture.and_then(|t| texture::texturing(blob, t)),
        shading: match material.shading {
            core_scene::Shading::Flat => Shading::Flat,
            core_scene::Shading::Gouraud => Shading::Gouraud,
            core_scene::Shading::Phong => Shading::Phong,
        },
        cull: match material.cull {
            core_scene::Cull::Back => Cull::Back,
            core_scene::Cull::Front => Cull::Front,
            core_scene::Cull::None => Cull::None,
        },
        ..if material.coloured {
            by_colour()
        } else {
            by_level
        }
    }
}

/// How an actor is drawn.
fn look(blob: &Blob<'_>, actor: u16) -> Look {
    let Some(look) = blob.look(actor) else {
        return Look::default();
    };
    Look {
        representation: match look.representation {
            core_scene::Representation::Wireframe => Representation::Wireframe,
            core_scene::Representation::HiddenLine => Representation::HiddenLine,
            core_scene::Representation::Points => Representation::Points,
        },
        depth_test: look.depth_test,
        bias: look.bias.into(),
        line_width: look.line_width.into(),
        mark: Mark::Bitmap {
            size: look.mark_size,
            offset: look.mark_offset,
            rows: blob.mark(&look).to_vec(),
        },
        space: if look.on_screen {
            Space::Screen
        } else {
            Space::World
        },
    }
}

/// All meshes, those of actors on the screen in pixels.
fn meshes(blob: &Blob<'_>) -> Vec<Mesh> {
    let mut meshes: Vec<Mesh> = (0..blob.mesh_count()).map(|i| mesh(blob, i)).collect();
    for i in 0..blob.actor_count() {
        if blob.look(i).is_some_and(|look| look.on_screen) {
            let actor = blob.actor(i);
            let step =
                f64::from(actor.step_mantissa) * f64::exp2(f64::from(actor.step_exponent - 31));
            let offset = actor.offset.map(|c| f64::from(c) / 65536.0);
            for position in &mut meshes[usize::from(actor.mesh)].positions {
                *position = [0, 1, 2].map(|axis| offset[axis] + position[axis] * step);
            }
        }
    }
    meshes
}

/// A mesh in grid steps, its triangles and edges in the blob's order.
fn mesh(blob: &Blob<'_>, number: u16) -> Mesh {
    let record = blob.mesh(number);
    let mut mesh = Mesh {
        name: format!("mesh {}", number + 1),
        ..Mesh::default()
    };
    for i in 0..record.meshlets {
        let Some(meshlet) = blob.meshlet(record.first_meshlet + i) else {
            continue;
        };
        let first = mesh.positions.len() as u32;
        let fine = blob.meshlet_fine(&meshlet, &record);
        for (i, vertex) in blob.meshlet_vertices(&meshlet).iter().enumerate() {
            let low = fine.get(i).copied().unwrap_or_default().map(i32::from);
            let [x, y, z, code] = vertex.map(i16::from_le);
            let steps = [x, y, z].map(i32::from);
            let place =
                [0, 1, 2].map(|a| meshlet.base[a] + (steps[a] << meshlet.shifts[a]) + low[a]);
            mesh.positions.push(place.map(f64::from));
            let code = code.to_le_bytes().map(|b| i32::from(b as i8));
            let normal = if fine.is_empty() {
                normal::decode(code, normal::COARSE)
            } else {
                let [u, v] = code.map(|c| c << 4);
                normal::decode([u | low[3] & 15, v | low[3] >> 4], normal::FINE)
            };
            mesh.normals.push(normal.to_array());
        }
        mesh.texture_coordinates
            .extend(texture::coordinates(blob, &meshlet, &record));
        let tints = blob.meshlet_colours(&meshlet, &record).iter();
        mesh.colours
            .extend(tints.map(|[r, g, b, _]| [r, g, b].map(|c| f64::from(*c) / 255.0)));
        let corners = |t: &[u8; 3]| t.map(|v| first + u32::from(v));
        let (edges, _) = blob.meshlet_edges(record.first_meshlet + i);
        let ends = |[from, to]: &[u8; 2]| [*from, to & !CHAINED].map(|v| first + u32::from(v));
        mesh.edges.extend(edges.iter().map(ends));
        mesh.triangles
            .extend(blob.meshlet_triangles(&meshlet).iter().map(corners));
    }
    mesh
}
