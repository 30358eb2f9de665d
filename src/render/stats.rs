//! What a frame took.

use crate::raster::How;

/// Counts of one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameStats {
    /// Bands that the frame was drawn in.
    pub bands: u32,
    /// Meshlets whose bounds were looked at.
    pub meshlets: u32,
    /// Meshlets left out because they are beyond a side of the view.
    pub meshlets_outside: u32,
    /// Meshlets left out because they show only faces that are not drawn.
    pub meshlets_away: u32,
    /// Times that the list of meshlets had to be made anew because the scratch did not
    /// hold all of the frame: each costs a look at all bounds.
    pub list_refills: u32,
    /// Meshlets transformed.
    pub meshlets_transformed: u32,
    /// Vertices transformed.
    pub vertices: u32,
    /// Triangles looked at, counted again in each band that they may reach.
    pub triangles: u32,
    /// Triangles that are not in the band's rows or cover no pixel centre.
    pub triangles_missed: u32,
    /// Triangles left out by eights because they show only backs, before their vertices are
    /// transformed: not among those looked at.
    pub triangles_behind: u32,
    /// Triangles left out because of the side they show.
    pub triangles_away: u32,
    /// Triangles left out because they are beyond a plane.
    pub triangles_outside: u32,
    /// Triangles that were clipped, into one or more that count by themselves.
    pub triangles_clipped: u32,
    /// Triangles drawn, counted again in each band.
    pub triangles_drawn: u32,
    /// Lines looked at, counted again in each band.
    pub lines: u32,
    /// Marks looked at, counted again in each band.
    pub marks: u32,
}

impl FrameStats {
    /// With all triangles looked at. Most are not counted by themselves, since something becomes
    /// of each: what `triangles` holds until then is how many there are more than that.
    pub(super) fn summed(self) -> Self {
        let became = self.triangles_missed
            + self.triangles_away
            + self.triangles_outside
            + self.triangles_drawn;
        Self {
            triangles: self.triangles.wrapping_add(became),
            ..self
        }
    }

    /// Counts what became of a triangle.
    pub(super) fn count(&mut self, how: How) {
        match how {
            How::Missed => self.triangles_missed += 1,
            How::Away => self.triangles_away += 1,
            How::Filled => self.triangles_drawn += 1,
        }
    }
}
