//! Colours that a scene's surfaces have under its lights: samples spread over each
//! actor's faces, at a few moments of the animation, those that the camera may see.

use std::f64::consts::PI;

use fixel_scene::{Actor, Cull, Fog, Material, Projection, Scene, Shading};
use glam::{DMat3, DMat4, DVec3};

use super::choose::Sample;
use super::light::{Point, lit};
use crate::fog::{factor, fogged};

/// Samples of an actor, about so many.
const SAMPLES: f64 = 4096.0;
/// Moments of a turntable that are looked at.
const MOMENTS: u32 = 8;

/// Samples of all actors. The weights of an actor's are the area that it has in
/// scene units, and all together 1.
pub(super) fn samples(scene: &Scene) -> Vec<Sample> {
    let turns = scene.animation.turntable.map_or(1, |_| MOMENTS);
    let mut samples = Vec::new();
    for actor in &scene.actors {
        for step in 0..turns {
            let turn = 2.0 * PI * f64::from(step) / f64::from(turns);
            Surface::new(scene, actor, turn).sample(f64::from(turns), &mut samples);
        }
    }
    let sum: f64 = samples.iter().map(|sample| sample.weight).sum();
    for sample in &mut samples {
        sample.weight /= sum.max(f64::MIN_POSITIVE);
    }
    samples
}

/// An actor at a moment.
struct Surface<'a> {
    scene: &'a Scene,
    material: &'a Material,
    places: Vec<DVec3>,
    normals: Vec<DVec3>,
    triangles: Vec<[usize; 3]>,
    tints: &'a [[f64; 3]],
}

impl<'a> Surface<'a> {
    fn new(scene: &'a Scene, actor: &Actor, turn: f64) -> Self {
        let mesh = &scene.meshes[actor.mesh];
        let matrix = to_world(actor, turn);
        let linear = DMat3::from_mat4(matrix);
        let outward = linear.determinant() > 0.0;
        let turned = linear.inverse().transpose();
        let corners = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| i as usize);
            if outward { [a, b, c] } else { [a, c, b] }
        };
        let place = |p: &[f64; 3]| matrix.transform_point3((*p).into());
        let normal = |n: &[f64; 3]| (turned * DVec3::from(*n)).normalize_or_zero();
        Self {
            scene,
            material: &scene.materials[actor.material],
            places: mesh.positions.iter().map(place).collect(),
            normals: mesh.normals.iter().map(normal).collect(),
            triangles: mesh.triangles.iter().map(corners).collect(),
            tints: &mesh.colours,
        }
    }

    fn sample(&self, turns: f64, samples: &mut Vec<Sample>) {
        let areas: Vec<f64> = self
            .triangles
            .iter()
            .map(|t| self.cross(t).length())
            .collect();
        let total: f64 = areas.iter().sum();
        let each = total * turns / SAMPLES;
        let (mut due, mut number) = (0.0, 0);
        for (triangle, area) in self.triangles.iter().zip(areas) {
            if self.is_away(triangle) {
                continue;
            }
            due += area;
            while due > each / 2.0 && each > 0.0 {
                due -= each;
                number += 1;
                let weights = spread(number);
                let colour = self.colour(triangle, weights);
                let weight = each / turns;
                samples.push(Sample { colour, weight });
                // Fog is laid over palette entries: both colours are needed.
                if let Some(fog) = &self.scene.fog {
                    let colour = fogged(fog, colour, self.fog(fog, triangle, weights));
                    samples.push(Sample { colour, weight });
                }
            }
        }
    }

    /// Twice the area, along the normal.
    fn cross(&self, triangle: &[usize; 3]) -> DVec3 {
        let [a, b, c] = triangle.map(|i| self.places[i]);
        (b - a).cross(c - a)
    }

    /// Whether the camera sees a side of the face that is not drawn; in viewports,
    /// other cameras may see the other one.
    fn is_away(&self, triangle: &[usize; 3]) -> bool {
        if !self.scene.viewports.is_empty() {
            return false;
        }
        let towards = self.eye(self.places[triangle[0]]);
        let front = self.cross(triangle).dot(towards) > 0.0;
        match self.material.cull {
            Cull::Back => !front,
            Cull::Front => front,
            Cull::None => false,
        }
    }

    /// How much fog there is before a place on a face.
    fn fog(&self, fog: &Fog, triangle: &[usize; 3], weights: [f64; 3]) -> f64 {
        let camera = &self.scene.camera;
        let eye = DVec3::from(camera.position);
        let sight = (DVec3::from(camera.focal_point) - eye).normalize_or_zero();
        let [a, b, c] = triangle.map(|i| (self.places[i] - eye).dot(sight));
        factor(fog, a * weights[0] + b * weights[1] + c * weights[2])
    }

    /// Towards the eye.
    fn eye(&self, place: DVec3) -> DVec3 {
        let camera = &self.scene.camera;
        let (eye, focus) = (
            DVec3::from(camera.position),
            DVec3::from(camera.focal_point),
        );
        match camera.projection {
            Projection::Perspective { .. } => (eye - place).normalize_or_zero(),
            Projection::Parallel { .. } => (eye - focus).normalize_or_zero(),
        }
    }

    fn point(&self, index: usize) -> Point {
        Point {
            place: self.places[index],
            normal: self.normals[index],
            tint: self.tints.get(index).map_or(DVec3::ONE, |c| (*c).into()),
        }
    }

    /// The colour of a face where its corners have these weights.
    fn colour(&self, triangle: &[usize; 3], weights: [f64; 3]) -> [f64; 3] {
        let points = triangle.map(|i| self.point(i));
        let light = |point: &Point| lit(self.scene, self.material, point, self.eye(point.place));
        let colour = match self.material.shading {
            Shading::Flat => {
                let mut centre = Point::mix(&points, [1.0 / 3.0; 3]);
                centre.normal = self.cross(triangle).normalize_or_zero();
                light(&centre)
            }
            Shading::Gouraud => {
                let [a, b, c] = points.map(|point| light(&point));
                a * weights[0] + b * weights[1] + c * weights[2]
            }
            Shading::Phong => light(&Point::mix(&points, weights)),
        };
        colour.into()
    }
}

/// Weights of a triangle's corners, evenly spread as the number grows: Roberts, "The
/// unreasonable effectiveness of quasirandom sequences" (2018), folded.
fn spread(number: u32) -> [f64; 3] {
    let part = |step: f64| (0.5 + f64::from(number) * step).fract();
    let (mut u, mut v) = (part(0.754877666246693), part(0.569840290998053));
    if u + v > 1.0 {
        (u, v) = (1.0 - u, 1.0 - v);
    }
    [1.0 - u - v, u, v]
}

/// From the actor's mesh to the world, with so much more of a turn about y, in
/// radians.
fn to_world(actor: &Actor, turn: f64) -> DMat4 {
    let rotation = |axis: usize, angle: f64| {
        let (sin, cos) = libm::sincos(angle);
        let mut columns = [DVec3::X, DVec3::Y, DVec3::Z];
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        columns[i][i] = cos;
        columns[i][j] = sin;
        columns[j][i] = -sin;
        columns[j][j] = cos;
        DMat3::from_cols(columns[0], columns[1], columns[2])
    };
    let [x, y, z] = actor.orientation.map(f64::to_radians);
    let linear = rotation(2, z)
        * rotation(0, x)
        * rotation(1, y + turn)
        * DMat3::from_diagonal(actor.scale.into());
    let (position, origin) = (DVec3::from(actor.position), DVec3::from(actor.origin));
    DMat4::from_mat3_translation(linear, position + origin - linear * origin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_turned_about_y_then_x_then_z() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");
        let mut actor = fixel_scene::load(path.as_ref()).unwrap().actors.remove(0);
        actor.origin = [1.0, 0.0, 0.0];
        actor.position = [0.0, 10.0, 0.0];
        actor.scale = [1.0, 2.0, 3.0];
        actor.orientation = [90.0, 60.0, 90.0];
        // From the origin (0, 1, 1): scaled (0, 2, 3); about y by 60 and 30 degrees
        // (3, 2, 0); about x (3, 0, 2); about z (0, 3, 2).
        let found = to_world(&actor, PI / 6.0).transform_point3(DVec3::new(1.0, 1.0, 1.0));
        assert!(
            found.distance(DVec3::new(1.0, 13.0, 2.0)) < 1e-12,
            "{found}"
        );
    }

    #[test]
    fn samples_are_spread_evenly() {
        let mut quarters = [0; 4];
        for number in 1..=1000 {
            let weights = spread(number);
            assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(weights.iter().all(|weight| *weight >= 0.0));
            let near = weights.iter().position(|weight| *weight > 0.5);
            quarters[near.unwrap_or(3)] += 1;
        }
        assert!(
            quarters.iter().all(|count| (235..=265).contains(count)),
            "{quarters:?}"
        );
    }
}
