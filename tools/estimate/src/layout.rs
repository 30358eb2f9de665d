//! How a program shares out a board's RAM.

use fixel::Scene;
use fixel::palette::Rgb565Table;

use crate::board::Board;
use crate::capacity::Lists;
use crate::model::Firmware;
use crate::parts::Parts;

/// What a program has in RAM.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// How long the renderer's lists are.
    pub lists: Lists,
    /// Rows of a band, at most.
    pub band_rows: u16,
    /// Two of which are on the bus: one is sent while the other is made.
    pub wire: Wire,
}

/// What the panel's bytes are gathered in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wire {
    /// Whole bands, which are sent while the next one is drawn.
    Bands,
    /// Single rows: little is sent while anything is drawn.
    Rows,
}

const fn layout(lists: Lists, band_rows: u16, wire: Wire) -> Layout {
    Layout {
        lists,
        band_rows,
        wire,
    }
}

/// From roomy, and fast, to tight.
const LAYOUTS: [Layout; 7] = [
    Layout::ROOMY,
    layout(Lists::Usual, 8, Wire::Bands),
    layout(Lists::Short, 8, Wire::Bands),
    layout(Lists::Shortest, 8, Wire::Bands),
    layout(Lists::Short, 8, Wire::Rows),
    layout(Lists::Shortest, 8, Wire::Rows),
    layout(Lists::Shortest, 4, Wire::Rows),
];

/// Bytes of RAM, by what they are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ram {
    /// Indices (or colours) and depths of a band.
    pub band: u64,
    /// The panel's bytes, on the bus and before.
    pub bus: u64,
    /// The renderer's working memory and the panel's colours.
    pub scratch: u64,
    /// The stack at its deepest.
    pub stack: u64,
}

impl Ram {
    /// All of it.
    pub fn sum(&self) -> u64 {
        self.band + self.bus + self.scratch + self.stack
    }
}

impl Layout {
    /// The measured firmware's.
    pub const ROOMY: Self = layout(Lists::Usual, 16, Wire::Bands);

    /// The roomiest that a board has the RAM for, of `rows` if they are given; the tightest
    /// if it has it for none.
    pub(crate) fn fitting(
        board: &Board,
        scene: &Scene<'_>,
        firmware: &Firmware,
        rows: Option<u16>,
    ) -> Self {
        let mut layouts = LAYOUTS.map(|layout| Self {
            band_rows: rows.unwrap_or(layout.band_rows),
            ..layout
        });
        let fits = |layout: &Self| layout.ram(board, scene, firmware).sum() <= board.ram_bytes;
        let found = layouts.iter().copied().find(fits);
        layouts.reverse();
        found.unwrap_or(layouts[0])
    }

    /// Bytes of RAM for a scene.
    pub(crate) fn ram(&self, board: &Board, scene: &Scene<'_>, firmware: &Firmware) -> Ram {
        let parts = Parts::of(scene);
        let rows = u64::from(self.rows(scene));
        let own = if scene.is_direct() { 2 } else { 1 };
        let wire_rows = match self.wire {
            _ if board.panel.bits_a_second == 0 => 0,
            Wire::Bands => rows,
            Wire::Rows => 1,
        };
        let bits = u64::from(scene.width()) * wire_rows * u64::from(board.panel.bits_a_pixel);
        Ram {
            band: u64::from(scene.frame_width()) * rows * (own + 2),
            bus: 2 * bits.div_ceil(8),
            scratch: self.lists.bytes(parts) + size_of::<Rgb565Table>() as u64,
            stack: firmware.stack_bytes,
        }
    }

    /// Rows of a band, which is no higher than the frame.
    pub(crate) fn rows(&self, scene: &Scene<'_>) -> u16 {
        self.band_rows.clamp(1, scene.frame_height().max(1))
    }
}
