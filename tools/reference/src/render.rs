//! The scene to the truth, pixel by pixel.

use crate::bvh::{Bvh, bounds};
use crate::fog::{fog_part, fogged};
use crate::geometry::{Face, Geometry};
use crate::hit::{Hit, Layer};
use crate::light::Lit;
use crate::overlay;
use crate::ray::Meeting;
use crate::through::Through;
use crate::truth::Truth;
use crate::view::View;
use crate::window::{Window, row_colour, sampled_size};
use fixel_scene::Scene;
use rayon::prelude::*;

/// How to render.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Width in pixels, at least 1.
    pub width: u32,
    /// Height in pixels, at least 1.
    pub height: u32,
    /// The animation's frame.
    pub frame: u32,
}

/// Distances that differ relatively by no more than this are the same surface
/// twice (coplanar triangles); the one earlier in the scene is seen.
const COPLANAR: f64 = 1e-12;

/// Finds the nearest surface at every pixel's centre (at `x + 0.5, y + 0.5`,
/// `y` down; a centre exactly on an edge follows the top-left rule).
pub fn render(scene: &Scene, options: Options) -> Truth {
    render_watched(scene, options, &|| ())
}

/// As [`render()`]; calls `row_done` after each of the `height` rows, from any
/// thread and in any order.
pub fn render_watched(scene: &Scene, options: Options, row_done: &(dyn Fn() + Sync)) -> Truth {
    let Options {
        width,
        height,
        frame,
    } = options;
    let windows = Window::all(scene, width, height, frame);
    let [width, height] = sampled_size(scene, width, height);
    let trees: Vec<Bvh> = windows
        .iter()
        .map(|w| {
            let boxes: Vec<_> = w.geometry.faces.iter().map(|f| bounds(f.corners)).collect();
            Bvh::new(&boxes)
        })
        .collect();
    let pixels_in_all = width as usize * height as usize;
    let mut pixels = vec![None; pixels_in_all];
    let mut layers = vec![Vec::new(); pixels_in_all];
    let mut background = vec![[0.0; 3]; pixels_in_all];
    pixels
        .par_chunks_mut(width as usize)
        .zip(layers.par_chunks_mut(width as usize))
        .zip(background.par_chunks_mut(width as usize))
        .enumerate()
        .for_each(|(y, ((row, layers), background))| {
            let y = y as u32;
            background.fill(row_colour(&scene.display.background, y, height));
            for (window, bvh) in windows.iter().zip(&trees) {
                let places = (0..width).filter_map(|x| Some((x, window.place(x, y)?)));
                for (x, [column, y]) in places {
                    let (geometry, view) = (&window.geometry, &window.view);
                    background[x as usize] = window.background(y);
                    let (surface, before) = nearest(geometry, bvh, view, [column, y]);
                    let at = [column, y];
                    row[x as usize] = surface.map(|seen| seen.hit(geometry, view, scene, at));
                    layers[x as usize] = before
                        .iter()
                        .filter_map(|seen| seen.layer(geometry, view, scene, at))
                        .collect();
                }
            }
            row_done();
        });
    let overlays = windows
        .iter()
        .enumerate()
        .map(|(i, _)| {
            overlay::draw(
                scene,
                &windows[i..],
                frame,
                width,
                (&mut pixels, &mut layers),
            )
        })
        .collect();
    let materials = scene.materials.len();
    Truth {
        width,
        height,
        pixels,
        layers,
        background,
        fog: scene.fog,
        samples: scene.display.samples,
        joined: scene.display.stereo.joined(),
        materials,
        windows,
        overlays,
        traced: None,
    }
}

/// The nearest face on a ray.
struct Seen<'a> {
    face: &'a Face,
    meeting: Meeting,
    /// Distance of the next face.
    second: Option<f64>,
}

impl Seen<'_> {
    /// Its depth, and that of the next face.
    fn depths_lsb(&self, view: &View) -> (f64, f64) {
        let own = view.depth_lsb(self.meeting.w) - self.face.sunk_lsb.unwrap_or(0.0);
        let second = self.second.map_or(f64::NEG_INFINITY, |w| view.depth_lsb(w));
        (own, second)
    }

    /// What it adds to what is behind it, if it is blended.
    fn layer(
        &self,
        geometry: &Geometry,
        view: &View,
        scene: &Scene,
        at: [u32; 2],
    ) -> Option<Layer> {
        let Through::Blend(opacity) = self.face.through else {
            return None;
        };
        let hit = self.hit(geometry, view, scene, at);
        Some(Layer {
            colour: scene.fog.map_or(hit.colour, |fog| {
                fogged(&fog, hit.colour.into(), hit.fog).into()
            }),
            opacity,
            depth_lsb: hit.depth_lsb,
        })
    }

    fn hit(&self, geometry: &Geometry, view: &View, scene: &Scene, at: [u32; 2]) -> Hit {
        let (face, weights) = (self.face, self.meeting.weights);
        let material = scene.actors[face.actor].material;
        let hidden = face.sunk_lsb.is_some();
        let lit = if hidden {
            Lit::default()
        } else {
            geometry.lit(face, weights, &scene.materials[material], view)
        };
        let texel = geometry.texel(face, at, view);
        let colour = texel.map_or(lit.colour, |(_, texel)| lit.textured(texel.colour));
        let (depth_lsb, second) = self.depths_lsb(view);
        Hit {
            depth_lsb,
            actor: face.actor,
            triangle: face.triangle,
            material,
            weights,
            level: lit.level,
            fog: scene.fog.map_or(0.0, |fog| fog_part(&fog, self.meeting.w)),
            colour: colour.into(),
            texel: texel.map(|(_, texel)| texel.colour.into()),
            texels: texel.map_or([([0.0; 3], 0.0); 4], |(_, texel)| {
                texel.parts.map(|(colour, weight)| (colour.into(), weight))
            }),
            own_and_gloss: [lit.own.into(), lit.gloss.into()],
            texture_place: texel.map(|(place, _)| place.into()),
            margin_lsb: depth_lsb - second,
            hidden,
        }
    }
}

/// The nearest face that is not blended, and the blended ones before it, far ones first.
fn nearest<'a>(
    geometry: &'a Geometry,
    bvh: &Bvh,
    view: &View,
    at: [u32; 2],
) -> (Option<Seen<'a>>, Vec<Seen<'a>>) {
    let faces = &geometry.faces;
    let ray = view.ray(at[0], at[1]);
    let [near, far] = view.range();
    let mut best: Option<(usize, Meeting)> = None;
    let mut second: Option<f64> = None;
    // Faces that lie deeper than they are, by depth.
    let mut sunk: Option<Seen<'a>> = None;
    let mut blended: Vec<(usize, Meeting)> = Vec::new();
    bvh.walk(&ray.line(), near, far, |index| {
        let face = &faces[index];
        if let Some(meeting) = face.seen(&ray, view)
            && !geometry.is_hole(face, at, view)
        {
            if let Through::Blend(_) = face.through {
                blended.push((index, meeting));
                return second.unwrap_or(far);
            }
            if face.sunk_lsb.is_some() {
                let seen = Seen {
                    face,
                    meeting,
                    second: None,
                };
                let depth = seen.depths_lsb(view).0;
                if sunk
                    .as_ref()
                    .is_none_or(|old| old.depths_lsb(view).0 < depth)
                {
                    sunk = Some(seen);
                }
                return second.unwrap_or(far);
            }
            match best {
                Some(old) if !in_front((index, meeting.w), (old.0, old.1.w)) => {
                    second = Some(second.map_or(meeting.w, |w| w.min(meeting.w)));
                }
                _ => {
                    second = best.map(|(_, old)| old.w);
                    best = Some((index, meeting));
                }
            }
        }
        second.unwrap_or(far)
    });
    let surface = best.map(|(index, meeting)| Seen {
        face: &faces[index],
        meeting,
        second,
    });
    let surface = match (surface, sunk) {
        (Some(surface), Some(sunk)) => {
            let deeper = surface.depths_lsb(view).0 < sunk.depths_lsb(view).0;
            Some(if deeper { sunk } else { surface })
        }
        (surface, sunk) => surface.or(sunk),
    };
    let depth_lsb = surface.as_ref().map(|seen| seen.depths_lsb(view).0);
    blended.sort_by(|a, b| b.1.w.total_cmp(&a.1.w).then(a.0.cmp(&b.0)));
    let blended = blended.into_iter().map(|(index, meeting)| Seen {
        face: &faces[index],
        meeting,
        second: None,
    });
    let before = |seen: &Seen<'_>| depth_lsb.is_none_or(|behind| seen.depths_lsb(view).0 > behind);
    (surface, blended.filter(before).collect())
}

/// Whether face and distance `a` hide `b`.
fn in_front(a: (usize, f64), b: (usize, f64)) -> bool {
    if (a.1 - b.1).abs() <= COPLANAR * b.1.abs() {
        a.0 < b.0
    } else {
        a.1 < b.1
    }
}
