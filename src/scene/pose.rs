//! What a scene looks like in one frame: the part that changes.

use fixed::types::U8F24;

use super::{Actor, Scene};
use crate::math::{Angle, Vec3, World};

/// How depth shrinks things.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// Things shrink with distance.
    Perspective {
        /// Tangent of half the vertical angle of view, above 0.
        tan_half_angle: U8F24,
    },
    /// Things do not shrink.
    Parallel {
        /// Half of the picture's height in world units, above 0.
        half_height: World,
    },
}

/// The eye. Lengths in world units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    /// Where it is.
    pub position: Vec3,
    /// What it looks at.
    pub focal_point: Vec3,
    /// Which way is up; any length, not parallel to the line of sight.
    pub view_up: Vec3,
    /// Perspective or parallel.
    pub projection: Projection,
    /// Distance of the near plane along the line of sight, in units of
    /// `2^range_exponent`; above 0 for perspective.
    pub near: World,
    /// Distance of the far plane, in units of `2^range_exponent`; [`World::MAX`]:
    /// none (perspective only).
    pub far: World,
    /// See `near`; 0..=11. 0 but where a parallel view's range is far larger than
    /// its scene.
    pub range_exponent: u8,
}

/// Where an actor is and how it is turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Where its pivot is.
    pub position: Vec3,
    /// Turned about x, y and z; a point turns about y first, then x, then z.
    pub orientation: [Angle; 3],
}

/// A scene's state in one frame. It starts as the scene file says, and the
/// application changes what it wants.
#[derive(Clone, Copy, Debug)]
pub struct Pose<'a> {
    /// The eye, of every viewport that has none of its own.
    pub camera: Camera,
    /// Screen rows; the width is the band's.
    pub height: u16,
    /// Added to every actor's turn about its y axis (the turntable).
    pub turn: Angle,
    /// Actors that are elsewhere than the scene file says: index and place.
    pub moved: &'a [(u16, Placement)],
    /// Viewports whose camera is another than the scene file says: number and
    /// camera.
    pub cameras: &'a [(u16, Camera)],
}

impl Pose<'_> {
    /// Where an actor is in this frame.
    pub fn placement(&self, index: u16, actor: &Actor) -> Placement {
        let moved = self.moved.iter().find(|(which, _)| *which == index);
        let mut placement = match moved {
            Some((_, placement)) => *placement,
            None => Placement {
                position: Vec3::from_bits(actor.position),
                orientation: actor.orientation.map(Angle::from_bits),
            },
        };
        let [x, y, z] = placement.orientation;
        placement.orientation = [x, y.plus(self.turn), z];
        placement
    }
}

impl Scene<'_> {
    /// The scene at frame `number` of its animation.
    pub fn pose(&self, number: u32) -> Pose<'static> {
        let header = &self.header;
        Pose {
            camera: header.camera().camera(),
            height: header.height,
            turn: Angle::fraction(number, header.turntable),
            moved: &[],
            cameras: &[],
        }
    }
}
