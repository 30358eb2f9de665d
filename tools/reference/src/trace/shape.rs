//! A line against a triangle, an ellipsoid or a flat parallelogram, in world space.

use crate::bvh::{Line, bounds};
use crate::ray::Ray;
use fixel_scene::Primitive;
use glam::{DAffine3, DVec3};

/// A shape in the world.
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    /// Corners, counter-clockwise seen from outside.
    Triangle([DVec3; 3]),
    /// A sphere or a rectangle, placed.
    Primitive(Box<Placed>),
}

/// A primitive in its actor's place.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    primitive: Primitive,
    to_world: DAffine3,
    to_model: DAffine3,
}

/// Where a line meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meeting {
    /// In units of the line's direction.
    pub t: f64,
    /// Of a triangle's corners; of a primitive, the place in its own space.
    pub at: [f64; 3],
}

impl Placed {
    pub fn new(primitive: Primitive, to_world: DAffine3) -> Self {
        Self {
            primitive,
            to_world,
            to_model: to_world.inverse(),
        }
    }
}

impl Shape {
    /// The box around it.
    pub fn bounds(&self) -> [DVec3; 2] {
        match self {
            Self::Triangle(corners) => bounds(*corners),
            Self::Primitive(placed) => {
                let rows = placed.to_world.matrix3.transpose();
                let rows = [rows.x_axis, rows.y_axis, rows.z_axis];
                let reach = match placed.primitive {
                    Primitive::Sphere { radius } => rows.map(|row| row.length() * radius),
                    Primitive::Rectangle { width, depth } => {
                        rows.map(|row| (row.x.abs() * width + row.z.abs() * depth) / 2.0)
                    }
                };
                let (centre, reach) = (placed.to_world.translation, DVec3::from(reach));
                [centre - reach, centre + reach]
            }
        }
    }

    /// Where the line meets it, nearest first: twice at most, anywhere along the line.
    /// `from_it`: the line begins on it, which is not a meeting.
    pub fn meet(&self, line: &Line, from_it: bool) -> [Option<Meeting>; 2] {
        match self {
            // What is flat is not met again.
            Self::Triangle(_) if from_it => [None; 2],
            Self::Triangle(corners) => [meet_triangle(line, *corners), None],
            Self::Primitive(placed) => {
                let own = Line {
                    origin: placed.to_model.transform_point3(line.origin),
                    direction: placed.to_model.transform_vector3(line.direction),
                };
                let meeting = |t: f64| Meeting {
                    t,
                    at: own.at(t).into(),
                };
                match placed.primitive {
                    Primitive::Sphere { radius } => {
                        meet_sphere(&own, radius, from_it).map(|t| t.map(meeting))
                    }
                    Primitive::Rectangle { .. } if from_it => [None; 2],
                    Primitive::Rectangle { width, depth } => {
                        let t = -own.origin.y / own.direction.y;
                        let place = own.at(t);
                        let inside = place.x.abs() <= width / 2.0 && place.z.abs() <= depth / 2.0;
                        [inside.then(|| meeting(t)), None]
                    }
                }
            }
        }
    }

    /// The outer normal, unit length, where a line has met it.
    pub fn normal(&self, at: [f64; 3]) -> DVec3 {
        match self {
            Self::Triangle([a, b, c]) => (*b - *a).cross(*c - *a).normalize_or_zero(),
            Self::Primitive(placed) => {
                let own = match placed.primitive {
                    Primitive::Sphere { .. } => DVec3::from(at),
                    Primitive::Rectangle { .. } => DVec3::Y,
                };
                (placed.to_model.matrix3.transpose() * own).normalize_or_zero()
            }
        }
    }

    /// Texture coordinates where a line has met a primitive that has them.
    pub fn coordinates(&self, [x, _, z]: [f64; 3]) -> Option<[f64; 2]> {
        match self {
            Self::Primitive(placed) => match placed.primitive {
                Primitive::Rectangle { width, depth } => Some([x / width + 0.5, 0.5 - z / depth]),
                Primitive::Sphere { .. } => None,
            },
            Self::Triangle(_) => None,
        }
    }
}

/// By the test for rays along the third axis, which the axis along which the line goes
/// fastest is made.
fn meet_triangle(line: &Line, corners: [DVec3; 3]) -> Option<Meeting> {
    let axis = line.direction.abs().max_position();
    let turned = |v: DVec3| DVec3::new(v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]);
    let (origin, direction) = (turned(line.origin), turned(line.direction));
    let slope = [direction.x / direction.z, direction.y / direction.z];
    // From the line's own origin, so that nothing is lost far from the world's.
    let ray = Ray {
        origin: [0.0; 2],
        slope,
    };
    let met = ray.meet(corners.map(|corner| turned(corner) - origin))?;
    Some(Meeting {
        t: met.w / direction.z,
        at: met.weights,
    })
}

/// By the place of closest approach, which keeps a grazing line's digits.
fn meet_sphere(line: &Line, radius: f64, from_it: bool) -> [Option<f64>; 2] {
    let square = line.direction.length_squared();
    let closest = -line.origin.dot(line.direction) / square;
    if from_it {
        return [Some(2.0 * closest), None];
    }
    let inside = radius * radius - line.at(closest).length_squared();
    if inside < 0.0 {
        return [None; 2];
    }
    let half = (inside / square).sqrt();
    [Some(closest - half), Some(closest + half)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Line = Line {
        origin: DVec3::new(0.0, -5.0, 0.0),
        direction: DVec3::Y,
    };

    fn sphere(to_world: DAffine3) -> Shape {
        Shape::Primitive(Box::new(Placed::new(
            Primitive::Sphere { radius: 2.0 },
            to_world,
        )))
    }

    fn ts(shape: &Shape, line: &Line) -> [Option<f64>; 2] {
        shape.meet(line, false).map(|met| met.map(|met| met.t))
    }

    #[test]
    fn a_sphere_is_met_twice_once_or_not() {
        let ball = sphere(DAffine3::IDENTITY);
        assert_eq!(ts(&ball, &UP), [Some(3.0), Some(7.0)]);
        let beside = |x: f64| Line {
            origin: DVec3::new(x, -5.0, 0.0),
            direction: DVec3::Y * 2.0,
        };
        // Tangent: both meetings are one.
        assert_eq!(ts(&ball, &beside(2.0)), [Some(2.5), Some(2.5)]);
        assert_eq!(ts(&ball, &beside(2.0 + 1e-12)), [None; 2]);
        // From inside, behind; and from its own surface.
        let middle = Line {
            origin: DVec3::Y,
            ..UP
        };
        assert_eq!(ts(&ball, &middle), [Some(-3.0), Some(1.0)]);
        let surface = Line {
            origin: DVec3::Y * -2.0,
            ..UP
        };
        let again = ball.meet(&surface, true).map(|met| met.map(|met| met.t));
        assert_eq!(again, [Some(4.0), None]);
    }

    #[test]
    fn an_ellipsoid_has_its_own_normals() {
        // Half axes 6, 2, 2, its middle at x = 1.
        let placed =
            DAffine3::from_translation(DVec3::X) * DAffine3::from_scale(DVec3::new(3.0, 1.0, 1.0));
        let shape = sphere(placed);
        assert_eq!(ts(&shape, &UP).map(|t| t.is_some()), [true; 2]);
        let met = shape.meet(&UP, false)[0].unwrap();
        let at = UP.at(met.t) - DVec3::X;
        assert!((at.x * at.x / 36.0 + at.y * at.y / 4.0 - 1.0).abs() < 1e-12);
        // The gradient of the same.
        let wanted = DVec3::new(at.x / 36.0, at.y / 4.0, 0.0).normalize();
        assert!(shape.normal(met.at).distance(wanted) < 1e-12);
        let [low, high] = shape.bounds();
        assert_eq!(
            (low, high),
            (DVec3::new(-5.0, -2.0, -2.0), DVec3::new(7.0, 2.0, 2.0))
        );
    }

    #[test]
    fn a_rectangle_has_edges_and_coordinates() {
        let primitive = Primitive::Rectangle {
            width: 4.0,
            depth: 2.0,
        };
        let shape = Shape::Primitive(Box::new(Placed::new(primitive, DAffine3::IDENTITY)));
        let through = |x: f64, z: f64| {
            let line = Line {
                origin: DVec3::new(x, -5.0, z),
                direction: DVec3::Y,
            };
            shape.meet(&line, false)[0]
        };
        assert!(through(2.01, 0.0).is_none() && through(0.0, -1.01).is_none());
        let met = through(-2.0, 1.0).unwrap();
        assert_eq!((met.t, shape.coordinates(met.at)), (5.0, Some([0.0, 0.0])));
        assert_eq!(
            shape.coordinates(through(1.0, -0.5).unwrap().at),
            Some([0.75, 0.75])
        );
        assert_eq!(shape.normal(met.at), DVec3::Y);
        // Seen along its plane it is not there.
        let along = Line {
            origin: DVec3::new(-9.0, 0.0, 0.0),
            direction: DVec3::X,
        };
        assert_eq!(shape.meet(&along, false), [None; 2]);
    }

    #[test]
    fn a_triangle_is_met_from_any_side() {
        let corners = [
            DVec3::ZERO,
            DVec3::new(2.0, 0.0, 0.0),
            DVec3::new(0.0, 0.0, -2.0),
        ];
        let shape = Shape::Triangle(corners);
        for (origin, direction) in [
            (DVec3::new(0.5, -5.0, -0.5), DVec3::Y),
            (DVec3::new(0.5, 5.0, -0.5), -DVec3::Y),
            (DVec3::new(-4.5, 5.0, -0.5), DVec3::new(1.0, -1.0, 0.0)),
        ] {
            let met = shape.meet(&Line { origin, direction }, false)[0].unwrap();
            assert_eq!(
                met,
                Meeting {
                    t: 5.0,
                    at: [0.5, 0.25, 0.25]
                }
            );
        }
        assert_eq!(shape.normal([0.0; 3]), DVec3::Y);
    }
}
