//! Buttons turn the object.

use fixel::math::Angle;
use fixel::{Pose, Scene};

/// What is pressed while a frame begins. Read once a frame, contacts that bounce for a few
/// milliseconds do no harm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Buttons {
    /// Turns the object to the left, by [`STEP`] a frame.
    pub left: bool,
    /// Turns it to the right.
    pub right: bool,
    /// Stops the scene's own animation; pressed again, lets it go on.
    pub stop: bool,
}

/// How far a button turns the object in a frame: a 64th of a turn.
pub const STEP: Angle = Angle::from_bits(1 << 26);

/// How the object stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Object {
    /// The frame of the scene's animation.
    pub frame: u32,
    /// What the buttons have turned it, about the vertical axis.
    pub turn: Angle,
    stopped: bool,
    stop_pressed: bool,
}

impl Object {
    /// As the scene has it in frame 0.
    pub const fn new() -> Self {
        Self {
            frame: 0,
            turn: Angle::from_bits(0),
            stopped: false,
            stop_pressed: false,
        }
    }

    /// Does what the buttons say, before a frame.
    pub fn press(&mut self, buttons: Buttons) {
        if buttons.left {
            self.turn = self
                .turn
                .plus(Angle::from_bits(STEP.to_bits().wrapping_neg()));
        }
        if buttons.right {
            self.turn = self.turn.plus(STEP);
        }
        if buttons.stop && !self.stop_pressed {
            self.stopped = !self.stopped;
        }
        self.stop_pressed = buttons.stop;
    }

    /// The scene in this frame, for a screen of so many rows.
    pub fn pose(&self, scene: &Scene<'_>, height: u16) -> Pose<'static> {
        let mut pose = scene.pose(self.frame);
        pose.height = height;
        pose.turn = pose.turn.plus(self.turn);
        pose
    }

    /// Goes on to the next frame.
    pub fn advance(&mut self) {
        if !self.stopped {
            self.frame = self.frame.wrapping_add(1);
        }
    }
}

impl Default for Object {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: Buttons = Buttons {
        left: false,
        right: false,
        stop: false,
    };

    #[test]
    fn left_and_right_undo_each_other() {
        let mut object = Object::new();
        let left = Buttons { left: true, ..NONE };
        object.press(left);
        assert_eq!(object.turn.plus(STEP), Angle::from_bits(0));
        for _ in 0..63 {
            object.press(left);
        }
        assert_eq!(object.turn, Angle::from_bits(0), "64 steps are a turn");
        object.press(Buttons {
            right: true,
            ..left
        });
        assert_eq!(object, Object::new());
    }

    #[test]
    fn stop_counts_once_however_long_it_is_held() {
        let stop = Buttons { stop: true, ..NONE };
        let mut object = Object::new();
        let mut frames = [0; 6];
        for (frame, buttons) in frames.iter_mut().zip([NONE, stop, stop, NONE, stop, NONE]) {
            object.press(buttons);
            *frame = object.frame;
            object.advance();
        }
        assert_eq!(frames, [0, 1, 1, 1, 1, 2]);
    }
}
