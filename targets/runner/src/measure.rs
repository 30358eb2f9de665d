//! The measuring loop: renders frames, hashes what came out, counts what it
//! cost.

use core::hint::black_box;
use core::sync::atomic::{Ordering, compiler_fence};

use crate::engine::{self, EngineError, Finished, Scene, Scratch};
use crate::hash::Fnv64;
use crate::line::Line;

/// What a target lends the loop.
pub trait Platform {
    /// A running counter, which may wrap.
    fn ticks(&mut self) -> u64;
    /// Instructions executed between two readings of [`Platform::ticks`];
    /// nanoseconds on a target that cannot count instructions.
    fn between(&self, start: u64, end: u64) -> u64;
    /// Prints a text to whoever started the program.
    fn print(&mut self, text: &[u8]);
    /// Takes a finished band's RGB565 bytes, if the target has a use for them.
    fn show(&mut self, panel: &[u8]) {
        let _ = panel;
    }
}

/// What to render.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Job {
    /// The first frame.
    pub from: u32,
    /// One past the last frame.
    pub to: u32,
    /// Rows in a band; a band as high as the picture if larger.
    pub band_rows: usize,
}

/// Everything that frames need, for pictures of at most `PIXELS` pixels in one
/// band; `BYTES` is twice that.
#[derive(Debug)]
pub struct Memory<const PIXELS: usize, const BYTES: usize> {
    index: [u8; PIXELS],
    depth: [u16; PIXELS],
    panel: [u8; BYTES],
    scratch: Scratch,
}

impl<const PIXELS: usize, const BYTES: usize> Memory<PIXELS, BYTES> {
    /// All zero: lies in `.bss`.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        const { assert!(BYTES == PIXELS * 2, "two bytes a pixel") };
        Self {
            index: [0; PIXELS],
            depth: [0; PIXELS],
            panel: [0; BYTES],
            scratch: Scratch::new(),
        }
    }
}

/// A stretch of work between two readings of the counter, less the cost of
/// reading it.
#[derive(Clone, Copy, Debug)]
struct Stopwatch {
    overhead: u64,
    start: u64,
    total: u64,
}

impl Stopwatch {
    fn new<P: Platform>(platform: &mut P) -> Self {
        let mut watch = Self {
            overhead: 0,
            start: 0,
            total: 0,
        };
        watch.start(platform);
        watch.stop(platform);
        watch.overhead = watch.total;
        watch.total = 0;
        watch
    }

    #[inline(never)]
    fn start<P: Platform>(&mut self, platform: &mut P) {
        compiler_fence(Ordering::SeqCst);
        self.start = platform.ticks();
        compiler_fence(Ordering::SeqCst);
    }

    #[inline(never)]
    fn stop<P: Platform>(&mut self, platform: &mut P) {
        compiler_fence(Ordering::SeqCst);
        let end = platform.ticks();
        compiler_fence(Ordering::SeqCst);
        let spent = platform.between(self.start, end);
        self.total += spent.saturating_sub(self.overhead);
    }
}

/// Counts the instructions of `work`, less those of reading the counter.
pub fn count<P: Platform>(platform: &mut P, work: impl FnOnce()) -> u64 {
    let mut watch = Stopwatch::new(platform);
    watch.start(platform);
    work();
    watch.stop(platform);
    watch.total
}

/// Hashes of one frame, band by band; the same whatever the bands' height.
#[derive(Clone, Copy, Debug, Default)]
struct Digest {
    index: Fnv64,
    depth: Fnv64,
    panel: Fnv64,
    covered: u64,
}

impl Digest {
    fn band(&mut self, band: &Finished<'_>, panel: &[u8]) {
        self.index.bytes(band.index);
        self.depth.words(band.depth);
        self.panel.bytes(panel);
        self.covered += band.depth.iter().filter(|&&depth| depth != 0).count() as u64;
    }
}

/// Renders the job's frames and prints a line for each: `frame`, `width`,
/// `height`, `covered` pixels, `count` (instructions for the frame up to the
/// bytes that a panel takes; hashing is not in it), and the hashes `index`,
/// `depth` and `panel`.
pub fn measure<P: Platform, const PIXELS: usize, const BYTES: usize>(
    platform: &mut P,
    blob: &[u8],
    job: Job,
    memory: &mut Memory<PIXELS, BYTES>,
) -> Result<(), EngineError> {
    let scene = Scene::parse(blob)?;
    let band_rows = job.band_rows.min(scene.height);
    for frame in job.from..job.to {
        let mut digest = Digest::default();
        let mut watch = Stopwatch::new(platform);
        let panel = &mut memory.panel;
        watch.start(platform);
        engine::render(
            black_box(&scene),
            frame,
            band_rows,
            &mut memory.scratch,
            &mut memory.index,
            &mut memory.depth,
            |band| {
                let Some(panel) = panel.get_mut(..band.index.len() * 2) else {
                    return;
                };
                band.resolve_rgb565(panel);
                black_box(&mut *panel);
                watch.stop(platform);
                digest.band(band, panel);
                platform.show(panel);
                watch.start(platform);
            },
        )?;
        watch.stop(platform);
        Line::new()
            .small("frame", frame)
            .small("width", scene.width as u32)
            .small("height", scene.height as u32)
            .number("covered", digest.covered)
            .number("count", watch.total)
            .hex("index", digest.index.value())
            .hex("depth", digest.depth.value())
            .hex("panel", digest.panel.value())
            .end(|text| platform.print(text));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    /// Every reading is one tick later, and a tick is one instruction.
    #[derive(Default)]
    struct Fake {
        now: u64,
        out: Vec<u8>,
    }

    impl Platform for Fake {
        fn ticks(&mut self) -> u64 {
            self.now += 1;
            self.now
        }
        fn between(&self, start: u64, end: u64) -> u64 {
            end - start
        }
        fn print(&mut self, text: &[u8]) {
            self.out.extend_from_slice(text);
        }
    }

    #[test]
    fn the_cost_of_reading_is_taken_off() {
        let mut platform = Fake::default();
        assert_eq!(count(&mut platform, || ()), 0);
    }

    #[test]
    fn not_a_scene() {
        let mut memory = Memory::<64, 128>::new();
        let job = Job {
            from: 0,
            to: 1,
            band_rows: 8,
        };
        let result = measure(&mut Fake::default(), b"nonsense", job, &mut memory);
        assert_eq!(result, Err(EngineError::Scene));
    }
}
