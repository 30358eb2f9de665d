//! What the browser simulator has open.
//!
//! In: files in memory, and requests as JSON. Out: answers as JSON, with bytes beside them
//! (pixels, a baked scene). Used by `targets/web`, which is this as WebAssembly, and by its
//! tests; nothing here reads files or knows a browser.

mod boards;
mod catalogue;
mod eye;
mod facts;
mod requests;
mod samples;
mod session;
mod snippet;

pub use requests::{Asked, Frame, Open};
pub use session::{Answer, Session};
