//! The camera in a frame.

use fixel_scene::{Animation, Camera, Projection, Quantity, Scene, Target};
use glam::{DQuat, DVec3};

use crate::track::sample;

/// The scene's camera in frame `frame`, where its tracks have it.
pub fn camera_at(scene: &Scene, frame: u32) -> Camera {
    moved(&scene.animation, scene.camera, Target::Camera, frame)
}

/// A camera in frame `frame`: as it stands, moved to where its tracks have it and
/// then by azimuth, elevation, roll, dolly, zoom and pan, as VTK's `vtkCamera` does
/// it. The clipping range stays.
pub(crate) fn moved(
    animation: &Animation,
    mut camera: Camera,
    target: Target,
    frame: u32,
) -> Camera {
    let now = |quantity, plain| sample(animation, target, quantity, frame, plain);
    let number = |quantity, plain: f64| now(quantity, [plain, 0.0, 0.0])[0];
    let mut eye = DVec3::from(now(Quantity::Position, camera.position));
    let mut focus = DVec3::from(now(Quantity::FocalPoint, camera.focal_point));
    let mut up = DVec3::from(camera.view_up).normalize();

    let about = |axis: DVec3, quantity| {
        DQuat::from_axis_angle(axis.normalize(), number(quantity, 0.0).to_radians())
    };
    eye = focus + about(up, Quantity::Azimuth) * (eye - focus);
    let left = up.cross(focus - eye);
    eye = focus + about(left, Quantity::Elevation) * (eye - focus);
    up = about(focus - eye, Quantity::Roll) * up;
    eye = focus + (eye - focus) / number(Quantity::Dolly, 1.0);
    let zoom = number(Quantity::Zoom, 1.0);
    let [right, rise, _] = now(Quantity::Pan, [0.0; 3]);
    let forward = (focus - eye).normalize();
    let x_axis = forward.cross(up).normalize();
    let way = x_axis * right + x_axis.cross(forward) * rise;
    eye += way;
    focus += way;

    camera.position = eye.into();
    camera.focal_point = focus.into();
    camera.view_up = up.into();
    match &mut camera.projection {
        Projection::Perspective { view_angle } => *view_angle /= zoom,
        Projection::Parallel { parallel_scale } => *parallel_scale /= zoom,
    }
    camera
}
