//! Where everything gets that a camera may have to see.

use glam::DVec3;

use crate::description::{Camera, Scene, Target};
use crate::framing::{Bounds, clipping_range_of};
use crate::motion::{cameras, tracks};

/// How far everything gets in all frames.
#[derive(Clone, Debug)]
pub struct Reach {
    /// Centre and radius of a sphere around each actor.
    pub actors: Vec<([f64; 3], f64)>,
    /// Where the eye is; and what it looks at, if key frames move it.
    pub views: Vec<[f64; 3]>,
}

impl Reach {
    /// Of a scene.
    pub fn of(scene: &Scene) -> Self {
        let bounds = Bounds::of(&scene.actors, &scene.meshes, &scene.animation);
        let sphere = |(centre, radius): &(DVec3, f64)| (centre.to_array(), *radius);
        let own = scene.viewports.iter().enumerate();
        let own = own.filter_map(|(number, viewport)| {
            Some((Target::Viewport(number), viewport.camera.as_ref()?))
        });
        let mut views = Vec::new();
        for (target, camera) in [(Target::Camera, &scene.camera)].into_iter().chain(own) {
            views.push(camera.position);
            if tracks(&scene.animation, target).next().is_some() {
                let cameras = cameras(camera, &scene.animation, target);
                let both = |camera: Camera| [camera.position, camera.focal_point];
                views.push(camera.focal_point);
                views.extend(cameras.into_iter().flat_map(both));
            }
        }
        Self {
            actors: bounds.spheres().iter().map(sphere).collect(),
            views,
        }
    }

    /// A clipping range for a camera that somebody moves by hand: before and behind
    /// all that moves, as one is made for a scene file that has none.
    pub fn clipping_range(&self, camera: &Camera) -> [f64; 2] {
        let spheres = self
            .actors
            .iter()
            .map(|(centre, r)| (DVec3::from(*centre), *r));
        clipping_range_of(&[*camera], spheres)
    }
}
