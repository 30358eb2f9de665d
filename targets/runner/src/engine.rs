//! The one module that knows the renderer: size of a scene, one frame in
//! bands, palette to panel bytes. A placeholder until the core has them: it
//! draws a pattern from the blob's bytes, in integer arithmetic.

use core::ops::Range;

/// Why a frame could not be rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineError {
    /// The blob is not a scene.
    Scene,
    /// The frame, or a band, is larger than the memory given.
    Memory,
}

impl EngineError {
    /// In words.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Scene => "the blob is not a scene",
            Self::Memory => "the frame does not fit the memory given",
        }
    }
}

/// What the renderer keeps between bands, whatever the scene.
#[derive(Debug)]
pub struct Scratch(());

impl Scratch {
    /// Ready for use.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self(())
    }
}

/// A parsed scene.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    bytes: &'a [u8],
    /// Width of the picture in pixels.
    pub width: usize,
    /// Height of the picture in pixels.
    pub height: usize,
}

impl<'a> Scene<'a> {
    /// Checks a blob, which starts at a multiple of 4.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, EngineError> {
        let &[b'F', b'X', b'P', b'L', w0, w1, h0, h1, ..] = bytes else {
            return Err(EngineError::Scene);
        };
        Ok(Self {
            bytes,
            width: usize::from(u16::from_le_bytes([w0, w1])),
            height: usize::from(u16::from_le_bytes([h0, h1])),
        })
    }
}

/// A finished band.
#[derive(Debug)]
pub struct Finished<'a> {
    /// The rows of the picture that it covers.
    pub rows: Range<usize>,
    /// Palette indices, row by row.
    pub index: &'a [u8],
    /// Depths, row by row; 0 where nothing was drawn.
    pub depth: &'a [u16],
    palette: &'a [u16; 256],
    width: usize,
}

impl Finished<'_> {
    /// Writes the band as RGB565, high byte first, as an ST7789 takes it.
    pub fn resolve_rgb565(&self, out: &mut [u8]) {
        for (&index, bytes) in self.index.iter().zip(out.chunks_exact_mut(2)) {
            let colour = self
                .palette
                .get(usize::from(index))
                .copied()
                .unwrap_or_default();
            bytes.copy_from_slice(&colour.to_be_bytes());
        }
    }

    /// The same, one row at a time through a buffer at least a row long.
    pub fn rows_rgb565(&self, buffer: &mut [u8], send: &mut impl FnMut(&[u8])) {
        let Some(buffer) = buffer.get_mut(..self.width * 2) else {
            return;
        };
        for index in self.index.chunks_exact(self.width.max(1)) {
            let row = Finished {
                rows: self.rows.clone(),
                index,
                depth: &[],
                palette: self.palette,
                width: self.width,
            };
            row.resolve_rgb565(buffer);
            send(buffer);
        }
    }
}

/// Renders `frame` in bands of at most `band_rows` rows, top to bottom, and
/// hands each finished one to `take`. The band's memory is `index` and
/// `depth`, at least `width * band_rows` long.
pub fn render(
    scene: &Scene<'_>,
    frame: u32,
    band_rows: usize,
    scratch: &mut Scratch,
    index: &mut [u8],
    depth: &mut [u16],
    mut take: impl FnMut(&Finished<'_>),
) -> Result<(), EngineError> {
    let _ = scratch;
    let mut palette = [0; 256];
    for (i, colour) in palette.iter_mut().enumerate() {
        *colour = (i as u16).wrapping_mul(257);
    }
    let seed = scene.bytes.iter().map(|&b| u32::from(b)).sum::<u32>();
    let mut top = 0;
    while top < scene.height {
        let rows = band_rows.clamp(1, scene.height - top);
        let pixels = rows * scene.width;
        let (Some(index), Some(depth)) = (index.get_mut(..pixels), depth.get_mut(..pixels)) else {
            return Err(EngineError::Memory);
        };
        for (i, (index, depth)) in index.iter_mut().zip(depth.iter_mut()).enumerate() {
            let value = (top * scene.width + i) as u32 * (frame + 1) + seed;
            *index = (value >> 3) as u8;
            *depth = if value & 7 == 0 { 0 } else { value as u16 | 1 };
        }
        take(&Finished {
            rows: top..top + rows,
            index,
            depth,
            palette: &palette,
            width: scene.width,
        });
        top += rows;
    }
    Ok(())
}
