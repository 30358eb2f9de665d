//! A scene on a board: memory, and time.

use fixel::Scene;
use fixel::scene::Pose;

use crate::board::Board;
use crate::frame::work_with;
use crate::layout::{Layout, Ram, Wire};
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
    /// How RAM is shared out.
    pub layout: Layout,
    /// Into what.
    pub ram: Ram,
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
    /// Of one frame, as `pose` has it, by the roomiest program that the board has the RAM
    /// for, in bands of `band_rows` rows if that is given. `None` if nothing was counted for
    /// the board.
    pub fn fitting(
        model: &Model,
        board: &Board,
        scene: &Scene<'_>,
        (pose, band_rows): (&Pose<'_>, Option<u16>),
        scene_bytes: u64,
    ) -> Option<Self> {
        let firmware = model.firmware.get(board.target)?.get(&Parts::of(scene))?;
        let layout = Layout::fitting(board, scene, firmware, band_rows);
        Self::new(model, board, scene, (pose, layout), scene_bytes)
    }

    /// The same by a program that shares out its RAM so, whether or not the board has it.
    pub fn new(
        model: &Model,
        board: &Board,
        scene: &Scene<'_>,
        (pose, layout): (&Pose<'_>, Layout),
        scene_bytes: u64,
    ) -> Option<Self> {
        let parts = Parts::of(scene);
        let firmware = model.firmware.get(board.target)?.get(&parts)?;
        let layout = Layout {
            band_rows: layout.rows(scene),
            ..layout
        };
        let work = work_with(layout.lists, scene, pose, layout.band_rows);
        let instructions = model.instructions(board.target, &work)?;
        let bits = f64::from(board.panel.bits_a_pixel);
        let drawing_s = instructions * board.cycles.each / f64::from(board.clock_hz);
        let all_px = f64::from(scene.width()) * f64::from(scene.height());
        let sending_s = match board.panel.bits_a_second {
            0 => 0.0,
            speed => all_px * bits / f64::from(speed),
        };
        let bands = f64::from(scene.frame_height().div_ceil(layout.band_rows));
        // The first band is drawn while nothing is sent, the last one sent while nothing is
        // drawn, or the other way round.
        let both = match layout.wire {
            Wire::Bands => drawing_s.max(sending_s) + drawing_s.min(sending_s) / bands,
            Wire::Rows => drawing_s + sending_s,
        };
        let seconds = both + f64::from(board.panel.refresh_ms) / 1e3;
        Some(Self {
            parts,
            code_bytes: firmware.code_bytes,
            scene_bytes,
            layout,
            ram: layout.ram(board, scene, firmware),
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
        self.ram.sum()
    }
}
