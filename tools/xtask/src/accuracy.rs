//! The core's pictures held against the f64 reference, on every scene.

mod limits;

use std::path::Path;

use fixel_reference::{Frame, Report, Truth};
use fixel_report::{Entry, Page};
use fixel_scene::{ColourFormat, Filter, Representation, Scene, Texturing};
use serde_json::{Map, Value, json};

use self::limits::Held;
use crate::problem::{Problem, Result};
use crate::report::{Tally, table};
use crate::{parallel, scene};

/// The report's first page.
const INDEX: &str = "index.html";

/// The core's two renderers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Renderer {
    Raster,
    Ray,
}

impl Renderer {
    const ALL: [Self; 2] = [Self::Raster, Self::Ray];

    fn name(self) -> &'static str {
        match self {
            Self::Raster => "raster",
            Self::Ray => "ray",
        }
    }
}

/// A scene by a renderer.
struct Compared {
    /// The page and the small picture of a report, if one is asked for.
    page: Option<(String, String)>,
    held: Held,
}

/// Compares every scene in `scenes/`, `scenes/bench/`, `scenes/ray/` and `scenes/small/`, frame 0,
/// at its own size, by both renderers. Gives `{"scene": {"raster": {...}, "ray": {...}}}` with the fields of `fixel
/// compare --json`, and `rgb888_psnr_true_db`, the colour on a display with 8
/// bits a channel. Each scene is held to limits. `report`: a folder for a page a scene and
/// renderer, and an index over them.
pub fn run(tally: &mut Tally, report: Option<&Path>) -> Result<Value> {
    if let Some(folder) = report {
        let fail = |error| format!("cannot make the folder {}: {error}", folder.display());
        std::fs::create_dir_all(folder).map_err(fail)?;
    }
    let mut entries = Vec::new();
    let files = scene::all()?;
    let jobs: Vec<(&Path, Renderer)> = files
        .iter()
        .flat_map(|file| Renderer::ALL.map(|renderer| (file.as_path(), renderer)))
        .collect();
    let compared = parallel::map(&jobs, |&(file, renderer)| {
        compare(file, renderer, report.is_some())
    });
    let mut all = Map::new();
    for ((file, renderer), compared) in jobs.into_iter().zip(compared) {
        let name = scene::name(file);
        let what = format!("accuracy of {name} by {}", renderer.name());
        let Some(Some(compared)) = tally.need(&what, compared) else {
            continue;
        };
        let limits = match renderer {
            Renderer::Raster => compared.held.by_triangles(),
            Renderer::Ray => compared.held.by_rays(&name),
        };
        let broken = limits.as_ref().err().map(ToString::to_string);
        tally.check(&what, limits);
        let figures = compared.figures()?;
        if let (Some(folder), Some((page, picture))) = (report, compared.page) {
            let path = format!("{name}-{}.html", renderer.name());
            fixel_output::write(&folder.join(&path), page.as_bytes())?;
            entries.push(Entry {
                scene: name.clone(),
                renderer: renderer.name().into(),
                file: path,
                picture,
                figures: figures.clone(),
                broken,
            });
        }
        let scene = all.entry(name).or_insert_with(|| json!({}));
        scene[renderer.name()] = figures;
    }
    if let Some(folder) = report {
        let path = folder.join(INDEX);
        fixel_output::write(&path, fixel_report::index(&entries).as_bytes())?;
        eprintln!("wrote {}", path.display());
    }
    Ok(all.into())
}

/// `None`: the renderer draws nothing of the scene.
fn compare(file: &Path, renderer: Renderer, pages: bool) -> Result<Option<Compared>> {
    let mut scene = fixel_scene::load(file).map_err(|error| error.to_string())?;
    let without_palette = scene.palette.direct;
    if renderer == Renderer::Ray && (without_palette || !has_surfaces(&scene)) {
        return Ok(None);
    }
    let in_file = |problem: Problem| match problem {
        Problem::Missing(text) => Problem::Missing(format!("{}: {text}", file.display())),
        Problem::Failed(text) => Problem::Failed(format!("{}: {text}", file.display())),
    };
    let (report, frame, truth) = report(&scene, renderer).map_err(in_file)?;
    let mut rgb888_psnr_db = report.rgb_psnr_true_db;
    if !without_palette {
        scene.display.colour = ColourFormat::Rgb888;
        let (report, ..) = self::report(&scene, renderer).map_err(in_file)?;
        rgb888_psnr_db = report.rgb_psnr_true_db;
    }
    // They have more colours than a palette.
    let blended = |texture: &Texturing| texture.filter == Filter::Bilinear;
    let blended_texels = scene
        .materials
        .iter()
        .any(|m| m.texture.as_ref().is_some_and(blended));
    let held = Held {
        report,
        rgb888_psnr_db,
        one_material: scene.materials.len() == 1 && !without_palette && !blended_texels,
        without_palette,
        lod: scene.lod.is_some(),
    };
    let mut compared = Compared { page: None, held };
    if pages {
        let page = fixel_report::page(&Page {
            title: format!("{} by {}", scene::name(file), renderer.name()),
            truth: &truth,
            frame: &frame,
            figures: &compared.figures()?,
            index: Some(INDEX),
        });
        let page = page.map_err(|error| error.to_string())?;
        compared.page = Some((page, Entry::small(&frame)));
    }
    Ok(Some(compared))
}

impl Compared {
    /// As JSON has them.
    fn figures(&self) -> Result<Value> {
        let report = serde_json::to_value(&self.held.report);
        let mut report = report.map_err(|error| error.to_string())?;
        report["rgb888_psnr_true_db"] = json!(self.held.rgb888_psnr_db);
        Ok(report)
    }
}

/// Whether there is anything that rays meet.
fn has_surfaces(scene: &Scene) -> bool {
    let mut looks = scene.actors.iter().map(|actor| actor.look.representation);
    looks.any(|look| look == Representation::Surface)
}

fn report(scene: &Scene, renderer: Renderer) -> Result<(Report, Frame, Truth)> {
    let baked = match renderer {
        Renderer::Raster => fixel_bake::bake(scene),
        Renderer::Ray => fixel_bake::bake_for_rays(scene),
    };
    let baked = baked.map_err(|error| match error.problem {
        fixel_bake::Problem::NotYet { .. } => Problem::Missing(error.to_string()),
        _ => Problem::Failed(error.to_string()),
    })?;
    let core = fixel::Scene::parse(baked.bytes()).map_err(|error| error.to_string())?;
    let options = fixel_host::Options::of(&core);
    let at = fixel_reference::Options {
        width: options.width.into(),
        height: options.height.into(),
        frame: options.frame,
    };
    let (frame, truth) = match renderer {
        Renderer::Raster => (
            fixel_host::frame(&baked, &core, &options).0,
            fixel_reference::render(scene, at),
        ),
        Renderer::Ray => (
            fixel_host::ray_frame(&baked, &core, &options).0,
            fixel_reference::render_rays(scene, at),
        ),
    };
    let report = fixel_reference::compare(&truth, &frame).map_err(|error| error.to_string())?;
    Ok((report, frame, truth))
}

/// The README's tables.
pub fn markdown(figures: &Value) -> String {
    type Field = (&'static str, fn(&Value) -> String);
    fn whole(value: &Value) -> String {
        value.as_u64().unwrap_or_default().to_string()
    }
    fn real(value: &Value) -> String {
        format!("{:.2}", value.as_f64().unwrap_or_default())
    }
    let of = |renderer: Renderer, columns: &[(&str, Field)]| {
        let scenes = figures.as_object().into_iter().flatten();
        let scenes = scenes.filter_map(|(name, of)| Some((name, of.get(renderer.name())?)));
        let cells = |(name, report): (&String, &Value)| {
            let fields = columns
                .iter()
                .map(|(_, (field, text))| text(&report[field]));
            std::iter::once(name.clone()).chain(fields).collect()
        };
        let head: Vec<&str> = std::iter::once("scene")
            .chain(columns.iter().map(|(title, _)| *title))
            .collect();
        table(&head, &scenes.map(cells).collect::<Vec<_>>())
    };
    let raster = of(
        Renderer::Raster,
        &[
            ("covered px", ("covered_px", whole)),
            ("coverage differs, px", ("coverage_mismatch_px", whole)),
            ("other triangle, px", ("visible_mismatch_px", whole)),
            ("depth, max of 65535", ("depth_max_lsb", real)),
            ("within 1, %", ("depth_within_1_percent", real)),
            ("light, max of 255", ("level_max", real)),
            ("light within 2, %", ("level_within_2_percent", real)),
            ("colour, dB", ("rgb_psnr_db", real)),
            ("unquantised, dB", ("rgb_psnr_true_db", real)),
            ("8 bits a channel, dB", ("rgb888_psnr_true_db", real)),
        ],
    );
    let ray = of(
        Renderer::Ray,
        &[
            ("covered px", ("covered_px", whole)),
            ("coverage differs, px", ("coverage_mismatch_px", whole)),
            ("other surface, px", ("visible_mismatch_px", whole)),
            ("depth within 1, %", ("depth_within_1_percent", real)),
            ("lit px", ("lit_px", whole)),
            ("wrong shadow, px", ("shadow_mismatch_px", whole)),
            ("in clusters", ("shadow_mismatch_clusters", whole)),
            ("colour, dB", ("rgb_psnr_db", real)),
            ("unquantised, dB", ("rgb888_psnr_true_db", real)),
        ],
    );
    format!(
        "Against the f64 reference; `cargo xtask accuracy`. The rasteriser:\n\n{raster}\n\
         The ray caster, against rays in f64 (shadows, mirrors and glass included):\n\n{ray}"
    )
}
