//! Colours that a scene's surfaces have under its lights: samples spread over each
//! actor's faces, at a few moments of the animation, those that a camera may see.

use fixel_scene::{
    Actor, Aspect, Background, Camera, Cull, Fog, Material, Moment, Representation, Scene, Shading,
    Texturing, Viewport,
};
use glam::{DMat3, DMat4, DVec2, DVec3};

use super::background_colours;
use super::choose::Sample;
use super::light::{Lit, Point, lit};
use super::through::{Piece, seen};
use super::window::Window;
use crate::fog::{factor, fogged};
use crate::picture::Picture;
use crate::transparency::blended;

/// Samples of a whole picture, about so many.
const SAMPLES: f64 = 8192.0;
/// A face is halved so often at most.
const DEEPEST: u32 = 24;
/// How much of a picture an actor's lines or points are taken to cover.
const LINES: f64 = 1.0 / 64.0;
/// Vertices of lines and points that are looked at, at most.
const VERTICES: usize = 256;
/// Vertices that are looked at for the most light, at most.
const BRIGHTEST: usize = 1024;
/// Moments of an animation that are looked at.
const MOMENTS: usize = 8;

/// Samples of all actors. Their weights are as large as they look to the camera (what
/// is before them left aside), and all together 1.
pub(super) fn samples(scene: &Scene) -> Vec<Sample> {
    let moments = Moment::some(scene, MOMENTS);
    let copies = |material: &Material| material.texture.map(|how| Picture::copies(scene, &how));
    let copies: Vec<Vec<Picture>> = (scene.materials.iter())
        .map(|material| copies(material).unwrap_or_default())
        .collect();
    let mut samples = Vec::new();
    for moment in &moments {
        let windows = windows(scene, moment);
        for (window, share, height, background) in windows {
            let share = share / moments.len() as f64;
            let mut pieces = Vec::new();
            let actors = scene.actors.iter().zip(&moment.actors);
            for (number, (actor, matrix)) in actors.enumerate() {
                let matrix = DMat4::from_cols_array_2d(matrix);
                let mut surface = Surface::new(scene, actor, matrix, window);
                surface.copies = &copies[actor.material];
                surface.height = height;
                if actor.look.representation == Representation::Surface {
                    surface.sample(share, number, &mut pieces);
                } else {
                    surface.sample_vertices(share, &mut samples);
                }
            }
            samples.extend(seen(pieces, &background_colours(background)));
        }
    }
    let sum: f64 = samples.iter().map(|sample| sample.weight).sum();
    for sample in &mut samples {
        sample.weight /= sum.max(f64::MIN_POSITIVE);
    }
    samples
}

/// The most light, 1 being full, that a material gets where a camera may see it: as if
/// its colours were white, of the brightest channel.
pub(super) fn brightest(scene: &Scene, material: usize) -> f64 {
    let white = Material {
        ambient_colour: [1.0; 3],
        diffuse_colour: [1.0; 3],
        specular_colour: [1.0; 3],
        ..scene.materials[material].clone()
    };
    let mut most = 0.0;
    for moment in Moment::some(scene, MOMENTS) {
        for (window, ..) in windows(scene, &moment) {
            for (actor, matrix) in scene.actors.iter().zip(&moment.actors) {
                if actor.material != material {
                    continue;
                }
                let matrix = DMat4::from_cols_array_2d(matrix);
                let mut surface = Surface::new(scene, actor, matrix, window);
                surface.material = &white;
                most = surface.brightest().max(most);
            }
        }
    }
    most
}

/// What the cameras see, of each viewport or of the whole picture, how much of the
/// picture that is, how many pixels high, and what is behind everything.
fn windows<'a>(scene: &'a Scene, moment: &Moment) -> Vec<(Window, f64, f64, &'a Background)> {
    let pixels = f64::from(scene.display.height);
    let whole = f64::from(scene.display.width) / f64::from(scene.display.height);
    let all = &scene.display.background;
    let window = |(viewport, own): (&'a Viewport, &Option<Camera>)| {
        let [_, _, width, height] = viewport.rectangle;
        let aspect = match viewport.aspect {
            Aspect::Keep => whole * width / height,
            Aspect::Stretch => whole,
        };
        let window = Window::new(own.as_ref().unwrap_or(&moment.camera), aspect);
        let background = viewport.background.as_ref().unwrap_or(all);
        (window, width * height, pixels * height, background)
    };
    if scene.viewports.is_empty() {
        vec![(Window::new(&moment.camera, whole), 1.0, pixels, all)]
    } else {
        let viewports = scene.viewports.iter().zip(&moment.viewports);
        viewports.map(window).collect()
    }
}

/// An actor at a moment, seen by a camera.
struct Surface<'a> {
    scene: &'a Scene,
    window: Window,
    material: &'a Material,
    places: Vec<DVec3>,
    normals: Vec<DVec3>,
    triangles: Vec<[usize; 3]>,
    tints: &'a [[f64; 3]],
    coordinates: &'a [[f64; 2]],
    /// The material's texture and its smaller copies, if it has one and they matter.
    copies: &'a [Picture],
    /// Of the whole picture, in pixels.
    height: f64,
}

impl<'a> Surface<'a> {
    fn new(scene: &'a Scene, actor: &Actor, matrix: DMat4, window: Window) -> Self {
        let mesh = &scene.meshes[actor.mesh];
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
            window,
            material: &scene.materials[actor.material],
            places: mesh.positions.iter().map(place).collect(),
            normals: mesh.normals.iter().map(normal).collect(),
            triangles: mesh.triangles.iter().map(corners).collect(),
            tints: &mesh.colours,
            coordinates: &mesh.texture_coordinates,
            copies: &[],
            height: 1.0,
        }
    }

    /// Cuts faces until each part looks small, and takes one sample of each.
    /// `share`: how much of all that is looked at this is. `layer`: which actor's.
    fn sample(&self, share: f64, layer: usize, samples: &mut Vec<Piece>) {
        let small = self.window.size() / (SAMPLES * share);
        for triangle in &self.triangles {
            if self.is_away(triangle) {
                continue;
            }
            let mut pieces = vec![([DVec3::X, DVec3::Y, DVec3::Z], 0)];
            while let Some((corners, depth)) = pieces.pop() {
                let places = corners.map(|weights| self.at(triangle, weights));
                let (most, size) = self.window.apparent(places);
                if most > small && depth < DEEPEST {
                    pieces.extend(halves(corners, places).map(|half| (half, depth + 1)));
                    continue;
                }
                if size <= 0.0 {
                    continue;
                }
                let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
                let colour = self.colour(triangle, middle.to_array());
                let weight = size / self.window.size() * share;
                let place = self.at(triangle, middle);
                let piece = |colour| Piece {
                    sample: Sample { colour, weight },
                    place: self.window.in_picture(place),
                    distance: self.window.depth(place),
                    layer,
                    opacity: if blended(self.material) {
                        self.material.opacity
                    } else {
                        1.0
                    },
                };
                samples.push(piece(colour));
                // Fog is laid over palette entries: both colours are needed.
                if let Some(fog) = &self.scene.fog {
                    let colour = fogged(fog, colour, self.fog(fog, triangle, middle));
                    samples.push(piece(colour));
                }
            }
        }
    }

    /// Takes samples at vertices, where lines and points are lit.
    fn sample_vertices(&self, share: f64, samples: &mut Vec<Sample>) {
        let step = self.places.len().div_ceil(VERTICES).max(1);
        let count = self.places.len().div_ceil(step).max(1);
        for index in (0..self.places.len()).step_by(step) {
            let point = self.point(index);
            let eye = self.window.towards_eye(point.place);
            let lit = lit(self.scene, self.material, &point, eye).clamped(false);
            samples.push(Sample {
                colour: lit.own.into(),
                weight: LINES * share / count as f64,
            });
        }
    }

    /// The most light at a vertex on this side.
    fn brightest(&self) -> f64 {
        let step = self.places.len().div_ceil(BRIGHTEST).max(1);
        let light = |index: usize| {
            let point = self.point(index);
            let eye = self.window.towards_eye(point.place);
            let side = point.normal.dot(eye);
            let away = match self.material.cull {
                Cull::Back => side < 0.0,
                Cull::Front => side > 0.0,
                Cull::None => false,
            };
            if away {
                return 0.0;
            }
            let lit = lit(self.scene, self.material, &point, eye);
            (lit.own + lit.gloss).max_element()
        };
        (0..self.places.len())
            .step_by(step)
            .map(light)
            .fold(0.0, f64::max)
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

    /// Whether the camera sees a side of the face that is not drawn.
    fn is_away(&self, triangle: &[usize; 3]) -> bool {
        let towards = self.window.towards_eye(self.places[triangle[0]]);
        let front = self.cross(triangle).dot(towards) > 0.0;
        match self.material.cull {
            Cull::Back => !front,
            Cull::Front => front,
            Cull::None => false,
        }
    }

    /// How much fog there is before a place on a face.
    fn fog(&self, fog: &Fog, triangle: &[usize; 3], weights: DVec3) -> f64 {
        factor(fog, self.window.depth(self.at(triangle, weights)))
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
            let eye = self.window.towards_eye(point.place);
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
        let texel = texture.map_or(DVec3::ONE, |how| self.texel(&how, triangle, weights.into()));
        (texel * lit.own + lit.gloss)
            .clamp(DVec3::ZERO, DVec3::ONE)
            .into()
    }

    /// What is seen of the texture where a face's corners have these weights.
    fn texel(&self, how: &Texturing, triangle: &[usize; 3], weights: DVec3) -> DVec3 {
        let coordinates = |weights: DVec3| {
            let [a, b, c] = triangle.map(|i| self.point(i).coordinates);
            a * weights.x + b * weights.y + c * weights.z
        };
        let here = coordinates(weights);
        let number = self.next_to(triangle, weights).map(|next| {
            let size = DVec2::new(self.copies[0].width as f64, self.copies[0].height as f64);
            let steps = next.map(|weights| ((coordinates(weights) - here) * size).abs());
            let most = steps[0].max(steps[1]).max_element();
            (most.log2() + 0.5).floor().max(0.0) as usize
        });
        let last = self.copies.len() - 1;
        self.copies[number.unwrap_or(last).min(last)].seen(how, here)
    }

    /// The corners' weights one pixel to the right and one pixel below.
    fn next_to(&self, triangle: &[usize; 3], weights: DVec3) -> Option<[DVec3; 2]> {
        let normal = self.cross(triangle);
        let place = self.at(triangle, weights);
        let next = self.window.next_to(place, normal, self.height)?;
        let [a, b, c] = triangle.map(|i| self.places[i]);
        let part = |p: DVec3, q: DVec3| p.cross(q).dot(normal) / normal.length_squared();
        Some(next.map(|p| DVec3::new(part(b - p, c - p), part(c - p, a - p), part(a - p, b - p))))
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
