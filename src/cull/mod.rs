//! Which meshlets can be seen, decided from their bounds alone. In: a meshlet's
//! record and its [`ActorView`]. Out: [`Visible`]: the
//! screen rows it may touch and how near it is. And which groups of its triangles are seen from
//! behind: [`Sight`]. Used by `render`.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "spheres and cones of checked meshlets, planes of the view: products fit 64 bits; tests stop at overflow"
)]

mod cone;
mod faces;
mod sphere;

pub use faces::Sight;

use crate::scene::{Cull, Meshlet};
use crate::view::{ActorView, MeshletRows};

/// What is known of a meshlet that may be visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visible {
    /// First screen row that it may touch.
    pub first_row: u16,
    /// One past the last row.
    pub end_row: u16,
    /// Larger is nearer; comparable between actors. Of the nearest place, but of the
    /// middle if the material is blended: what is drawn over the other should be what
    /// is seen over it.
    pub nearness: u16,
}

/// Why a meshlet was left out, or what it may touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It may be seen.
    Visible(Visible),
    /// It is beyond a side of the view.
    OutsideView,
    /// It shows only faces that are left out.
    FacesAway,
}

/// Judges a meshlet. Never calls one invisible that has a pixel to show, where
/// pixels may be `reach` pixels off the meshlet's place.
#[inline(never)]
pub fn judge(view: &ActorView, meshlet: &Meshlet, height: u16, reach: u16) -> Verdict {
    let away = match view.material.cull {
        Cull::Back => cone::faces_away(view, meshlet, false),
        Cull::Front => cone::faces_away(view, meshlet, true),
        Cull::None => false,
    };
    if away {
        return Verdict::FacesAway;
    }
    let base = MeshletRows::new(view, meshlet).base();
    match sphere::extent(view, base, meshlet.radius_steps(), height, reach) {
        Some(visible) => Verdict::Visible(visible),
        None => Verdict::OutsideView,
    }
}
