//! The bench's scenes through fixel and three other renderers, in one process: the same
//! frames, each up to RGB565 bytes of the whole picture, and the wall time that they take.
//!
//! `fixel-hostbench SCENE.toml... [--pictures DIR]` prints a JSON object,
//! `{"scene": {"renderer": {"wall_us": x, "covered_px": n}}}`; what each drew in frame 4
//! goes to a folder, to see that all draw the same.

mod model;
mod on_embedded;
mod on_euc;
mod on_fixel;
mod on_retrofire;

use std::fs::File;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use serde_json::{Map, Value, json};

use model::Model;

/// The frames that are drawn, as everywhere in the bench.
const FRAMES: std::ops::Range<u32> = 2..12;
/// Rounds over them, of which each frame's fastest counts; renderers take turns, so that
/// what else the machine does hits all alike.
const ROUNDS: usize = 60;
/// The frame whose picture is kept.
const SHOWN: u32 = 4;

/// Something that draws a scene.
trait Renderer {
    /// Its name.
    fn name(&self) -> &'static str;
    /// Draws a frame.
    fn draw(&mut self, frame: u32);
    /// RGB565, in the panel's byte order.
    fn pixels(&self) -> &[u16];
}

fn main() -> ExitCode {
    let mut scenes = Vec::new();
    let mut pictures = None;
    let mut arguments = std::env::args_os().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--pictures" {
            pictures = arguments.next().map(PathBuf::from);
        } else {
            scenes.push(PathBuf::from(argument));
        }
    }
    match run(&scenes, pictures.as_deref()) {
        Ok(figures) => {
            println!("{figures:#}");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(scenes: &[PathBuf], pictures: Option<&Path>) -> Result<Value, String> {
    let mut all = Map::new();
    for path in scenes {
        let model = Model::load(path)?;
        let mut renderers: [Box<dyn Renderer + '_>; 4] = [
            Box::new(on_fixel::Fixel::new(path)?),
            Box::new(on_embedded::Embedded::new(&model)?),
            Box::new(on_euc::Euc::new(&model)),
            Box::new(on_retrofire::Retrofire::new(&model)),
        ];
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let mut best = [[u128::MAX; FRAMES.end as usize]; 4];
        for _ in 0..ROUNDS {
            for (renderer, best) in renderers.iter_mut().zip(&mut best) {
                for frame in FRAMES {
                    let start = Instant::now();
                    renderer.draw(black_box(frame));
                    black_box(renderer.pixels());
                    let best = &mut best[frame as usize];
                    *best = start.elapsed().as_nanos().min(*best);
                }
            }
        }
        let mut figures = Map::new();
        for (renderer, best) in renderers.iter_mut().zip(best) {
            renderer.draw(SHOWN);
            let drawn = renderer.pixels();
            let covered = drawn
                .iter()
                .filter(|pixel| **pixel != model.empty())
                .count();
            let taken = best[FRAMES.start as usize..].iter().sum::<u128>() as f64;
            let mean_us = taken / f64::from(FRAMES.end - FRAMES.start) / 1e3;
            figures.insert(
                renderer.name().into(),
                json!({ "wall_us": (mean_us * 10.0).round() / 10.0, "covered_px": covered }),
            );
            if let Some(folder) = pictures {
                let file = folder.join(format!("{name}_{}.png", renderer.name()));
                picture(&file, model.size, drawn)?;
            }
        }
        all.insert(name.into_owned(), figures.into());
    }
    Ok(all.into())
}

/// Writes a PNG.
fn picture(path: &Path, [width, height]: [usize; 2], pixels: &[u16]) -> Result<(), String> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let file = File::create(path).map_err(|error| fail(&error))?;
    let mut encoder = png::Encoder::new(file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let bytes: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| {
            let pixel = u16::from_be(*pixel);
            [pixel >> 11 << 3, pixel >> 5 << 2, pixel << 3].map(|c| c as u8)
        })
        .collect();
    let mut writer = encoder.write_header().map_err(|error| fail(&error))?;
    writer
        .write_image_data(&bytes)
        .map_err(|error| fail(&error))
}
