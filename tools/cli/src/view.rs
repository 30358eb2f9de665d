//! `fixel view`.

use crate::args::{self, Renderer};
use crate::input;
use anyhow::Result;
use fixel_view::{Loader, Options, Source};
use std::path::Path;
use std::sync::Arc;

/// Shows a scene in a window.
pub fn run(args: &args::View) -> Result<()> {
    let file = args.input.clone();
    let load: Loader = Arc::new(move |_: &Path| {
        let input = input::load(&file, &[]).map_err(|error| format!("{error:#}"))?;
        Ok(Arc::new(Source {
            scene: input.scene,
            baked: input.baked,
        }))
    });
    let options = Options {
        path: args.input.scene.clone(),
        screen: args.screen.get(),
        board: args.board,
        renderer: match args.renderer {
            Renderer::Raster => fixel_view::Renderer::Raster,
            Renderer::Ray => fixel_view::Renderer::Ray,
            Renderer::Reference => fixel_view::Renderer::Reference,
            Renderer::RayReference => fixel_view::Renderer::RayReference,
        },
        zoom: args.zoom,
        script: args.script.clone(),
        window: !args.no_window,
    };
    fixel_view::run(options, load).map_err(anyhow::Error::msg)
}
