//! A vertex before projection.

/// A vertex before projection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClipVertex {
    /// To the right, scaled by the lens; see
    /// [`ActorView`](crate::view::ActorView).
    pub x: i32,
    /// Down, scaled by the lens.
    pub y: i32,
    /// Distance along the line of sight.
    pub distance: i32,
    /// Light level, raw [`FineLevel`](crate::math::FineLevel).
    pub level: i32,
}
