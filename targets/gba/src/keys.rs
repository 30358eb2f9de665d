//! The keys.

use core::ptr;

use fixel_demo::Buttons;

/// A bit a key, 0 if it is pressed (GBATEK, "GBA Keypad Input").
const INPUT: *const u16 = 0x0400_0130 as *const u16;
const A: u16 = 1 << 0;
const RIGHT: u16 = 1 << 4;
const LEFT: u16 = 1 << 5;

/// What is pressed now: left and right of the cross turn the object, A stops and starts
/// the scene's own animation.
pub fn pressed() -> Buttons {
    // SAFETY: reading has no side effect.
    let keys = !unsafe { ptr::read_volatile(INPUT) };
    Buttons {
        left: keys & LEFT != 0,
        right: keys & RIGHT != 0,
        stop: keys & A != 0,
    }
}
