//! A frame from the rasteriser, collected band by band.

use std::convert::Infallible;

use fixel::display::Display;
use fixel::frame::BandRows;
use fixel::math::Angle;
use fixel::palette::Palette;
use fixel::render::{
    FrameStats, Paint, PaintActor, PaintLight, PaintTexel, PaintTriangle, Picked, Scratch, Shaded,
    render_frame, render_frame_with,
};
use fixel::scene::{Camera, Dither, Pose};
use fixel::{Band, Scene};

/// What to render.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Width in pixels, 1..=2048.
    pub width: u16,
    /// Height in pixels, 1..=2048.
    pub height: u16,
    /// Frame of the animation.
    pub frame: u32,
    /// Rows of a band; `None`: one band as high as the screen.
    pub band_rows: Option<u16>,
    /// The eye, if it is elsewhere than the scene says.
    pub camera: Option<Camera>,
}

impl Options {
    /// The scene's own size, frame 0, one band.
    pub fn of(scene: &Scene<'_>) -> Self {
        Self {
            width: scene.width(),
            height: scene.height(),
            frame: 0,
            band_rows: None,
            camera: None,
        }
    }

    /// The scene in the frame, seen from where these say.
    pub fn pose<'s>(&self, scene: &Scene<'s>) -> Pose<'s> {
        let pose = scene.pose(self.frame);
        let camera = self.camera.unwrap_or(pose.camera);
        Pose { camera, ..pose }
    }
}

/// A whole frame, as large as the picture or, with several samples or two eyes to a
/// pixel, larger. Pixels go by rows from the top left.
#[derive(Clone, Debug)]
pub struct Planes {
    /// Palette indices.
    pub index: Vec<u8>,
    /// Depths; 0 where nothing is.
    pub depth: Vec<u16>,
    /// Width and height of the frame, whose pixels may be samples of the picture's.
    pub size: (u16, u16),
    /// Which frame of the animation it is.
    pub frame: u32,
    /// As in [`Options::camera`].
    pub camera: Option<Camera>,
    /// What the frame took.
    pub stats: FrameStats,
}

/// Meshlets, kept meshlets and actors: the host has the memory.
pub(crate) type HostScratch = Scratch<4096, 256, 64>;

pub(crate) struct Collector(Planes);

impl Display for Collector {
    type Error = Infallible;

    fn begin(&mut self, _: &Palette<'_>) -> Result<(), Infallible> {
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        self.0.index.extend(rows.indices);
        self.0.depth.extend(rows.depths);
        Ok(())
    }
}

/// Renders the scene as it looks.
pub fn render(scene: &Scene<'_>, options: &Options) -> Planes {
    let dither = scene.dither();
    paint(&Shaded { dither }, scene, options)
}

/// The same with the object turned about the vertical axis, by as much as buttons have
/// turned it.
pub fn render_turned(scene: &Scene<'_>, options: &Options, turn: Angle) -> Planes {
    let mut scratch = Box::new(HostScratch::new());
    collected(scene, options, |pose, band, collector| {
        let mut pose = *pose;
        pose.turn = pose.turn.plus(turn);
        let work = &mut scratch.workspace();
        let Ok(stats) = render_frame(scene, &pose, work, band, collector);
        stats
    })
}

/// Renders the palette indices without dithering.
pub(crate) fn undithered(scene: &Scene<'_>, options: &Options) -> Vec<u8> {
    paint(
        &Shaded {
            dither: Dither::NONE,
        },
        scene,
        options,
    )
    .index
}

/// Renders the light of each pixel, 0 where nothing is: its level three times, or of
/// a material that goes by colour red, green and blue.
pub(crate) fn light(scene: &Scene<'_>, options: &Options) -> Vec<[u8; 3]> {
    let plane = |channel| paint(&PaintLight { channel }, scene, options).index;
    let coloured = (0..scene.material_count()).any(|m| scene.material(m).coloured);
    if !coloured {
        return plane(0).into_iter().map(|level| [level; 3]).collect();
    }
    let (red, green, blue) = (plane(0), plane(1), plane(2));
    let rows = red.into_iter().zip(green).zip(blue);
    rows.map(|((r, g), b)| [r, g, b]).collect()
}

/// Renders where in its texture each pixel is, in texels; empty if there are no
/// textures.
pub(crate) fn texture_place(scene: &Scene<'_>, options: &Options) -> Vec<[f64; 2]> {
    if scene.texture_count() == 0 {
        return Vec::new();
    }
    let along = |axis| {
        let bytes =
            [0, 1, 2, 3].map(|byte| paint(&PaintTexel { axis, byte }, scene, options).index);
        let place = |i: usize| i32::from_le_bytes([0, 1, 2, 3].map(|b: usize| bytes[b][i]));
        let places = (0..bytes[0].len()).map(|i| f64::from(place(i)) / 65536.0);
        places.collect::<Vec<_>>()
    };
    let (across, down) = (along(0), along(1));
    across.into_iter().zip(down).map(|(x, y)| [x, y]).collect()
}

/// Renders the actor of each pixel; meaningless where nothing is.
pub fn actors(scene: &Scene<'_>, options: &Options) -> Vec<u16> {
    let [low, high] = [0, 1].map(|byte| paint(&PaintActor { byte }, scene, options).index);
    let join = |(low, high): (u8, u8)| u16::from_le_bytes([low, high]);
    low.into_iter().zip(high).map(join).collect()
}

/// Renders the triangle (its place in the blob) of each pixel; meaningless where
/// nothing is.
pub fn triangles(scene: &Scene<'_>, options: &Options) -> Vec<u32> {
    let bytes = [0, 1, 2, 3].map(|byte| paint(&PaintTriangle { byte }, scene, options).index);
    (0..bytes[0].len())
        .map(|i| u32::from_le_bytes([0, 1, 2, 3].map(|b: usize| bytes[b][i])))
        .collect()
}

/// What a pixel of the picture shows, its first sample if it has several and to the
/// left eye if there are two; see [`fixel::render::pick`].
pub fn pick(scene: &Scene<'_>, options: &Options, x: u16, y: u16) -> Option<Picked> {
    let output = scene.output();
    let (width, height) = output.frame_size((options.width, options.height));
    let (mut indices, mut depths) = (vec![0; width.into()], vec![0; width.into()]);
    let mut scratch = Box::new(HostScratch::new());
    let mut pose = options.pose(scene);
    pose.height = height;
    let mut band = Band::new(width, &mut indices, &mut depths).ok()?;
    let [across, down] = output.samples.map(u16::from);
    let (x, y) = (x.saturating_mul(across), y.saturating_mul(down));
    fixel::render::pick(scene, &pose, &mut scratch.workspace(), &mut band, x, y)
}

fn paint<P: Paint<Stored = u8>>(paint: &P, scene: &Scene<'_>, options: &Options) -> Planes {
    let mut scratch = Box::new(HostScratch::new());
    collected(scene, options, |pose, band, collector| {
        let work = &mut scratch.workspace();
        let Ok(stats) = render_frame_with(paint, scene, pose, work, band, collector);
        stats
    })
}

/// The planes of a frame that `draw` draws in bands.
pub(crate) fn collected<'s>(
    scene: &Scene<'s>,
    options: &Options,
    draw: impl FnOnce(&Pose<'s>, &mut Band<'_>, &mut Collector) -> FrameStats,
) -> Planes {
    let (width, height) = scene.output().frame_size((options.width, options.height));
    let rows = options.band_rows.unwrap_or(height).clamp(1, height.max(1));
    let pixels = usize::from(width.max(1)) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut pose = options.pose(scene);
    pose.height = height;
    let mut collector = Collector(Planes {
        index: Vec::new(),
        depth: Vec::new(),
        size: (width, height),
        frame: options.frame,
        camera: options.camera,
        stats: FrameStats::default(),
    });
    // The buffers hold `rows` rows of 1..=2048 pixels: a band there is.
    if let Ok(mut band) = Band::new(width, &mut indices, &mut depths) {
        collector.0.stats = draw(&pose, &mut band, &mut collector);
    }
    collector.0
}
