//! Cameras and viewports.

use super::Background;

/// The eye. Right-handed; looks from `position` to `focal_point`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye's place.
    pub position: [f64; 3],
    /// What is in the middle of the picture.
    pub focal_point: [f64; 3],
    /// A direction that points up in the picture; need not be perpendicular
    /// to the line of sight, must not be parallel to it.
    pub view_up: [f64; 3],
    /// How depth shrinks things.
    pub projection: Projection,
    /// Distances of the near and the far plane along the line of sight;
    /// 0 < near < far for perspective.
    pub clipping_range: [f64; 2],
}

/// Perspective or parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Perspective.
    Perspective {
        /// Full vertical angle of view, in degrees.
        view_angle: f64,
    },
    /// Parallel.
    Parallel {
        /// Half of the picture's height, in scene units.
        parallel_scale: f64,
    },
}

impl Projection {
    /// Shows more in height, by a factor of at least 1: of the view angle's tangent, or of the
    /// parallel scale.
    pub fn widen(&mut self, factor: f64) {
        if factor > 1.0 {
            match self {
                Self::Perspective { view_angle } => {
                    let half = libm::tan(view_angle.to_radians() / 2.0) * factor;
                    *view_angle = 2.0 * libm::atan(half).to_degrees();
                }
                Self::Parallel { parallel_scale } => *parallel_scale *= factor,
            }
        }
    }
}

/// A part of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Viewport {
    /// `[x, y, width, height]` as parts of the picture's width and height, all
    /// within 0..=1; (x, y) is the lower left corner and y points up, as VTK has
    /// it. In pixels, each side is at the line between pixels that is nearest.
    pub rectangle: [f64; 4],
    /// Its own eye; `None`: [`Scene::camera`](super::Scene::camera).
    pub camera: Option<Camera>,
    /// Its own background; `None`: [`Display::background`](super::Display::background), a gradient of which
    /// runs from the viewport's top edge to its bottom edge.
    pub background: Option<Background>,
    /// How the camera's picture is brought into it.
    pub aspect: Aspect,
}

/// How a camera's picture is brought into a viewport. Its height always shows the
/// camera's angle of view or parallel scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// Pixels are square; the viewport's shape decides how much is seen to the
    /// sides (the default).
    Keep,
    /// As much is seen as in the whole picture, squeezed or stretched.
    Stretch,
}
