//! Where things are over time, as far as framing and baking need to know it. The
//! reference works out the same by itself.

use glam::{DMat4, DVec3};

use crate::description::{Actor, Animation, Camera, Projection, Quantity, Scene, Target, Track};

/// Angles of a turntable at which its bounds are looked at. The box of a
/// turning box between two of them is larger by less than 1 in 1000.
const TURNTABLE_STEPS: u32 = 64;
/// Frames of the tracks that are looked at, and with a turntable for each of its
/// angles.
const FRAMES: [u32; 2] = [256, 16];

/// A moment of an animation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant {
    /// Degrees that the turntable adds.
    turn: f64,
    /// The tracks' frame.
    frame: f64,
}

impl Instant {
    /// So many moments that nothing of note is missed between them: one if nothing
    /// moves.
    pub fn all(animation: &Animation) -> Vec<Self> {
        let turns = animation.turntable.map_or(1, |_| TURNTABLE_STEPS);
        let frames = frames(animation, FRAMES[usize::from(turns > 1)]);
        let turn = |step| 360.0 * f64::from(step) / f64::from(turns);
        let at = |frame: f64| {
            (0..turns).map(move |step| Self {
                turn: turn(step),
                frame,
            })
        };
        frames.into_iter().flat_map(at).collect()
    }
}

/// Frames of the tracks, about so many, every key among them.
fn frames(animation: &Animation, most: u32) -> Vec<f64> {
    let Some(length) = animation.frames.filter(|_| !animation.tracks.is_empty()) else {
        return vec![0.0];
    };
    let steps = length.min(most).max(1);
    let even = (0..steps).map(|step| f64::from(step) * f64::from(length) / f64::from(steps));
    let keys = animation.tracks.iter().flat_map(|track| &track.keys);
    let mut all: Vec<f64> = even.chain(keys.map(|key| f64::from(key.frame))).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// A track's value.
fn value(track: &Track, frame: f64) -> [f64; 3] {
    let after = track
        .keys
        .iter()
        .position(|key| f64::from(key.frame) > frame);
    let (last, next) = match after {
        None => (track.keys.len() - 1, track.keys.len() - 1),
        Some(next) => (next.saturating_sub(1), next),
    };
    let (from, to) = (&track.keys[last], &track.keys[next]);
    let span = f64::from(to.frame) - f64::from(from.frame);
    let part = if span > 0.0 {
        ((frame - f64::from(from.frame)) / span).max(0.0)
    } else {
        0.0
    };
    std::array::from_fn(|i| from.value[i] + (to.value[i] - from.value[i]) * part)
}

/// The tracks that move something.
pub(crate) fn tracks(animation: &Animation, target: Target) -> impl Iterator<Item = &Track> {
    animation
        .tracks
        .iter()
        .filter(move |track| track.target == target)
}

/// A point of an actor's mesh in world space.
pub(crate) fn place(
    actors: &[Actor],
    animation: &Animation,
    at: &Instant,
    index: usize,
    point: DVec3,
) -> DVec3 {
    let Some(actor) = actors.get(index) else {
        return point;
    };
    let (mut position, mut orientation, mut factor) = (actor.position, actor.orientation, 1.0);
    for track in tracks(animation, Target::Actor(index)) {
        let value = value(track, at.frame);
        match track.quantity {
            Quantity::Position => position = value,
            Quantity::Orientation => orientation = value,
            _ => factor = value[0],
        }
    }
    let origin = DVec3::from(actor.origin);
    let [x, mut y, z] = orientation;
    if actor.parent.is_none() && !actor.still {
        y += at.turn;
    }
    let mut p = (point - origin) * DVec3::from(actor.scale) * factor;
    let [xy, xz, yx, yz, zx, zy] = actor.shear;
    p += DVec3::new(
        xy * p.y + xz * p.z,
        yx * p.x + yz * p.z,
        zx * p.x + zy * p.y,
    );
    let (sin, cos) = libm::sincos(y.to_radians());
    p = DVec3::new(cos * p.x + sin * p.z, p.y, cos * p.z - sin * p.x);
    let (sin, cos) = libm::sincos(x.to_radians());
    p = DVec3::new(p.x, cos * p.y - sin * p.z, sin * p.y + cos * p.z);
    let (sin, cos) = libm::sincos(z.to_radians());
    p = DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z);
    p += origin + DVec3::from(position);
    if actor.matrix != crate::IDENTITY {
        p = DMat4::from_cols_array_2d(&actor.matrix)
            .transpose()
            .transform_point3(p);
    }
    match actor.parent {
        Some(parent) => place(actors, animation, at, parent, p),
        None => p,
    }
}

/// The camera after a move of `value`.
pub(crate) fn moved(mut camera: Camera, quantity: Quantity, value: [f64; 3]) -> Camera {
    let (eye, focus) = (
        DVec3::from(camera.position),
        DVec3::from(camera.focal_point),
    );
    let up = DVec3::from(camera.view_up);
    let sight = focus - eye;
    let number = value[0];
    let turned = |axis: DVec3, v: DVec3| {
        // Rodrigues' formula.
        let axis = axis.normalize_or(DVec3::Y);
        let (sin, cos) = libm::sincos(number.to_radians());
        v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos))
    };
    match quantity {
        Quantity::Position => camera.position = value,
        Quantity::FocalPoint => camera.focal_point = value,
        Quantity::Azimuth => camera.position = (focus + turned(up, -sight)).into(),
        Quantity::Elevation => {
            camera.position = (focus + turned(up.cross(sight), -sight)).into();
        }
        Quantity::Roll => camera.view_up = turned(sight, up).into(),
        Quantity::Dolly => camera.position = (focus - sight / number).into(),
        Quantity::Zoom => match &mut camera.projection {
            Projection::Perspective { view_angle } => *view_angle /= number,
            Projection::Parallel { parallel_scale } => *parallel_scale /= number,
        },
        Quantity::Pan => {
            let right = sight.cross(up).normalize_or_zero();
            let way = right * value[0] + right.cross(sight).normalize_or_zero() * value[1];
            camera.position = (eye + way).into();
            camera.focal_point = (focus + way).into();
        }
        Quantity::Orientation | Quantity::Scale => {}
    }
    camera
}

/// The camera in all frames that are worth a look: one if it stands still.
pub(crate) fn cameras(camera: &Camera, animation: &Animation, target: Target) -> Vec<Camera> {
    if tracks(animation, target).next().is_none() {
        return vec![*camera];
    }
    let at = |frame: f64| camera_at(camera, animation, target, frame);
    frames(animation, FRAMES[0]).into_iter().map(at).collect()
}

/// A camera that the tracks of `target` move.
fn camera_at(camera: &Camera, animation: &Animation, target: Target, frame: f64) -> Camera {
    tracks(animation, target).fold(*camera, |camera, track| {
        moved(camera, track.quantity, value(track, frame))
    })
}

/// Where everything is at one moment of the animation.
#[derive(Clone, Debug)]
pub struct Moment {
    /// For each actor, the columns of the matrix that takes its mesh to the world.
    pub actors: Vec<[[f64; 4]; 4]>,
    /// [`Scene::camera`], moved.
    pub camera: Camera,
    /// Each viewport's own camera, moved, if it has one.
    pub viewports: Vec<Option<Camera>>,
}

impl Moment {
    /// Moments of a scene, evenly spread over its animation, `most` of them if
    /// anything moves and the first one if not.
    pub fn some(scene: &Scene, most: usize) -> Vec<Self> {
        let animation = &scene.animation;
        let frames = frames(animation, FRAMES[0]);
        let moves = animation.turntable.is_some() || frames.len() > 1;
        let count = if moves { most.max(1) } else { 1 };
        let moment = |number: usize| {
            let turns = animation.turntable.map_or(0.0, |_| 360.0);
            let at = Instant {
                turn: turns * number as f64 / count as f64,
                frame: frames[number * frames.len() / count],
            };
            Self::new(scene, &at)
        };
        (0..count).map(moment).collect()
    }

    fn new(scene: &Scene, at: &Instant) -> Self {
        let place = |actor, point| place(&scene.actors, &scene.animation, at, actor, point);
        let matrix = |actor| {
            let origin = place(actor, DVec3::ZERO);
            let axis = |axis| (place(actor, axis) - origin).extend(0.0).to_array();
            let [x, y, z] = DVec3::AXES.map(axis);
            [x, y, z, origin.extend(1.0).to_array()]
        };
        let camera = |camera, target| camera_at(camera, &scene.animation, target, at.frame);
        let viewports = scene.viewports.iter().enumerate();
        Self {
            actors: (0..scene.actors.len()).map(matrix).collect(),
            camera: camera(&scene.camera, Target::Camera),
            viewports: viewports
                .map(|(number, viewport)| {
                    let own = viewport.camera.as_ref()?;
                    Some(camera(own, Target::Viewport(number)))
                })
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> Scene {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");
        crate::load(path.as_ref()).unwrap()
    }

    #[test]
    fn a_point_is_turned_about_y_then_x_then_z() {
        let mut scene = cube();
        let actor = &mut scene.actors[0];
        actor.origin = [1.0, 0.0, 0.0];
        actor.position = [0.0, 10.0, 0.0];
        actor.scale = [1.0, 2.0, 3.0];
        actor.orientation = [90.0, 60.0, 90.0];
        scene.animation.turntable = Some(100);
        // From the origin (0, 1, 1): scaled (0, 2, 3); about y by 60 and 30 degrees
        // (3, 2, 0); about x (3, 0, 2); about z (0, 3, 2).
        let moments = Moment::some(&scene, 12);
        assert_eq!(moments.len(), 12);
        let matrix = DMat4::from_cols_array_2d(&moments[1].actors[0]);
        let found = matrix.transform_point3(DVec3::ONE);
        assert!(
            found.distance(DVec3::new(1.0, 13.0, 2.0)) < 1e-12,
            "{found}"
        );
        scene.animation.turntable = None;
        assert_eq!(Moment::some(&scene, 12).len(), 1);
    }

    #[test]
    fn a_moment_has_the_camera_and_the_frame_of_its_time() {
        let mut scene = cube();
        let key = |frame, x: f64| crate::Key {
            frame,
            value: [x, 0.0, 0.0],
        };
        let track = |target, quantity| Track {
            target,
            quantity,
            keys: vec![key(0, 0.0), key(8, 16.0)],
        };
        scene.animation.frames = Some(8);
        scene.animation.tracks = vec![
            track(Target::Camera, Quantity::Position),
            track(Target::Actor(0), Quantity::Position),
        ];
        for (number, moment) in Moment::some(&scene, 4).iter().enumerate() {
            // Nine frames are looked at, the last key among them.
            let x = 2.0 * (number * 9 / 4) as f64;
            assert_eq!(moment.camera.position, [x, 0.0, 0.0]);
            assert_eq!(moment.actors[0][3][0], x);
        }
    }
}
