//! A test of a node's four boxes: whether one of the sheared space's axes separates them
//! from a ray, or from all rays of a window.

/// Bits of a slope, and fractional bits of a place in a node's units.
pub(super) const SLOPE_BITS: u32 = 15;

/// What the four boxes of a node are tested with: words of a byte a box.
pub(super) struct BoxTest {
    /// The lower sides, the third axis' sides that go with them, and the upper ones.
    pub x: [u32; 4],
    pub y: [u32; 4],
    pub z: [u32; 2],
    /// Where the ray is.
    pub at: [i32; 2],
    pub slopes: [i32; 2],
    pub margins: [i32; 2],
    /// On the third axis, in units of the node.
    pub range: (i32, i32),
    /// The boxes are too small to tell.
    pub small: bool,
}

impl BoxTest {
    /// If the ray meets a box, given by its place in the words: its sides on the third
    /// axis.
    #[inline(always)]
    pub(super) fn meets(&self, shift: u32) -> Option<(i32, i32)> {
        let byte = |all: u32| (all >> shift & 255) as i32;
        let [low, high] = self.z.map(byte);
        if self.small {
            return Some((low, high));
        }
        let (from, to) = self.range;
        if low > to || high < from {
            return None;
        }
        let ([x, y], [sx, sy]) = (self.at, self.slopes);
        let [margin_x, margin_y] = self.margins;
        let [low_side, first, high_side, second] = self.x;
        if (byte(low_side) << SLOPE_BITS) + x - sx * byte(first) > margin_x
            || (byte(high_side) << SLOPE_BITS) + x - sx * byte(second) < -margin_x
        {
            return None;
        }
        let [low_side, first, high_side, second] = self.y;
        if (byte(low_side) << SLOPE_BITS) + y - sy * byte(first) > margin_y
            || (byte(high_side) << SLOPE_BITS) + y - sy * byte(second) < -margin_y
        {
            return None;
        }
        Some((low, high))
    }
}
