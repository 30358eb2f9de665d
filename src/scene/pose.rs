//! What a scene looks like in one frame: the part that changes.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "a pose's numbers of 32 bits, in 64; what may be larger saturates; tests stop at overflow"
)]

use fixed::types::U8F24;

use super::{Actor, Quantity, Scene};
use crate::math::{Angle, Factor, Rotation, Vec3, World};

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

/// Where an actor is, how it is turned and how large it is: in its parent's space
/// if it has one, in the world if not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Where its pivot is.
    pub position: Vec3,
    /// Turned about x, y and z; a point turns about y first, then x, then z.
    pub orientation: [Angle; 3],
    /// Times its size in the scene file; 1 as a rule. Holds for its children too.
    pub scale: Factor,
}

/// Where an actor is in the world, its parents' places included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Where its pivot is.
    pub position: Vec3,
    /// How it is turned.
    pub rotation: Rotation,
    /// Times its size in the scene file.
    pub scale: Factor,
}

impl From<Placement> for Place {
    /// Where an actor without a parent is.
    fn from(placement: Placement) -> Self {
        Self {
            position: placement.position,
            rotation: Rotation::from_orientation(placement.orientation),
            scale: placement.scale,
        }
    }
}

impl Place {
    /// A vector of the actor's own, raw world bits, with its scale, in Q30. Below
    /// 2^45, beyond which it saturates.
    #[inline(never)]
    pub fn scaled(&self, vector: [i32; 3]) -> [i64; 3] {
        // 31 bits and 32.
        let by = i64::from(self.scale.to_bits());
        vector.map(|c| ((i64::from(c) * by) >> 10).clamp(-(1 << 45), 1 << 45))
    }

    /// World units a grid step: mantissa and exponent as an [`Actor`] has them.
    #[inline(never)]
    pub fn step(&self, actor: &Actor) -> (u32, i32) {
        let by = u64::from(self.scale.to_bits().max(1));
        let step = u64::from(actor.step_mantissa) * by;
        let bits = 64 - step.leading_zeros() as i32; // at least 32
        let (least, most) = super::layout::STEP_EXPONENTS;
        let exponent = actor.step_exponent + bits - 32 - 24;
        ((step >> (bits - 32)) as u32, exponent.clamp(least, most))
    }

    /// Where something is that is at `inner` in this actor's space.
    fn holding(&self, inner: &Self) -> Self {
        let turned = self
            .rotation
            .apply_wide(self.scaled(inner.position.to_bits()));
        Self {
            position: self.position.plus(turned.map(|c| (c + (1 << 13)) >> 14)),
            rotation: inner.rotation.then(&self.rotation),
            scale: self.scale.saturating_mul(inner.scale),
        }
    }
}

/// A scene's state in one frame. It starts as the scene file says, and the
/// application changes what it wants.
#[derive(Clone, Copy, Debug)]
pub struct Pose<'a> {
    /// The eye, of every viewport that has none of its own.
    pub camera: Camera,
    /// Screen rows; the width is the band's.
    pub height: u16,
    /// Added to the turn about its y axis of every actor without a parent that is
    /// not still (the turntable).
    pub turn: Angle,
    /// The frame that actors' key frames are looked up at.
    pub frame: u32,
    /// Actors that are elsewhere than the scene file says: index and place. Their
    /// children move with them.
    pub moved: &'a [(u16, Placement)],
    /// Viewports whose camera is another than the scene file says: number and
    /// camera.
    pub cameras: &'a [(u16, Camera)],
    /// How many entries on the scene's cycled palette entries have gone: they look
    /// as so many entries further on do in the palette.
    pub palette_shift: u16,
}

impl Pose<'_> {
    /// Where an actor is in this frame, in its parent's space.
    #[inline(never)]
    pub fn placement(&self, scene: &Scene<'_>, index: u16, actor: &Actor) -> Placement {
        let moved = self.moved.iter().find(|(which, _)| *which == index);
        let mut placement = match moved {
            Some((_, placement)) => *placement,
            None => self.as_the_scene_says(scene, index, actor),
        };
        if actor.parent.is_none() && !actor.still {
            let [x, y, z] = placement.orientation;
            placement.orientation = [x, y.plus(self.turn), z];
        }
        placement
    }

    /// An actor where it is in this frame, in its parent's space, but turned so about x, y
    /// and z: an entry for [`Pose::moved`].
    pub fn turned(
        &self,
        scene: &Scene<'_>,
        index: u16,
        orientation: [Angle; 3],
    ) -> (u16, Placement) {
        let own = self.as_the_scene_says(scene, index, &scene.actor(index));
        let placement = Placement { orientation, ..own };
        (index, placement)
    }

    fn as_the_scene_says(&self, scene: &Scene<'_>, index: u16, actor: &Actor) -> Placement {
        let mut placement = Placement {
            position: Vec3::from_bits(actor.position),
            orientation: actor.orientation.map(Angle::from_bits),
            scale: Factor::ONE,
        };
        for track in scene.moving(index) {
            let between = scene.between(&track, self.frame);
            match track.quantity {
                Quantity::Position => placement.position = Vec3::from_bits(between.rounded()),
                Quantity::Orientation => {
                    placement.orientation = between.turns().map(Angle::from_bits);
                }
                _ => placement.scale = between.factor(),
            }
        }
        placement
    }

    /// Where an actor is in the world in this frame.
    #[inline(never)]
    pub fn place(&self, scene: &Scene<'_>, index: u16, actor: &Actor) -> Place {
        let mut place = Place::from(self.placement(scene, index, actor));
        let mut parent = actor.parent;
        for _ in 0..super::layout::PARENTS {
            let Some(index) = parent else { break };
            let actor = scene.actor(index);
            let above = Place::from(self.placement(scene, index, &actor));
            place = above.holding(&place);
            parent = actor.parent;
        }
        place
    }
}

impl Scene<'_> {
    /// The scene at frame `number` of its animation.
    #[inline(never)]
    pub fn pose(&self, number: u32) -> Pose<'static> {
        let header = &self.header;
        let frame = number.checked_rem(header.frames).unwrap_or(number);
        Pose {
            camera: self.moved_camera(header.camera.camera(), None, frame),
            height: self.frame_height(),
            turn: Angle::fraction(number, header.turntable),
            frame,
            moved: &[],
            cameras: &[],
            palette_shift: self.palette_shift(number),
        }
    }

    /// See [`Pose::palette_shift`].
    fn palette_shift(&self, number: u32) -> u16 {
        let (_, count) = self.header.cycle;
        let frames = self.header.cycle_frames;
        let part = number.checked_rem(frames).unwrap_or(0);
        let shift = u64::from(part) * u64::from(count);
        shift.checked_div(frames.into()).unwrap_or(0) as u16
    }

    /// A camera, the scene's or a viewport's own, with its tracks, in their order.
    pub(super) fn moved_camera(
        &self,
        mut camera: Camera,
        viewport: Option<u8>,
        frame: u32,
    ) -> Camera {
        let tracks = self.moving(super::layout::CAMERA);
        for track in tracks.filter(|track| track.viewport == viewport) {
            let between = self.between(&track, frame);
            match track.quantity {
                Quantity::Position => camera.position = Vec3::from_bits(between.rounded()),
                Quantity::FocalPoint => camera.focal_point = Vec3::from_bits(between.rounded()),
                Quantity::Azimuth => camera.azimuth(between.angle()),
                Quantity::Elevation => camera.elevation(between.angle()),
                Quantity::Roll => camera.roll(between.angle()),
                Quantity::Dolly => camera.dolly(between.factor()),
                Quantity::Zoom => camera.zoom(between.factor()),
                Quantity::Pan => {
                    let Vec3 { x, y, .. } = Vec3::from_bits(between.rounded());
                    camera.pan(x, y);
                }
                Quantity::Orientation | Quantity::Scale => {}
            }
        }
        camera
    }
}
