//! Every scene and mesh in `scenes/` loads, and the bench's hold what they
//! promise.

use std::path::{Path, PathBuf};

use fixel_scene::{Scene, Shading, load, load_mesh};

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file() && path.extension().is_some_and(|e| e != "md"))
        .collect();
    files.sort();
    files
}

fn scene(name: &str) -> Scene {
    load(&scenes().join(name)).unwrap()
}

#[test]
fn all_load_and_keep_the_promises_of_a_scene() {
    let folders = ["", "bench", "ray", "meshes"].map(|folder| files(&scenes().join(folder)));
    let all = folders.concat();
    assert!(all.len() > 25, "{all:?}");
    for path in all {
        let scene = load(&path).unwrap_or_else(|error| panic!("{error}"));
        let [near, far] = scene.camera.clipping_range;
        assert!(0.0 < near && near < far, "{path:?}");
        for actor in &scene.actors {
            assert!(actor.mesh < scene.meshes.len() && actor.material < scene.materials.len());
        }
        for mesh in &scene.meshes {
            assert_eq!(mesh.positions.len(), mesh.normals.len());
            let count = mesh.positions.len() as u32;
            assert!(mesh.triangles.iter().flatten().all(|index| *index < count));
            for [x, y, z] in &mesh.normals {
                assert!(((x * x + y * y + z * z).sqrt() - 1.0).abs() < 1e-12);
            }
        }
    }
}

/// Meshes that are closed, or nearly so, hold their volume on the inside of
/// the winding.
#[test]
fn winding_is_outward() {
    for (name, triangles) in [
        ("teapot.obj", 992),
        ("bunny.obj", 3674),
        ("suzanne.glb", 14_842),
        ("cube.obj", 12),
        ("sphere.obj", 960),
    ] {
        let mesh = load_mesh(&scenes().join("meshes").join(name)).unwrap();
        assert_eq!(mesh.triangles.len(), triangles, "{name}");
        let volume: f64 = mesh
            .triangles
            .iter()
            .map(|triangle| {
                let [a, b, c] = triangle.map(|index| mesh.positions[index as usize]);
                a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            })
            .sum();
        assert!(volume > 0.0, "{name}");
    }
}

#[test]
fn the_bench_is_as_its_targets_say() {
    for (name, shading, size) in [
        ("w1_teapot_flat", Shading::Flat, (320, 240)),
        ("w2_teapot_gouraud", Shading::Gouraud, (320, 240)),
        ("w3_bunny_gouraud", Shading::Gouraud, (320, 240)),
        ("w4_cube_textured", Shading::Flat, (320, 240)),
        ("w6_bunny_64x64", Shading::Gouraud, (64, 64)),
    ] {
        let scene = scene(&format!("bench/{name}.toml"));
        assert_eq!((scene.display.width, scene.display.height), size, "{name}");
        assert_eq!(scene.animation.turntable, Some(32), "{name}");
        assert_eq!(scene.actors[0].orientation, [22.5, 0.0, 0.0], "{name}");
        let material = &scene.materials[0];
        assert_eq!((material.ambient, material.diffuse), (0.15, 0.85), "{name}");
        assert_eq!(material.shading, shading, "{name}");
        assert_eq!(scene.lights.len(), 1, "{name}");
    }
    assert_eq!(scene("bench/w5_fill.toml").meshes[0].triangles.len(), 20);
}

#[test]
fn extensions_may_be_in_upper_case() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join("CUBE.OBJ");
    std::fs::copy(scenes().join("meshes/cube.obj"), &path).unwrap();
    assert_eq!(load(&path).unwrap().meshes[0].positions.len(), 24);
}

#[test]
fn a_missing_file_or_a_strange_one_is_refused() {
    let message = |name: &str| load(Path::new(name)).unwrap_err().to_string();
    assert_eq!(message("no/such.toml"), "no/such.toml: does not exist");
    assert_eq!(message("no/such.ob"), "no/such.ob: does not exist");
    let picture = scenes().join("textures/leaf.png");
    let picture = picture.to_str().unwrap();
    assert_eq!(
        message(picture),
        format!(
            "{picture}: is not a kind of file that can be read; \
             expected one of .toml, .obj, .glb, .gltf, .stl, .ply"
        )
    );
}
