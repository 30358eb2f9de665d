//! Model space to world space.

use fixel_scene::{Quantity, Scene, Target};
use glam::{DMat3, DMat4, DVec3};

use crate::track::sample;

/// The matrix that places actor `index` in the world at animation frame `frame`:
/// `M T(position) T(origin) Rz Rx Ry H S T(-origin)`, applied from the right, the
/// order of VTK's `vtkProp3D`, then the same of its parent. Angles are in degrees
/// and turn counter-clockwise seen from the axis' positive end. A turntable adds
/// `360 * frame / turntable` degrees to the angle about y of what has no parent
/// and is not still.
///
/// # Panics
/// If there is no such actor.
pub fn actor_matrix(scene: &Scene, index: usize, frame: u32) -> DMat4 {
    let (actor, animation) = (&scene.actors[index], &scene.animation);
    let now = |quantity, plain| sample(animation, Target::Actor(index), quantity, frame, plain);
    let position = now(Quantity::Position, actor.position);
    let [x, mut y, z] = now(Quantity::Orientation, actor.orientation);
    let [factor, ..] = now(Quantity::Scale, [1.0; 3]);
    if let (Some(turn), None, false) = (animation.turntable, actor.parent, actor.still) {
        y += 360.0 * f64::from(frame) / f64::from(turn);
    }
    let [xy, xz, yx, yz, zx, zy] = actor.shear;
    let shear = DMat3::from_cols(
        DVec3::new(1.0, yx, zx),
        DVec3::new(xy, 1.0, zy),
        DVec3::new(xz, yz, 1.0),
    );
    let origin = DVec3::from(actor.origin);
    let own = DMat4::from_cols_array_2d(&actor.matrix).transpose()
        * DMat4::from_translation(DVec3::from(position))
        * DMat4::from_translation(origin)
        * DMat4::from_rotation_z(z.to_radians())
        * DMat4::from_rotation_x(x.to_radians())
        * DMat4::from_rotation_y(y.to_radians())
        * DMat4::from_mat3(shear)
        * DMat4::from_scale(DVec3::from(actor.scale) * factor)
        * DMat4::from_translation(-origin);
    match actor.parent {
        Some(parent) => actor_matrix(scene, parent, frame) * own,
        None => own,
    }
}
