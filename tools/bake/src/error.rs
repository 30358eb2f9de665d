//! Why a scene cannot be baked.

use std::fmt;

use fixel::SceneError;
use fixel_scene::Element;

/// Something that a blob cannot hold, and where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct BakeError {
    /// The table of the scene file.
    pub element: Option<Element>,
    /// What is wrong.
    pub problem: Problem,
}

/// A number of a scene, for messages.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot<'a> {
    /// Its table.
    pub element: Element,
    /// How a message calls it.
    pub what: &'a str,
}

impl<'a> Spot<'a> {
    pub(crate) fn new(element: Element, what: &'a str) -> Self {
        Self { element, what }
    }
}

impl Problem {
    /// In a table of the scene file.
    pub(crate) fn at(self, element: Element) -> BakeError {
        BakeError {
            element: Some(element),
            problem: self,
        }
    }
}

impl From<Problem> for BakeError {
    fn from(problem: Problem) -> Self {
        Self {
            element: None,
            problem,
        }
    }
}

impl From<SceneError> for BakeError {
    fn from(error: SceneError) -> Self {
        Problem::Refused(error).into()
    }
}

impl fmt::Display for BakeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.problem.fmt(f)
    }
}

/// What a blob cannot hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
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
    /// A blob that the core refuses.
    Refused(SceneError),
    /// An actor that turns within a space that is not even.
    Turns {
        /// Its name.
        actor: String,
    },
    /// A mesh that cannot be simplified as far as was asked for.
    Simplify {
        /// Its name.
        mesh: String,
        /// Triangles that are left where nothing more can go.
        least: usize,
        /// Its share of the triangles asked for.
        most: usize,
    },
    /// A camera at its own focal point, or whose `view_up` has no length.
    NoDirection,
    /// A number that the format cannot hold.
    Range {
        /// Which, and where.
        what: String,
        /// Its value.
        value: f64,
        /// The largest that fits, either side of 0.
        most: f64,
    },
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooMany { what, found, most } => {
                write!(f, "{found} {what}; expected at most {most}")
            }
            Self::NotYet { what } => write!(f, "{what} is not supported yet"),
            Self::Refused(error) => write!(f, "what was baked cannot be drawn: {error}"),
            Self::Turns { actor } => write!(
                f,
                "actor `{actor}` turns (by key frames or the turntable) inside its own matrix \
                 or its parent's uneven scale, shear or reflection, which would bend its mesh \
                 anew in each frame; expected the uneven part on the actor itself as scale or \
                 shear, or a matrix that only turns on a parent"
            ),
            Self::Simplify { mesh, least, most } => write!(
                f,
                "`{mesh}` cannot be simplified below {least} triangles without closing its \
                 borders, its texture's seams or its creases, {most} are its share; expected \
                 a larger number"
            ),
            Self::NoDirection => f.write_str(
                "the camera has no direction; expected position and focal_point apart, and \
                 a view_up that is not 0",
            ),
            Self::Range { what, value, most } => write!(
                f,
                "{what} is {}, out of range; expected within {} either side of 0",
                short(*value),
                short(*most)
            ),
        }
    }
}

/// A number in six digits.
fn short(value: f64) -> f64 {
    let text = format!("{value:.5e}");
    text.parse().unwrap_or(value)
}

impl std::error::Error for BakeError {}

/// Refuses more of a thing than the blob has room for.
pub(crate) fn at_most(what: &'static str, found: usize, most: usize) -> Result<(), BakeError> {
    if found <= most {
        Ok(())
    } else {
        Err(Problem::TooMany { what, found, most }.into())
    }
}
