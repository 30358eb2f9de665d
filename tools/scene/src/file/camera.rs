//! `[camera]`, its defaults as VTK has them.

use std::ops::RangeInclusive;

use glam::DVec3;

use super::table::{Keys, Neutral, Table};
use crate::description::{Animation, Camera, Projection, Quantity, Target};
use crate::error::Error;
use crate::framing::{self, Bounds};
use crate::motion;

pub(super) const CAMERA: Keys = Keys {
    known: &[
        "position",
        "focal_point",
        "view_up",
        "view_angle",
        "projection",
        "parallel_scale",
        "clipping_range",
        "azimuth",
        "elevation",
        "roll",
        "dolly",
        "zoom",
        "pan",
    ],
    later: &[("stereo", Neutral::Text("none"))],
};

/// Degrees.
const VIEW_ANGLES: RangeInclusive<f64> = 0.01..=179.0;
/// VTK's.
const VIEW_ANGLE: f64 = 30.0;

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Perspective,
    Parallel,
}

/// The shape of the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// Width / height.
    pub aspect: f64,
    /// How much more a camera with a place of its own sees in height than its numbers say,
    /// at least 1: see [`crate::Screen::widening`].
    pub widening: f64,
}

impl Shape {
    /// A view angle, or a parallel scale, widened.
    fn widen(self, projection: &mut Projection) {
        projection.widen(self.widening);
    }
}

/// Without a position the eye looks along -z and sees all of `bounds`. The tracks of
/// `target` move it.
pub(super) fn camera(
    table: Option<&Table<'_, '_>>,
    bounds: &Bounds,
    shape: Shape,
    animation: &Animation,
    target: Target,
) -> Result<Camera, Error> {
    let range = |camera: &Camera| {
        let cameras = motion::cameras(camera, animation, target);
        framing::clipping_range(&cameras, bounds)
    };
    let aspect = shape.aspect;
    let Some(table) = table else {
        let mut camera = framing::frame(bounds, DVec3::Z, VIEW_ANGLE, aspect);
        camera.clipping_range = range(&camera);
        return Ok(camera);
    };
    let kinds = [
        ("perspective", Kind::Perspective),
        ("parallel", Kind::Parallel),
    ];
    let kind = table.choice("projection", &kinds, &[])?;
    let kind = kind.unwrap_or(Kind::Perspective);
    let view_angle = table.number("view_angle", VIEW_ANGLES)?;
    let view_angle = view_angle.unwrap_or(VIEW_ANGLE);
    let parallel_scale = table.number("parallel_scale", super::FACTOR)?;
    if kind == Kind::Perspective && parallel_scale.is_some() {
        let what =
            "is for a parallel camera; expected view_angle, or projection = \"parallel\" too";
        return Err(table.error("parallel_scale", what));
    }
    let focal_point = table.numbers("focal_point", super::LENGTH, "[0, 0, 0]")?;

    let position = table.numbers("position", super::LENGTH, "[0, 0, 5]")?;
    let framed = match focal_point {
        Some(point) => bounds.seen_from_point(point.into()),
        None => bounds.clone(),
    };
    let mut camera = match position {
        Some(position) => Camera {
            position,
            focal_point: focal_point.unwrap_or_default(),
            view_up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { view_angle },
            clipping_range: [0.0; 2],
        },
        None => framing::frame(&framed, DVec3::Z, view_angle, aspect),
    };
    if kind == Kind::Parallel {
        let fits = || framing::parallel_scale(&framed, aspect);
        camera.projection = Projection::Parallel {
            parallel_scale: parallel_scale.unwrap_or_else(fits),
        };
    }
    if position.is_some() || parallel_scale.is_some() {
        shape.widen(&mut camera.projection);
    }
    if let Some(view_up) = table.numbers("view_up", super::LENGTH, "[0, 1, 0]")? {
        camera.view_up = view_up;
    }
    check_directions(table, &camera)?;
    for (key, quantity) in MOVES {
        if let Some(number) = move_number(table, key, quantity)? {
            camera = motion::moved(camera, quantity, [number; 3]);
        }
    }
    if let Projection::Perspective { view_angle } = camera.projection
        && !VIEW_ANGLES.contains(&view_angle)
    {
        let what = format!(
            "makes the view angle {view_angle} degrees; expected it to stay in {:?}",
            VIEW_ANGLES
        );
        return Err(table.error("zoom", what));
    }
    if let Some([right, up]) = pan(table)? {
        camera = motion::moved(camera, Quantity::Pan, [right, up, 0.0]);
    }
    check_directions(table, &camera)?;
    camera.clipping_range = match clipping_range(table, kind)? {
        Some(range) => range,
        None => range(&camera),
    };
    Ok(camera)
}

/// The camera's moves, in the order in which they are made; then [`pan`].
pub(super) const MOVES: [(&str, Quantity); 5] = [
    ("azimuth", Quantity::Azimuth),
    ("elevation", Quantity::Elevation),
    ("roll", Quantity::Roll),
    ("dolly", Quantity::Dolly),
    ("zoom", Quantity::Zoom),
];

/// How far a move goes: degrees, or a factor.
pub(super) fn move_number(
    table: &Table<'_, '_>,
    key: &str,
    quantity: Quantity,
) -> Result<Option<f64>, Error> {
    let range = match quantity {
        Quantity::Dolly | Quantity::Zoom | Quantity::Scale => super::SCALE,
        _ => -super::TURNS..=super::TURNS,
    };
    table.number(key, range)
}

/// How far the camera goes to the right and up.
pub(super) fn pan(table: &Table<'_, '_>) -> Result<Option<[f64; 2]>, Error> {
    table.numbers("pan", super::LENGTH, "[1, 0.5]")
}

/// The three directions of the view must exist.
fn check_directions(table: &Table<'_, '_>, camera: &Camera) -> Result<(), Error> {
    let sight = DVec3::from(camera.focal_point) - DVec3::from(camera.position);
    let up = DVec3::from(camera.view_up);
    // What the rounding of coordinates leaves of a direction is not one.
    let size = DVec3::from(camera.position).length() + DVec3::from(camera.focal_point).length();
    if sight.length() <= size * 1e-12 {
        let key = if table.has("focal_point") {
            "focal_point"
        } else {
            "position"
        };
        return Err(table.error(
            key,
            "position and focal_point are the same; expected e.g. position = [0, 0, 5], \
             focal_point = [0, 0, 0]",
        ));
    }
    let (sight, Some(up)) = (sight.normalize(), up.try_normalize()) else {
        return Err(table.error("view_up", "has length 0; expected e.g. view_up = [0, 1, 0]"));
    };
    if sight.cross(up).length() < 1e-6 {
        let key = if table.has("view_up") {
            "view_up"
        } else {
            "position"
        };
        return Err(table.error(
            key,
            "view_up is parallel to the line of sight; expected e.g. view_up = [0, 0, 1]",
        ));
    }
    Ok(())
}

fn clipping_range(table: &Table<'_, '_>, kind: Kind) -> Result<Option<[f64; 2]>, Error> {
    let example = "[0.1, 100]";
    let range = table.numbers::<2>("clipping_range", super::LENGTH, example)?;
    let Some([near, far]) = range else {
        return Ok(None);
    };
    let wrong = if near >= far {
        format!("near {near} is not less than far {far}")
    } else if kind == Kind::Perspective && near <= 0.0 {
        format!("near {near} is not greater than 0")
    } else {
        return Ok(range);
    };
    Err(table.error(
        "clipping_range",
        format!("{wrong}; expected [near, far], e.g. clipping_range = {example}"),
    ))
}
