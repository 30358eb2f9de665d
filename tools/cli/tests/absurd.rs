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

/// Long lists: nothing takes the square of their length, and they are refused if they do not fit.
#[test]
fn lists_without_measure() {
    let folder = Folder::new();
    let many = |count: usize, text: &dyn Fn(usize) -> String| {
        let text: String = (0..count).map(text).collect();
        folder.write("many.toml", &text);
    };
    let actor = "[[actor]]\nmesh = \"square.obj\"\n";
    many(100_000, &|_| actor.to_owned());
    refused(
        &folder,
        "many.toml",
        "many.toml:1: actor: there are 100000; expected at most 65534",
    );
    many(20_000, &|i| {
        let parent = (i + 1) % 20_000;
        format!("{actor}name = \"a{i}\"\nparent = \"a{parent}\"\n")
    });
    refused(
        &folder,
        "many.toml",
        "goes round in a ring (\"a19999\" of \"a0\" of",
    );
    many(20_000, &|i| {
        let parent = i.saturating_sub(1);
        let parent = if i == 0 {
            String::new()
        } else {
            format!("parent = \"a{parent}\"\n")
        };
        format!("{actor}name = \"a{i}\"\n{parent}")
    });
    refused(
        &folder,
        "many.toml",
        "actor.parent: is one too many; expected at most 16",
    );
    let light = "[[light]]\nkind = \"directional\"\ndirection = [0, 0, -1]\n";
    many(50_000, &|i| {
        if i == 0 {
            actor.to_owned()
        } else {
            light.to_owned()
        }
    });
    refused(&folder, "many.toml", "expected at most 8");
    let text = "[[text]]\ntext = \"a\"\nposition = [0, 0, 0]\n";
    many(70_000, &|i| {
        if i == 0 {
            actor.to_owned()
        } else {
            text.to_owned()
        }
    });
    refused(
        &folder,
        "many.toml",
        "text: there are 69999; expected at most 65534",
    );
    let points = "[0, 0, 0],".repeat(700_000);
    folder.write(
        "many.toml",
        &format!("{actor}[[line]]\npoints = [{points}]\n"),
    );
    refused(&folder, "many.toml", "has 700000 points, at most 10000");
    folder.write(
        "many.toml",
        &format!("{actor}[[line]]\npoints = [{points}{points}]\n"),
    );
    refused(&folder, "many.toml", "bytes; expected at most 8388608");
    folder.write("many.toml", &format!("{} = 1\n", "a".repeat(8_000_000)));
    refused(&folder, "many.toml", "is an unknown key; expected one of");
    // Vertices, of which a face needs three.
    folder.write(
        "many.obj",
        &format!("{}f 1 2 3\n", "v 0 0 0\n".repeat(3_000_001)),
    );
    refused(
        &folder,
        "many.obj",
        "has too many of \"v\"; expected at most 3000000",
    );
    let head = [vec![b' '; 80], 1_000_001_u32.to_le_bytes().to_vec()].concat();
    let file = std::fs::File::create(folder.path("many.stl")).unwrap();
    file.set_len(84 + 50 * 1_000_001).unwrap();
    std::os::unix::fs::FileExt::write_all_at(&file, &head, 0).unwrap();
    refused(
        &folder,
        "many.stl",
        "has too many triangles; expected at most 1000000",
    );
}

/// What a file says to a terminal stays what it says.
#[test]
fn orders_to_a_terminal() {
    let folder = Folder::new();
    folder.write("odd.obj", "v 0 0 \u{1b}[2J\u{7}\u{202e}\n");
    refused(
        &folder,
        "odd.obj",
        "\\u{1b}[2J\\u{7}\\u{202e}\" is not a number",
    );
    folder.write(
        "odd.obj",
        "mtllib \u{1b}[2J.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    let run = folder.fixel("render odd.obj --size 8x8 -o a.png");
    assert!(
        run.stderr().contains("\"\\u{1b}[2J.mtl\" does not exist"),
        "{}",
        run.stderr()
    );
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

/// Whatever a glTF file calls what it wants.
#[test]
fn buffers_elsewhere() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("inner")).unwrap();
    std::fs::write(folder.path("secret.bin"), [0; 36]).unwrap();
    std::os::unix::fs::symlink("../secret.bin", folder.path("inner/link.bin")).unwrap();
    let secret = folder.path("secret.bin");
    let secret = secret.display();
    for uri in [
        "../secret.bin",
        "%2e%2e/secret.bin",
        "..%2fsecret.bin",
        "./inner/../../secret.bin",
        "link.bin",
        "/dev/zero",
        "a%0ab",
        "%00",
        r"\\\\server\\share",
        "http://127.0.0.1/a.bin",
        &secret.to_string(),
        &format!("file://{secret}"),
    ] {
        let gltf = format!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
            "nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
            "min":[0,0,0],"max":[1,1,1]}}],"bufferViews":[{{"buffer":0,"byteLength":36}}],
            "buffers":[{{"byteLength":36,"uri":"{uri}"}}]}}"#
        );
        folder.write("inner/a.gltf", &gltf);
        let run = Run::of(
            Command::new(env!("CARGO_BIN_EXE_fixel"))
                .current_dir(folder.path("inner"))
                .env_remove("FIXEL_ALLOW")
                .args("render a.gltf --size 8x8 -o a.png".split(' ')),
        );
        let line = run.fails();
        // What is read would be triangles without area.
        assert!(
            line.contains("a.gltf: ") && !line.contains("area"),
            "{uri}: {line}"
        );
    }
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
