//! The parts of a picture that have cameras of their own.

use crate::camera::{camera_at, moved};
use crate::geometry::Geometry;
use crate::view::View;
use fixel_scene::{Aspect, Background, Display, Rgb, Scene, Target, Viewport};
use glam::DVec3;

/// A viewport in a picture.
#[derive(Clone, Debug)]
pub(crate) struct Window {
    /// First column and row, y down.
    pub corner: [u32; 2],
    /// Columns and rows.
    pub size: [u32; 2],
    pub view: View,
    pub geometry: Geometry,
    pub background: Background,
    /// Of its camera, unit length.
    pub view_up: DVec3,
}

impl Window {
    /// All of a scene's in a picture of `width` by `height` pixels, later ones over
    /// earlier ones, in samples: see [`sampled_size`].
    pub fn all(scene: &Scene, width: u32, height: u32, frame: u32) -> Vec<Self> {
        let whole = [Viewport {
            rectangle: [0.0, 0.0, 1.0, 1.0],
            camera: None,
            background: None,
            aspect: Aspect::Keep,
        }];
        let viewports = match scene.viewports.as_slice() {
            [] => &whole[..],
            viewports => viewports,
        };
        let scenes_own = camera_at(scene, frame);
        let Display {
            samples, stereo, ..
        } = scene.display;
        let columns = width * stereo.joined() / stereo.eyes();
        let window = |eye: u32, number: usize, viewport: &Viewport| {
            let [x, y, w, h] = viewport.rectangle;
            let ([left, right], [top, bottom]) = (
                [x, x + w].map(|at| line(at, columns)),
                [1.0 - (y + h), 1.0 - y].map(|at| line(at, height)),
            );
            let size = [right - left, bottom - top];
            let shape = match viewport.aspect {
                Aspect::Keep => f64::from(size[0]) / f64::from(size[1]),
                Aspect::Stretch => f64::from(width) / f64::from(height),
            };
            let camera = match viewport.camera {
                Some(own) => moved(&scene.animation, own, Target::Viewport(number), frame),
                None => scenes_own,
            };
            let size = [size[0] * samples[0], size[1] * samples[1]];
            let slope = (stereo.eye_angle() / 2.0).to_radians().tan();
            let slope = if eye == 0 { -slope } else { slope };
            let view = View::shaped(&camera, size, shape).of_eye(&camera, slope);
            let aside = eye * (width * stereo.joined() - columns);
            Self {
                corner: [(aside + left) * samples[0], top * samples[1]],
                size,
                geometry: Geometry::new(scene, &view, frame),
                view,
                background: viewport.background.unwrap_or(scene.display.background),
                view_up: DVec3::from(camera.view_up).normalize(),
            }
        };
        let eyes = 0..stereo.eyes();
        eyes.flat_map(|eye| viewports.iter().enumerate().map(move |(n, v)| (eye, n, v)))
            .map(|(eye, number, viewport)| window(eye, number, viewport))
            .collect()
    }

    /// Column and row of the picture's pixel in this part, if it is in it.
    pub fn place(&self, x: u32, y: u32) -> Option<[u32; 2]> {
        let [left, top] = self.corner;
        let place = [x.checked_sub(left)?, y.checked_sub(top)?];
        (place[0] < self.size[0] && place[1] < self.size[1]).then_some(place)
    }

    /// The picture's pixels in this part that share a side with one of them.
    pub fn neighbours(&self, [x, y]: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
        let to = |x: Option<u32>, y: Option<u32>| Some([x?, y?]);
        let all = [
            to(x.checked_sub(1), Some(y)),
            to(Some(x + 1), Some(y)),
            to(Some(x), y.checked_sub(1)),
            to(Some(x), Some(y + 1)),
        ];
        let inside = |[x, y]: &[u32; 2]| self.place(*x, *y).is_some();
        all.into_iter().flatten().filter(inside)
    }

    /// The background in row `y` of this part.
    pub fn background(&self, y: u32) -> Rgb {
        row_colour(&self.background, y, self.size[1])
    }
}

/// Columns and rows of samples for a picture of `width` by `height` pixels.
pub(crate) fn sampled_size(scene: &Scene, width: u32, height: u32) -> [u32; 2] {
    let [across, down] = scene.display.samples;
    [
        width * scene.display.stereo.joined() * across,
        height * down,
    ]
}

/// The line between pixels that is nearest to a part of the picture's size. Ties,
/// which the rounding of a scene's numbers would decide, go up.
fn line(at: f64, size: u32) -> u32 {
    (at * f64::from(size) + 0.5 + 1e-4).floor() as u32
}

/// A background's colour in row `y` of `height`.
pub(crate) fn row_colour(background: &Background, y: u32, height: u32) -> Rgb {
    match *background {
        Background::Solid(colour) => colour,
        Background::Gradient { top, bottom } => {
            let t = (f64::from(y) + 0.5) / f64::from(height);
            std::array::from_fn(|i| top[i] + (bottom[i] - top[i]) * t)
        }
    }
}
