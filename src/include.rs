//! Baked scenes in the program's own flash.

/// Bytes that start at a multiple of four, as [`Scene::parse`] needs them.
///
/// [`Scene::parse`]: crate::Scene::parse
#[repr(C, align(4))]
#[derive(Debug)]
pub struct Aligned<T: ?Sized>(pub T);

/// A baked scene's bytes, in flash and aligned.
///
/// ```text
/// static TEAPOT: &[u8] = fixel::include_scene!("teapot.fxl");
/// ```
#[macro_export]
macro_rules! include_scene {
    ($path:expr) => {{
        static SCENE: &$crate::Aligned<[u8]> = &$crate::Aligned(*include_bytes!($path));
        &SCENE.0
    }};
}
