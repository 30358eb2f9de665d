//! The scenes that the commands render, baked.

use std::fs;
use std::path::{Path, PathBuf};

use crate::paths;
use crate::problem::Result;

/// The bench scenes, in the order of the README's table. They are in
/// `scenes/bench/`.
pub const BENCH: [&str; 6] = [
    "w1_teapot_flat",
    "w2_teapot_gouraud",
    "w3_bunny_gouraud",
    "w4_cube_textured",
    "w5_fill",
    "w6_bunny_64x64",
];

/// The bench scenes of the ray caster; in `scenes/bench/` too.
pub const RAY_BENCH: [&str; 3] = ["r1_bunny_rays", "r2_bunny_shadow", "r3_spheres_whitted"];

/// What every target must draw alike by rays: files in `scenes/ray/`.
pub const RAY_PARITY: [&str; 0] = [];

/// What every target must draw alike, besides the bench scenes: files in
/// `scenes/`. Clipping, slivers, a parallel camera and more actors than the
/// firmware keeps matrices for are among them; chains of parents, key frames and
/// camera moves.
pub const PARITY: [&str; 26] = [
    "teapot",
    "bunny",
    "suzanne",
    "near_clip",
    "behind_camera",
    "slivers",
    "parallel",
    "many_actors",
    "tiny_128x64",
    "parents",
    "keyframes",
    "palette_cycle",
    "viewports",
    "fog_exponential",
    "spot",
    "lights",
    "textured_floor",
    "antialiased",
    "stereo_anaglyph",
    "wireframe",
    "hidden_line",
    "lines_markers_text",
    "alpha_test",
    "screen_door",
    "blend",
    "blend_fog",
];

/// The scene whose RAM is held to a limit, and one of another mesh that must
/// need just as much.
pub const FOOTPRINT: [&str; 2] = ["w2_teapot_gouraud", "w3_bunny_gouraud"];

/// Every scene that parity is proved on.
pub fn parity() -> impl Iterator<Item = &'static str> {
    let by_rays = RAY_PARITY.into_iter().chain(RAY_BENCH);
    PARITY.into_iter().chain(BENCH).chain(by_rays)
}

/// Every scene that is measured.
pub fn bench() -> impl Iterator<Item = &'static str> {
    BENCH.into_iter().chain(RAY_BENCH)
}

/// Whether a scene is drawn by rays: it is in the lists above, or its folder is called
/// so.
pub fn by_rays(name: &str) -> bool {
    let file = file(name);
    let is = |name: &&str| file.file_stem().is_some_and(|stem| stem == *name);
    RAY_BENCH.iter().any(is) || file.parent().is_some_and(|folder| folder.ends_with("ray"))
}

/// The scene's file: a name from the lists above, or a path.
pub fn file(name: &str) -> PathBuf {
    if Path::new(name).extension().is_some() {
        return name.into();
    }
    let folder = if BENCH.contains(&name) || RAY_BENCH.contains(&name) {
        "scenes/bench"
    } else if RAY_PARITY.contains(&name) {
        "scenes/ray"
    } else {
        "scenes"
    };
    paths::root().join(folder).join(format!("{name}.toml"))
}

/// A baked scene.
#[derive(Clone, Debug)]
pub struct Baked {
    /// The `.fxl` file.
    pub path: PathBuf,
    /// Its size.
    pub bytes: u64,
}

/// Bakes a scene into the work folder.
pub fn bake(name: &str) -> Result<Baked> {
    let source = file(name);
    let stem = source.file_stem().unwrap_or_default().to_string_lossy();
    let path = paths::work("scenes")?.join(format!("{stem}.fxl"));
    let blob = blob(&source, by_rays(name))?;
    let same = fs::read(&path).is_ok_and(|old| old == blob);
    if !same {
        fs::write(&path, &blob).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(Baked {
        path,
        bytes: blob.len() as u64,
    })
}

/// The scene as bytes for flash.
fn blob(source: &Path, for_rays: bool) -> Result<Vec<u8>> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", source.display());
    let scene = fixel_scene::load(source).map_err(|error| error.to_string())?;
    let bake = if for_rays {
        fixel_bake::bake_for_rays
    } else {
        fixel_bake::bake
    };
    let baked = bake(&scene).map_err(|error| fail(&error))?;
    Ok(baked.bytes().to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_scenes_are() {
        assert!(file("teapot").ends_with("scenes/teapot.toml"));
        assert!(file("w5_fill").ends_with("scenes/bench/w5_fill.toml"));
        assert_eq!(file("other/x.obj"), Path::new("other/x.obj"));
    }
}
