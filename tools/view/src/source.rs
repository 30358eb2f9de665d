//! A scene as it was loaded.

use std::path::Path;
use std::sync::Arc;

use fixel_bake::Baked;
use fixel_scene::Scene;

/// A scene, and its blob if it came baked.
#[derive(Debug)]
pub struct Source {
    /// The description.
    pub scene: Scene,
    /// The blob as it was in the file.
    pub baked: Option<Baked>,
}

/// Loads a scene, a mesh or a baked scene, or says in one line why it cannot be.
pub type Loader = Arc<dyn Fn(&Path) -> Result<Arc<Source>, String> + Send + Sync>;
