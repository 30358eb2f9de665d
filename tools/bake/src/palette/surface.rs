//! Colours that a scene's surfaces have under its lights: samples spread over each
//! actor's faces, at a few moments of the animation, those that the camera may see.

use std::f64::consts::PI;

use fixel_scene::{Actor, Cull, Fog, Material, Projection, Scene, Shading, Texturing, Wrap};
use glam::{DMat3, DMat4, DVec2, DVec3};

use super::choose::Sample;
use super::light::{Lit, Point, lit};
use crate::fog::{factor, fogged};

/// Samples of a whole picture, about so many.
const SAMPLES: f64 = 8192.0;
/// A face is halved so often at most.
const DEEPEST: u32 = 24;
/// What is out of the picture counts so much less: the camera may turn.
const OUTSIDE: f64 = 1.0 / 32.0;
/// Moments of a turntable that are looked at.
const MOMENTS: u32 = 8;

/// Samples of all actors. Their weights are as large as they look to the camera (what
/// is before them left aside), and all together 1.
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
    coordinates: &'a [[f64; 2]],
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
            coordinates: &mesh.texture_coordinates,
        }
    }

    /// Cuts faces until each part looks small, and takes one sample of each.
    fn sample(&self, turns: f64, samples: &mut Vec<Sample>) {
        let window = Window::new(self.scene);
        let small = window.size() * turns / SAMPLES;
        for triangle in &self.triangles {
            if self.is_away(triangle) {
                continue;
            }
            let mut parts = vec![([DVec3::X, DVec3::Y, DVec3::Z], 0)];
            while let Some((corners, depth)) = parts.pop() {
                let places = corners.map(|weights| self.at(triangle, weights));
                let (most, size) = window.apparent(places);
                if most > small && depth < DEEPEST {
                    parts.extend(halves(corners, places).map(|half| (half, depth + 1)));
                    continue;
                }
                if size <= 0.0 {
                    continue;
                }
                let middle = ((corners[0] + corners[1] + corners[2]) / 3.0).to_array();
                let colour = self.colour(triangle, middle);
                let weight = size / turns;
                samples.push(Sample { colour, weight });
                // Fog is laid over palette entries: both colours are needed.
                if let Some(fog) = &self.scene.fog {
                    let colour = fogged(fog, colour, self.fog(fog, triangle, middle));
                    samples.push(Sample { colour, weight });
                }
            }
        }
    }

    /// The place where a face's corners have these weights.
    fn at(&self, triangle: &[usize; 3], weights: DVec3) -> DVec3 {
        let [a, b, c] = triangle.map(|i| self.places[i]);
        a * weights.x + b * weights.y + c * weights.z
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
            coordinates: self
                .coordinates
                .get(index)
                .map_or(DVec2::ZERO, |c| (*c).into()),
        }
    }

    /// The colour of a face where its corners have these weights.
    fn colour(&self, triangle: &[usize; 3], weights: [f64; 3]) -> [f64; 3] {
        let points = triangle.map(|i| self.point(i));
        let here = Point::mix(&points, weights);
        let texture = self.material.texture;
        let light = |point: &Point| {
            let eye = self.eye(point.place);
            lit(self.scene, self.material, point, eye).clamped(texture.is_some())
        };
        let lit = match self.material.shading {
            Shading::Flat => {
                let mut centre = Point::mix(&points, [1.0 / 3.0; 3]);
                centre.normal = self.cross(triangle).normalize_or_zero();
                light(&centre)
            }
            Shading::Gouraud => Lit::mix(points.map(|point| light(&point)), weights),
            Shading::Phong => light(&here),
        };
        let texel = texture.map_or(DVec3::ONE, |how| self.texel(&how, here.coordinates));
        (texel * lit.own + lit.gloss)
            .clamp(DVec3::ZERO, DVec3::ONE)
            .into()
    }

    /// The texel around a place.
    fn texel(&self, how: &Texturing, place: DVec2) -> DVec3 {
        let texture = &self.scene.textures[how.texture];
        let at = |place: f64, size: u32| {
            let size = i64::from(size);
            let i = (place * size as f64).floor() as i64;
            let within = match how.wrap {
                Wrap::Clamp => i.clamp(0, size - 1),
                Wrap::Repeat => i.rem_euclid(size),
                Wrap::Mirror => {
                    let i = i.rem_euclid(2 * size);
                    i.min(2 * size - 1 - i)
                }
            };
            within as usize
        };
        let (x, y) = (
            at(place.x, texture.width),
            at(1.0 - place.y, texture.height),
        );
        let [red, green, blue, _] = texture.texels[y * texture.width as usize + x];
        DVec3::from([red, green, blue].map(|c| f64::from(c) / 255.0))
    }
}

/// A triangle's halves, cut through the middle of its longest side.
fn halves(corners: [DVec3; 3], places: [DVec3; 3]) -> [[DVec3; 3]; 2] {
    let side = |i: usize| places[i].distance_squared(places[(i + 1) % 3]);
    let longest = (1..3).fold(0, |m, i| if side(i) > side(m) { i } else { m });
    let [a, b, c] = [0, 1, 2].map(|i| corners[(longest + i) % 3]);
    let middle = (a + b) / 2.0;
    [[a, middle, c], [middle, b, c]]
}

/// The camera's picture.
struct Window {
    eye: DVec3,
    /// Right, up and forward.
    axes: [DVec3; 3],
    /// Half of its width and height: at distance 1 in perspective.
    half: [f64; 2],
    near: f64,
    perspective: bool,
}

impl Window {
    fn new(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let eye = DVec3::from(camera.position);
        let forward = (DVec3::from(camera.focal_point) - eye).normalize_or_zero();
        let right = forward.cross(camera.view_up.into()).normalize_or_zero();
        let (perspective, half) = match camera.projection {
            Projection::Perspective { view_angle } => {
                (true, libm::tan(view_angle.to_radians() / 2.0))
            }
            Projection::Parallel { parallel_scale } => (false, parallel_scale),
        };
        let aspect = f64::from(scene.display.width) / f64::from(scene.display.height);
        Self {
            eye,
            axes: [right, right.cross(forward), forward],
            half: [half * aspect, half],
            near: camera.clipping_range[0],
            perspective,
        }
    }

    fn size(&self) -> f64 {
        4.0 * self.half[0] * self.half[1]
    }

    /// How large a triangle looks: at most, where it is nearest, and from its middle.
    fn apparent(&self, places: [DVec3; 3]) -> (f64, f64) {
        let [a, b, c] = places;
        let area = (b - a).cross(c - a) / 2.0;
        let middle = (a + b + c) / 3.0 - self.eye;
        let [x, y, depth] = self.axes.map(|axis| axis.dot(middle));
        let reach = places.map(|p| p.distance(middle + self.eye));
        let reach = reach.into_iter().fold(0.0, f64::max);
        if depth + reach < self.near {
            return (0.0, 0.0);
        }
        let [width, height] = self.half;
        if !self.perspective {
            let size = area.dot(self.axes[2]).abs();
            let inside = x.abs() < width && y.abs() < height;
            return (size, if inside { size } else { size * OUTSIDE });
        }
        let distance = middle.length().max(self.near);
        let nearest = (distance - reach).max(self.near);
        let size = area.dot(middle / distance).abs() / (distance * distance);
        let inside = depth > 0.0 && x.abs() < width * depth && y.abs() < height * depth;
        // What is beside the picture need not be cut so finely.
        let beside =
            x.abs() - reach > width * (depth + reach) || y.abs() - reach > height * (depth + reach);
        let most = if beside {
            0.0
        } else {
            area.length() / (nearest * nearest)
        };
        (most, if inside { size } else { size * OUTSIDE })
    }
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
    fn weights_are_what_is_seen() {
        // A square of 2 by 2 that fills a quarter of a picture of 4 by 4.
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");
        let mut scene = fixel_scene::load(path.as_ref()).unwrap();
        (scene.display.width, scene.display.height) = (100, 100);
        scene.camera.position = [0.0, 0.0, 10.0];
        scene.camera.focal_point = [0.0; 3];
        scene.camera.view_up = [0.0, 1.0, 0.0];
        scene.camera.projection = Projection::Parallel {
            parallel_scale: 2.0,
        };
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let [a, b, c, d] = square.map(|[x, y]| DVec3::new(x, y, 0.0));
        let window = Window::new(&scene);
        let size = window.apparent([a, b, c]).1 + window.apparent([a, c, d]).1;
        assert!((size / window.size() - 0.25).abs() < 1e-12);
        // Seen along its plane it has no size; far off the picture, little.
        let turned = [a, b, c].map(|p| DVec3::new(p.x, 0.0, p.y));
        assert!(window.apparent(turned).1 < 1e-12);
        let off = [a, b, c].map(|p| p + DVec3::X * 10.0);
        assert!((window.apparent(off).1 - 2.0 * OUTSIDE).abs() < 1e-12);
    }
}
