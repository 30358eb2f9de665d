//! Level of detail.

/// Coarser meshes stand in for those that are far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lod {
    /// Most that a coarser mesh's surface is seen off the mesh's own, in pixels of the
    /// picture, 0.01..=8.
    pub error: f64,
}

impl Default for Lod {
    fn default() -> Self {
        Self { error: 1.0 }
    }
}
