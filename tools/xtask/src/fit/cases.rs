//! What `cargo xtask fit` counts: scenes, as they are and changed, and those that grow.

use std::path::Path;

use fixel_estimate::Work;
use fixel_scene::{Filter, Representation, Scene, Shading, Texturing};

use crate::measure::ONE_BAND;
use crate::problem::Result;
use crate::report::Tally;
use crate::{growth, scene};

/// Frames that are counted of each scene.
pub const FRAMES: std::ops::Range<u32> = 3..5;
/// Rows of bands.
const BANDS: [u16; 2] = [16, ONE_BAND as u16];
/// Pixels of a band of the measured firmware, at most.
const MOST_PX: u32 = 320 * 240;
/// The variant of a scene in which nothing is changed.
pub const AS_IT_IS: &str = "";
/// What is changed in a scene for more to fit to.
const HALF: &str = "_half";
const FLAT: &str = "_flat";
const GOURAUD: &str = "_gouraud";
const PHONG: &str = "_phong";
const WIRES: &str = "_wires";
const OTHER_COPIES: &str = "_copies";
const OTHER_FILTER: &str = "_filter";
const VARIANTS: [&str; 8] = [
    AS_IT_IS,
    HALF,
    FLAT,
    GOURAUD,
    PHONG,
    WIRES,
    OTHER_COPIES,
    OTHER_FILTER,
];

/// A frame whose work is known.
pub struct Case {
    /// The scene.
    pub scene: String,
    /// What is changed in it.
    pub variant: &'static str,
    /// The frame.
    pub frame: u32,
    /// Rows of a band.
    pub band_rows: u16,
    /// What it is made of.
    pub work: Work,
    /// The blob.
    pub baked: scene::Baked,
}

/// Every scene that is drawn by triangles, as large as it is and half as large, and those
/// that grow.
pub fn all(tally: &mut Tally) -> Result<Vec<Case>> {
    let mut all = Vec::new();
    for path in scene::all()? {
        let name = scene::name(&path);
        if scene::by_rays(&name) {
            continue;
        }
        for variant in VARIANTS {
            let what = format!("{name} {variant}");
            if let Some(Some(baked)) = tally.need(&what, bake(&path, variant)) {
                add(&mut all, (&name, variant), baked)?;
            }
        }
    }
    let by_triangles = |grown: &growth::Grown| grown.kind != growth::Kind::RayActors;
    for grown in growth::scenes()?.into_iter().filter(by_triangles) {
        let name = grown.name();
        if let Some(baked) = tally.need(&name, grown.bake()) {
            add(&mut all, (&name, AS_IT_IS), baked)?;
        }
    }
    Ok(all)
}

fn add(
    all: &mut Vec<Case>,
    (name, variant): (&str, &'static str),
    (blob, baked): (fixel_bake::Baked, scene::Baked),
) -> Result<()> {
    let parsed = blob.scene().map_err(|error| error.to_string())?;
    for (frame, band_rows) in FRAMES.flat_map(|frame| BANDS.map(|rows| (frame, rows))) {
        // More pixels than the measured firmware has room for in one band.
        let px = u32::from(parsed.frame_width()) * u32::from(parsed.frame_height());
        if u32::from(band_rows) == ONE_BAND && px > MOST_PX {
            continue;
        }
        all.push(Case {
            scene: name.to_owned(),
            variant,
            frame,
            band_rows,
            work: fixel_estimate::work(&parsed, &parsed.pose(frame), band_rows),
            baked: baked.clone(),
        });
    }
    Ok(())
}

/// A variant of a scene; none if it is that already.
fn bake(path: &Path, variant: &str) -> Result<Option<(fixel_bake::Baked, scene::Baked)>> {
    let mut shown = fixel_scene::load(path).map_err(|error| error.to_string())?;
    let whole = shown.clone();
    match variant {
        HALF => {
            shown.display.width = (shown.display.width / 2).max(1);
            shown.display.height = (shown.display.height / 2).max(1);
        }
        FLAT => shown
            .materials
            .iter_mut()
            .for_each(|m| m.shading = Shading::Flat),
        GOURAUD => shown
            .materials
            .iter_mut()
            .for_each(|m| m.shading = Shading::Gouraud),
        PHONG => shown
            .materials
            .iter_mut()
            .for_each(|m| m.shading = Shading::Phong),
        WIRES => {
            let all = shown.actors.iter_mut();
            all.for_each(|actor| actor.look.representation = Representation::Wireframe);
        }
        OTHER_COPIES => textures(&mut shown, |t| t.mipmaps = !t.mipmaps),
        OTHER_FILTER => textures(&mut shown, |t| {
            t.filter = match t.filter {
                Filter::Nearest => Filter::Bilinear,
                Filter::Bilinear => Filter::Nearest,
            }
        }),
        _ => {}
    }
    if variant != AS_IT_IS && shown == whole {
        return Ok(None);
    }
    let blob = match fixel_bake::bake(&shown) {
        Ok(blob) => blob,
        // Not everything can be drawn in every way.
        Err(_) if variant != AS_IT_IS => return Ok(None),
        Err(error) => return Err(error.to_string().into()),
    };
    let name = format!("{}{variant}", scene::name(path));
    let baked = scene::Baked::keep("fit", &name, &blob)?;
    Ok(Some((blob, baked)))
}

/// Changes how each texture lies on its surface.
fn textures(scene: &mut Scene, change: impl Fn(&mut Texturing)) {
    let all = scene.materials.iter_mut();
    all.filter_map(|material| material.texture.as_mut())
        .for_each(change);
}
