//! What frames took.

/// What one frame took, in clock cycles of the board (or what else it counts).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// From the first band to the last one's start.
    pub whole: u32,
    /// Of these, doing nothing but wait for the bus.
    pub waiting: u32,
}

impl Cost {
    /// What drawing took, panel colours included.
    pub const fn drawing(self) -> u32 {
        self.whole.saturating_sub(self.waiting)
    }
}

/// What all frames so far took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// How many there were.
    pub frames: u32,
    /// The last one.
    pub last: Cost,
    /// Cycles of drawing of the one that took the most.
    pub most: u32,
}

impl Statistics {
    /// None so far.
    pub const fn new() -> Self {
        Self {
            frames: 0,
            last: Cost {
                whole: 0,
                waiting: 0,
            },
            most: 0,
        }
    }

    /// One more frame.
    pub fn add(&mut self, cost: Cost) {
        self.frames = self.frames.wrapping_add(1);
        self.last = cost;
        self.most = self.most.max(cost.drawing());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slowest_frame_is_kept() {
        let mut all = Statistics::new();
        for (whole, waiting) in [(10, 4), (20, 1), (30, 25)] {
            all.add(Cost { whole, waiting });
        }
        assert_eq!((all.frames, all.most, all.last.drawing()), (3, 19, 5));
    }
}
