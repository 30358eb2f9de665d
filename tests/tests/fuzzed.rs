//! What fuzzers run, with bytes that they have found to break something (tests/data/fuzz)
//! and with some that are as good as any: no panic, no overflow, no byte that depends on
//! bands, no pixel away from where the reference has one.

use std::fs;

use fixel_tests::fuzz::{arithmetic, blob, calls, mesh, panels, picture, scene, text};
use fixel_tests::made::Random;
use fixel_tests::root;

/// Runs what was found by the fuzzer of that name.
fn found(name: &str, run: impl Fn(&[u8])) {
    let folder = root().join("tests/data/fuzz").join(name);
    let Ok(files) = fs::read_dir(&folder) else {
        return;
    };
    for file in files {
        let path = file.expect("an entry").path();
        eprintln!("{}", path.display());
        run(&fs::read(&path).expect("a file that was found"));
    }
}

/// Runs some bytes.
fn random(seed: u64, count: usize, run: impl Fn(&[u8])) {
    let mut random = Random(seed);
    for _ in 0..count {
        let length = 40 + (random.next() * 400.0) as usize;
        let bytes: Vec<u8> = (0..length).map(|_| (random.next() * 256.0) as u8).collect();
        run(&bytes);
    }
}

#[test]
fn blobs() {
    found("blob", blob);
    // One byte changed, of a scene with everything.
    for name in ["small", "moving", "lines", "panes", "rays"] {
        let path = root().join(format!("tests/data/{name}.toml"));
        let (_, baked) = if name == "rays" {
            fixel_tests::load_for_rays(&path)
        } else {
            fixel_tests::load(&path)
        };
        let mut bytes = baked.bytes().to_vec();
        let mut random = Random(7);
        for _ in 0..300 {
            let at = (random.next() * bytes.len() as f64) as usize;
            let before = bytes[at];
            bytes[at] = (random.next() * 256.0) as u8;
            blob(&bytes);
            bytes[at] = before;
        }
    }
}

#[test]
fn calls_with_anything() {
    found("calls", calls);
    random(3, 2000, calls);
}

#[test]
fn arithmetic_of_anything() {
    found("arithmetic", arithmetic);
    random(11, 40_000, arithmetic);
}

#[test]
fn panels_of_anything() {
    found("panels", panels);
    random(13, 40_000, panels);
}

#[test]
fn scenes_of_anything() {
    found("scene", scene);
    random(5, 150, scene);
}

/// Files of the repository with some bytes changed.
fn changed(files: &[&str], count: usize, run: impl Fn(&str, &[u8])) {
    let mut random = Random(9);
    for file in files {
        let bytes = fs::read(root().join(file)).expect("a file of the repository");
        for _ in 0..count {
            let mut bytes = bytes.clone();
            for _ in 0..1 + (random.next() * 3.0) as usize {
                let at = (random.next() * bytes.len() as f64) as usize;
                bytes[at] = (random.next() * 256.0) as u8;
            }
            run(file, &bytes);
        }
    }
}

#[test]
fn scene_files() {
    found("text", text);
    let files = [
        "tests/data/small.toml",
        "tests/data/moving.toml",
        "tests/data/lines.toml",
    ];
    changed(&files, 200, |_, bytes| text(bytes));
}

#[test]
fn meshes() {
    found("mesh", mesh);
    let files = [
        "scenes/meshes/cube.obj",
        "scenes/meshes/house.gltf",
        "scenes/meshes/suzanne.glb",
        "scenes/meshes/ring_coloured.ply",
        "tests/data/post.mtl",
    ];
    changed(&files, 40, |file, bytes| {
        let kind = ["obj", "gltf", "glb", "stl", "ply", "mtl"]
            .iter()
            .position(|kind| file.ends_with(kind));
        let kind = kind.expect("one of them") as u8;
        mesh(&[&[kind], bytes].concat());
    });
}

#[test]
fn pictures() {
    found("picture", picture);
    changed(&["scenes/textures/checker.png"], 200, |_, bytes| {
        picture(bytes)
    });
}
