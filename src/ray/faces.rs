//! The sides of surfaces.

/// Which sides of triangles are met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Faces {
    pub front: bool,
    pub back: bool,
}

impl Faces {
    pub(super) const BOTH: Self = Self {
        front: true,
        back: true,
    };
}
