//! Instructions of a frame, from its work: a sum of amounts times what each takes.
//!
//! What each takes on a processor was fitted to counts from emulators by `cargo xtask fit`,
//! on scenes other than those that the test holds it to.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::parts::Parts;
use crate::term::{Term, Work};

/// What `cargo xtask fit` makes.
const FITTED: &str = include_str!("../coefficients.json");

/// Everything that was fitted or measured.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Model {
    /// How the file was made.
    pub about: String,
    /// By target, instructions of one of each term.
    pub instructions: BTreeMap<String, BTreeMap<String, f64>>,
    /// By target and by what is linked, what the firmware takes.
    pub firmware: BTreeMap<String, BTreeMap<Parts, Firmware>>,
    /// Counts that nothing was fitted to.
    pub held_out: Vec<Count>,
}

/// What firmware takes, scene and bands aside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Firmware {
    /// Code and tables, in bytes.
    pub code_bytes: u64,
    /// The deepest that the stack went, in bytes.
    pub stack_bytes: u64,
}

/// A frame that an emulator counted.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Count {
    /// The scene's name.
    pub scene: String,
    /// What was changed in it, if anything was.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub variant: String,
    /// The frame's number.
    pub frame: u32,
    /// Rows of a band, at most.
    pub band_rows: u16,
    /// The target's name.
    pub target: String,
    /// Instructions, up to the bytes that a panel takes.
    pub instructions: u64,
}

impl Model {
    /// The fitted one.
    ///
    /// # Errors
    /// If the file that is built in is not one.
    pub fn fitted() -> Result<Self, serde_json::Error> {
        serde_json::from_str(FITTED)
    }

    /// Instructions of a frame on a target; `None` if none were counted there.
    pub fn instructions(&self, target: &str, work: &Work) -> Option<f64> {
        let each = self.instructions.get(target)?;
        let amounts = Term::ALL.iter().map(|term| {
            let each = each.get(term.name()).copied().unwrap_or(0.0);
            each * work.of(*term)
        });
        Some(amounts.sum())
    }
}
