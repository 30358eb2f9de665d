//! A comparison as a page for a browser: pictures, maps of the differences, histograms and
//! figures in one file, and an index over many.
//!
//! In: a frame and the truth that it was held against. Out: HTML that needs nothing but
//! itself, in light and dark. Used by `fixel compare --report` and
//! `cargo xtask accuracy --report`.

mod figures;
mod histogram;
mod index;
mod page;
mod picture;
mod style;

pub use index::{Entry, index};
pub use page::{Page, page};

/// Text as it stands in HTML, also between quotes.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
