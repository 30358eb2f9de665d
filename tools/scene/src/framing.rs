//! Where the scene is, and a camera that sees all of it: VTK's ResetCamera
//! and ResetCameraClippingRange (vtkRenderer.cxx), but for a turntable the
//! bounds hold for every frame.

use glam::DVec3;

use crate::description::{Actor, Animation, Camera, Mesh, Projection, Target};
use crate::look::Space;
use crate::motion::{self, Instant};

/// Around all actors, in world space.
#[derive(Clone, Debug)]
pub(crate) struct Bounds {
    centre: DVec3,
    /// Holds all actors at all frames; greater than 0.
    radius: f64,
    /// One sphere an actor, for all frames; together tighter than the one.
    spheres: Vec<(DVec3, f64)>,
}

impl Bounds {
    /// The bounds of actors, of which each has a mesh with vertices.
    pub fn of(actors: &[Actor], meshes: &[Mesh], animation: &Animation) -> Self {
        let instants = Instant::all(animation);
        let moves = instants.len() > 1;
        let mut spheres = Vec::new();
        let mut corners = Vec::new();
        for (index, actor) in actors.iter().enumerate() {
            if actor.look.space != Space::World {
                continue;
            }
            let Some(mesh) = meshes.get(actor.mesh) else {
                continue;
            };
            let local = box_corners(&mesh.positions);
            let before = corners.len();
            for instant in &instants {
                let place = |corner| motion::place(actors, animation, instant, index, corner);
                corners.extend(local.map(place));
            }
            // The point that turning leaves in place.
            let pivot = DVec3::from(actor.origin) + DVec3::from(actor.position);
            let plain = actor.parent.is_none() && actor.matrix == crate::IDENTITY;
            let mut tracked = animation.tracks.iter();
            let around = if moves && plain && !tracked.any(|t| t.target == Target::Actor(index)) {
                pivot
            } else {
                middle(&corners[before..])
            };
            spheres.push((around, farthest(around, &corners[before..])));
        }
        let (low, high) = extent(&corners);
        let centre = (low + high) / 2.0;
        // VTK's radius is half the box's diagonal. What turns needs less than
        // half the diagonal of the box around all its frames.
        let radius = if moves {
            farthest(centre, &corners)
        } else {
            (high - low).length() / 2.0
        };
        Self {
            centre,
            radius: if radius > 0.0 { radius } else { 0.5 },
            spheres,
        }
    }

    /// The middle of them all.
    pub fn centre(&self) -> [f64; 3] {
        self.centre.into()
    }

    /// A sphere around each actor at all frames.
    pub fn spheres(&self) -> &[(DVec3, f64)] {
        &self.spheres
    }

    /// Bounds around a given middle that hold the same things.
    pub fn seen_from_point(&self, centre: DVec3) -> Self {
        Self {
            centre,
            radius: self.radius + centre.distance(self.centre),
            spheres: self.spheres.clone(),
        }
    }
}

fn extent(points: &[DVec3]) -> (DVec3, DVec3) {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), point| {
        (low.min(*point), high.max(*point))
    })
}

fn middle(points: &[DVec3]) -> DVec3 {
    let (low, high) = extent(points);
    (low + high) / 2.0
}

fn farthest(centre: DVec3, points: &[DVec3]) -> f64 {
    points
        .iter()
        .fold(0.0, |most, point| most.max(centre.distance(*point)))
}

fn box_corners(positions: &[[f64; 3]]) -> [DVec3; 8] {
    let points: Vec<DVec3> = positions.iter().map(|&point| point.into()).collect();
    let (low, high) = extent(&points);
    std::array::from_fn(|corner| {
        let pick = |axis: usize| {
            if corner >> axis & 1 == 0 {
                low[axis]
            } else {
                high[axis]
            }
        };
        DVec3::new(pick(0), pick(1), pick(2))
    })
}

/// A perspective camera in the direction `from` (unit length) off the
/// bounds' middle, at the distance from which the sphere just fits the
/// shorter side of the picture; `aspect` is width / height. The clipping
/// range is left for [`clipping_range`].
pub(crate) fn frame(bounds: &Bounds, from: DVec3, view_angle: f64, aspect: f64) -> Camera {
    let half = view_angle.to_radians() / 2.0;
    let half = if aspect < 1.0 {
        libm::atan(libm::tan(half) * aspect)
    } else {
        half
    };
    let position = bounds.centre + from * (bounds.radius / libm::sin(half));
    Camera {
        position: position.into(),
        focal_point: bounds.centre.into(),
        view_up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective { view_angle },
        clipping_range: [0.0; 2],
    }
}

/// Half the picture's height at which the sphere just fits.
pub(crate) fn parallel_scale(bounds: &Bounds, aspect: f64) -> f64 {
    bounds.radius / aspect.min(1.0)
}

/// Distances before and behind everything that can be seen, from the camera in all
/// of its places. What reaches behind the eye is cut at a hundredth of the far
/// distance, as VTK does for a depth buffer of 16 bits.
pub(crate) fn clipping_range(cameras: &[Camera], bounds: &Bounds) -> [f64; 2] {
    clipping_range_of(cameras, bounds.spheres.iter().copied())
}

/// The same for spheres: centres and radii.
pub(crate) fn clipping_range_of(
    cameras: &[Camera],
    spheres: impl Iterator<Item = (DVec3, f64)> + Clone,
) -> [f64; 2] {
    const NEAR_OF_FAR: f64 = 0.01;
    let (mut near, mut far) = (f64::INFINITY, f64::NEG_INFINITY);
    for camera in cameras {
        let position = DVec3::from(camera.position);
        let sight = (DVec3::from(camera.focal_point) - position).normalize();
        for (centre, radius) in spheres.clone() {
            let depth = (centre - position).dot(sight);
            near = near.min(depth - radius);
            far = far.max(depth + radius);
        }
    }
    // VTK widens by half the range either side; the sphere is roomy already,
    // and depth has only 16 bits to share out.
    let room = (far - near) * 0.01;
    far += room;
    near -= room;
    if far <= 0.0 {
        // All of it is behind the eye: any range shows nothing.
        return [0.01, 1000.01];
    }
    [near.max(far * NEAR_OF_FAR), far]
}
