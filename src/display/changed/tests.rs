use super::*;
use core::num::NonZeroU32;
use std::vec::Vec;

/// Four pages of 30 bytes, and how many bytes were sent.
struct Panel {
    pages: [[u8; 30]; 4],
    sent: Vec<(u16, u16, usize)>,
    /// Transfers until the bus breaks.
    left: u32,
}

impl PartialRows for Panel {
    type Error = ();

    fn part(&mut self, y: u16, first: u16, bytes: &[u8]) -> Result<(), ()> {
        self.left = self.left.checked_sub(1).ok_or(())?;
        self.sent.push((y, first, bytes.len()));
        let first = usize::from(first);
        self.pages[usize::from(y / 8)][first..first + bytes.len()].copy_from_slice(bytes);
        Ok(())
    }
}

fn panel() -> Panel {
    Panel {
        pages: [[0; 30]; 4],
        sent: Vec::new(),
        left: u32::MAX,
    }
}

fn show(display: &mut Changed<'_, Panel>, frame: &[[u8; 30]; 4]) -> Result<(), ()> {
    (0..)
        .zip(frame)
        .try_for_each(|(page, bytes)| display.rows(8 * page, bytes))
}

#[test]
fn what_changed_is_sent_and_the_picture_is_whole() {
    assert_eq!(Changed::<Panel>::sums(30, 8, 8, 32), 16);
    let mut sums = [NonZeroU32::new(7); 16];
    let mut display = Changed::new(panel(), 30, 8, 8, &mut sums);
    let mut frame = [[0; 30]; 4];
    show(&mut display, &frame).unwrap();
    // The first frame is sent whole, even where it is black.
    let whole = [(0, 0, 30), (8, 0, 30), (16, 0, 30), (24, 0, 30)];
    assert_eq!(display.panel().sent, whole);
    display.panel().sent.clear();
    show(&mut display, &frame).unwrap();
    assert_eq!(display.panel().sent, []);
    // Two tiles side by side, one apart, and the short one at the end of a page.
    (frame[1][7], frame[1][8], frame[2][0], frame[2][29]) = (1, 2, 3, 4);
    show(&mut display, &frame).unwrap();
    assert_eq!(display.panel().sent, [(8, 0, 16), (16, 0, 8), (16, 24, 6)]);
    assert_eq!(display.panel().pages, frame);
    let mut seed = 1u32;
    for _ in 0..200 {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let [at, page, value, _] = seed.to_be_bytes();
        frame[usize::from(page % 4)][usize::from(at % 30)] = value;
        show(&mut display, &frame).unwrap();
        assert_eq!(display.panel().pages, frame);
    }
    display.forget();
    display.panel().sent.clear();
    show(&mut display, &frame).unwrap();
    assert_eq!(display.panel().sent, whole);
}

#[test]
fn after_a_broken_transfer_the_next_frame_is_right() {
    for good in 0..4 {
        let mut sums = [None; 16];
        let mut display = Changed::new(panel(), 30, 8, 8, &mut sums);
        let frame = [[0x5a; 30]; 4];
        display.panel().left = good;
        assert_eq!(show(&mut display, &frame), Err(()));
        display.panel().left = u32::MAX;
        show(&mut display, &frame).unwrap();
        assert_eq!(display.panel().pages, frame);
    }
}
