//! The panel in mode 4 (GBATEK, "LCD VRAM Bitmap BG Modes"): two pages of 240 by 160
//! bytes, each an index into a palette of 256 colours. One is shown while the other is
//! drawn.

use core::convert::Infallible;
use core::ptr;

use fixel::Display;
use fixel::frame::BandRows;
use fixel::palette::{Palette, bgr555};

/// The panel's columns and rows.
pub const SIZE: (u16, u16) = (240, 160);

const CONTROL: *mut u16 = 0x0400_0000 as *mut u16;
/// Mode 4, which is a picture on background 2.
const MODE_4: u16 = 4 | 1 << 10;
/// Shows the second page.
const SECOND: u16 = 1 << 4;
/// The row that is on its way to the panel; from 160 on, none is.
const ROW: *const u16 = 0x0400_0006 as *const u16;
const PALETTE: *mut u16 = 0x0500_0000 as *mut u16;
/// The pages.
const PAGES: [*mut u32; 2] = [0x0600_0000 as *mut u32, 0x0600_A000 as *mut u32];
/// Source, destination and control of the third DMA channel.
const DMA_SOURCE: *mut *const u32 = 0x0400_00D4 as *mut *const u32;
const DMA_DESTINATION: *mut *mut u32 = 0x0400_00D8 as *mut *mut u32;
const DMA_CONTROL: *mut u32 = 0x0400_00DC as *mut u32;
/// At once, by words, both addresses going up.
const DMA_GO: u32 = 1 << 31 | 1 << 26;

/// Both pages, one of them shown.
#[derive(Debug)]
pub struct Mode4 {
    /// The page that is drawn.
    page: usize,
    colours: [u16; 256],
}

impl Mode4 {
    /// A panel that shows an empty page.
    pub const fn new() -> Self {
        Self {
            page: 0,
            colours: [0; 256],
        }
    }

    /// Shows the page that was drawn, with its colours, between two rows of the panel's
    /// own frames, when none is on its way.
    pub fn flip(&mut self) {
        // SAFETY: registers and memory of this machine, aligned; this thread alone uses
        // them. The palette has 256 entries.
        unsafe {
            while ptr::read_volatile(ROW) >= SIZE.1 {}
            while ptr::read_volatile(ROW) < SIZE.1 {}
            for (place, colour) in self.colours.iter().enumerate() {
                ptr::write_volatile(PALETTE.add(place), *colour);
            }
            let second = if self.page == 0 { 0 } else { SECOND };
            ptr::write_volatile(CONTROL, MODE_4 | second);
        }
        self.page ^= 1;
    }
}

impl Default for Mode4 {
    fn default() -> Self {
        Self::new()
    }
}

impl Display for Mode4 {
    type Error = Infallible;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), Infallible> {
        for (place, colour) in self.colours.iter_mut().zip(palette.entries()) {
            *place = bgr555(colour);
        }
        Ok(())
    }

    /// Copies whole words: video memory does not take bytes. Rows beyond the panel's,
    /// and rows of another width than its, are left out.
    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        let width = usize::from(SIZE.0);
        let count = rows.rows().min(SIZE.1.saturating_sub(rows.top));
        let indices = rows.indices.get(..usize::from(count) * width);
        let words = bytemuck::try_cast_slice::<u8, u32>(indices.unwrap_or_default());
        let (Ok(words), true, Some(page)) = (words, rows.width == SIZE.0, PAGES.get(self.page))
        else {
            return Ok(());
        };
        if words.is_empty() {
            return Ok(());
        }
        // SAFETY: a page has a word for each four pixels of the panel, and these rows
        // are within it. The channel reads what `words` borrows, and has finished when
        // the write that starts it has: the processor stands still meanwhile.
        unsafe {
            let to = page.add(usize::from(rows.top) * width / 4);
            ptr::write_volatile(DMA_SOURCE, words.as_ptr());
            ptr::write_volatile(DMA_DESTINATION, to);
            ptr::write_volatile(DMA_CONTROL, DMA_GO | words.len() as u32);
        }
        Ok(())
    }
}
