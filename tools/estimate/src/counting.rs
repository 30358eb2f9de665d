//! Counts work while the core draws: a paint that draws as another does, and is told of
//! each meshlet, triangle and line.

use std::cell::RefCell;

use fixel::Scene;
use fixel::fog::Haze;
use fixel::frame::{Stored, Target};
use fixel::math::Level;
use fixel::raster::{Fill, How};
use fixel::render::{Ids, Paint};
use fixel::shade::{Blend, Pixel};
use fixel::vertex::ScreenVertex;

use crate::bend::levels_bend;
use crate::kernel::{AtVertices, Kernel, Way};
use crate::seen::{Front, Seen};
use crate::span;
use crate::term::{Term, Work};

/// Pixels between levels that are divided by distance.
const PERSPECTIVE_PX: f64 = 16.0;

/// Draws as `paint` does, and counts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counting<'a, P> {
    pub paint: P,
    pub counter: &'a RefCell<Counter>,
}

/// What was counted up to now.
#[derive(Debug)]
pub(crate) struct Counter {
    pub work: Work,
    kernels: Vec<Kernel>,
    /// The meshlet of each triangle.
    meshlets: Vec<u32>,
    /// Whether depths go by 1 / distance.
    perspective: bool,
    front: Front,
    last_meshlet: Option<(u16, u32)>,
    /// Actors whose matrices are kept.
    kept: Vec<Option<u16>>,
}

impl Counter {
    /// For a renderer that keeps the matrices of so many actors.
    pub fn new(scene: &Scene<'_>, perspective: bool, actors: usize) -> Self {
        let mut meshlets = vec![0; scene.triangle_count()];
        for number in 0..scene.meshlet_count() as u32 {
            let Some(meshlet) = scene.meshlet(number) else {
                continue;
            };
            let first = meshlet.first_triangle as usize;
            let all = meshlets.iter_mut().skip(first);
            all.take(meshlet.triangles.into())
                .for_each(|at| *at = number);
        }
        Self {
            work: Work::default(),
            kernels: (0..scene.actor_count())
                .map(|number| Kernel::of(scene, number))
                .collect(),
            meshlets,
            perspective,
            front: Front::default(),
            last_meshlet: None,
            kept: vec![None; actors],
        }
    }

    fn add(&mut self, term: Term, amount: f64) {
        self.work.add(term, amount);
    }

    fn transformed(&mut self, actor: u16, vertices: u8) {
        let vertices = f64::from(vertices);
        let Kernel {
            vertices: lit,
            fine,
            lights,
            tinted,
            ..
        } = self.kernels[usize::from(actor)];
        self.add(Term::MeshletTransformed, 1.0);
        self.add(Term::Vertex, vertices);
        if fine {
            self.add(Term::FineVertex, vertices);
        }
        if self.perspective {
            self.add(Term::PerspectiveVertex, vertices);
        }
        match lit {
            AtVertices::Nothing => {}
            AtVertices::Plain => {
                self.add(Term::PlainLitVertex, vertices);
                self.add(Term::PlainVertexLight, vertices * lights.count());
            }
            AtVertices::Everything => {
                self.add(Term::MeshletLight, lights.count());
                lights.shine(&mut self.work, Term::Lit, vertices, tinted);
            }
        }
        self.matrices(actor);
    }

    /// An actor's matrices are asked for.
    pub fn matrices(&mut self, actor: u16) {
        let slots = self.kept.len();
        let kept = &mut self.kept[usize::from(actor) % slots];
        if *kept != Some(actor) {
            *kept = Some(actor);
            self.add(Term::ActorView, 1.0);
        }
    }

    fn triangle<C>(
        &mut self,
        target: &Target<'_, C>,
        corners: [&ScreenVertex; 3],
        how: How,
        ids: Ids,
    ) {
        let actor = usize::from(ids.actor);
        let meshlet = self.meshlets[ids.triangle as usize];
        if self.last_meshlet != Some((ids.actor, meshlet)) {
            self.last_meshlet = Some((ids.actor, meshlet));
            self.add(Term::MeshletInBand, 1.0);
            self.matrices(ids.actor);
            if self.lights_a_meshlet(actor) {
                let lights = self.kernels[actor].lights.count();
                self.add(Term::MeshletLight, lights);
            }
        }
        if how != How::Filled {
            return;
        }
        let seen = self.front.seen(target, corners);
        let way = self.kernels[actor].way;
        let small = seen.small;
        match way {
            _ if self.kernels[actor].look.is_some() => {
                self.add(Term::HidingTriangle, 1.0);
                self.add(Term::HidingRow, seen.rows);
                self.add(Term::HidingPx, seen.px);
            }
            Way::Flat { plain } => {
                self.plain(&seen, Term::SmallFlat);
                let lights = self.kernels[actor].lights;
                if plain {
                    self.add(Term::PlainLitFace, 1.0);
                    self.add(Term::PlainFaceLight, lights.count());
                } else {
                    lights.shine(&mut self.work, Term::Lit, 1.0, false);
                }
            }
            Way::Gouraud if self.perspective && levels_bend(corners) => {
                self.add(Term::LargePerspective, 1.0);
                self.add(Term::PerspectiveRun, seen.runs(|_| PERSPECTIVE_PX));
                self.large_gouraud(&seen);
            }
            Way::Gouraud if small => self.plain(&seen, Term::SmallGouraud),
            Way::Gouraud => {
                self.add(Term::LargeGouraud, 1.0);
                self.large_gouraud(&seen);
            }
            Way::Surface(surface) => {
                let Kernel { lights, tinted, .. } = self.kernels[actor];
                surface.count(
                    &mut self.work,
                    (&seen, corners),
                    (lights, tinted),
                    self.perspective,
                );
            }
        }
    }

    fn lights_a_meshlet(&self, actor: usize) -> bool {
        match self.kernels[actor].way {
            Way::Surface(surface) => surface.lit_here(),
            Way::Flat { plain } => !plain,
            Way::Gouraud => false,
        }
    }

    fn plain(&mut self, seen: &Seen, small: Term) {
        if seen.tiny {
            self.add(Term::Tiny, 1.0);
            self.add(Term::TinyBoxPx, seen.boxed);
            self.add(Term::TinyPx, seen.px);
            return;
        }
        let terms = match (seen.small, small) {
            (true, Term::SmallFlat) => [
                Term::SmallFlat,
                Term::SmallFlatRow,
                Term::SmallFlatPx,
                Term::SmallFlatPxInFront,
            ],
            (true, _) => [
                Term::SmallGouraud,
                Term::SmallGouraudRow,
                Term::SmallGouraudPx,
                Term::SmallGouraudPxInFront,
            ],
            (false, _) => [
                Term::LargeFlat,
                Term::LargeFlatRow,
                Term::LargeFlatPx,
                Term::LargeFlatPxInFront,
            ],
        };
        let amounts = [1.0, seen.rows, seen.px, seen.in_front];
        for (term, amount) in terms.into_iter().zip(amounts) {
            self.add(term, amount);
        }
    }

    fn large_gouraud(&mut self, seen: &Seen) {
        self.add(Term::LargeGouraudRow, seen.rows);
        self.add(Term::LargeGouraudPx, seen.px);
        self.add(Term::LargeGouraudPxInFront, seen.in_front);
    }

    fn line<C>(&mut self, target: &Target<'_, C>, ends: [&ScreenVertex; 2], ids: Ids) {
        let kernel = &self.kernels[usize::from(ids.actor)];
        let width = kernel.look.map_or(1, |look| look.line_width.max(1));
        let coloured = kernel.coloured;
        let [[ax, ay], [bx, by]] = ends.map(span::place);
        let (dx, dy) = (bx - ax, by - ay);
        let longest = dx.abs().max(dy.abs()).max(1e-9);
        // Those that are in the target's rows.
        let (top, end) = (f64::from(target.top), f64::from(target.end));
        let (least, most) = (ay.min(by), ay.max(by));
        let part = if most - least > 1e-9 {
            ((most.min(end) - least.max(top)) / (most - least)).clamp(0.0, 1.0)
        } else {
            f64::from(u8::from((top..end).contains(&ay)))
        };
        if part == 0.0 {
            return;
        }
        let steps = part * (longest + 1.0);
        let term = if coloured {
            Term::ColouredLineStep
        } else {
            Term::LineStep
        };
        self.add(Term::LineInBand, 1.0);
        if coloured {
            self.add(Term::ColouredLineInBand, 1.0);
        }
        self.add(term, steps);
        let beside = (f64::from(width) / 16.0 - 1.0).max(0.0);
        self.add(Term::WideLinePx, steps * beside);
    }
}

impl<P: Paint> Paint for Counting<'_, P> {
    type Stored = P::Stored;

    const FOGGED: bool = P::FOGGED;

    fn fill<'a>(&self, shades: &'a [u8; 256], flat: Option<Level>, ids: Ids) -> Fill<'a> {
        self.paint.fill(shades, flat, ids)
    }

    fn hidden<'a>(&self, ids: Ids) -> Fill<'a> {
        self.paint.hidden(ids)
    }

    fn background(&self, index: u8) -> P::Stored {
        self.paint.background(index)
    }

    fn surface(&self, pixel: &Pixel<'_>, ids: Ids) -> P::Stored {
        self.paint.surface(pixel, ids)
    }

    fn blend(&self, pixel: &Pixel<'_>, behind: P::Stored, blend: &Blend<'_>) -> P::Stored {
        self.paint.blend(pixel, behind, blend)
    }

    fn fog(&self, target: &mut Target<'_, P::Stored>, scene: &Scene<'_>, haze: &Haze) {
        let fogged = match P::Stored::indices(target) {
            Some(_) => Term::FoggedPx,
            None => Term::DirectFoggedPx,
        };
        let mut counter = self.counter.borrow_mut();
        let (width, stride) = (usize::from(target.width), usize::from(target.stride));
        let mut degree = 0;
        for row in target.depths.chunks(stride.max(1)) {
            let mut last = None;
            for depth in row.iter().take(width) {
                if *depth == 0 {
                    counter.add(Term::UnfoggedPx, 1.0);
                    last = None;
                    continue;
                }
                let before = degree;
                haze.over([0; 3], *depth, &mut degree);
                counter.add(fogged, 1.0);
                counter.add(Term::FogStep, degree.abs_diff(before) as f64);
                if last != Some(degree) {
                    counter.add(Term::FogRun, 1.0);
                    last = Some(degree);
                }
            }
        }
        drop(counter);
        self.paint.fog(target, scene, haze);
    }

    fn transformed(&self, actor: u16, vertices: u8) {
        self.counter.borrow_mut().transformed(actor, vertices);
    }

    fn drawn<C>(&self, target: &Target<'_, C>, corners: [&ScreenVertex; 3], how: How, ids: Ids) {
        let mut counter = self.counter.borrow_mut();
        counter.triangle(target, corners, how, ids);
    }

    fn line<C>(&self, target: &Target<'_, C>, ends: [&ScreenVertex; 2], ids: Ids) {
        self.counter.borrow_mut().line(target, ends, ids);
    }
}
