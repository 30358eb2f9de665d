//! What moves.

/// What moves from frame to frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Animation {
    /// Frames in one turn of every actor without a parent about its own y axis, if
    /// they turn: frame `n` adds `360 * n / turntable` degrees to `orientation[1]`.
    pub turntable: Option<u32>,
    /// Frames after which the tracks start again: frame `n` is theirs `n % frames`.
    pub frames: Option<u32>,
    /// Key frames. Those of the camera are applied in the order of their
    /// quantities.
    pub tracks: Vec<Track>,
    /// Palette entries that go round.
    pub palette_cycle: Option<PaletteCycle>,
}

/// Palette entries that take each other's place: in frame `n` the entry
/// `first + i` of `count` has the colour of entry
/// `first + (i + floor(n * count / frames)) mod count`. No renderer but those that
/// have a palette shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaletteCycle {
    /// The first entry.
    pub first: u32,
    /// The last entry, after `first`.
    pub last: u32,
    /// Frames in which they go round once, at least 1.
    pub frames: u32,
}

/// One quantity of one thing over time: linear between the keys, the first one's
/// value before them, the last one's after them.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// What moves.
    pub target: Target,
    /// What of it.
    pub quantity: Quantity,
    /// At least one, by frame; no two at one.
    pub keys: Vec<Key>,
}

/// What a track moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// An actor, by its index.
    Actor(usize),
    /// The scene's camera.
    Camera,
    /// A viewport's own camera, by the viewport's number.
    Viewport(usize),
}

/// What of it a track moves. The camera's are turns and factors beside what
/// `[camera]` says; VTK's words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// An actor's or the camera's position.
    Position,
    /// The camera's focal point.
    FocalPoint,
    /// An actor's angles, in degrees.
    Orientation,
    /// A factor of an actor's scale, of its children's with it.
    Scale,
    /// The eye turns about the focal point, round the view-up vector; degrees.
    Azimuth,
    /// The eye turns about the focal point, round the picture's horizontal, up;
    /// degrees.
    Elevation,
    /// The view-up vector turns round the line of sight; degrees.
    Roll,
    /// The distance from the eye to the focal point is divided by this.
    Dolly,
    /// The view angle, or the parallel scale, is divided by this.
    Zoom,
    /// Eye and focal point move so far to the right and up, in the picture's plane.
    Pan,
}

/// A track's value in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The frame.
    pub frame: u32,
    /// The value; of a single number, the first.
    pub value: [f64; 3],
}

impl Animation {
    /// Frames after which everything starts again: of the tracks, or of the
    /// turntable, or of the palette.
    pub fn length(&self) -> Option<u32> {
        let cycle = self.palette_cycle.map(|cycle| cycle.frames);
        self.frames.or(self.turntable).or(cycle)
    }
}
