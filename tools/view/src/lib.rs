//! `fixel view`: a window that shows a scene as its panel shows it, enlarged pixel for
//! pixel, and follows mouse, keys and the scene's file.
//!
//! In: a scene's path and how to load it. Out: a window until the user closes it. Used by
//! the `fixel` command.
//!
//! ```text
//! keys, mouse, file ──> State ──job──> Worker (bakes, renders) ──picture──> frame ──> window
//! ```
//!
//! `State` decides, and knows no window; everything but `window.rs` is tested without one.

mod camera;
mod canvas;
mod draw;
mod event;
mod false_colour;
mod frame;
mod keys;
mod script;
mod source;
mod state;
mod step;
mod variant;
mod view;
mod watch;
mod window;
mod worker;

pub use source::{Loader, Source};
pub use variant::Renderer;

use std::path::PathBuf;

use fixel_estimate::Board;
use fixel_scene::Screen;

/// How to begin.
#[derive(Debug)]
pub struct Options {
    /// The scene, mesh or baked scene.
    pub path: PathBuf,
    /// The panel; none: the scene's own display.
    pub screen: Option<Screen>,
    /// The board that is reckoned with; none: the first of them.
    pub board: Option<&'static Board>,
    /// How to render.
    pub renderer: Renderer,
    /// Screen pixels that a panel pixel takes; none: as many as fit.
    pub zoom: Option<u32>,
    /// A file of keys and mouse moves to go through.
    pub script: Option<PathBuf>,
    /// Whether there is a window; without one, a script.
    pub window: bool,
}

/// Shows a scene until the user closes the window, or the script is at its end.
///
/// # Errors
/// One line: the scene cannot be loaded, there is no display, or a line of the script is
/// wrong.
pub fn run(options: Options, load: Loader) -> Result<(), String> {
    let source = load(&options.path)?;
    let mut state = state::State::new(source);
    if let Some(screen) = options.screen {
        state.choose_screen(screen);
    }
    if let Some(board) = options.board {
        state.choose_board(board);
    }
    state.choose_renderer(options.renderer);
    let steps = match &options.script {
        Some(path) => step::read(path)?,
        None => Vec::new(),
    };
    let start = view::Start {
        state,
        load,
        path: options.path,
        zoom: options.zoom,
        steps,
    };
    if options.window {
        window::run(start)
    } else {
        script::run(start)
    }
}
