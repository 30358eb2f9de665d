//! A frame from the ray caster, in the same shape as the rasteriser's.

use fixel::Scene;
use fixel::light::Lit;
use fixel::ray::{RayScratch, Seen, Watch, render_frame_watched};
use fixel::render::FrameStats;
use fixel_bake::Baked;
use fixel_reference::{Frame, Lookup, NO_TRIANGLE};

use crate::Planes;
use crate::colour::{before_dithering, pixels};
use crate::compare::lookup;
use crate::planes::{Options, collected};

/// Actors: the host has the memory.
type HostScratch = RayScratch<1024>;

/// Renders the scene by rays, as it looks. It has to be baked for that
/// ([`fixel_bake::bake_for_rays`]).
pub fn render_rays(scene: &Scene<'_>, options: &Options) -> Planes {
    render(scene, options, &mut ())
}

/// Renders every plane of a baked scene by rays.
pub fn ray_frame(baked: &Baked, scene: &Scene<'_>, options: &Options) -> (Frame, Planes) {
    let (width, height) = scene.output().frame_size((options.width, options.height));
    let size = usize::from(width) * usize::from(height);
    let mut all = All {
        width,
        seen: vec![None; size],
        smoothed: vec![None; size],
    };
    let drawn = render(scene, options, &mut all);
    // A later viewport's background covers what an earlier one shows.
    for (seen, depth) in all.seen.iter_mut().zip(&drawn.depth) {
        *seen = seen.filter(|_| *depth != 0);
    }
    let lookup = Lookup {
        direct: false,
        // What is watched is without.
        fog: Vec::new(),
        ..lookup(scene, options, drawn.size)
    };
    let seen = || all.seen.iter();
    let triangle = |seen: &Option<Seen>| {
        let place = seen.as_ref().and_then(|seen| seen.triangle);
        let source = place.and_then(|place| baked.sources.triangles.get(place as usize));
        source.map_or(NO_TRIANGLE, |source| source.triangle)
    };
    let background = lookup.background.iter();
    let smoothed = || all.smoothed.iter();
    let own = seen().zip(background).zip(smoothed());
    let index: Vec<u8> = own
        .map(|((seen, background), smoothed)| match (smoothed, seen) {
            (Some((_, index)), _) => *index,
            (None, Some(seen)) => seen.index,
            (None, None) => *background,
        })
        .collect();
    let level = |c: u16| ((c + 32) >> 6).min(255) as u8;
    let frame = Frame {
        width: width.into(),
        height: height.into(),
        actor: seen().map(|seen| seen.map_or(0, |s| s.actor + 1)).collect(),
        triangle: seen().map(triangle).collect(),
        light: seen()
            .zip(smoothed())
            .map(|(seen, smoothed)| {
                let own = seen.map_or([0; 3], |seen| seen.light);
                smoothed.map_or(own, |(light, _)| light).map(level)
            })
            .collect(),
        rgb: pixels(&before_dithering(scene, options.frame), &index),
        index,
        depth: drawn.depth.clone(),
        texture_place: Vec::new(),
        lit: seen().map(|seen| seen.map_or(0, |s| s.lights)).collect(),
        lookup,
    };
    (frame, drawn)
}

struct All {
    width: u16,
    seen: Vec<Option<Seen>>,
    /// Of pixels of several rays, light and index.
    smoothed: Vec<Option<(Lit, u8)>>,
}

impl Watch for All {
    fn pixel(&mut self, column: u16, row: u16, seen: &Seen) {
        let at = usize::from(row) * usize::from(self.width) + usize::from(column);
        self.seen[at] = Some(*seen);
        self.smoothed[at] = None;
    }

    fn smoothed(&mut self, column: u16, row: u16, light: Lit, index: u8) {
        let at = usize::from(row) * usize::from(self.width) + usize::from(column);
        self.smoothed[at] = Some((light, index));
    }
}

fn render<W: Watch>(scene: &Scene<'_>, options: &Options, watch: &mut W) -> Planes {
    let mut scratch = Box::new(HostScratch::new());
    collected(scene, options, |pose, band, collector| {
        let work = &mut scratch.workspace();
        let Ok(stats) = render_frame_watched(scene, pose, work, band, collector, watch);
        FrameStats {
            bands: stats.bands,
            ..FrameStats::default()
        }
    })
}
