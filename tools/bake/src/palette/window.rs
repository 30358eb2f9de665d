//! How large things look to a camera.

use fixel_scene::{Camera, Projection};
use glam::DVec3;

/// What is out of the picture counts so much less: the camera may turn.
const OUTSIDE: f64 = 1.0 / 32.0;

/// A camera's picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    eye: DVec3,
    /// Right, up and forward.
    axes: [DVec3; 3],
    /// Half of its width and height: at distance 1 in perspective.
    half: [f64; 2],
    near: f64,
    perspective: bool,
}

impl Window {
    /// `aspect`: width over height.
    pub(super) fn new(camera: &Camera, aspect: f64) -> Self {
        let eye = DVec3::from(camera.position);
        let forward = (DVec3::from(camera.focal_point) - eye).normalize_or_zero();
        let right = forward.cross(camera.view_up.into()).normalize_or_zero();
        let (perspective, half) = match camera.projection {
            Projection::Perspective { view_angle } => {
                (true, libm::tan(view_angle.to_radians() / 2.0))
            }
            Projection::Parallel { parallel_scale } => (false, parallel_scale),
        };
        Self {
            eye,
            axes: [right, right.cross(forward), forward],
            half: [half * aspect, half],
            near: camera.clipping_range[0],
            perspective,
        }
    }

    /// From a place towards the eye, unit length.
    pub(super) fn towards_eye(&self, place: DVec3) -> DVec3 {
        if self.perspective {
            (self.eye - place).normalize_or_zero()
        } else {
            -self.axes[2]
        }
    }

    /// The distance of a place along the line of sight.
    pub(super) fn depth(&self, place: DVec3) -> f64 {
        self.axes[2].dot(place - self.eye)
    }

    /// Where a place is in the picture, 0..1 from its left and from its top; `None` if it
    /// is not in it.
    pub(super) fn in_picture(&self, place: DVec3) -> Option<[f64; 2]> {
        let [x, y, depth] = self.axes.map(|axis| axis.dot(place - self.eye));
        let reach = if self.perspective { depth } else { 1.0 };
        let [width, height] = self.half;
        let at = [
            (1.0 + x / (width * reach)) / 2.0,
            (1.0 - y / (height * reach)) / 2.0,
        ];
        let inside = depth >= self.near && at.iter().all(|c| (0.0..1.0).contains(c));
        inside.then_some(at)
    }

    /// The places in a plane that are seen one pixel to the right of one there and one
    /// pixel below, in a picture so many pixels high; `None` beyond the horizon.
    pub(super) fn next_to(&self, place: DVec3, normal: DVec3, height: f64) -> Option<[DVec3; 2]> {
        let [right, up, forward] = self.axes;
        let depth = self.depth(place);
        let pixel = 2.0 * self.half[1] / height;
        let seen = |beside: DVec3| {
            let (from, ray) = if self.perspective {
                (self.eye, (place - self.eye) / depth + beside * pixel)
            } else {
                (place + beside * pixel, forward)
            };
            let along = (place - from).dot(normal) / ray.dot(normal);
            (along.is_finite() && (along > 0.0 || !self.perspective)).then(|| from + ray * along)
        };
        Some([seen(right)?, seen(-up)?])
    }

    /// Of the whole picture.
    pub(super) fn size(&self) -> f64 {
        4.0 * self.half[0] * self.half[1]
    }

    /// How large a triangle looks: at most, where it is nearest, and from its middle.
    pub(super) fn apparent(&self, places: [DVec3; 3]) -> (f64, f64) {
        let [a, b, c] = places;
        let area = (b - a).cross(c - a) / 2.0;
        let middle = (a + b + c) / 3.0 - self.eye;
        let [x, y, depth] = self.axes.map(|axis| axis.dot(middle));
        let reach = places.map(|p| p.distance(middle + self.eye));
        let reach = reach.into_iter().fold(0.0, f64::max);
        if depth + reach < self.near {
            return (0.0, 0.0);
        }
        let [width, height] = self.half;
        if !self.perspective {
            let size = area.dot(self.axes[2]).abs();
            let inside = x.abs() < width && y.abs() < height;
            let beside = x.abs() - reach > width || y.abs() - reach > height;
            let most = if beside { 0.0 } else { size };
            return (most, if inside { size } else { size * OUTSIDE });
        }
        let distance = middle.length().max(self.near);
        let nearest = (distance - reach).max(self.near);
        let size = area.dot(middle / distance).abs() / (distance * distance);
        let inside = depth > 0.0 && x.abs() < width * depth && y.abs() < height * depth;
        // What is beside the picture need not be cut so finely.
        let beside =
            x.abs() - reach > width * (depth + reach) || y.abs() - reach > height * (depth + reach);
        let most = if beside {
            0.0
        } else {
            area.length() / (nearest * nearest)
        };
        (most, if inside { size } else { size * OUTSIDE })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_what_is_seen() {
        // A square of 2 by 2 that fills a quarter of a picture of 4 by 4.
        let camera = Camera {
            position: [0.0, 0.0, 10.0],
            focal_point: [0.0; 3],
            view_up: [0.0, 1.0, 0.0],
            projection: Projection::Parallel {
                parallel_scale: 2.0,
            },
            clipping_range: [1.0, 20.0],
        };
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let [a, b, c, d] = square.map(|[x, y]| DVec3::new(x, y, 0.0));
        let window = Window::new(&camera, 1.0);
        let size = window.apparent([a, b, c]).1 + window.apparent([a, c, d]).1;
        assert!((size / window.size() - 0.25).abs() < 1e-12);
        // Seen along its plane it has no size; far off the picture, little.
        let turned = [a, b, c].map(|p| DVec3::new(p.x, 0.0, p.y));
        assert!(window.apparent(turned).1 < 1e-12);
        let off = [a, b, c].map(|p| p + DVec3::X * 10.0);
        assert!((window.apparent(off).1 - 2.0 * OUTSIDE).abs() < 1e-12);
        // It need not be cut, what is in the picture has to.
        assert_eq!(window.apparent(off).0, 0.0);
        assert!((window.apparent([a, b, c]).0 - 2.0).abs() < 1e-12);
    }
}
