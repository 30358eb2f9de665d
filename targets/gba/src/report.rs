//! What a program says to whoever runs it in an emulator: a block at the start of
//! EWRAM, which a front end reads between two pictures of the panel.

use core::ptr;

/// Bytes of text.
const TEXT: usize = 8192 - 16;

/// The block. `targets/libretro` has the same.
#[repr(C)]
struct Report {
    magic: [u8; 4],
    /// 0 while the program runs, 1 when it has ended well, 2 when it has not.
    state: u32,
    /// How many pictures were shown.
    pictures: u32,
    /// Bytes of text so far.
    length: u32,
    text: [u8; TEXT],
}

#[unsafe(link_section = ".report")]
static mut REPORT: Report = Report {
    magic: [0; 4],
    state: 0,
    pictures: 0,
    length: 0,
    text: [0; TEXT],
};

const MAGIC: [u8; 4] = *b"FXLR";

/// Says that there is a report.
pub fn begin() {
    // SAFETY: the block has one writer, this thread, and its readers only look.
    unsafe { ptr::write_volatile(&raw mut REPORT.magic, MAGIC) }
}

/// Adds text; what does not fit is lost.
pub fn print(text: &[u8]) {
    for &byte in text {
        // SAFETY: as in `begin`; the place is within the text.
        unsafe {
            let length = ptr::read_volatile(&raw const REPORT.length);
            if (length as usize) < TEXT {
                let place = (&raw mut REPORT.text).cast::<u8>().add(length as usize);
                ptr::write_volatile(place, byte);
                ptr::write_volatile(&raw mut REPORT.length, length + 1);
            }
        }
    }
}

/// One more picture is on the panel; the text is this line about it from now on.
pub fn shown(line: &[u8]) {
    // SAFETY: as in `begin`.
    unsafe { ptr::write_volatile(&raw mut REPORT.length, 0) }
    print(line);
    // SAFETY: as in `begin`.
    unsafe {
        let pictures = ptr::read_volatile(&raw const REPORT.pictures);
        ptr::write_volatile(&raw mut REPORT.pictures, pictures.wrapping_add(1));
    }
}

/// Ends the program: nothing follows but waiting.
pub fn end(success: bool) -> ! {
    begin();
    // SAFETY: as in `begin`.
    unsafe { ptr::write_volatile(&raw mut REPORT.state, if success { 1 } else { 2 }) }
    loop {
        core::hint::spin_loop();
    }
}

/// Says why nothing more can be done, and ends.
pub fn fail(message: &str) -> ! {
    print(message.as_bytes());
    print(b"\n");
    end(false)
}
