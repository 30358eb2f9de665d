//! A test of a node's four boxes: whether one of the sheared space's axes separates them
//! from a ray, or from all rays of a window.

/// Bits of a slope, and fractional bits of a place in a node's units.
pub(super) const SLOPE_BITS: u32 = 15;

/// A byte of each of a node's boxes.
pub(super) type Sides<'a> = &'a [u8; 4];

/// What the four boxes of a node are tested with.
pub(super) struct BoxTest<'a> {
    /// The lower sides along an axis, and the upper ones.
    pub x: [Sides<'a>; 2],
    pub y: [Sides<'a>; 2],
    pub z: [Sides<'a>; 2],
    /// Where the ray is, twice.
    pub twice: [i32; 2],
    pub slopes: [i32; 2],
    /// The slopes without signs.
    pub steep: [i32; 2],
    /// Twice what is added to a box.
    pub margins: [i32; 2],
    /// On the third axis, in units of the node.
    pub range: (i32, i32),
}

impl BoxTest<'_> {
    /// If the ray meets a box, given by its number: its sides on the third axis. Along each of the
    /// others, the ray is nearer to the box's middle than half of its shadow. Bytes are read
    /// where they are: there are more than a core has registers.
    #[inline(always)]
    pub(super) fn meets(&self, child: usize) -> Option<(i32, i32)> {
        let byte = |sides: Sides<'_>| i32::from(sides.get(child).copied().unwrap_or(0));
        let [near, far] = self.z.map(byte);
        let (from, to) = self.range;
        if near > to || far < from {
            return None;
        }
        let (middle, deep) = (near + far, far - near);
        let missed = |sides: [Sides<'_>; 2], twice: i32, slope: i32, steep: i32, margin: i32| {
            let [low, high] = sides.map(byte);
            let off = twice + ((low + high) << SLOPE_BITS) - slope * middle;
            let reach = margin + ((high - low) << SLOPE_BITS) + steep * deep;
            off.wrapping_add(reach) as u32 > (reach as u32).wrapping_mul(2)
        };
        let ([x, y], [sx, sy]) = (self.twice, self.slopes);
        let ([steep_x, steep_y], [margin_x, margin_y]) = (self.steep, self.margins);
        if missed(self.x, x, sx, steep_x, margin_x) || missed(self.y, y, sy, steep_y, margin_y) {
            return None;
        }
        Some((near, far))
    }
}
