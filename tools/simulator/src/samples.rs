//! Scenes of the repository that come with the page.

/// A scene to begin with.
pub(crate) struct Sample {
    pub title: &'static str,
    pub path: &'static str,
    /// A scene of the same lit for black and white, if there is one.
    pub mono: Option<&'static str>,
}

const fn plain(title: &'static str, path: &'static str) -> Sample {
    Sample {
        title,
        path,
        mono: None,
    }
}

pub(crate) const SAMPLES: [Sample; 7] = [
    Sample {
        title: "Teapot",
        path: "scenes/teapot.toml",
        mono: Some("scenes/mono_teapot.toml"),
    },
    Sample {
        title: "Bunny",
        path: "scenes/bunny.toml",
        mono: Some("scenes/mono_bunny.toml"),
    },
    Sample {
        title: "Suzanne",
        path: "scenes/suzanne.toml",
        mono: Some("scenes/mono_suzanne.toml"),
    },
    plain("Textured house", "scenes/house.toml"),
    plain("Key frames", "scenes/keyframes.toml"),
    plain("Coloured lights", "scenes/lights.toml"),
    plain("Mirror and glass", "scenes/bench/r3_spheres_whitted.toml"),
];

macro_rules! files {
    ($($path:literal),* $(,)?) => {
        [$(($path, include_bytes!(concat!("../../../", $path)) as &[u8])),*]
    };
}

/// The samples' files.
pub(crate) const FILES: [(&str, &[u8]); 19] = files![
    "scenes/teapot.toml",
    "scenes/mono_teapot.toml",
    "scenes/bunny.toml",
    "scenes/mono_bunny.toml",
    "scenes/suzanne.toml",
    "scenes/mono_suzanne.toml",
    "scenes/house.toml",
    "scenes/keyframes.toml",
    "scenes/lights.toml",
    "scenes/bench/r3_spheres_whitted.toml",
    "scenes/meshes/teapot.obj",
    "scenes/meshes/bunny.obj",
    "scenes/meshes/suzanne.glb",
    "scenes/meshes/house.gltf",
    "scenes/meshes/cube.obj",
    "scenes/meshes/sphere.obj",
    "scenes/meshes/floor_grid.obj",
    "scenes/textures/bricks.png",
    "scenes/textures/tiles.png",
];
