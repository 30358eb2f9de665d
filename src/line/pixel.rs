//! One pixel.

use super::DepthRule;
use crate::frame::Target;
use crate::math::Depth;

impl DepthRule {
    /// The depth with the bias, from one with `fraction` fractional bits, rounded
    /// to nearest.
    #[inline(always)]
    pub(super) fn depth(&self, z: i32, fraction: u32) -> Depth {
        let depth = (z + (1 << (fraction - 1))) >> fraction;
        (depth + i32::from(self.bias)).clamp(1, 65535) as Depth
    }

    /// Writes a pixel if it is in the target and nothing nearer stands there.
    #[inline(always)]
    pub(super) fn put<C>(
        &self,
        target: &mut Target<'_, C>,
        [x, y]: [i32; 2],
        here: Depth,
        index: impl FnOnce() -> Option<C>,
    ) {
        let row = y - i32::from(target.top);
        let columns = i32::from(target.width);
        if x < 0 || x >= columns || row < 0 || y >= i32::from(target.end) {
            return;
        }
        let at = (row * i32::from(target.stride) + x) as usize;
        if let (Some(depth), Some(pixel)) = (target.depths.get_mut(at), target.indices.get_mut(at))
            && (!self.test || here > *depth)
        {
            *depth = here;
            if let Some(index) = index() {
                *pixel = index;
            }
        }
    }
}
