//! `fixel estimate`.

use crate::{args, input, output};
use anyhow::{Context, Result, bail};
use fixel_estimate::{Board, Estimate, Model};
use serde_json::{Value, json};

/// Says what a scene takes on a board.
pub fn run(args: &args::Estimate) -> Result<()> {
    let board = args.board;
    let json = args.json.as_ref().and_then(args::Destination::file);
    let input = input::load_on(&args.input, args.screen.get(), &[json])?;
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
    let band_rows = u16::try_from(args.bands.min(2048))?;
    let pose = scene.pose(args.frame);
    let asked = (&pose, band_rows);
    let Some(estimate) = Estimate::new(&model, board, &scene, asked, bytes) else {
        bail!("nothing was counted for {}", board.name);
    };
    if let Some(destination) = &args.json {
        return output::json(destination, &figures(board, &estimate));
    }
    output::stdout(&text(board, &estimate, (scene.width(), scene.height())))
}

fn figures(board: &Board, e: &Estimate) -> Value {
    json!({
        "board": board.name,
        "flash_bytes": e.flash_bytes(),
        "code_bytes": e.code_bytes,
        "scene_bytes": e.scene_bytes,
        "ram_bytes": e.ram_bytes(),
        "band_rows": e.band_rows,
        "band_bytes": e.band_bytes,
        "bus_bytes": e.bus_bytes,
        "scratch_bytes": e.scratch_bytes,
        "stack_bytes": e.stack_bytes,
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
    let refresh = match panel.refresh_ms {
        0 => String::new(),
        ms => format!(", {ms} ms of the panel's own included"),
    };
    format!(
        "board: {}, {}\n\
         picture: {}x{}\n\
         flash: {}: code {} ({}), scene {}\n\
         RAM: {}: band of {} rows {}, on the bus {}, working memory {}, stack {}\n\
         instructions a frame: {:.2} million\n\
         drawing: {:.1} ms at {:.1} MHz and {} cycles an instruction ({})\n\
         sending: {bus}\n\
         frames a second: {:.1}{refresh}\n",
        board.name,
        board.what,
        size.0,
        size.1,
        of(e.flash_bytes(), board.flash_bytes),
        e.code_bytes,
        e.parts.what(),
        e.scene_bytes,
        of(e.ram_bytes(), board.ram_bytes),
        e.band_rows,
        e.band_bytes,
        e.bus_bytes,
        e.scratch_bytes,
        e.stack_bytes,
        e.instructions / 1e6,
        e.drawing_s * 1e3,
        f64::from(board.clock_hz) / 1e6,
        board.cycles.each,
        board.cycles.source,
        e.frames_a_second,
    )
}
