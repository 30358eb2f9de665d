//! What is truly seen at each pixel.

use crate::fog::fogged;
use crate::hit::{Hit, Layer};
use crate::overlay::Overlay;
use crate::trace::{RayCounts, Reach, Traced};
use crate::window::Window;
use fixel_scene::{Fog, Rgb};

/// The truth about a picture. Pixels go by rows from the top left.
#[derive(Clone, Debug)]
pub struct Truth {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) pixels: Vec<Option<Hit>>,
    /// The blended surfaces before each, far ones first.
    pub(crate) layers: Vec<Vec<Layer>>,
    /// The background's colour at each pixel.
    pub(crate) background: Vec<Rgb>,
    pub(crate) fog: Option<Fog>,
    /// Samples of a pixel, across and down.
    pub(crate) samples: [u32; 2],
    /// Pictures beside each other that become one.
    pub(crate) joined: u32,
    /// How many materials the scene has.
    pub(crate) materials: usize,
    /// Parts of the picture, later ones over earlier ones.
    pub(crate) windows: Vec<Window>,
    /// Lines and marks of each.
    pub(crate) overlays: Vec<Overlay>,
    /// If rays made it.
    pub(crate) traced: Option<Traced>,
}

impl Truth {
    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All pixels by rows; `None` where nothing is seen.
    pub fn pixels(&self) -> &[Option<Hit>] {
        &self.pixels
    }

    /// The surface at column `x`, row `y`.
    ///
    /// # Panics
    /// If the pixel is outside of the picture.
    pub fn hit(&self, x: u32, y: u32) -> Option<&Hit> {
        assert!(
            x < self.width && y < self.height,
            "pixel {x}, {y} is outside"
        );
        self.pixels[(y * self.width + x) as usize].as_ref()
    }

    /// Whether an actor is a sphere or a rectangle that rays meet as a whole.
    pub(crate) fn is_primitive(&self, actor: usize) -> bool {
        self.traced
            .as_ref()
            .is_some_and(|traced| traced.world.is_primitive(actor))
    }

    /// Whether a pixel's colour is of several rays.
    pub(crate) fn is_resampled(&self, i: usize) -> bool {
        self.traced
            .as_ref()
            .is_some_and(|traced| traced.resampled[i])
    }

    /// As [`crate::Frame::lit`].
    pub(crate) fn lit(&self) -> Vec<u8> {
        let bits = |reaches: &Vec<Reach>| {
            let lights = reaches.iter().take(8).enumerate();
            let reached = lights.filter(|(_, reach)| reach.part > 0.0);
            reached.fold(0, |bits, (light, _)| bits | 1 << light)
        };
        let pixels = self.traced.iter().flat_map(|traced| &traced.reaches);
        pixels.map(bits).collect()
    }

    /// How many rays it took, if rays made it.
    pub fn rays(&self) -> Option<RayCounts> {
        self.traced.as_ref().map(|traced| traced.rays)
    }

    /// The blended surfaces before what is seen at each pixel, far ones first: no part of
    /// the depth buffer, of coverage or of what is picked.
    pub fn layers(&self) -> &[Vec<Layer>] {
        &self.layers
    }

    /// How many pixels show a surface.
    pub fn covered_px(&self) -> usize {
        self.pixels.iter().flatten().count()
    }

    /// Depth in units of the 16-bit buffer at which the given triangle (or edge, or
    /// vertex; see [`Hit::triangle`]) itself is met at a pixel, seen or hidden; `None` if it is not met there.
    pub fn depth_of_lsb(&self, actor: usize, triangle: usize, x: u32, y: u32) -> Option<f64> {
        let (window, overlay, [column, row]) = self.window(x, y)?;
        if let Some(traced) = &self.traced {
            let view = &window.view;
            let mut met = view.rays_around(column, row).into_iter().filter_map(|ray| {
                let w = traced.world.meet_one(actor, triangle, &view.line(&ray))?;
                view.in_range(w).then(|| view.depth_lsb(w))
            });
            return met.next();
        }
        let Some(face) = window.geometry.face(actor, triangle) else {
            return overlay.depth_lsb(actor, triangle, self.number(x, y));
        };
        let meeting = face.seen(&window.view.ray(column, row), &window.view)?;
        Some(window.view.depth_lsb(meeting.w) - face.sunk_lsb.unwrap_or(0.0))
    }

    /// The part of the picture that is seen at a pixel, and the place in it.
    fn window(&self, x: u32, y: u32) -> Option<(&Window, &Overlay, [u32; 2])> {
        let all = self.windows.iter().zip(&self.overlays).rev();
        let mut placed = all.filter_map(|(w, o)| Some((w, o, w.place(x, y)?)));
        placed.next()
    }

    fn number(&self, x: u32, y: u32) -> usize {
        (y * self.width + x) as usize
    }

    /// Whether rounding decides which of two pixels a line or a mark takes at pixel
    /// number `i`.
    pub(crate) fn is_doubtful(&self, i: usize) -> bool {
        let (x, y) = (i as u32 % self.width, i as u32 / self.width);
        let window = self.window(x, y);
        window.is_some_and(|(_, overlay, _)| overlay.is_doubtful(i))
    }

    /// The unquantised colour of every pixel, background included, each
    /// channel in 0..=1.
    pub fn colours(&self) -> impl Iterator<Item = Rgb> + '_ {
        self.pixels
            .iter()
            .zip(&self.background)
            .zip(&self.layers)
            .map(|((pixel, background), layers)| {
                let behind = match pixel {
                    Some(hit) => {
                        let own = if hit.hidden { *background } else { hit.colour };
                        match &self.fog {
                            Some(fog) => fogged(fog, own.into(), hit.fog).into(),
                            None => own,
                        }
                    }
                    None => *background,
                };
                layers.iter().fold(behind, |behind, l| l.over(behind))
            })
    }

    /// The picture, 8 bits a channel, rounded to the nearest: the mean of each
    /// pixel's samples, red of the left eye and green and blue of the right one in
    /// an anaglyph.
    pub fn picture(&self) -> Vec<[u8; 3]> {
        let all: Vec<Rgb> = self.colours().collect();
        let [across, down] = self.samples;
        let [columns, rows] = self.picture_size();
        let mean = |x: u32, y: u32, channel: usize| {
            let mut sum = 0.0;
            for sy in y * down..(y + 1) * down {
                let row = (sy * self.width) as usize;
                let from = row + (x * across) as usize;
                let samples = &all[from..from + across as usize];
                sum += samples.iter().map(|c| c[channel]).sum::<f64>();
            }
            (255.0 * sum / f64::from(across * down)).round() as u8
        };
        let right = (self.joined - 1) * columns;
        let pixels = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        pixels
            .map(|(x, y)| [mean(x, y, 0), mean(x + right, y, 1), mean(x + right, y, 2)])
            .collect()
    }

    /// Columns and rows of [`Truth::picture`]; the truth itself has a pixel for each
    /// sample, and an anaglyph's two pictures beside each other.
    pub fn picture_size(&self) -> [u32; 2] {
        let [across, down] = self.samples;
        [self.width / (self.joined * across), self.height / down]
    }

    /// The 16-bit depth buffer: 0 where nothing is seen, at least 1 where
    /// something is.
    pub fn depth16(&self) -> Vec<u16> {
        let depth = |hit: &Hit| hit.depth_lsb.round().max(1.0) as u16;
        self.pixels
            .iter()
            .map(|p| p.as_ref().map_or(0, depth))
            .collect()
    }

    /// 0 where nothing is seen, otherwise 1 + the actor's index (at most
    /// 65535: later actors share that number).
    pub fn actor_ids(&self) -> Vec<u16> {
        let id = |hit: Hit| u16::try_from(hit.actor + 1).unwrap_or(u16::MAX);
        self.pixels.iter().map(|p| p.map_or(0, id)).collect()
    }
}
