//! The scene to the truth, pixel by pixel.

use super::counts::{Counters, RayCounts};
use super::sequence;
pub(crate) use super::tracer::Reach;
use super::tracer::{For, Tracer};
use super::world::{Met, World};
use crate::fog::fog_part;
use crate::hit::Hit;
use crate::light::Lights;
use crate::overlay::Overlay;
use crate::render::Options;
use crate::truth::Truth;
use crate::view::View;
use crate::window::{Window, row_colour, sampled_size};
use fixel_scene::{Ray, Scene};
use glam::DVec3;
use rayon::prelude::*;
use std::sync::Arc;

/// What only a ray-traced truth has.
#[derive(Clone, Debug)]
pub(crate) struct Traced {
    pub world: Arc<World>,
    /// For each pixel, how much of each light gets to what its centre shows; none
    /// where that is nothing.
    pub reaches: Vec<Vec<Reach>>,
    /// Pixels that have more than one ray.
    pub resampled: Vec<bool>,
    pub rays: RayCounts,
}

/// The picture as ray tracing makes it: shadows, mirrors, glass, soft light. Each
/// pixel's [`Hit`] is what the ray through its centre meets first, with the colour of
/// all of the pixel's rays. Only surfaces are drawn: no lines, marks or points.
pub fn render_rays(scene: &Scene, options: Options) -> Truth {
    render_rays_watched(scene, options, &|| ())
}

/// As [`render_rays`]; calls `row_done` after each of the `height` rows, from any
/// thread and in any order.
pub fn render_rays_watched(scene: &Scene, options: Options, row_done: &(dyn Fn() + Sync)) -> Truth {
    let Options {
        width,
        height,
        frame,
    } = options;
    let windows = Window::all(scene, width, height, frame);
    let [width, height] = sampled_size(scene, width, height);
    let world = Arc::new(World::new(scene, frame));
    let lights = Lights::new(scene);
    let counters = Counters::default();
    let eyes: Vec<Eye<'_>> = windows
        .iter()
        .map(|window| Eye {
            scene,
            window,
            tracer: Tracer {
                world: &world,
                lights: &lights,
                how: &scene.ray,
                background: window.background,
                up: window.view_up,
                counters: &counters,
            },
        })
        .collect();
    let size = [width, height];
    let plain = |y: u32| row_colour(&scene.display.background, y, height);
    let mut pixels = each(size, |x, y| {
        let pixel = match eye_at(&eyes, [x, y]) {
            Some((eye, at)) => eye.look(at, 0),
            None => Pixel::nothing(plain(y).into()),
        };
        if x + 1 == width {
            row_done();
        }
        pixel
    });
    let count = scene.ray.samples;
    let means = each(size, |x, y| {
        let (eye, at) = eye_at(&eyes, [x, y]).filter(|_| count > 1)?;
        let own = &pixels[(y * width + x) as usize];
        let neighbours = eye.window.neighbours([x, y]);
        let mut neighbours = neighbours.map(|[x, y]| &pixels[(y * width + x) as usize]);
        neighbours
            .any(|other| own.differs(other, &scene.ray))
            .then(|| {
                let others: DVec3 = (1..count).map(|sample| eye.look(at, sample).colour).sum();
                (own.colour + others) / f64::from(count)
            })
    });
    let resampled = means.iter().map(Option::is_some).collect();
    for (pixel, mean) in pixels.iter_mut().zip(means) {
        pixel.colour = mean.unwrap_or(pixel.colour);
    }
    let hit = |pixel: &Pixel| {
        let colour = pixel.colour.into();
        pixel.hit.map(|hit| Hit { colour, ..hit })
    };
    let overlays = windows.iter().map(|_| Overlay::default()).collect();
    Truth {
        width,
        height,
        pixels: pixels.iter().map(hit).collect(),
        layers: vec![Vec::new(); pixels.len()],
        background: pixels.iter().map(|pixel| pixel.colour.into()).collect(),
        fog: scene.fog,
        samples: scene.display.samples,
        joined: scene.display.stereo.joined(),
        materials: scene.materials.len(),
        overlays,
        traced: Some(Traced {
            reaches: pixels.into_iter().map(|pixel| pixel.reaches).collect(),
            resampled,
            rays: counters.read(),
            world: world.clone(),
        }),
        windows,
    }
}

/// Something for every pixel, by rows.
fn each<T: Send>([width, height]: [u32; 2], of: impl Fn(u32, u32) -> T + Sync) -> Vec<T> {
    let row = |y: u32| (0..width).map(|x| of(x, y)).collect::<Vec<T>>();
    (0..height).into_par_iter().flat_map_iter(row).collect()
}

/// The last eye whose window has a pixel, and the pixel's place in it.
fn eye_at<'a, 'b>(eyes: &'b [Eye<'a>], [x, y]: [u32; 2]) -> Option<(&'b Eye<'a>, [u32; 2])> {
    let mut found = eyes
        .iter()
        .rev()
        .filter_map(|eye| Some((eye, eye.window.place(x, y)?)));
    found.next()
}

/// A window and what its rays need.
struct Eye<'a> {
    scene: &'a Scene,
    window: &'a Window,
    tracer: Tracer<'a>,
}

/// What a ray from the eye brings back.
struct Pixel {
    hit: Option<Hit>,
    colour: DVec3,
    reaches: Vec<Reach>,
}

impl Pixel {
    fn nothing(colour: DVec3) -> Self {
        Self {
            hit: None,
            colour,
            reaches: Vec::new(),
        }
    }

    /// Whether another pixel is so different that both are sampled again.
    fn differs(&self, other: &Self, how: &Ray) -> bool {
        let actor = |pixel: &Self| pixel.hit.map(|hit| hit.actor);
        let most = (self.colour - other.colour).abs().max_element();
        actor(self) != actor(other) || most > how.threshold
    }
}

impl Eye<'_> {
    /// The ray through a sample of a pixel.
    fn look(&self, at: [u32; 2], sample: u32) -> Pixel {
        let view: &View = &self.window.view;
        let line = if sample == 0 {
            view.line(&view.ray(at[0], at[1]))
        } else {
            let place = sequence::in_pixel(sample, self.scene.ray.samples);
            view.line(&view.ray_through([0, 1].map(|i| f64::from(at[i]) + place[i])))
        };
        let tracer = &self.tracer;
        tracer.counters.camera();
        let Some(met) = tracer.world.nearest(&line, view.range(), None) else {
            return Pixel::nothing(self.window.background(at[1]).into());
        };
        let shown = tracer.show(&line, &met, 1, For { pixel: at, sample });
        let colour = shown.colour;
        let Met { surface, at, .. } = met;
        Pixel {
            hit: Some(Hit {
                depth_lsb: view.depth_lsb(met.t),
                actor: surface.actor,
                triangle: surface.triangle,
                material: surface.material,
                weights: at,
                level: shown.lit.level,
                colour: colour.into(),
                fog: self.scene.fog.map_or(0.0, |fog| fog_part(&fog, met.t)),
                texels: [([0.0; 3], 0.0); 4],
                own_and_gloss: [[0.0; 3]; 2],
                texel: shown.spot.texel.map(|(_, texel)| texel.colour.into()),
                texture_place: shown.spot.texel.map(|(place, _)| place.into()),
                margin_lsb: f64::INFINITY,
                hidden: false,
            }),
            colour,
            reaches: shown.reaches,
        }
    }
}
