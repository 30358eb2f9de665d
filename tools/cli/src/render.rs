//! `fixel render`.

use crate::args::{Destination, Renderer};
use crate::input::Input;
use crate::{args, input, output, raster, reference};
use anyhow::Result;
use clap::{CommandFactory, error::ErrorKind};
use fixel_scene::Scene;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What any renderer delivers.
struct Picture {
    rgb: Vec<[u8; 3]>,
    /// Width and height of what follows: a pixel's samples, and the pictures of an
    /// anaglyph, are apart there.
    samples: (u32, u32),
    depth: Vec<u16>,
    actor: Vec<u16>,
    stats: Map<String, Value>,
}

/// Renders one frame and writes what was asked for.
pub fn run(args: &args::Render) -> Result<()> {
    let picture_path = match &args.output {
        Some(path) => path.clone(),
        None => default_output(&args.input.scene),
    };
    let outputs = outputs(args, &picture_path);
    refuse_same_file(&outputs, &picture_path);
    let input = input::load_on(&args.input, args.screen.get(), &outputs)?;
    let pictures = [
        Some(&picture_path),
        args.depth_out.as_ref(),
        args.id_out.as_ref(),
    ];
    for path in pictures.into_iter().flatten() {
        output::refuse_other_than_png(path)?;
    }
    let options = input::options(&input.scene, &args.frame);
    let (width, height) = (options.width, options.height);
    let started = Instant::now();
    let mut stats = common_stats(args, &input.scene, options);
    let wholes: Vec<_> = (0..input.scene.actors.len())
        .map(|actor| input.scene.whole(actor) as u16 + 1)
        .collect();
    let mut picture = draw(args, input, options)?;
    for id in picture.actor.iter_mut().filter(|id| **id != 0) {
        *id = wholes[usize::from(*id) - 1];
    }
    let milliseconds = started.elapsed().as_secs_f64() * 1e3;

    let (columns, rows) = picture.samples;
    output::write(
        &picture_path,
        &output::png_rgb(width, height, &picture.rgb)?,
    )?;
    if let Some(path) = &args.depth_out {
        output::write(path, &output::png_grey16(columns, rows, &picture.depth)?)?;
    }
    if let Some(path) = &args.id_out {
        output::write(path, &output::png_grey16(columns, rows, &picture.actor)?)?;
    }
    if let Some(destination) = &args.stats {
        let covered = picture.actor.iter().filter(|id| **id != 0).count();
        stats.insert("covered_px".into(), json!(covered));
        stats.insert("render_ms".into(), json!(milliseconds));
        stats.extend(picture.stats);
        output::json(destination, &stats)?;
    }
    eprintln!("wrote {} ({width}x{height})", picture_path.display());
    Ok(())
}

/// In the current folder, the scene's name with `.png`.
fn default_output(scene: &Path) -> PathBuf {
    let mut name = scene.file_stem().unwrap_or("frame".as_ref()).to_owned();
    name.push(".png");
    name.into()
}

/// The files that will be written.
fn outputs<'a>(args: &'a args::Render, picture: &'a Path) -> [Option<&'a Path>; 4] {
    [
        Some(picture),
        args.depth_out.as_deref(),
        args.id_out.as_deref(),
        args.stats.as_ref().and_then(Destination::file),
    ]
}

/// Two outputs to one file are wrong usage.
fn refuse_same_file(outputs: &[Option<&Path>], picture: &Path) {
    for (i, path) in outputs.iter().enumerate() {
        if path.is_some() && outputs[..i].contains(path) {
            let name = path.unwrap_or(picture).display();
            let message = format!("two outputs go to the same file {name}");
            args::Cli::command()
                .error(ErrorKind::ArgumentConflict, message)
                .exit();
        }
    }
}

fn draw(args: &args::Render, input: Input, at: fixel_reference::Options) -> Result<Picture> {
    match args.renderer {
        Renderer::Reference => {
            let truth = reference::render(&input.scene, at);
            Ok(Picture {
                rgb: reference::picture(&input.scene, at, &truth),
                samples: (truth.width(), truth.height()),
                depth: truth.depth16(),
                actor: truth.actor_ids(),
                stats: Map::new(),
            })
        }
        Renderer::RayReference => {
            let truth = reference::render_rays(&input.scene, at);
            let mut stats = Map::new();
            if let Some(rays) = truth.rays() {
                stats.insert("rays_camera".into(), json!(rays.camera));
                stats.insert("rays_bounced".into(), json!(rays.bounced));
                stats.insert("rays_shadow".into(), json!(rays.shadow));
            }
            Ok(Picture {
                rgb: truth.picture(),
                samples: (truth.width(), truth.height()),
                depth: truth.depth16(),
                actor: truth.actor_ids(),
                stats,
            })
        }
        Renderer::Raster | Renderer::Ray => {
            let options = raster::Options {
                rays: args.renderer == Renderer::Ray,
                width: at.width,
                height: at.height,
                frame: at.frame,
                bands: args.bands,
            };
            let rendered = raster::render(input, options)?;
            let frame = rendered.frame;
            Ok(Picture {
                rgb: rendered.picture,
                samples: (frame.width, frame.height),
                depth: frame.depth,
                actor: frame.actor,
                stats: rendered.stats,
            })
        }
    }
}

/// What holds for every renderer.
fn common_stats(
    args: &args::Render,
    scene: &Scene,
    options: fixel_reference::Options,
) -> Map<String, Value> {
    let triangles = |actor: &fixel_scene::Actor| scene.meshes[actor.mesh].triangles.len();
    let renderer = match args.renderer {
        Renderer::Raster => "raster",
        Renderer::Ray => "ray",
        Renderer::Reference => "reference",
        Renderer::RayReference => "ray-reference",
    };
    let fields = [
        ("scene", json!(args.input.scene.display().to_string())),
        ("renderer", json!(renderer)),
        ("width", json!(options.width)),
        ("height", json!(options.height)),
        ("frame", json!(options.frame)),
        (
            "actors",
            json!(scene.actors.iter().filter(|actor| !actor.part).count()),
        ),
        (
            "triangles",
            json!(scene.actors.iter().map(triangles).sum::<usize>()),
        ),
    ];
    fields
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}
