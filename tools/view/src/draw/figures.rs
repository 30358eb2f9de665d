//! What there is to say of a picture in numbers, a line each.

use std::time::Duration;

use fixel_estimate::{Estimate, Model};
use fixel_host::{Options, Planes};

use crate::variant::Job;

/// Of a frame by triangles.
pub(super) fn raster(
    core: &fixel::Scene<'_>,
    planes: &Planes,
    bytes: usize,
    taken: Duration,
) -> Vec<String> {
    let s = planes.stats;
    let covered = planes.depth.iter().filter(|depth| **depth != 0).count();
    vec![
        format!(
            "{} triangles, {} drawn; {covered} px covered; {} vertices transformed",
            core.triangle_count(),
            s.triangles_drawn,
            s.vertices,
        ),
        format!(
            "{} meshlets, {} drawn ({} outside, {} turned away); {} colours, {bytes} bytes of flash",
            core.meshlet_count(),
            s.meshlets_transformed,
            s.meshlets_outside,
            s.meshlets_away,
            core.palette().len(),
        ),
        drawn_here(taken),
    ]
}

/// What the frame takes on the chosen board.
pub(super) fn estimate(
    job: &Job,
    core: &fixel::Scene<'_>,
    options: &Options,
    bytes: usize,
) -> Option<String> {
    let model = Model::fitted().ok()?;
    let pose = options.pose(core);
    let asked = (&pose, None);
    let board = job.board();
    let e = Estimate::fitting(&model, &board, core, asked, bytes as u64)?;
    Some(format!(
        "{}: about {:.2} M instructions, {:.1} frames/s, {} KB of RAM{}",
        board.name,
        e.instructions / 1e6,
        e.frames_a_second,
        e.ram_bytes().div_ceil(1024),
        if e.fits(&board) { "" } else { ": does not fit" },
    ))
}

/// How long it took.
pub(super) fn drawn_here(taken: Duration) -> String {
    format!("{:.1} ms on this computer", taken.as_secs_f64() * 1e3)
}

/// How often pixels were drawn.
pub(super) fn overdraw(counts: &[u8]) -> String {
    let drawn = counts.iter().filter(|count| **count > 0).count();
    let sum: u64 = counts.iter().map(|count| u64::from(*count)).sum();
    let most = counts.iter().max().copied().unwrap_or(0);
    let mean = sum as f64 / drawn.max(1) as f64;
    format!("drawn {mean:.2} times in the mean, {most} times at most (blue 1, white 8 and more)")
}
