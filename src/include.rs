//! Baked scenes in the program's own flash.

/// Bytes that start at a multiple of four, as [`Scene::embedded`] and [`Scene::parse`] need them.
///
/// [`Scene::embedded`]: crate::Scene::embedded
/// [`Scene::parse`]: crate::Scene::parse
#[repr(C, align(4))]
#[derive(Debug)]
pub struct Aligned<T: ?Sized>(pub T);

/// A baked scene's bytes, in flash and aligned, for [`Scene::embedded`].
///
/// With `OUT_DIR`, the file that the build script made (`fixel_bake::scene` of the crate
/// `fixel-bake`, or what else writes there); else a file beside the source file.
///
/// ```text
/// // build.rs: fn main() { fixel_bake::scene("teapot.toml"); }
/// static TEAPOT: &[u8] = fixel::include_scene!(OUT_DIR, "teapot.fxl");
///
/// // Made by `fixel bake bunny.toml -o bunny.fxl`.
/// static BUNNY: &[u8] = fixel::include_scene!("bunny.fxl");
/// ```
///
/// [`Scene::embedded`]: crate::Scene::embedded
#[macro_export]
macro_rules! include_scene {
    (OUT_DIR, $name:expr) => {
        $crate::include_scene!(concat!(env!("OUT_DIR"), "/", $name))
    };
    ($path:expr) => {{
        static SCENE: &$crate::Aligned<[u8]> = &$crate::Aligned(*include_bytes!($path));
        &SCENE.0
    }};
}
