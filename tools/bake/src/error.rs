//! Why a scene cannot be baked.

use std::fmt;

/// Something that a blob cannot hold.
#[derive(Clone, Debug, PartialEq)]
pub enum BakeError {
    /// More of something than the format counts.
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there may be.
        most: usize,
    },
    /// A capability that the renderer does not have yet.
    NotYet {
        /// What, and where.
        what: String,
    },
    /// An actor that turns within a space that is not even.
    Turns {
        /// Its name.
        actor: String,
    },
    /// A number that the format cannot hold.
    Range {
        /// Which, and where.
        what: String,
        /// Its value.
        value: f64,
    },
}

impl fmt::Display for BakeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooMany { what, found, most } => {
                write!(f, "{found} {what}, at most {most} can be baked")
            }
            Self::NotYet { what } => write!(f, "{what} is not supported yet"),
            Self::Turns { actor } => write!(
                f,
                "actor `{actor}` turns (by key frames or the turntable) inside its own matrix \
                 or its parent's uneven scale, shear or reflection, which would bend its mesh \
                 anew in each frame; expected the uneven part on the actor itself as scale or \
                 shear, or a matrix that only turns on a parent"
            ),
            Self::Range { what, value } => write!(f, "{what} is {value}, out of range"),
        }
    }
}

impl std::error::Error for BakeError {}
