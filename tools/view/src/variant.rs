//! What is asked of the worker: a scene as the user wants to see it.

use std::sync::Arc;

use fixel_estimate::Board;
use fixel_scene::{
    Camera, Display, Element, PANELS, PanelDithering, Representation, Scene, Screen, Stereo, Target,
};

use crate::source::Source;

/// Who renders.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Renderer {
    /// The fixed-point rasteriser, as on a microcontroller.
    #[default]
    Raster,
    /// The fixed-point ray caster.
    Ray,
    /// The f64 reference for the rasteriser.
    Reference,
    /// The f64 reference for the ray caster.
    RayReference,
}

impl Renderer {
    /// In the order of the key.
    pub const ALL: [Self; 4] = [Self::Raster, Self::Ray, Self::Reference, Self::RayReference];

    /// As the command line has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Raster => "raster",
            Self::Ray => "ray",
            Self::Reference => "reference",
            Self::RayReference => "ray-reference",
        }
    }
}

/// What is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Show {
    /// The panel's picture.
    #[default]
    Picture,
    /// Depth: the nearer the lighter.
    Depth,
    /// Each actor in a colour of its own.
    Actors,
    /// Each meshlet in a colour of its own.
    Meshlets,
    /// How often each pixel is drawn.
    Overdraw,
}

/// How the scene differs from its file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Variant {
    /// How all actors are drawn; none: as the file says.
    pub representation: Option<Representation>,
    /// A panel by its number; none: the file's display.
    pub panel: Option<usize>,
    /// How a grey panel of few levels dithers; none: as the file says, or as suits the panel.
    pub dithering: Option<PanelDithering>,
    /// Two eyes in red and cyan, or one; none: as the file says.
    pub stereo: Option<bool>,
}

/// Degrees between the eyes: VTK's.
const EYE_ANGLE: f64 = 2.0;

impl Variant {
    /// Changes a scene into this.
    pub fn apply(&self, scene: &mut Scene) {
        if let Some(representation) = self.representation {
            for actor in &mut scene.actors {
                actor.look.representation = representation;
            }
        }
        match self.screen() {
            Some(screen) => screen.apply(scene),
            None => scene.display = self.display(&scene.display),
        }
        match self.stereo {
            Some(true) => {
                scene.display.stereo = Stereo::Anaglyph {
                    eye_angle: EYE_ANGLE,
                };
                // They go through a palette.
                scene.palette.direct = false;
            }
            Some(false) => scene.display.stereo = Stereo::None,
            None => {}
        }
    }

    /// The panel instead of the file's display.
    fn screen(&self) -> Option<Screen> {
        let panel = *self.panel.and_then(|panel| PANELS.get(panel))?;
        let dithering = self.dithering;
        Some(Screen { panel, dithering })
    }

    /// Size, colour and dithering of what shows this.
    pub fn display(&self, display: &Display) -> Display {
        let mut shown = display.clone();
        match self.screen() {
            Some(screen) => {
                (shown.width, shown.height) = (screen.panel.width, screen.panel.height);
                shown.colour = screen.panel.colour;
                shown.dithering = screen.dithering(display.colour, display.dithering);
            }
            None if shown.colour.is_dithered() => {
                shown.dithering = self.dithering.unwrap_or(shown.dithering);
            }
            None => {}
        }
        shown
    }
}

/// A picture that is wanted.
#[derive(Clone, Debug)]
pub struct Job {
    /// The scene.
    pub source: Arc<Source>,
    /// What is changed of it.
    pub variant: Variant,
    /// The eye, if somebody moved it.
    pub camera: Option<Camera>,
    /// The frame of the animation.
    pub frame: u32,
    /// Who renders.
    pub renderer: Renderer,
    /// What.
    pub show: Show,
    /// The board that is reckoned with.
    pub board: &'static Board,
}

impl PartialEq for Job {
    fn eq(&self, other: &Self) -> bool {
        let rest = |job: &Self| (job.variant, job.camera, job.frame, job.renderer, job.show);
        Arc::ptr_eq(&self.source, &other.source)
            && rest(self) == rest(other)
            && self.board.name == other.board.name
    }
}

impl Job {
    /// The board with the panel that is shown; with its own where the scene's display is.
    pub fn board(&self) -> Board {
        match self.variant.panel.and_then(|panel| PANELS.get(panel)) {
            Some(panel) => self.board.showing(panel),
            None => *self.board,
        }
    }

    /// The description of what is to be rendered; its camera stands still if somebody moved
    /// it.
    pub fn scene(&self) -> Scene {
        let mut scene = self.source.scene.clone();
        self.variant.apply(&mut scene);
        if let Some(camera) = self.camera {
            scene.camera = camera;
            let tracks = &mut scene.animation.tracks;
            tracks.retain(|track| track.target != Target::Camera);
            scene.source.lines.remove(&Element::Camera);
        }
        scene
    }
}
