//! A picture of a scene by one of the renderers, on one thread.

mod figures;

use std::sync::Arc;
use std::time::Instant;

use fixel::render::Ids;
use fixel_bake::{BakeError, Baked, camera_in};
use fixel_host::{Options, Planes};
use fixel_reference::Truth;
use fixel_scene::{Scene, Stereo};

use crate::false_colour;
use crate::variant::{Job, Renderer, Show, Variant};

/// What was drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    /// What was asked for.
    pub job: Job,
    /// Of the panel.
    pub width: u32,
    /// Of the panel.
    pub height: u32,
    /// The panel's pixels, by rows from the top left.
    pub rgb: Vec<[u8; 3]>,
    /// Whether every pixel is drawn by itself; the first pictures of slow renderers are
    /// coarser.
    pub whole: bool,
    /// What there is to say in numbers, a line each.
    pub figures: Vec<String>,
}

/// Draws, and keeps what it baked.
#[derive(Debug, Default)]
pub struct Drawer {
    baked: Vec<(Job, For, Baked)>,
}

/// What a scene is baked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum For {
    Raster,
    Rays,
    /// Without a palette.
    Counting,
}

/// Scenes kept.
const KEPT: usize = 4;

impl Drawer {
    /// Draws one panel pixel of `step` across and down by itself.
    ///
    /// # Errors
    /// One line: what about the scene does not go.
    pub fn draw(&mut self, job: &Job, step: u32) -> Result<Picture, String> {
        let scene = job.scene();
        let [width, height] = [scene.display.width, scene.display.height];
        let size = [width.div_ceil(step), height.div_ceil(step)];
        let started = Instant::now();
        let (rgb, figures) = match job.renderer {
            Renderer::Raster => self.raster(job, &scene, size)?,
            Renderer::Ray => self.ray(job, &scene, size)?,
            Renderer::Reference | Renderer::RayReference => reference(job, &scene, size, started),
        };
        Ok(Picture {
            job: job.clone(),
            width,
            height,
            rgb: enlarged(&rgb, size[0], [width, height], step),
            whole: step == 1,
            figures,
        })
    }

    /// The scene baked, as its file has it or as the user changed it; the camera is as in the
    /// file, and what the user moved comes with the pose.
    fn bake(&mut self, job: &Job, what: For) -> Result<&Baked, String> {
        let same = |(kept, kept_for, _): &(Job, For, Baked)| {
            Arc::ptr_eq(&kept.source, &job.source)
                && kept.variant == job.variant
                && *kept_for == what
        };
        if let Some(at) = self.baked.iter().position(same) {
            let kept = self.baked.remove(at);
            self.baked.push(kept);
        } else {
            let baked = bake(job, what)?;
            self.baked
                .retain(|(kept, ..)| Arc::ptr_eq(&kept.source, &job.source));
            if self.baked.len() >= KEPT {
                self.baked.remove(0);
            }
            self.baked.push((job.clone(), what, baked));
        }
        let last = self.baked.last().map(|(.., baked)| baked);
        last.ok_or_else(|| "nothing is baked".into())
    }

    fn raster(&mut self, job: &Job, scene: &Scene, size: [u32; 2]) -> Result<Drawn, String> {
        let counting = if job.show == Show::Overdraw {
            For::Counting
        } else {
            For::Raster
        };
        let baked = self.bake(job, counting)?;
        let core = baked.scene().map_err(|error| error.to_string())?;
        let options = options(job, scene, &core, size)?;
        let started = Instant::now();
        let planes = fixel_host::render(&core, &options);
        let taken = started.elapsed();
        let bytes = baked.bytes().len();
        let mut figures = figures::raster(&core, &planes, bytes, taken);
        figures.extend(figures::estimate(job, &core, &options, bytes));
        let shown = |rgb: Vec<[u8; 3]>| first_samples(&core, &planes, &rgb);
        let covered = |i: usize| planes.depth.get(i).is_some_and(|depth| *depth != 0);
        let rgb = match job.show {
            Show::Picture => fixel_host::picture(&core, &planes).0,
            Show::Depth => shown(false_colour::depth(&planes.depth)),
            Show::Actors => {
                let actors = fixel_host::actors(&core, &options);
                let whole = |actor: u16| scene.whole(actor.into()) as u32;
                let there = actors.iter().enumerate();
                let there = there.map(|(i, actor)| covered(i).then(|| whole(*actor)));
                shown(false_colour::numbers(there))
            }
            Show::Meshlets => {
                let meshlets = Meshlets::of(&core);
                let ids = fixel_host::triangles(&core, &options);
                let there = ids.iter().enumerate();
                let there = there.map(|(i, id)| covered(i).then(|| meshlets.holding(*id)));
                shown(false_colour::numbers(there))
            }
            Show::Overdraw => {
                let refused = "overdraw is not counted in scenes with viewports";
                let counts = fixel_host::overdraw(&core, &options).ok_or(refused)?;
                // What is baked without a palette is not what is shown otherwise.
                figures.truncate(1);
                figures.push(figures::overdraw(&counts));
                shown(false_colour::counts(&counts))
            }
        };
        Ok((rgb, figures))
    }

    fn ray(&mut self, job: &Job, scene: &Scene, size: [u32; 2]) -> Result<Drawn, String> {
        if matches!(job.show, Show::Meshlets | Show::Overdraw) {
            return Err("rays know neither meshlets nor overdraw; v chooses the rasteriser".into());
        }
        let baked = self.bake(job, For::Rays)?;
        let core = baked.scene().map_err(|error| error.to_string())?;
        let options = options(job, scene, &core, size)?;
        let started = Instant::now();
        if job.show == Show::Actors {
            let (frame, planes) = fixel_host::ray_frame(baked, &core, &options);
            let ids = frame.actor.iter().map(|id| id.checked_sub(1));
            let whole = |actor: u16| scene.whole(actor.into()) as u32;
            let rgb = false_colour::numbers(ids.map(|id| id.map(whole)));
            return Ok((first_samples(&core, &planes, &rgb), Vec::new()));
        }
        let planes = fixel_host::render_rays(&core, &options);
        let figures = vec![
            format!(
                "{} triangles, {} bytes of flash",
                core.triangle_count(),
                baked.bytes().len()
            ),
            figures::drawn_here(started.elapsed()),
        ];
        let rgb = match job.show {
            Show::Depth => first_samples(&core, &planes, &false_colour::depth(&planes.depth)),
            _ => fixel_host::picture(&core, &planes).0,
        };
        Ok((rgb, figures))
    }
}

/// Pixels, and figures.
type Drawn = (Vec<[u8; 3]>, Vec<String>);

fn bake(job: &Job, what: For) -> Result<Baked, String> {
    if let Some(baked) = &job.source.baked
        && job.variant == Variant::default()
        && what != For::Counting
    {
        let core = baked.scene().map_err(|error| error.to_string())?;
        if what == For::Raster || core.has_rays() {
            return Ok(baked.clone());
        }
    }
    let mut scene = job.source.scene.clone();
    job.variant.apply(&mut scene);
    let in_file = |error: BakeError| scene.error(error.element, &error.to_string()).to_string();
    match what {
        For::Raster => fixel_bake::bake(&scene).map_err(in_file),
        For::Rays => fixel_bake::bake_for_rays(&scene).map_err(in_file),
        For::Counting => {
            let mut plain = scene.clone();
            plain.palette = fixel_scene::Palette {
                direct: true,
                ..fixel_scene::Palette::default()
            };
            plain.display.colour = fixel_scene::ColourFormat::Rgb565;
            plain.display.dithering = fixel_scene::PanelDithering::None;
            plain.display.samples = [1, 1];
            plain.display.stereo = Stereo::None;
            plain.animation.palette_cycle = None;
            fixel_bake::bake(&plain).map_err(in_file)
        }
    }
}

fn options(
    job: &Job,
    scene: &Scene,
    core: &fixel::Scene<'_>,
    [width, height]: [u32; 2],
) -> Result<Options, String> {
    let (columns, rows) = core.output().frame_size((width as u16, height as u16));
    if columns > 2048 || rows > 2048 {
        return Err(format!(
            "{columns}x{rows} samples are too many; expected at most 2048x2048"
        ));
    }
    let camera = match &job.camera {
        Some(camera) => {
            let moved = camera_in(core, camera);
            Some(moved.map_err(|error| scene.error(None, &error.to_string()).to_string())?)
        }
        None => None,
    };
    Ok(Options {
        width: width as u16,
        height: height as u16,
        frame: job.frame,
        band_rows: None,
        camera,
    })
}

fn reference(job: &Job, scene: &Scene, [width, height]: [u32; 2], started: Instant) -> Drawn {
    let options = fixel_reference::Options {
        width,
        height,
        frame: job.frame,
    };
    let truth = if job.renderer == Renderer::Reference {
        fixel_reference::render(scene, options)
    } else {
        fixel_reference::render_rays(scene, options)
    };
    let shown = |rgb: Vec<[u8; 3]>| truth_samples(&truth, &rgb);
    let rgb = match job.show {
        Show::Depth => shown(false_colour::depth(&truth.depth16())),
        Show::Actors => {
            let ids = truth.actor_ids();
            let whole = |id: u16| {
                id.checked_sub(1)
                    .map(|actor| scene.whole(actor.into()) as u32)
            };
            shown(false_colour::numbers(ids.into_iter().map(whole)))
        }
        _ => truth.picture(),
    };
    let figures = vec![
        format!("{} px covered, in full colour", truth.covered_px()),
        figures::drawn_here(started.elapsed()),
    ];
    (rgb, figures)
}

/// Of a picture's samples and the eyes of an anaglyph, the first one's.
fn first_samples(core: &fixel::Scene<'_>, planes: &Planes, rgb: &[[u8; 3]]) -> Vec<[u8; 3]> {
    let (width, height) = core.output().picture_size(planes.size);
    let [across, down] = core.output().samples.map(usize::from);
    let stride = usize::from(planes.size.0);
    picked(rgb, [width.into(), height.into()], stride, [across, down])
}

fn truth_samples(truth: &Truth, rgb: &[[u8; 3]]) -> Vec<[u8; 3]> {
    let [width, height] = truth.picture_size().map(|side| side as usize);
    let down = truth.height() as usize / height.max(1);
    let stride = truth.width() as usize;
    // As many across as down, or the other eye follows.
    let across = (stride / width.max(1)).min(down.max(1));
    picked(rgb, [width, height], stride, [across, down])
}

fn picked(
    rgb: &[[u8; 3]],
    [width, height]: [usize; 2],
    stride: usize,
    [across, down]: [usize; 2],
) -> Vec<[u8; 3]> {
    let at = |x: usize, y: usize| rgb.get(y * down * stride + x * across).copied();
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels.map(|(x, y)| at(x, y).unwrap_or_default()).collect()
}

/// Each pixel `step` times across and down, cut to a size.
fn enlarged(rgb: &[[u8; 3]], from: u32, [width, height]: [u32; 2], step: u32) -> Vec<[u8; 3]> {
    if step == 1 {
        return rgb.to_vec();
    }
    let at = |x: u32, y: u32| rgb.get((y / step * from + x / step) as usize).copied();
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels.map(|(x, y)| at(x, y).unwrap_or_default()).collect()
}

/// Which meshlet a triangle, an edge or a vertex is of.
struct Meshlets {
    triangles: Vec<u32>,
    edges: Vec<u32>,
    vertices: Vec<u32>,
}

impl Meshlets {
    fn of(core: &fixel::Scene<'_>) -> Self {
        let all = || (0..core.meshlet_count() as u32).map(|number| (number, core.meshlet(number)));
        let count = |of: fn(&fixel::scene::Meshlet) -> u32| {
            sums(all().map(|(_, meshlet)| meshlet.as_ref().map_or(0, of)))
        };
        Self {
            triangles: count(|meshlet| meshlet.triangles.into()),
            edges: sums(all().map(|(number, _)| core.meshlet_edges(number).0.len() as u32)),
            vertices: count(|meshlet| meshlet.vertices.into()),
        }
    }

    fn holding(&self, id: u32) -> u32 {
        let (ends, number) = if id & Ids::POINT != 0 {
            (&self.vertices, id - Ids::POINT)
        } else if id & Ids::EDGE != 0 {
            (&self.edges, id - Ids::EDGE)
        } else {
            (&self.triangles, id)
        };
        ends.partition_point(|end| *end <= number) as u32
    }
}

/// How many there are up to each one, it included.
fn sums(counts: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut sum = 0;
    let add = |count| {
        sum += count;
        sum
    };
    counts.map(add).collect()
}

#[cfg(test)]
mod tests;
