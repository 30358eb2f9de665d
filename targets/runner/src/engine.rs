//! The one module that knows the renderer: from a blob and a frame's number to
//! finished bands, and from those to the bytes that a panel takes.

use core::convert::Infallible;

use fixel::frame::BandRows;
use fixel::palette::{Palette, Rgb565Table};
#[cfg(all(feature = "triangles", not(feature = "rays-alone")))]
use fixel::render::Bands;
use fixel::{Band, Display, Scene, SceneError};

/// Why a frame could not be rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineError {
    /// The blob is not a scene.
    Scene(SceneError),
    /// A row is longer than the memory given.
    Memory,
    /// The frame's pixels are samples, and the program shows only whole pixels.
    Samples,
    /// The scene is not baked for rays, and the program has nothing else.
    Triangles,
    /// The scene is baked for bands without a palette, and the program has none such.
    Direct,
}

impl EngineError {
    /// In a few words, without formatting.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Scene(_) => "the blob is not a scene",
            Self::Memory => "a row does not fit the memory given",
            Self::Samples => "the scene is anti-aliased or an anaglyph",
            Self::Triangles => "the scene is not baked for rays",
            Self::Direct => "the scene is baked without a palette",
        }
    }
}

/// Meshlets that are listed at once, unless a target says otherwise. The
/// measuring and the demo firmware use the same, so that speed and RAM belong
/// together.
pub const MESHLETS: usize = if cfg!(feature = "small") { 32 } else { 64 };
/// Meshlets that are kept from band to band: as many as 10 KB hold, of which each also
/// keeps colours where a scene may use them.
pub const SLOTS: usize = if cfg!(feature = "small") {
    2
} else if cfg!(feature = "compact") {
    7
} else if cfg!(feature = "whole") {
    10
} else {
    12
};
/// Actors whose matrices are kept.
pub const ACTORS: usize = if cfg!(any(feature = "small", feature = "compact")) {
    1
} else {
    4
};
/// Actors whose places the ray caster keeps.
pub const RAY_ACTORS: usize = 11;

/// The renderers' working memory.
#[derive(Debug)]
pub struct Scratch<
    const MESHLETS: usize = { self::MESHLETS },
    const SLOTS: usize = { self::SLOTS },
    const ACTORS: usize = { self::ACTORS },
> {
    #[cfg(not(feature = "rays-alone"))]
    triangles: fixel::Scratch<MESHLETS, SLOTS, ACTORS>,
    #[cfg(feature = "ray")]
    rays: fixel::ray::RayScratch<RAY_ACTORS>,
}

impl<const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize>
    Scratch<MESHLETS, SLOTS, ACTORS>
{
    /// Ready for the first frame.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self {
            #[cfg(not(feature = "rays-alone"))]
            triangles: fixel::Scratch::new(),
            #[cfg(feature = "ray")]
            rays: fixel::ray::RayScratch::new(),
        }
    }

    /// The memory without its size.
    pub fn workspace(&mut self) -> Workspace<'_> {
        Workspace {
            #[cfg(not(feature = "rays-alone"))]
            triangles: self.triangles.workspace(),
            #[cfg(feature = "ray")]
            rays: self.rays.workspace(),
        }
    }
}

/// The renderers' working memory, of any size.
#[derive(Debug)]
pub struct Workspace<'a> {
    #[cfg(not(feature = "rays-alone"))]
    triangles: fixel::render::Workspace<'a>,
    /// For blobs that are baked for rays.
    #[cfg(feature = "ray")]
    rays: fixel::ray::RayWorkspace<'a>,
}

/// Where bands are drawn.
#[derive(Debug)]
pub struct Buffers<'a> {
    /// Palette indices of a band.
    pub index: &'a mut [u8],
    /// Depths of a band.
    pub depth: &'a mut [u16],
    /// The renderers' working memory.
    pub work: Workspace<'a>,
    /// From an index to a panel's colour.
    pub colours: &'a mut Rgb565Table,
}

/// Hands each finished band, with the panel's colours, to a function.
struct Sink<'a, F> {
    colours: &'a mut Rgb565Table,
    take: F,
}

impl<F: FnMut(BandRows<'_>, &Rgb565Table)> Display for Sink<'_, F> {
    type Error = Infallible;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), Infallible> {
        self.colours.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        (self.take)(rows, self.colours);
        Ok(())
    }
}

/// Checks a blob, which starts at a multiple of 4.
#[inline(always)]
pub fn parse(blob: &[u8]) -> Result<Scene<'_>, SceneError> {
    Scene::parse(blob)
}

/// Renders `frame` in bands of at most `band_rows` rows, top to bottom, and
/// hands each finished one to `take`. Bands are lower if the buffers are
/// smaller.
pub fn render(
    scene: &Scene<'_>,
    frame: u32,
    band_rows: usize,
    mut buffers: Buffers<'_>,
    take: impl FnMut(BandRows<'_>, &Rgb565Table),
) -> Result<(), EngineError> {
    let width = scene.frame_width();
    let pixels = usize::from(width).saturating_mul(band_rows);
    let least = pixels.min(buffers.index.len()).min(buffers.depth.len());
    let index = buffers.index.get_mut(..least).unwrap_or_default();
    let depth = buffers.depth.get_mut(..least).unwrap_or_default();
    let mut band = Band::new(width, index, depth).map_err(|_| EngineError::Memory)?;
    let mut sink = Sink {
        colours: buffers.colours,
        take,
    };
    let pose = scene.pose(frame);
    #[cfg(feature = "ray")]
    if scene.has_rays() {
        let rays = &mut buffers.work.rays;
        let Ok(_) = fixel::ray::render_frame(scene, &pose, rays, &mut band, &mut sink);
        return Ok(());
    }
    #[cfg(feature = "rays-alone")]
    return Err(EngineError::Triangles);
    #[cfg(not(feature = "rays-alone"))]
    {
        let work = &mut buffers.work.triangles;
        let Ok(_) = fixel::render_frame(scene, &pose, work, &mut band, &mut sink);
        Ok(())
    }
}

/// The same of a scene that is baked without a palette: `colours` and `depth` are a band's
/// pixels.
#[cfg(all(feature = "triangles", not(feature = "rays-alone")))]
pub fn render_direct(
    scene: &Scene<'_>,
    frame: u32,
    band_rows: usize,
    (colours, depth): (&mut [u16], &mut [u16]),
    work: &mut Workspace<'_>,
    mut take: impl FnMut(BandRows<'_, u16>),
) -> Result<(), EngineError> {
    let width = scene.frame_width();
    let pixels = usize::from(width).saturating_mul(band_rows);
    let least = pixels.min(colours.len()).min(depth.len());
    let colours = colours.get_mut(..least).unwrap_or_default();
    let depth = depth.get_mut(..least).unwrap_or_default();
    let mut band = Band::new(width, colours, depth).map_err(|_| EngineError::Memory)?;
    let (pose, dither) = (scene.pose(frame), scene.dither());
    let bands = Bands::direct(scene, &pose, dither, &mut work.triangles, &mut band);
    let mut bands = bands.ok_or(EngineError::Direct)?;
    while let Some(rows) = bands.next() {
        take(rows);
    }
    Ok(())
}
