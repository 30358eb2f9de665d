//! Scenes made in code.
#![allow(clippy::missing_panics_doc, reason = "a test's panic is its failure")]

use crate::root;
use fixel_scene::{
    Actor, Attenuation, ColourFormat, Light, LightKind, Material, Mesh, Primitive, Scene, Shading,
};

/// Some scene of the repository, for its display and all else that is not said here.
pub fn empty() -> Scene {
    let path = root().join("scenes/ray/bunny_shadow.toml");
    let mut scene = fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    scene.actors.clear();
    scene.meshes.clear();
    scene.materials.clear();
    scene.animation = Default::default();
    scene.ray = Default::default();
    scene.display.colour = ColourFormat::Rgb888;
    (scene.display.width, scene.display.height) = (160, 120);
    scene
}

/// A ball or a rectangle of a scene of the repository, in another size.
fn primitive(wanted: Primitive) -> Mesh {
    let path = root().join("scenes/ray/ellipsoids.toml");
    let scene = fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    let factors = |mesh: &Mesh| match (mesh.primitive?, wanted) {
        (Primitive::Sphere { radius: own }, Primitive::Sphere { radius }) => {
            Some([radius / own; 3])
        }
        (Primitive::Rectangle { width: w, depth: d }, Primitive::Rectangle { width, depth }) => {
            Some([width / w, 1.0, depth / d])
        }
        _ => None,
    };
    let mut found = scene
        .meshes
        .iter()
        .filter_map(|mesh| Some((mesh, factors(mesh)?)));
    let (mesh, factors) = found.next().expect("it has both");
    let place = |p: &[f64; 3]| std::array::from_fn(|i| p[i] * factors[i]);
    Mesh {
        name: format!("{wanted:?}"),
        positions: mesh.positions.iter().map(place).collect(),
        primitive: Some(wanted),
        ..mesh.clone()
    }
}

/// A ball about the origin.
pub fn ball(radius: f64) -> Mesh {
    primitive(Primitive::Sphere { radius })
}

/// A rectangle that lies at the origin.
pub fn rectangle(width: f64, depth: f64) -> Mesh {
    primitive(Primitive::Rectangle { width, depth })
}

/// A box from -1/2 to 1/2.
pub fn cube() -> Mesh {
    mesh("cube")
}

/// A mesh of the repository.
pub fn mesh(name: &str) -> Mesh {
    let path = root().join(format!("scenes/meshes/{name}.obj"));
    fixel_scene::load_mesh(&path).unwrap_or_else(|e| panic!("{e}"))
}

/// Adds an actor; its material is the first one, grey if there is none.
pub fn add(scene: &mut Scene, mesh: Mesh, position: [f64; 3]) -> &mut Actor {
    let known = scene.meshes.iter().position(|m| *m == mesh);
    let mesh = known.unwrap_or_else(|| {
        scene.meshes.push(mesh);
        scene.meshes.len() - 1
    });
    let index = scene.actors.len();
    if scene.materials.is_empty() {
        scene.materials.push(Material {
            ambient: 0.1,
            shading: Shading::Phong,
            ..Material::default()
        });
    }
    scene.actors.push(Actor {
        name: format!("actor {index}"),
        mesh,
        position,
        ..Actor::default()
    });
    scene.actors.last_mut().expect("one was added")
}

/// Light from infinitely far.
pub fn far_light(direction: [f64; 3]) -> Light {
    Light {
        kind: LightKind::Directional { direction },
        colour: [1.0; 3],
        intensity: 0.8,
        edges: None,
    }
}

/// A lamp that is as bright at all distances.
pub fn lamp(position: [f64; 3]) -> Light {
    const EVEN: Attenuation = [1.0, 0.0, 0.0];
    Light {
        kind: LightKind::Point {
            position,
            attenuation: EVEN,
        },
        ..far_light([0.0, 0.0, 1.0])
    }
}

/// Xorshift; numbers from 0 to 1.
#[derive(Debug)]
pub struct Random(pub u64);

impl Random {
    /// The next one.
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number between two.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Three of them.
    pub fn place(&mut self, low: f64, high: f64) -> [f64; 3] {
        [0; 3].map(|_| self.between(low, high))
    }
}
