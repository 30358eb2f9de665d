//! An actor whose places are pixels.

use super::actor_view::row_length;
use super::{
    ActorView, DepthMap, EyeInGrid, FINE_ROW_FRACTION, ModelLights, ROW_FRACTION, ViewFrame,
};
use crate::math::{MAX_SCREEN, Rotation, SUBPX_BITS};
use crate::scene::{Actor, Scene};

/// Fractional bits of a clip coordinate: 1/8 sub-pixel, so that 4096 pixels off the
/// screen still have 28 bits.
const CLIP_BITS: u32 = SUBPX_BITS + 3;

impl ActorView {
    /// Becomes that of an actor whose world units are pixels from the screen's top left corner: as
    /// a parallel view has it, at the greatest depth.
    #[inline(never)]
    pub fn set_on_screen(&mut self, frame: &ViewFrame, scene: &Scene<'_>, actor: &Actor) {
        let mesh = scene.mesh(actor.mesh);
        let material = scene.material(actor.material);
        let row_fraction = if mesh.fine.is_some() {
            FINE_ROW_FRACTION
        } else {
            ROW_FRACTION
        };
        let middle = [frame.width, frame.height].map(|s| i32::from(s) << (SUBPX_BITS - 1));
        // A grid step in clip units.
        let up = actor.step_exponent - 31 + (CLIP_BITS + row_fraction) as i32;
        let step = i64::from(actor.step_mantissa);
        let step = if up >= 0 {
            step << up.min(31)
        } else {
            step >> up.wrapping_neg().min(63)
        };
        let step = step.min(i32::MAX.into()) as i32;
        let [x, y, _] = actor.offset.map(i64::from); // 16 fractional bits
        let [half_width, half_height] = middle.map(i64::from);
        let constant = |offset: i64, half: i64| {
            ((offset << row_fraction) >> (16 - CLIP_BITS))
                - (half << (CLIP_BITS - SUBPX_BITS + row_fraction))
        };
        let rows = [[step, 0, 0], [0, step, 0], [0; 3]];
        let row_lengths = rows.map(row_length);
        let [length_x, length_y, _] = row_lengths;
        let shift = CLIP_BITS - SUBPX_BITS;
        *self = Self {
            row_fraction,
            rows,
            constants: [constant(x, half_width), constant(y, half_height), 0],
            row_lengths,
            side_lengths: [length_x, length_y],
            parallel_shift: shift as i32,
            depth: DepthMap::NEAREST,
            eye: EyeInGrid::Direction([0, 0, -(1 << 30)]),
            lights: ModelLights::new(scene, &material, &Rotation::IDENTITY),
            material,
            mesh,
            middle,
            lens: frame.lens,
            parallel_guard: MAX_SCREEN << shift,
            ..Self::ZERO
        };
    }
}
