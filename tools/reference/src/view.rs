//! World space to view space, and the ray through a pixel.

use crate::bvh::Line;
use crate::ray::Ray;
use fixel_scene::{Camera, Projection};
use glam::DVec3;

/// How far the sample is moved off the pixel's centre, in pixels, to the right
/// and down. It turns the top-left rule into plain geometry: a centre exactly
/// on a left edge (interior to the right) or on a horizontal top edge
/// (interior below) moves inside, one on a right or bottom edge moves outside.
/// Down is a thousand times less than right, so that only an edge flatter than
/// one pixel in a thousand counts as horizontal. Both are far above the
/// rounding of f64 (1e-13 pixels) and far below anything that a 16-bit depth
/// could show. Moving the sample, unlike a tolerance at each edge, can open no
/// gap and double no pixel where several edges meet.
const TIE_SHIFT_PX: [f64; 2] = [1e-7, 1e-10];

/// The camera, ready to cast rays: view space has `x` to the right, `y` up and
/// `w` along the line of sight, with the eye at 0; lengths are scene units.
#[derive(Clone, Debug)]
pub struct View {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// Half of the picture's width and height: at w = 1 for perspective, in
    /// scene units for parallel.
    half: [f64; 2],
    perspective: bool,
    /// Near and far plane.
    range: [f64; 2],
    size_px: [f64; 2],
    /// How much further to the right things appear with each unit of `w`.
    slope: f64,
}

impl View {
    /// The view of a camera on a picture of `width` by `height` pixels. The
    /// angle of view and the parallel scale are vertical, as VTK has them; the
    /// picture's aspect gives the width (pixels are square).
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        Self::shaped(
            camera,
            [width, height],
            f64::from(width) / f64::from(height),
        )
    }

    /// The same with what is seen `shape` times as wide as high, whatever the
    /// pixels.
    pub(crate) fn shaped(camera: &Camera, size: [u32; 2], shape: f64) -> Self {
        let eye = DVec3::from(camera.position);
        let forward = (DVec3::from(camera.focal_point) - eye).normalize();
        let right = forward.cross(DVec3::from(camera.view_up)).normalize();
        let up = right.cross(forward);
        let size_px = size.map(f64::from);
        let (half_height, perspective) = match camera.projection {
            Projection::Perspective { view_angle } => ((view_angle / 2.0).to_radians().tan(), true),
            Projection::Parallel { parallel_scale } => (parallel_scale, false),
        };
        Self {
            eye,
            right,
            up,
            forward,
            half: [half_height * shape, half_height],
            perspective,
            range: camera.clipping_range,
            size_px,
            slope: 0.0,
        }
    }

    /// The eye moved aside so far that the focal point is seen at `slope` from it,
    /// and the picture sheared so that it stays where it was.
    pub(crate) fn of_eye(self, camera: &Camera, slope: f64) -> Self {
        let distance = DVec3::from(camera.focal_point).distance(DVec3::from(camera.position));
        Self {
            eye: self.eye + self.right * (slope * distance),
            slope,
            ..self
        }
    }

    /// A ray in the world; t is the distance along the line of sight.
    pub(crate) fn line(&self, ray: &Ray) -> Line {
        let world = |v: DVec3| self.right * v.x + self.up * v.y + self.forward * v.z;
        let Line { origin, direction } = ray.line();
        Line {
            origin: self.eye + world(origin),
            direction: world(direction),
        }
    }

    /// A world point in view space: right, up, along the line of sight.
    pub fn to_view(&self, world: DVec3) -> DVec3 {
        let p = world - self.eye;
        DVec3::new(p.dot(self.right), p.dot(self.up), p.dot(self.forward))
    }

    /// From a world point towards the eye, unit length: for a parallel camera
    /// against the line of sight, from everywhere.
    pub(crate) fn towards_eye(&self, world: DVec3) -> DVec3 {
        if self.perspective {
            (self.eye - world).normalize_or_zero()
        } else {
            -self.forward
        }
    }

    /// The ray through the centre of a pixel (column `x`, row `y`, counted
    /// down from the top).
    pub(crate) fn ray(&self, x: u32, y: u32) -> Ray {
        self.ray_through(Self::centre_px([x, y]))
    }

    /// [`View::ray`] and its mirror images about the pixel's centre: what is met by any of
    /// them is at the centre, if a ray through an edge may meet either side.
    pub(crate) fn rays_around(&self, x: u32, y: u32) -> [Ray; 4] {
        let [right, down] = TIE_SHIFT_PX;
        [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]].map(|[sx, sy]| {
            let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            self.ray_through([x + sx * right, y + sy * down])
        })
    }

    /// A pixel's centre on the screen.
    pub(crate) fn centre_px(pixel: [u32; 2]) -> [f64; 2] {
        [0, 1].map(|i| f64::from(pixel[i]) + 0.5 + TIE_SHIFT_PX[i])
    }

    /// The place on the screen, in pixels, of a point of view space before the eye.
    pub(crate) fn to_screen_px(&self, point: DVec3) -> [f64; 2] {
        let w = if self.perspective { point.z } else { 1.0 };
        let along = |at: f64, i: usize| (at / w / self.half[i] + 1.0) * self.size_px[i] / 2.0;
        [along(point.x, 0), along(-point.y, 1)]
    }

    /// The ray through a place on the screen.
    pub(crate) fn ray_through(&self, [x_px, y_px]: [f64; 2]) -> Ray {
        let along = |at: f64, size: f64, half: f64| (2.0 * at / size - 1.0) * half;
        let sx = along(x_px, self.size_px[0], self.half[0]);
        let sy = -along(y_px, self.size_px[1], self.half[1]);
        if self.perspective {
            Ray {
                origin: [0.0, 0.0],
                slope: [sx - self.slope, sy],
            }
        } else {
            Ray {
                origin: [sx, sy],
                slope: [-self.slope, 0.0],
            }
        }
    }

    /// Whether things shrink with distance.
    pub(crate) fn is_perspective(&self) -> bool {
        self.perspective
    }

    /// A point in view space in pixels from the top left.
    pub(crate) fn to_screen(&self, p: DVec3) -> [f64; 2] {
        let w = if self.perspective { p.z } else { 1.0 };
        let along = |v: f64, half: f64, size: f64| (v / w / half + 1.0) / 2.0 * size;
        [
            along(p.x, self.half[0], self.size_px[0]),
            along(-p.y, self.half[1], self.size_px[1]),
        ]
    }

    /// How much the depth of a triangle's plane changes a pixel: `|dz/dx| +
    /// |dz/dy|`, in units of the 16-bit buffer.
    pub(crate) fn slope_lsb(&self, [a, b, c]: [DVec3; 3]) -> f64 {
        let normal = (b - a).cross(c - a);
        let [near, far] = self.range;
        let pixel = [0, 1].map(|axis| 2.0 * self.half[axis] / self.size_px[axis]);
        let across = normal.x.abs() * pixel[0] + normal.y.abs() * pixel[1];
        // 1 / w, or w, is a linear function of the place on the screen.
        if self.perspective {
            65535.0 * near * across / normal.dot(a).abs()
        } else {
            65535.0 / (far - near) * across / normal.z.abs()
        }
    }

    /// Whether a distance along the line of sight lies between the planes.
    pub(crate) fn in_range(&self, w: f64) -> bool {
        self.range[0] <= w && w <= self.range[1]
    }

    /// Near and far plane.
    pub(crate) fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Depth in units of the 16-bit buffer, unrounded, of a distance along the
    /// line of sight: `65535 * near / w` or `65535 * (far - w) / (far - near)`.
    pub(crate) fn depth_lsb(&self, w: f64) -> f64 {
        let [near, far] = self.range;
        65535.0
            * if self.perspective {
                near / w
            } else {
                (far - w) / (far - near)
            }
    }
}
