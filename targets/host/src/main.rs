//! `measure SCENE.fxl FROM TO BAND_ROWS [FILE]`: renders frames as the measuring
//! firmware does, and prints the same lines; `count` is in nanoseconds. The
//! RGB565 bytes go to `FILE`.

use std::fs::{self, File};
use std::io::Write;
use std::process::ExitCode;
use std::time::Instant;

use fixel_runner::engine::EngineError;
use fixel_runner::{Job, Memory, Platform, measure};

/// The largest picture in one band.
const PIXELS: usize = 320 * 240;

/// The renderer's smallest working memory, if built for that: lists overflow,
/// next to nothing is kept, and the picture shall be the same.
#[cfg(feature = "small")]
type HostMemory = Memory<PIXELS, 8, 1, 1>;
/// What the firmware has.
#[cfg(not(feature = "small"))]
type HostMemory = Memory<PIXELS>;

/// The host's clock and streams.
struct Host {
    start: Instant,
    picture: Option<File>,
    written: std::io::Result<()>,
}

impl Platform for Host {
    fn ticks(&mut self) -> u64 {
        self.start.elapsed().as_nanos() as u64
    }
    fn between(&self, start: u64, end: u64) -> u64 {
        end - start
    }
    fn print(&mut self, text: &[u8]) {
        let _ = std::io::stdout().write_all(text);
    }
    fn show(&mut self, panel: &[u8]) {
        if let (Some(file), Ok(())) = (&mut self.picture, &self.written) {
            self.written = file.write_all(panel);
        }
    }
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next();
    let mut number = || arguments.next().and_then(|text| text.parse::<u32>().ok());
    let (Some(path), Some(from), Some(to), Some(rows)) = (path, number(), number(), number())
    else {
        return Err("usage: measure SCENE.fxl FROM TO BAND_ROWS [FILE]".into());
    };
    let job = Job {
        from,
        to,
        band_rows: rows as usize,
    };
    let bytes = fs::read(&path).map_err(|error| format!("{path}: {error}"))?;
    // The scene is read in place and must start at a multiple of 4.
    let mut words = vec![0u32; bytes.len().div_ceil(4)];
    let blob = bytemuck::cast_slice_mut::<u32, u8>(&mut words)
        .get_mut(..bytes.len())
        .ok_or("the buffer is too short")?;
    #[expect(clippy::disallowed_methods, reason = "it has as many bytes")]
    blob.copy_from_slice(&bytes);
    let picture = match arguments.next() {
        Some(path) => Some(File::create(&path).map_err(|error| format!("{path}: {error}"))?),
        None => None,
    };
    let mut host = Host {
        start: Instant::now(),
        picture,
        written: Ok(()),
    };
    let mut memory = Box::new(HostMemory::new());
    measure(&mut host, blob, job, &mut memory).map_err(|error| match error {
        EngineError::Scene(error) => format!("{path}: {error}"),
        other => other.message().to_owned(),
    })?;
    host.written
        .map_err(|error| format!("the picture: {error}"))
}
