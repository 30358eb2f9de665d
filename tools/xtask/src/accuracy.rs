//! The core's pictures held against the f64 reference, on every scene.

use std::path::Path;

use fixel_reference::{Frame, Report, Truth};
use fixel_report::{Entry, Page};
use fixel_scene::{ColourFormat, Filter, Representation, Scene, Texturing};
use serde_json::{Map, Value, json};

use crate::problem::{Problem, Result};
use crate::report::{Tally, table};
use crate::{parallel, scene};

/// Most pixels whose coverage may differ, as a share of the covered ones, and
/// always one pixel.
const COVERAGE_PERCENT: f64 = 0.02;
/// Most that places in textures are off in the mean, in texels.
const TEXELS: f64 = 0.25;
/// Fewest agreeing pixels, in percent, whose depth is within one unit.
const DEPTH_WITHIN_1_PERCENT: f64 = 99.9;
/// Fewest agreeing pixels, in percent, whose light is within 2 of 255.
const LEVEL_WITHIN_2_PERCENT: f64 = 99.0;
/// Least PSNR against the truth through the same palette.
const SAME_PALETTE_DB: f64 = 40.0;
/// Least PSNR against the unquantised truth: a palette without the colours that a scene
/// shows does not come near it.
const TRUE_DB: f64 = 30.0;
/// Least PSNR of a scene of one material against the unquantised truth, on a
/// display with 8 bits a channel: 16-bit colour alone costs all but 42 dB.
const PSNR_DB: f64 = 45.0;
/// Least PSNR of a scene without a palette against the unquantised truth, at 16 bits: the
/// rounding to them costs all but 42 dB, and what is mixed is rounded twice.
const DIRECT_DB: f64 = 40.0;

/// Of a scene with level of detail, whose coarser meshes are off by half a pixel: most pixels
/// whose coverage may differ, as a share of the covered ones.
const LOD_COVERAGE_PERCENT: f64 = 0.5;
/// Most that light is off in the mean there, of 255.
const LOD_LEVEL: f64 = 2.0;

/// Of the ray caster: most pixels that show another surface, as a share of the picture,
/// and always one pixel.
const RAY_SURFACE_PERCENT: f64 = 0.01;
/// Most pixels with a wrong shadow, as a share of the lit ones, and always one.
const RAY_SHADOW_PERCENT: f64 = 0.1;

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

/// A scene's figures.
struct Compared {
    /// The page and the small picture of a report, if one is asked for.
    page: Option<(String, String)>,
    report: Report,
    /// The PSNR that is held to a limit, if it is.
    rgb888_psnr_db: f64,
    one_material: bool,
    /// Colours are as they are lit, but for what 16 bits leave of them.
    without_palette: bool,
    /// It is drawn with coarser meshes from afar.
    lod: bool,
}

/// Compares every scene in `scenes/`, `scenes/bench/` and `scenes/ray/`, frame 0, at its own
/// size, by both renderers. Gives `{"scene": {"raster": {...}, "ray": {...}}}` with the fields of `fixel
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
            Renderer::Raster if compared.lod => lod_limits(&compared.report),
            Renderer::Raster => limits(&compared),
            Renderer::Ray => ray_limits(&compared.report).map_err(|problem| known(&name, problem)),
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
    let mut compared = Compared {
        page: None,
        one_material: scene.materials.len() == 1 && !without_palette && !blended_texels,
        without_palette,
        lod: scene.lod.is_some() && renderer == Renderer::Raster,
        report,
        rgb888_psnr_db,
    };
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
        let report = serde_json::to_value(&self.report);
        let mut report = report.map_err(|error| error.to_string())?;
        report["rgb888_psnr_true_db"] = json!(self.rgb888_psnr_db);
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

/// Scenes that the ray caster cannot draw within the limits, and why.
const RAY_KNOWN: [(&str, &str); 2] = [
    (
        "mono_bunny",
        "two pixels of 8,192: of triangles smaller than a pixel so many edges pass pixels' centres \
         that one within a step of the mesh's grid is no rarity",
    ),
    (
        "suzanne",
        "a face four pixels wide that lies edge-on to the light to within a step of the mesh's \
         grid: whether it is lit at all hangs on that",
    ),
];

/// A problem that is known is none of the code as it is.
fn known(scene: &str, problem: Problem) -> Problem {
    match (RAY_KNOWN.iter().find(|(name, _)| *name == scene), problem) {
        (Some((_, why)), Problem::Failed(what)) => Problem::Missing(format!("{what}: {why}")),
        (_, problem) => problem,
    }
}

fn ray_limits(report: &Report) -> Result<()> {
    let mut broken = Vec::new();
    let share = |count: usize, percent: f64| (count as f64 * percent / 100.0).max(1.0);
    let pixels = (report.width * report.height) as usize;
    let others = report.coverage_mismatch_px + report.visible_mismatch_px;
    if others as f64 > share(pixels, RAY_SURFACE_PERCENT) {
        broken.push(format!("another surface on {others} of {pixels} pixels"));
    }
    if report.depth_within_1_percent < DEPTH_WITHIN_1_PERCENT {
        let percent = report.depth_within_1_percent;
        broken.push(format!("depth is within 1 unit on {percent:.2} % only"));
    }
    let (wrong, lit) = (report.shadow_mismatch_px, report.lit_px);
    if wrong as f64 > share(lit, RAY_SHADOW_PERCENT) {
        broken.push(format!("wrong shadows on {wrong} of {lit} lit pixels"));
    }
    if report.shadow_mismatch_clusters > 0 {
        let clusters = report.shadow_mismatch_clusters;
        broken.push(format!("{clusters} clusters of wrong shadows"));
    }
    broken.extend(far_from_truth(report));
    if broken.is_empty() {
        Ok(())
    } else {
        Err(broken.join("; ").into())
    }
}

/// Colour through the same palette, if it is broken.
fn far_from_truth(report: &Report) -> Option<String> {
    let db = report.rgb_psnr_db;
    (db < SAME_PALETTE_DB).then(|| format!("colour through the same palette at {db:.1} dB only"))
}

fn limits(compared: &Compared) -> Result<()> {
    let report = &compared.report;
    let allowed = (report.covered_px as f64 * COVERAGE_PERCENT / 100.0).max(1.0);
    let mut broken = Vec::new();
    if report.coverage_mismatch_px as f64 > allowed {
        broken.push(format!(
            "coverage differs on {} of {} pixels",
            report.coverage_mismatch_px, report.covered_px
        ));
    }
    if report.depth_within_1_percent < DEPTH_WITHIN_1_PERCENT {
        broken.push(format!(
            "depth is within 1 unit on {:.2} % only",
            report.depth_within_1_percent
        ));
    }
    if report.level_within_2_percent < LEVEL_WITHIN_2_PERCENT {
        broken.push(format!(
            "light is within 2 of 255 on {:.2} % only",
            report.level_within_2_percent
        ));
    }
    broken.extend(far_from_truth(report));
    if report.rgb_psnr_true_db < TRUE_DB {
        let db = report.rgb_psnr_true_db;
        broken.push(format!(
            "colour at {db:.1} dB of the unquantised truth only"
        ));
    }
    if report.texel_mean > TEXELS {
        broken.push(format!(
            "places in textures are {:.2} texels off",
            report.texel_mean
        ));
    }
    if compared.one_material && compared.rgb888_psnr_db < PSNR_DB {
        broken.push(format!("colour at {:.1} dB only", compared.rgb888_psnr_db));
    }
    let true_db = report.rgb_psnr_true_db;
    if compared.without_palette && true_db < DIRECT_DB {
        broken.push(format!("colour without a palette at {true_db:.1} dB only"));
    }
    if broken.is_empty() {
        Ok(())
    } else {
        Err(broken.join("; ").into())
    }
}

/// Of a scene with level of detail: depth and light are those of other surfaces.
fn lod_limits(report: &Report) -> Result<()> {
    let mut broken = Vec::new();
    if report.coverage_mismatch_percent > LOD_COVERAGE_PERCENT {
        let percent = report.coverage_mismatch_percent;
        broken.push(format!("coverage differs on {percent:.2} %"));
    }
    if report.level_mean > LOD_LEVEL {
        let mean = report.level_mean;
        broken.push(format!("light is off by {mean:.2} of 255 in the mean"));
    }
    broken.extend(far_from_truth(report));
    if broken.is_empty() {
        Ok(())
    } else {
        Err(broken.join("; ").into())
    }
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

#[cfg(test)]
mod tests;
