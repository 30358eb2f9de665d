//! The measuring loop: renders frames, hashes what came out, counts what it
//! cost.

use core::hint::black_box;
use core::sync::atomic::{Ordering, compiler_fence};

use fixel::Scratch;
use fixel::frame::BandRows;
use fixel::palette::Rgb565Table;

use crate::engine::{self, Buffers, EngineError};
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
/// band, and how large the renderer's working memory is.
#[derive(Debug)]
pub struct Memory<
    const PIXELS: usize,
    const MESHLETS: usize = { engine::MESHLETS },
    const SLOTS: usize = { engine::SLOTS },
    const ACTORS: usize = { engine::ACTORS },
> {
    index: [u8; PIXELS],
    depth: [u16; PIXELS],
    panel: [u16; PIXELS],
    scratch: Scratch<MESHLETS, SLOTS, ACTORS>,
    colours: Rgb565Table,
}

impl<const PIXELS: usize, const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize>
    Memory<PIXELS, MESHLETS, SLOTS, ACTORS>
{
    /// Ready for the first frame.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self {
            index: [0; PIXELS],
            depth: [0; PIXELS],
            panel: [0; PIXELS],
            scratch: Scratch::new(),
            colours: Rgb565Table::new(),
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
    fn band(&mut self, band: BandRows<'_>, panel: &[u8]) {
        self.index.bytes(band.indices);
        self.depth.words(band.depths);
        self.panel.bytes(panel);
        self.covered += band.depths.iter().filter(|&&depth| depth != 0).count() as u64;
    }
}

/// Renders the job's frames and prints a line for each: `frame`, `width`,
/// `height`, `covered` pixels, `count` (instructions for the frame up to the
/// bytes that a panel takes; hashing is not in it), and the hashes `index`,
/// `depth` and `panel`.
pub fn measure<
    P: Platform,
    const PIXELS: usize,
    const MESHLETS: usize,
    const SLOTS: usize,
    const ACTORS: usize,
>(
    platform: &mut P,
    blob: &[u8],
    job: Job,
    memory: &mut Memory<PIXELS, MESHLETS, SLOTS, ACTORS>,
) -> Result<(), EngineError> {
    let scene = engine::parse(blob)?;
    for frame in job.from..job.to {
        let mut digest = Digest::default();
        let mut watch = Stopwatch::new(platform);
        let panel = &mut memory.panel;
        let buffers = Buffers {
            index: &mut memory.index,
            depth: &mut memory.depth,
            work: memory.scratch.workspace(),
            colours: &mut memory.colours,
        };
        watch.start(platform);
        engine::render(
            black_box(&scene),
            frame,
            job.band_rows,
            buffers,
            |band, colours| {
                let Some(panel) = panel.get_mut(..band.indices.len()) else {
                    return;
                };
                colours.resolve(band.indices, panel);
                black_box(&mut *panel);
                watch.stop(platform);
                let bytes = bytemuck::cast_slice(panel);
                digest.band(band, bytes);
                platform.show(bytes);
                watch.start(platform);
            },
        )?;
        watch.stop(platform);
        Line::new()
            .small("frame", frame)
            .small("width", scene.width().into())
            .small("height", scene.height().into())
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
        let mut memory = Memory::<64>::new();
        let job = Job {
            from: 0,
            to: 1,
            band_rows: 8,
        };
        let result = measure(&mut Fake::default(), b"nonsense", job, &mut memory);
        assert!(matches!(result, Err(EngineError::Scene(_))), "{result:?}");
    }
}
