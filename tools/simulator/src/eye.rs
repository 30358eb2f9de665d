//! The eye as a hand moves it, and where everything is that it may see.

use fixel::math::{Angle, Factor, World};
use fixel::scene::{Camera, Projection};
use fixel_scene::Reach;

use crate::requests::Frame;

/// What a hand has made of the view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// The eye, once somebody has moved it.
    pub camera: Option<Camera>,
    /// How much larger things are than in the scene.
    pub zoom: f64,
}

impl View {
    /// The scene's own.
    pub const OWN: Self = Self {
        camera: None,
        zoom: 1.0,
    };

    /// The eye, if it is not where `own` is.
    pub fn of(&self, own: Camera) -> Option<Camera> {
        if self.camera.is_none() && self.zoom == 1.0 {
            return None;
        }
        let mut camera = self.camera.unwrap_or(own);
        camera.projection = own.projection;
        camera.zoom(Factor::from_num(self.zoom));
        Some(camera)
    }
}

impl Frame {
    /// Whether the eye goes somewhere.
    pub(crate) fn moves(&self) -> bool {
        [self.azimuth, self.elevation, self.right, self.up] != [0.0; 4]
    }
}

/// In world units: scene units times a power of two, about the world's centre.
pub(crate) fn reach(core: &fixel::Scene<'_>, reach: &Reach) -> Vec<([f64; 3], f64)> {
    let header = core.header();
    let factor = f64::exp2(header.world_exponent.into());
    let unit = f64::exp2(header.centre_exponent.into());
    let centre = header.world_centre.map(|c| f64::from(c) * unit);
    let place = |p: [f64; 3]| [0, 1, 2].map(|axis| (p[axis] - centre[axis]) * factor);
    let spheres = reach.actors.iter();
    spheres
        .map(|(centre, radius)| (place(*centre), radius * factor))
        .collect()
}

/// The eye after the moves of a hand, and a clipping range for where it is then.
/// `height` is what a picture's height is as far away as the focal point.
pub(crate) fn moved(
    mut camera: Camera,
    frame: &Frame,
    height: f64,
    reach: &[([f64; 3], f64)],
) -> Camera {
    camera.azimuth(degrees(frame.azimuth));
    camera.elevation(degrees(frame.elevation));
    camera.level();
    let by = |part: f64| World::saturating_from_num(-part * height);
    camera.pan(by(frame.right), by(frame.up));
    let (near, far) = clipping_range(&camera, reach);
    if camera.range_exponent == 0 && near < far {
        (camera.near, camera.far) = (near, far);
    }
    camera
}

fn degrees(angle: f64) -> Angle {
    Angle::from_bits((angle / 360.0 * 4_294_967_296.0).round() as i64 as u32)
}

/// How much is seen from the picture's lower edge to its upper one, as far away as the focal
/// point, in world units.
pub(crate) fn height_at_focus(camera: &Camera) -> f64 {
    let away = camera
        .position
        .to_bits()
        .into_iter()
        .zip(camera.focal_point.to_bits());
    let squares = away.map(|(a, b)| (f64::from(a) - f64::from(b)).powi(2));
    let distance = squares.sum::<f64>().sqrt() / 65536.0;
    match camera.projection {
        Projection::Perspective { tan_half_angle } => {
            2.0 * distance * tan_half_angle.to_num::<f64>()
        }
        Projection::Parallel { half_height } => 2.0 * half_height.to_num::<f64>(),
    }
}

/// Before and behind everything, as scenes get it that name no range.
fn clipping_range(camera: &Camera, reach: &[([f64; 3], f64)]) -> (World, World) {
    let eye = camera.position.to_bits().map(|c| f64::from(c) / 65536.0);
    let focus = camera.focal_point.to_bits().map(|c| f64::from(c) / 65536.0);
    let sight = [0, 1, 2].map(|axis| focus[axis] - eye[axis]);
    let length = sight.iter().map(|c| c * c).sum::<f64>().sqrt();
    let (mut near, mut far) = (f64::INFINITY, f64::NEG_INFINITY);
    for (centre, radius) in reach {
        let along = (0..3).map(|axis| (centre[axis] - eye[axis]) * sight[axis]);
        let depth = along.sum::<f64>() / length;
        near = near.min(depth - radius);
        far = far.max(depth + radius);
    }
    let room = (far - near) * 0.01;
    far = (far + room).max(1e-3);
    near = (near - room).max(far * 0.01);
    (
        World::saturating_from_num(near),
        World::saturating_from_num(far),
    )
}
