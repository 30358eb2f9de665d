//! A scene on a board: memory, and time.

use fixel::Scene;
use fixel::palette::Rgb565Table;
use fixel::render::Scratch;
use fixel::scene::Pose;

use crate::board::Board;
use crate::capacity::{ACTORS, MESHLETS, SLOTS};
use crate::frame::work;
use crate::model::Model;
use crate::parts::Parts;

/// What a scene takes on a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// What of the renderer it needs.
    pub parts: Parts,
    /// Code and tables, in bytes.
    pub code_bytes: u64,
    /// The scene, in bytes of flash.
    pub scene_bytes: u64,
    /// Rows of a band.
    pub band_rows: u16,
    /// Indices (or colours) and depths of a band.
    pub band_bytes: u64,
    /// Two bands as the panel takes them, of which one is sent while the other is made.
    pub bus_bytes: u64,
    /// The renderer's working memory and the panel's colours.
    pub scratch_bytes: u64,
    /// The stack at its deepest.
    pub stack_bytes: u64,
    /// Instructions of a frame, up to RGB565.
    pub instructions: f64,
    /// Seconds that they take.
    pub drawing_s: f64,
    /// Seconds that a frame takes on the bus.
    pub sending_s: f64,
    /// Frames a second.
    pub frames_a_second: f64,
}

impl Estimate {
    /// Of one frame, as `pose` has it, in bands of at most `band_rows` rows. `None` if nothing
    /// was counted for the board.
    pub fn new(
        model: &Model,
        board: &Board,
        scene: &Scene<'_>,
        (pose, band_rows): (&Pose<'_>, u16),
        scene_bytes: u64,
    ) -> Option<Self> {
        let parts = Parts::of(scene);
        let firmware = model.firmware.get(board.target)?.get(&parts)?;
        let instructions = model.instructions(board.target, &work(scene, pose, band_rows))?;
        let (columns, rows) = (scene.frame_width(), scene.frame_height());
        let band_rows = band_rows.clamp(1, rows.max(1));
        let band_px = u64::from(columns) * u64::from(band_rows);
        let own = if scene.is_direct() { 2 } else { 1 };
        let shown_px = u64::from(scene.width()) * u64::from(band_rows);
        let bits = u64::from(board.panel.bits_a_pixel);
        let on_bus = board.panel.bits_a_second > 0;
        let drawing_s = instructions * board.cycles.each / f64::from(board.clock_hz);
        let all_px = f64::from(scene.width()) * f64::from(scene.height());
        let sending_s = if on_bus {
            all_px * bits as f64 / f64::from(board.panel.bits_a_second)
        } else {
            0.0
        };
        let bands = f64::from(rows.div_ceil(band_rows));
        // The first band is drawn while nothing is sent, the last one sent while nothing is
        // drawn, or the other way round.
        let both = drawing_s.max(sending_s) + drawing_s.min(sending_s) / bands;
        let seconds = both + f64::from(board.panel.refresh_ms) / 1e3;
        Some(Self {
            parts,
            code_bytes: firmware.code_bytes,
            scene_bytes,
            band_rows,
            band_bytes: band_px * (own + 2),
            bus_bytes: if on_bus {
                2 * (shown_px * bits).div_ceil(8)
            } else {
                0
            },
            scratch_bytes: (size_of::<Scratch<MESHLETS, SLOTS, ACTORS>>()
                + size_of::<Rgb565Table>()) as u64,
            stack_bytes: firmware.stack_bytes,
            instructions,
            drawing_s,
            sending_s,
            frames_a_second: 1.0 / seconds,
        })
    }

    /// Whether flash and RAM of a board hold it.
    pub fn fits(&self, board: &Board) -> bool {
        self.flash_bytes() <= board.flash_bytes && self.ram_bytes() <= board.ram_bytes
    }

    /// Bytes of flash.
    pub fn flash_bytes(&self) -> u64 {
        self.code_bytes + self.scene_bytes
    }

    /// Bytes of RAM.
    pub fn ram_bytes(&self) -> u64 {
        self.band_bytes + self.bus_bytes + self.scratch_bytes + self.stack_bytes
    }
}
