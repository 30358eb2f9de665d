//! The measuring loop: renders frames, hashes what came out, counts what it
//! cost.

use core::hint::black_box;
use core::sync::atomic::{Ordering, compiler_fence};

use core::convert::Infallible;

use fixel::display::{Resolve, Rgb565Rows};
use fixel::frame::BandRows;
use fixel::palette::Rgb565Table;
use fixel::{Display, Scene};

use crate::demo::WIDTH;
use crate::engine::{self, Buffers, EngineError, Scratch};
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
    sums: [u32; WIDTH],
    row: [u16; WIDTH],
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
            sums: [0; WIDTH],
            row: [0; WIDTH],
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

/// A band's pixels as a panel takes them.
struct Panel<'a> {
    pixels: &'a mut [u16],
    /// How many there are.
    count: usize,
}

impl Panel<'_> {
    /// The next `count` pixels.
    fn next(&mut self, count: usize) -> &mut [u16] {
        let from = self.count.min(self.pixels.len());
        self.count = from + count.min(self.pixels.len() - from);
        self.pixels.get_mut(from..self.count).unwrap_or_default()
    }

    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self.pixels.get(..self.count).unwrap_or_default())
    }
}

impl Rgb565Rows for Panel<'_> {
    type Error = Infallible;

    fn row(&mut self, _: u16, pixels: &[u16]) -> Result<(), Infallible> {
        for (to, from) in self.next(pixels.len()).iter_mut().zip(pixels) {
            *to = *from;
        }
        Ok(())
    }
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
        self.depths(band.depths, panel);
    }

    fn depths(&mut self, depths: &[u16], panel: &[u8]) {
        self.depth.words(depths);
        self.panel.bytes(panel);
        self.covered += depths.iter().filter(|&&depth| depth != 0).count() as u64;
    }
}

/// Renders the job's frames and prints a line for each: `frame`, `width`,
/// `height`, `covered` pixels, `count` (instructions for the frame up to the
/// bytes that a panel takes; hashing is not in it), and the hashes `index` (of nothing in a
/// scene without a palette), `depth` and `panel`.
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
    let scene = engine::parse(blob).map_err(EngineError::Scene)?;
    let output = scene.output();
    if output.is_resolved() && usize::from(scene.width()) > WIDTH {
        return Err(EngineError::Memory);
    }
    for frame in job.from..job.to {
        let mut digest = Digest::default();
        let mut watch = Stopwatch::new(platform);
        #[cfg(all(feature = "triangles", not(feature = "rays-alone")))]
        if scene.is_direct() {
            let band = (&mut memory.panel[..], &mut memory.depth[..]);
            let (rows, work) = (job.band_rows, &mut memory.scratch.workspace());
            watch.start(platform);
            engine::render_direct(black_box(&scene), frame, rows, band, work, |rows| {
                watch.stop(platform);
                let bytes = bytemuck::cast_slice(rows.indices);
                digest.depths(rows.depths, bytes);
                platform.show(bytes);
                watch.start(platform);
            })?;
            watch.stop(platform);
            line(platform, &scene, frame, &digest, watch.total);
            continue;
        }
        let panel = Panel {
            pixels: &mut memory.panel,
            count: 0,
        };
        let mut resolve = Resolve::new(output, &mut memory.sums, &mut memory.row, panel);
        let buffers = Buffers {
            index: &mut memory.index,
            depth: &mut memory.depth,
            work: memory.scratch.workspace(),
            colours: &mut memory.colours,
        };
        watch.start(platform);
        if output.is_resolved() {
            let pose = scene.pose(frame);
            let Ok(()) = resolve.begin(&fixel::render::palette(&scene, &pose));
        }
        engine::render(
            black_box(&scene),
            frame,
            job.band_rows,
            buffers,
            |band, colours| {
                resolve.rows().count = 0;
                if output.is_resolved() {
                    let Ok(()) = resolve.show(band);
                } else {
                    let pixels = resolve.rows().next(band.indices.len());
                    colours.resolve(band.indices, pixels);
                }
                black_box(resolve.rows().bytes());
                watch.stop(platform);
                let bytes = resolve.rows().bytes();
                digest.band(band, bytes);
                platform.show(bytes);
                watch.start(platform);
            },
        )?;
        watch.stop(platform);
        line(platform, &scene, frame, &digest, watch.total);
    }
    Ok(())
}

/// Prints a frame's line.
fn line<P: Platform>(platform: &mut P, scene: &Scene<'_>, frame: u32, digest: &Digest, count: u64) {
    Line::new()
        .small("frame", frame)
        .small("width", scene.width().into())
        .small("height", scene.height().into())
        .number("covered", digest.covered)
        .number("count", count)
        .hex("index", digest.index.value())
        .hex("depth", digest.depth.value())
        .hex("panel", digest.panel.value())
        .end(|text| platform.print(text));
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
