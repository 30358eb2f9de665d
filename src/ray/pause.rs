//! How long what failed is not tried again.

/// Most times that something is left out before it is tried again.
const MOST: u8 = 32;

/// What pays only where a mesh is coarser than pixels: after a failure it is left out once,
/// after each further one twice as often, after a success half as often. All zero: not yet
/// tried.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pause {
    left: u8,
    /// After the next failure.
    next: u8,
}

impl Pause {
    pub(super) const NONE: Self = Self { left: 0, next: 0 };

    /// Whether it may be tried.
    pub(super) fn is_over(self) -> bool {
        self.left == 0
    }

    /// One chance passes.
    pub(super) fn pass(&mut self) {
        self.left = self.left.saturating_sub(1);
    }

    /// It was tried.
    pub(super) fn tried(&mut self, succeeded: bool) {
        if succeeded {
            self.next /= 2;
        } else {
            self.left = self.next.max(1);
            self.next = (2 * self.left).min(MOST);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Pause;

    #[test]
    fn pauses_grow_and_shrink() {
        let mut pause = Pause::NONE;
        let mut wait = |succeeded| {
            pause.tried(succeeded);
            let mut chances = 0;
            while !pause.is_over() {
                pause.pass();
                chances += 1;
            }
            chances
        };
        let all = [false, false, false, true, false].map(&mut wait);
        assert_eq!(all, [1, 2, 4, 0, 4]);
        let last = [false; 8].map(wait);
        assert_eq!(last[7], 32);
    }
}
