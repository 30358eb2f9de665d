//! The colours that rays bring back: shadows, mirrors and glass make more of them than
//! surfaces have by themselves. The core casts the rays, in a first bake.

use std::convert::Infallible;

use fixel::display::Display;
use fixel::frame::BandRows;
use fixel::light::Lit;
use fixel::palette::Palette;
use fixel::ray::{RayScratch, Seen, Watch, render_frame_watched};
use fixel::{Band, Scene};

use crate::palette::Sample;

/// Pixels across and down at most.
const MOST: u16 = 128;
/// Frames of an animation that are looked at.
const FRAMES: u32 = 4;
/// Actors whose places are kept.
type Scratch = RayScratch<64>;

/// Colours of all surfaces that go by colour, in some frames of an animation of so many.
/// Their weights are the parts of the picture that they fill.
pub(crate) fn seen(scene: &Scene<'_>, frames: u32) -> Vec<Sample> {
    let (width, height) = (scene.width().max(1), scene.height().max(1));
    let shrink = f64::from(width.max(height)) / f64::from(MOST);
    let side = |side: u16| (f64::from(side) / shrink.max(1.0)).ceil() as u16;
    let (width, height) = (side(width), side(height));
    let pixels = usize::from(width) * usize::from(height);
    let looks = frames.clamp(1, FRAMES);
    let mut colours = Colours {
        by_colour: (0..scene.actor_count())
            .map(|actor| scene.material(scene.actor(actor).material).coloured)
            .collect(),
        samples: Vec::new(),
        weight: 1.0 / (pixels as f64 * f64::from(looks)),
    };
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut scratch = Box::new(Scratch::new());
    for look in 0..looks {
        let mut pose = scene.pose(look * frames / looks);
        pose.height = height;
        if let Ok(mut band) = Band::new(width, &mut indices, &mut depths) {
            let work = &mut scratch.workspace();
            let Ok(_) =
                render_frame_watched(scene, &pose, work, &mut band, &mut Nowhere, &mut colours);
        }
    }
    colours.samples
}

struct Nowhere;

impl Display for Nowhere {
    type Error = Infallible;

    fn begin(&mut self, _: &Palette<'_>) -> Result<(), Infallible> {
        Ok(())
    }

    fn show(&mut self, _: BandRows<'_>) -> Result<(), Infallible> {
        Ok(())
    }
}

struct Colours {
    /// Of each actor.
    by_colour: Vec<bool>,
    samples: Vec<Sample>,
    weight: f64,
}

impl Watch for Colours {
    fn pixel(&mut self, _: u16, _: u16, seen: &Seen) {
        if self.by_colour.get(usize::from(seen.actor)) == Some(&true) {
            self.samples.push(Sample {
                colour: seen.light.map(|c| f64::from(c) / (64.0 * 255.0)),
                weight: self.weight,
            });
        }
    }

    fn smoothed(&mut self, _: u16, _: u16, _: Lit, _: u8) {}
}
