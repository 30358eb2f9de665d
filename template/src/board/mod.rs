//! The display of the board that was chosen.

mod {{chip}};

pub use {{chip}}::{WIDTH, display};
