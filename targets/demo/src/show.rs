//! The loop's body: one frame after the other.

use fixel::render::FrameStats;
use fixel::{Band, Display, Scene, SceneError};
use fixel_runner::line::Line;

use crate::{Buttons, Cost, Memory, Object, Statistics};

/// Why nothing is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DemoError<E> {
    /// The blob is not a scene.
    Scene(SceneError),
    /// The scene's pixels are samples, which the demo does not average.
    Samples,
    /// The scene is baked for bands without a palette.
    Direct,
    /// The memory does not hold a row of the panel.
    Memory,
    /// The panel failed.
    Panel(E),
}

impl<E> DemoError<E> {
    /// In a few words, without formatting.
    pub const fn message(&self) -> &'static str {
        match self {
            Self::Scene(_) => "the blob is not a scene that this firmware knows",
            Self::Samples => "the scene is anti-aliased or an anaglyph",
            Self::Direct => "the scene is baked without a palette",
            Self::Memory => "a row does not fit the memory",
            Self::Panel(_) => "the panel failed",
        }
    }
}

/// A scene that is shown frame by frame.
#[derive(Debug)]
pub struct Demo<'a> {
    scene: Scene<'a>,
    width: u16,
    height: u16,
    object: Object,
    /// Of the last frame: what was shown, and the renderer's counts.
    shown: Object,
    counts: FrameStats,
    statistics: Statistics,
}

impl<'a> Demo<'a> {
    /// Checks a blob, which starts at a multiple of 4, for a panel of so many columns and
    /// rows, whatever the scene's own.
    ///
    /// # Errors
    /// If the blob is not a scene, one of several samples a pixel, or without a palette.
    pub fn new<E>(blob: &'a [u8], (width, height): (u16, u16)) -> Result<Self, DemoError<E>> {
        let scene = Scene::embedded(blob).map_err(DemoError::Scene)?;
        if scene.output().is_resolved() {
            return Err(DemoError::Samples);
        }
        if scene.is_direct() {
            return Err(DemoError::Direct);
        }
        Ok(Self {
            scene,
            width,
            height,
            object: Object::new(),
            shown: Object::new(),
            counts: FrameStats::default(),
            statistics: Statistics::new(),
        })
    }

    /// Draws the next frame, turned as the buttons say, to the panel.
    ///
    /// # Errors
    /// Those of the panel, after which the same frame may be tried again, and
    /// [`DemoError::Memory`].
    #[inline(never)]
    pub fn frame<
        D: Display,
        const PIXELS: usize,
        const MESHLETS: usize,
        const SLOTS: usize,
        const ACTORS: usize,
    >(
        &mut self,
        buttons: Buttons,
        memory: &mut Memory<PIXELS, MESHLETS, SLOTS, ACTORS>,
        display: &mut D,
    ) -> Result<(), DemoError<D::Error>> {
        self.object.press(buttons);
        let pose = self.object.pose(&self.scene, self.height);
        let mut band = Band::new(self.width, &mut memory.index, &mut memory.depth)
            .map_err(|_| DemoError::Memory)?;
        let work = &mut memory.scratch.workspace();
        self.counts = fixel::render_frame(&self.scene, &pose, work, &mut band, display)
            .map_err(DemoError::Panel)?;
        self.shown = self.object;
        self.object.advance();
        Ok(())
    }

    /// Counts what the last frame took, and gives a line about it: `frame` and `turn`, in
    /// 65536ths of a full turn, say what the panel shows.
    pub fn report(&mut self, cost: Cost) -> Line {
        self.statistics.add(cost);
        let mut line = Line::new();
        line.small("frame", self.shown.frame)
            .small("turn", self.shown.turn.to_bits() >> 16)
            .small("triangles", self.counts.triangles_drawn)
            .small("drawing", cost.drawing())
            .small("waiting", cost.waiting)
            .small("most", self.statistics.most);
        line
    }

    /// What the frames so far took.
    pub const fn statistics(&self) -> &Statistics {
        &self.statistics
    }
}
