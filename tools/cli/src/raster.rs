//! The core's renderers: bakes the scene in memory if need be, renders it by
//! triangles or by rays, and hands back what the core drew as plain arrays.

use crate::input::Input;
use anyhow::Result;
use fixel_reference::Frame;
use serde_json::{Map, Value, json};

/// How to render.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Frame of the animation.
    pub frame: u32,
    /// By rays instead of triangles.
    pub rays: bool,
    /// Rows in a band; `None`: one band as high as the picture.
    pub bands: Option<u32>,
}

/// A rendered frame.
#[derive(Debug)]
pub struct Rendered {
    /// What was drawn, as it is held against the reference: without dithering.
    pub frame: Frame,
    /// What a panel shows of it, as large as was asked for.
    pub picture: Vec<[u8; 3]>,
    /// The core's own counters, as they stand in `--stats`.
    pub stats: Map<String, Value>,
}

/// Renders a scene with the core.
pub fn render(input: Input, options: Options) -> Result<Rendered> {
    let asked = format!("{}x{}", options.width, options.height);
    let most = 2048;
    let too_large = input.refused(&format!(
        "{asked} pixels, or their samples, are too many; expected at most {most}x{most}"
    ));
    let baked = if options.rays {
        input.bake_for_rays()?
    } else {
        input.bake()?
    };
    let scene = baked.scene()?;
    let size = [options.width, options.height].map(u16::try_from);
    let [Ok(width), Ok(height)] = size else {
        return Err(too_large.into());
    };
    let (columns, rows) = scene.output().frame_size((width, height));
    if [width, height, columns, rows]
        .into_iter()
        .any(|side| side > most)
    {
        return Err(too_large.into());
    }
    let core_options = fixel_host::Options {
        width,
        height,
        frame: options.frame,
        band_rows: options.bands.map(|rows| rows.min(most.into()) as u16),
        camera: None,
    };
    let draw = if options.rays {
        fixel_host::ray_frame
    } else {
        fixel_host::frame
    };
    let (frame, planes) = draw(&baked, &scene, &core_options);
    let (picture, _) = fixel_host::picture(&scene, &planes);
    let s = planes.stats;
    let counters = [
        ("bands", s.bands),
        ("meshlets", s.meshlets),
        ("meshlets_outside", s.meshlets_outside),
        ("meshlets_away", s.meshlets_away),
        ("meshlets_transformed", s.meshlets_transformed),
        ("list_refills", s.list_refills),
        ("vertices", s.vertices),
        ("triangles_looked_at", s.triangles),
        ("triangles_missed", s.triangles_missed),
        ("triangles_behind", s.triangles_behind),
        ("triangles_away", s.triangles_away),
        ("triangles_outside", s.triangles_outside),
        ("triangles_clipped", s.triangles_clipped),
        ("triangles_drawn", s.triangles_drawn),
    ];
    let mut stats: Map<String, Value> = Map::new();
    stats.extend(counters.map(|(name, count)| (name.to_owned(), json!(count))));
    stats.insert("blob_bytes".into(), json!(baked.bytes().len()));
    if scene.header().level_error != 0 {
        let levels = fixel_host::levels(&scene, &scene.pose(options.frame), (width, height));
        stats.insert("levels".into(), json!(levels));
    }
    Ok(Rendered {
        frame,
        picture,
        stats,
    })
}
