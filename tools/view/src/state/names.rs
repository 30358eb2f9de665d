//! What things are called in the window.

use fixel_scene::{DITHERINGS, PanelDithering, Representation};

/// A way to dither, as a scene file has it.
pub(super) fn dithering(way: PanelDithering) -> &'static str {
    let found = DITHERINGS.iter().find(|(_, own)| *own == way);
    match found {
        Some((_, own)) if *own == PanelDithering::None => "not dithered",
        Some((name, _)) => name,
        None => "",
    }
}

/// How actors are drawn.
pub(super) fn representation(what: Representation) -> &'static str {
    match what {
        Representation::Surface => "surface",
        Representation::Wireframe => "wireframe",
        Representation::HiddenLine => "hidden lines",
        Representation::Points => "points",
    }
}
