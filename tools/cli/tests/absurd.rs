//! Files that are absurd, or meant ill: a clear error at once, with little memory.

mod common;

use common::*;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

/// Optimised, each takes milliseconds; not optimised, on a busy machine, less than this.
const AT_ONCE: Duration = Duration::from_secs(10);
/// Kilobytes of address space: what a run may ask for.
const MEMORY_KB: u32 = 1 << 20;

/// Renders a file; its error, which has to come soon and to contain `expected`.
#[track_caller]
fn refused(folder: &Folder, file: &str, expected: &str) {
    let begun = Instant::now();
    let script = format!("ulimit -v {MEMORY_KB}; exec \"$FIXEL\" render {file} -o none.png");
    let line = Run::of(
        Command::new("sh")
            .current_dir(folder.path(""))
            .env("FIXEL", env!("CARGO_BIN_EXE_fixel"))
            .env("RAYON_NUM_THREADS", "1")
            .args(["-c", &script]),
    )
    .fails();
    assert!(line.contains(expected), "{line}");
    assert!(begun.elapsed() < AT_ONCE, "{file}: {:?}", begun.elapsed());
}

/// The scene with another actor.
fn actor(folder: &Folder, actor: &str) {
    folder.write("absurd.toml", &format!("[[actor]]\n{actor}\n"));
}

#[test]
fn meshes_that_say_they_are_huge() {
    let folder = Folder::new();
    let binary_stl = [vec![b' '; 80], 1_000_000_000_u32.to_le_bytes().to_vec()].concat();
    std::fs::write(folder.path("huge.stl"), binary_stl).unwrap();
    refused(&folder, "huge.stl", "huge.stl: ");
    let ply = |vertices: u64, faces: u64| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
             property float z\nelement face {faces}\nproperty list uchar int vertex_indices\n\
             end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
        )
    };
    folder.write("huge.ply", &ply(4_000_000_000, 1));
    refused(&folder, "huge.ply", "huge.ply");
    folder.write("huge.ply", &ply(3, 4_000_000_000));
    refused(&folder, "huge.ply", "huge.ply");
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"componentType":5126,"count":3000000000,"type":"VEC3",
        "min":[0,0,0],"max":[1,1,1]}]}"#;
    folder.write("huge.gltf", gltf);
    refused(&folder, "huge.gltf", "huge.gltf");
    let glb = [
        b"glTF".as_slice(),
        &2_u32.to_le_bytes(),
        &u32::MAX.to_le_bytes(),
        &u32::MAX.to_le_bytes(),
        b"JSON{}",
    ];
    std::fs::write(folder.path("huge.glb"), glb.concat()).unwrap();
    refused(&folder, "huge.glb", "huge.glb");
    // A file of 40 GB, of which nothing is on the disk.
    let file = std::fs::File::create(folder.path("huge.obj")).unwrap();
    file.set_len(40 << 30).unwrap();
    refused(&folder, "huge.obj", "bytes; expected at most");
}

#[test]
fn numbers_that_are_none() {
    let folder = Folder::new();
    for number in ["nan", "inf", "-1e39", "1e400"] {
        folder.write(
            "odd.obj",
            &format!("v 0 0 0\nv 1 0 0\nv 0 {number} 0\nf 1 2 3\n"),
        );
        refused(&folder, "odd.obj", "odd.obj:3: ");
        actor(&folder, &format!("sphere = 1\nposition = [0, 0, {number}]"));
        refused(&folder, "absurd.toml", "absurd.toml:3: ");
    }
}

#[test]
fn what_has_no_end() {
    let folder = Folder::new();
    let cycle = "name = \"a\"\nsphere = 1\nparent = \"b\"\n\n\
                 [[actor]]\nname = \"b\"\nsphere = 1\nparent = \"a\"";
    actor(&folder, cycle);
    refused(&folder, "absurd.toml", "absurd.toml:");
    let deep = "[".repeat(200_000);
    folder.write("deep.toml", &format!("a = {deep}"));
    refused(&folder, "deep.toml", "deep.toml:1:");
    folder.write("deep.gltf", &format!("{{\"extras\": {deep}"));
    refused(&folder, "deep.gltf", "deep.gltf");
    // A node that is its own child.
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"children":[0]}]}"#;
    folder.write("own.gltf", gltf);
    refused(&folder, "own.gltf", "own.gltf");
}

#[test]
fn pictures_that_say_they_are_huge() {
    let folder = Folder::new();
    // The head of a PNG, and its checksum.
    let mut head = b"IHDR".to_vec();
    head.extend([0, 1, 0x86, 0xa0, 0, 1, 0x86, 0xa0, 8, 2, 0, 0, 0]);
    let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
    png.extend(&head);
    png.extend(crc(&head).to_be_bytes());
    png.extend(b"\0\0\0\0IDAT\x35\xaf\x06\x1e");
    std::fs::write(folder.path("huge.png"), png).unwrap();
    let scene = "mesh = \"square.obj\"\nmaterial = \"m\"\n\n[[material]]\nname = \"m\"\n\
                 texture = \"huge.png\"";
    actor(&folder, scene);
    refused(&folder, "absurd.toml", "huge.png");
}

/// CRC-32, as PNG has it.
fn crc(bytes: &[u8]) -> u32 {
    let bit = |crc: u32| crc >> 1 ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 };
    let byte = |crc: u32, byte: &u8| (0..8).fold(crc ^ u32::from(*byte), |crc, _| bit(crc));
    !bytes.iter().fold(!0, byte)
}

/// What a scene names is read only where it may.
#[test]
fn files_elsewhere() {
    let folder = Folder::new();
    let elsewhere = Folder::new();
    let there = elsewhere.path("square.obj");
    let there = there.display();
    std::fs::create_dir(folder.path("inner")).unwrap();
    std::fs::create_dir(folder.path("scene")).unwrap();
    let scene = |mesh: &str| {
        let text = format!("[[actor]]\nmesh = {mesh:?}\n");
        folder.write("scene/s.toml", &text);
    };
    let inside = |words: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fixel"));
        let words = words.split_whitespace();
        let folder = folder.path("inner");
        command
            .current_dir(folder)
            .args(words)
            .env_remove("FIXEL_ALLOW");
        command
    };
    let render = "render ../scene/s.toml --size 8x8 -o a.png";
    for mesh in [
        &there.to_string(),
        "../square.obj",
        "../scene/../square.obj",
    ] {
        scene(mesh);
        let line = Run::of(&mut inside(render)).fails();
        assert!(line.contains("s.toml:2: "), "{line}");
        assert!(line.contains("is outside of the folders"), "{line}");
        assert!(!Path::new(&folder.path("inner/a.png")).exists());
    }
    Run::of(&mut inside(&format!("{render} --allow .."))).ok();
    Run::of(inside(render).env("FIXEL_ALLOW", "..:/")).ok();
    // Where one stands is one's own.
    folder.fixel("render scene/s.toml --size 8x8 -o a.png").ok();
    let line = Run::of(&mut inside(&format!("{render} --allow none"))).fails();
    assert!(line.contains("none: no folder"), "{line}");
}
