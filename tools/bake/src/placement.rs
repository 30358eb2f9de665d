//! Where actors are, in parts that the core can move: each actor's way into its
//! parent's space is a turn and a move, which may change from frame to frame, and a
//! linear rest that stays and is worked into the mesh.
//!
//! An actor's way to its parent is `M T(position + origin) R H S T(-origin)`
//! (matrix, move, turn, shear, scale), the parent's own rest `A` comes after it. With
//! `B = A M` without its move, it is a move by `b + B (position + origin)` and the
//! linear `B R H S`. If B is even, it commutes with R and the rest is `B H S`; if the
//! actor does not turn, all of `B R H S` can be the rest. What is left is an actor
//! that turns within an uneven space: its mesh would be another one in every frame.

use fixel::scene::layout::PARENTS;
use fixel_scene::{Actor, Element, Quantity, Scene, Target};
use glam::{DMat3, DMat4, DVec3};

use crate::error::{BakeError, Problem, Spot};
use crate::units::Units;

/// How far a matrix may be from an even one that is taken for it.
const EVEN: f64 = 1e-12;

/// Where an actor is in its parent's space, as the core has it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    /// Degrees about x, y, z.
    pub orientation: [f64; 3],
    /// What comes before the turn; to be worked into the mesh.
    pub linear: DMat3,
    /// Where the pivot is with `position + origin` at zero.
    base: DVec3,
    /// What the way of a move is turned and scaled by.
    moves: DMat3,
    root: bool,
}

impl Placed {
    /// Where an actor's pivot is at a `position` as the scene has it.
    pub fn position(
        &self,
        units: &Units,
        (number, actor): (usize, &Actor),
        position: [f64; 3],
    ) -> Result<[i32; 3], BakeError> {
        let way = DVec3::from(position) + DVec3::from(actor.origin);
        let place = self.base + self.moves * way;
        let what = format!("actor `{}`: position", actor.name);
        let spot = Spot::new(Element::Actor(number), &what);
        if self.root {
            units.place(spot, place)
        } else {
            units.vector(spot, place)
        }
    }
}

/// All actors, in their order.
pub(crate) fn placed(scene: &Scene) -> Result<Vec<Placed>, BakeError> {
    let mut known = vec![None; scene.actors.len()];
    for index in 0..scene.actors.len() {
        let mut chain = vec![index];
        while let Some(parent) = scene.actors[chain[chain.len() - 1]].parent {
            if chain.len() > PARENTS {
                let problem = Problem::TooMany {
                    what: "parents above an actor",
                    found: chain.len(),
                    most: PARENTS,
                };
                return Err(problem.at(Element::Actor(index)));
            }
            chain.push(parent);
        }
        for index in chain.into_iter().rev() {
            if known[index].is_none() {
                let parent = scene.actors[index].parent;
                let above = parent.and_then(|p| known[p].map(|placed| (&scene.actors[p], placed)));
                known[index] = Some(place(scene, index, above)?);
            }
        }
    }
    Ok(known.into_iter().flatten().collect())
}

fn place(
    scene: &Scene,
    index: usize,
    above: Option<(&Actor, Placed)>,
) -> Result<Placed, BakeError> {
    let actor = &scene.actors[index];
    let matrix = DMat4::from_cols_array_2d(&actor.matrix).transpose();
    let (rest, origin) = above.map_or((DMat3::IDENTITY, DVec3::ZERO), |(parent, placed)| {
        (placed.linear, DVec3::from(parent.origin))
    });
    let outer = rest * DMat3::from_mat4(matrix);
    let inner = shear(actor.shear) * DMat3::from_diagonal(DVec3::from(actor.scale));
    let turn = rotation(actor.orientation);
    let whole = outer * turn * inner;
    let (orientation, linear) = match (even(outer), even(whole)) {
        (Some((factor, turned)), _) if turned == DMat3::IDENTITY => {
            (actor.orientation, inner * factor)
        }
        _ if turns(scene, index) => {
            let actor = actor.name.clone();
            return Err(Problem::Turns { actor }.at(Element::Actor(index)));
        }
        (_, Some((factor, turn))) => (angles(turn), DMat3::from_diagonal(DVec3::splat(factor))),
        (Some((factor, outer)), _) => (angles(outer * turn), inner * factor),
        _ => ([0.0; 3], whole),
    };
    Ok(Placed {
        orientation,
        linear,
        base: rest * (matrix.w_axis.truncate() - origin),
        moves: outer,
        root: above.is_none(),
    })
}

/// Whether an actor turns by itself, so that its orientation must stay what it is.
fn turns(scene: &Scene, index: usize) -> bool {
    let animation = &scene.animation;
    let actor = &scene.actors[index];
    let turntable = animation.turntable.is_some() && actor.parent.is_none() && !actor.still;
    turntable
        || animation.tracks.iter().any(|track| {
            track.target == Target::Actor(index) && track.quantity == Quantity::Orientation
        })
}

/// Factor and rotation, if a matrix is no more than that.
fn even(matrix: DMat3) -> Option<(f64, DMat3)> {
    let x = matrix.x_axis.x;
    if x > 0.0 && matrix == DMat3::from_diagonal(DVec3::splat(x)) {
        return Some((x, DMat3::IDENTITY));
    }
    let factor = matrix.determinant().cbrt();
    let turn = matrix * factor.recip();
    let off = turn * turn.transpose() - DMat3::IDENTITY;
    let even = factor > 0.0 && off.to_cols_array().iter().all(|c| c.abs() < EVEN);
    even.then(|| {
        let still = turn.abs_diff_eq(DMat3::IDENTITY, EVEN);
        (factor, if still { DMat3::IDENTITY } else { turn })
    })
}

fn shear([xy, xz, yx, yz, zx, zy]: [f64; 6]) -> DMat3 {
    DMat3::from_cols_array_2d(&[[1.0, yx, zx], [xy, 1.0, zy], [xz, yz, 1.0]])
}

/// About y, then x, then z.
fn rotation([x, y, z]: [f64; 3]) -> DMat3 {
    DMat3::from_rotation_z(z.to_radians())
        * DMat3::from_rotation_x(x.to_radians())
        * DMat3::from_rotation_y(y.to_radians())
}

/// The angles of a rotation, in degrees. Where y and z are about the same axis, z
/// is 0.
fn angles(turn: DMat3) -> [f64; 3] {
    let [x, y, z] = [turn.x_axis, turn.y_axis, turn.z_axis];
    let cos = y.x.hypot(y.y);
    let radians = if cos > 1e-9 {
        [y.z.atan2(cos), (-x.z).atan2(z.z), (-y.x).atan2(y.y)]
    } else {
        [y.z.atan2(cos), z.x.atan2(x.x), 0.0]
    };
    radians.map(f64::to_degrees)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_has_its_angles_back() {
        for turn in [
            [10.0, 20.0, 30.0],
            [-80.0, 170.0, -100.0],
            [90.0, 40.0, 0.0],
            [-90.0, -40.0, 25.0],
            [0.0, 180.0, 180.0],
        ] {
            let matrix = rotation(turn);
            let again = rotation(angles(matrix));
            assert!(again.abs_diff_eq(matrix, 1e-12), "{turn:?}");
        }
    }

    #[test]
    fn what_is_even() {
        let turn = rotation([10.0, 20.0, 30.0]);
        let (factor, same) = even(turn * 3.0).expect("a turn and a factor");
        assert!((factor - 3.0).abs() < 1e-12 && same.abs_diff_eq(turn, 1e-12));
        assert_eq!(even(DMat3::IDENTITY * 2.0), Some((2.0, DMat3::IDENTITY)));
        assert!(even(turn * DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0))).is_none());
        assert!(even(shear([0.1, 0.0, 0.0, 0.0, 0.0, 0.0])).is_none());
    }
}
