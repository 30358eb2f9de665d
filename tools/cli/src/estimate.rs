//! `fixel estimate`.

use crate::input::Input;
use crate::{args, input, output};
use anyhow::{Context, Result, bail};
use fixel_estimate::{Board, Estimate, Model, Wire};
use fixel_scene::Screen;
use serde_json::{Value, json};
use std::path::Path;

/// Says what a scene takes on a board.
pub fn run(args: &args::Estimate) -> Result<()> {
    let json = args.json.as_ref().and_then(args::Destination::file);
    let (input, board) = on_board(args, &[json])?;
    let board = &board;
    let by_rays = input.refused(
        "is baked for rays, whose instructions are not estimated; expected one for triangles",
    );
    let baked = input.bake()?;
    let scene = baked.scene()?;
    if scene.has_rays() {
        return Err(by_rays.into());
    }
    let model = Model::fitted().context("the coefficients that are built in")?;
    let bytes = baked.bytes().len() as u64;
    let band_rows = args.bands.map(|rows| rows.min(2048) as u16);
    let pose = scene.pose(args.frame);
    let asked = (&pose, band_rows);
    let Some(estimate) = Estimate::fitting(&model, board, &scene, asked, bytes) else {
        bail!("nothing was counted for {}", board.name);
    };
    let size = (scene.width(), scene.height());
    if let Some(destination) = &args.json {
        return output::json(destination, &figures(board, &estimate, size));
    }
    output::stdout(&text(board, &estimate, size))
}

/// The scene as it shows on the board, on the panel asked for or else on the board's own.
fn on_board(args: &args::Estimate, outputs: &[Option<&Path>]) -> Result<(Input, Board)> {
    let board = *args.board;
    if let Some(screen) = args.screen.get() {
        let input = input::load_on(&args.input, Some(screen), outputs)?;
        return Ok((input, board.showing(&screen.panel)));
    }
    let own = input::read(&args.input, None, outputs)?;
    let display = &own.scene.display;
    let input = match board.instead_of((display.width, display.height), display.colour) {
        Some(&panel) => {
            let dithering = None;
            let screen = Screen { panel, dithering };
            input::read(&args.input, Some(screen), outputs)?
        }
        None => own,
    };
    Ok((input::tell(input), board))
}

/// Rows that are sent at once.
fn bus_rows(e: &Estimate) -> u16 {
    match e.layout.wire {
        Wire::Bands => e.layout.band_rows,
        Wire::Rows => 1,
    }
}

fn figures(board: &Board, e: &Estimate, (width, height): (u16, u16)) -> Value {
    let [meshlets, slots, actors] = e.layout.lists.lengths();
    json!({
        "board": board.name,
        "width": width,
        "height": height,
        "flash_bytes": e.flash_bytes(),
        "code_bytes": e.code_bytes,
        "scene_bytes": e.scene_bytes,
        "ram_bytes": e.ram_bytes(),
        "band_rows": e.layout.band_rows,
        "band_bytes": e.ram.band,
        "bus_rows": bus_rows(e),
        "bus_bytes": e.ram.bus,
        "meshlets": meshlets,
        "slots": slots,
        "actors": actors,
        "scratch_bytes": e.ram.scratch,
        "stack_bytes": e.ram.stack,
        "fits": e.fits(board),
        "instructions": e.instructions.round() as u64,
        "cycles_an_instruction": board.cycles.each,
        "drawing_ms": e.drawing_s * 1e3,
        "sending_ms": e.sending_s * 1e3,
        "frames_a_second": e.frames_a_second,
    })
}

fn text(board: &Board, e: &Estimate, size: (u16, u16)) -> String {
    let of = |taken: u64, there: u64| {
        let fits = if taken > there { ", too many" } else { "" };
        format!("{taken} bytes of {there}{fits}")
    };
    // The measured firmware is built for speed.
    let smaller = if e.flash_bytes() > board.flash_bytes {
        "; opt-level = 2 makes code smaller"
    } else {
        ""
    };
    let panel = &board.panel;
    let bus = if panel.bits_a_second > 0 {
        format!(
            "{:.1} ms ({} bits a pixel, {:.1} Mbit/s)",
            e.sending_s * 1e3,
            panel.bits_a_pixel,
            f64::from(panel.bits_a_second) / 1e6
        )
    } else {
        "nothing to send".into()
    };
    let [meshlets, slots, actors] = e.layout.lists.lengths();
    let refresh = match panel.refresh_ms {
        0 => String::new(),
        ms => format!(", {ms} ms of the panel's own included"),
    };
    format!(
        "board: {}, {}\n\
         picture: {}x{} on {}\n\
         flash: {}: code {} ({}), scene {}{smaller}\n\
         RAM: {}: band of {} rows {}, on the bus two of {} {}, \
         Scratch<{meshlets}, {slots}, {actors}> and colours {}, stack {}\n\
         instructions a frame: {:.2} million\n\
         drawing: {:.1} ms at {:.1} MHz and {} cycles an instruction ({})\n\
         sending: {bus}\n\
         frames a second: {:.1}{refresh}\n",
        board.name,
        board.what,
        size.0,
        size.1,
        panel.name,
        of(e.flash_bytes(), board.flash_bytes),
        e.code_bytes,
        e.parts.what(),
        e.scene_bytes,
        of(e.ram_bytes(), board.ram_bytes),
        e.layout.band_rows,
        e.ram.band,
        bus_rows(e),
        e.ram.bus,
        e.ram.scratch,
        e.ram.stack,
        e.instructions / 1e6,
        e.drawing_s * 1e3,
        f64::from(board.clock_hz) / 1e6,
        board.cycles.each,
        board.cycles.source,
        e.frames_a_second,
    )
}
