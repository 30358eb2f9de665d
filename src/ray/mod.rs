//! A ray caster: the scene by rays through pixels, with shadows, mirrors and glass. In:
//! a [`Scene`](crate::Scene) baked for it, and a [`Pose`](crate::Pose). Out: finished
//! rows for a [`Display`](crate::Display), as the rasteriser gives them. Used by
//! applications; draws surfaces only, no lines, marks or texts.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "places in the world and in grids, held to what fits the 64 bits of their products; tests stop at overflow"
)]

mod actor;
mod actors;
mod ball;
mod beam;
mod bounce;
mod box_test;
mod camera;
mod candidates;
mod coarse;
mod coverage;
mod faces;
mod facet;
mod follow;
mod frame;
mod gather;
mod grid_ray;
mod hierarchy;
mod holes;
mod known;
mod leaves;
mod light;
mod listed;
mod nearest;
mod outline;
mod parts;
mod pass;
mod pause;
mod progressive;
#[expect(clippy::module_inception, reason = "that is what it has")]
mod ray;
mod rectangle;
mod scratch;
mod screen;
mod sequence;
mod shades;
mod smooth;
mod surface;
mod tile;
mod trace;
mod triangle;
mod waiting;
mod walk;
mod watch;
mod window;
mod window_space;
mod windows;

pub use actors::RaySlot;
pub use frame::{render_frame, render_frame_watched};
pub use pass::KeptPixel;
pub use progressive::render_progressively;
pub use scratch::{RayScratch, RayWorkspace};
pub use watch::{RayStats, Seen, Watch};
