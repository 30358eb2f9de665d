//! Model space to world space.

use fixel_scene::{Actor, Animation};
use glam::{DMat4, DVec3};

/// The matrix that places an actor in the world at animation frame `frame`:
/// `T(position) T(origin) Rz Rx Ry S T(-origin)`, applied from the right, the
/// order of VTK's `vtkProp3D`. Angles are in degrees and turn
/// counter-clockwise seen from the axis' positive end. A turntable adds
/// `360 * frame / turntable` degrees to the angle about y.
pub fn actor_matrix(actor: &Actor, animation: &Animation, frame: u32) -> DMat4 {
    let origin = DVec3::from(actor.origin);
    let [x, mut y, z] = actor.orientation;
    if let Some(turn) = animation.turntable {
        y += 360.0 * f64::from(frame) / f64::from(turn);
    }
    DMat4::from_translation(DVec3::from(actor.position))
        * DMat4::from_translation(origin)
        * DMat4::from_rotation_z(z.to_radians())
        * DMat4::from_rotation_x(x.to_radians())
        * DMat4::from_rotation_y(y.to_radians())
        * DMat4::from_scale(DVec3::from(actor.scale))
        * DMat4::from_translation(-origin)
}
