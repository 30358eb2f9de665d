//! Files out of bytes: scenes, meshes and pictures are read, or refused with a message.

use std::path::Path;
use std::sync::LazyLock;

use fixel_scene::{InMemory, Loader};

/// Meshes of more triangles are read and not baked, so that many are.
const MOST_BAKED: usize = 40;

/// Endings of meshes, in the order in which an input's first byte chooses them.
const KINDS: [&str; 6] = ["obj", "gltf", "glb", "stl", "ply", "mtl"];

/// What scene files may name.
static FILES: LazyLock<InMemory> = LazyLock::new(|| {
    let mut files = InMemory::default();
    for name in ["meshes/cube.obj", "meshes/square_textured.obj"] {
        files.insert(Path::new(name), read(&format!("scenes/{name}")));
    }
    files.insert(
        Path::new("checker.png"),
        read("scenes/textures/checker.png"),
    );
    files
});

/// A mesh whose materials are in a library, which is not among them.
static POST: LazyLock<InMemory> = LazyLock::new(|| {
    let mut files = InMemory::default();
    files.insert(Path::new("post.obj"), read("tests/data/post.obj"));
    files.insert(Path::new("bricks.png"), read("scenes/textures/checker.png"));
    files
});

fn read(name: &str) -> Vec<u8> {
    let path = crate::root().join(name);
    std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// A scene file.
pub fn text(bytes: &[u8]) {
    let mut files = FILES.clone();
    files.insert(Path::new("scene.toml"), bytes.to_vec());
    load(&files, "scene.toml");
}

/// A mesh of the kind that the first byte says, or a library of materials.
pub fn mesh(bytes: &[u8]) {
    let Some((kind, bytes)) = bytes.split_first() else {
        return;
    };
    let kind = KINDS[usize::from(*kind) % KINDS.len()];
    if kind == "mtl" {
        let mut files = POST.clone();
        files.insert(Path::new("post.mtl"), bytes.to_vec());
        return load(&files, "post.obj");
    }
    let name = format!("mesh.{kind}");
    let mut files = InMemory::default();
    files.insert(Path::new(&name), bytes.to_vec());
    load(&files, &name);
}

/// A picture, as a texture.
pub fn picture(bytes: &[u8]) {
    const SCENE: &str = "[[material]]\nname = \"a\"\ntexture = \"picture.png\"\n\
        [[actor]]\nmesh = \"meshes/square_textured.obj\"\n";
    let mut files = FILES.clone();
    files.insert(Path::new("scene.toml"), SCENE.into());
    files.insert(Path::new("picture.png"), bytes.to_vec());
    if let Err(error) = Loader::new(&files).load(Path::new("scene.toml")) {
        assert!(error.to_string().contains(": "), "{error}");
    }
}

fn load(files: &InMemory, name: &str) {
    match Loader::new(files).load(Path::new(name)) {
        Ok((scene, _)) => {
            let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
            let textures: usize = scene.textures.len();
            if triangles <= MOST_BAKED && textures == 0 {
                let _ = fixel_bake::bake(&scene);
            }
        }
        // Which file, and what is wrong with it.
        Err(error) => assert!(error.to_string().contains(": "), "{error}"),
    }
}
