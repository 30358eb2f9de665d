//! The browser simulator: one page with everything in it, and its test in a browser.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::problem::{Problem, Result};
use crate::report::Tally;
use crate::toolchain::{self, Route};
use crate::{child, debian, firmware, paths};

const CRATE: &str = "web";
const TARGET: &str = "wasm32-unknown-unknown";
const MODULE: &str = "fixel_web.wasm";
/// Debian's browser without a window, and what else may be there.
const BROWSER_PACKAGE: &str = "chromium-headless-shell";
const BROWSERS: [&str; 3] = [BROWSER_PACKAGE, "chromium", "google-chrome"];
/// What drives it.
const NODE: &str = "nodejs";

/// Builds the page, as `index.html` in a folder; gives its path.
pub fn build(folder: &Path) -> Result<PathBuf> {
    let page = |name: &str| read(&paths::target_crate(CRATE).join("page").join(name));
    let module = fs::read(module()?).map_err(|error| error.to_string())?;
    let packed = packed(&module).map_err(|error| error.to_string())?;
    let core = base64::engine::general_purpose::STANDARD.encode(packed);
    let mut html = page("index.html")?;
    for (place, text) in [
        ("/*{{style.css}}*/", page("style.css")?),
        ("{{worker.js}}", page("worker.js")?),
        ("{{core.js}}", page("core.js")?),
        ("{{says.js}}", page("says.js")?),
        ("{{hands.js}}", page("hands.js")?),
        ("{{main.js}}", page("main.js")?),
        ("{{core}}", core),
    ] {
        if html.matches(place).count() != 1 {
            return Err(format!("index.html does not have {place} once").into());
        }
        html = html.replace(place, &text);
    }
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let path = folder.join("index.html");
    fixel_output::write(&path, html.as_bytes())?;
    Ok(path)
}

/// The core as WebAssembly.
fn module() -> Result<PathBuf> {
    let route = toolchain::provide(TARGET)?;
    let folder = paths::target_crate(CRATE).join("target");
    let mut command = firmware::cargo_for(route, CRATE, TARGET, "build");
    command.arg("--target-dir").arg(&folder);
    if route != Route::Installed {
        command.env("CARGO_UNSTABLE_BUILD_STD", "std,panic_abort");
    }
    child::visibly(&mut command)?;
    Ok(folder.join(TARGET).join("release").join(MODULE))
}

fn packed(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// Panels whose pictures are compared, with a way of dithering where it counts.
const PANELS: [(&str, &str); 9] = [
    ("st7789-240x240", "none"),
    ("st7789-320x240", "none"),
    ("st7735-160x128", "none"),
    ("ssd1306-128x64", "blue_noise"),
    ("ssd1327-128x128", "bayer8"),
    ("sharp-400x240", "floyd_steinberg"),
    ("ssd1681-200x200", "bayer4"),
    ("gba-240x160", "none"),
    ("gc9a01-240x240", "none"),
];
/// Scenes with all their files, which are dropped on the page without their folders.
const DROPPED: [&[&str]; 4] = [
    &["scenes/meshes/ring_coloured.ply"],
    &[
        "scenes/bench/w4_cube_textured.toml",
        "scenes/meshes/cube_textured.obj",
        "scenes/textures/bricks.png",
    ],
    &[
        "scenes/meshes/house.gltf",
        "scenes/textures/bricks.png",
        "scenes/textures/tiles.png",
    ],
    &[
        "tests/data/post.obj",
        "tests/data/post.mtl",
        "scenes/textures/bricks.png",
    ],
];

/// Builds the page and drives it in a browser.
pub fn run(tally: &mut Tally) {
    let folder = paths::work("web");
    let built = folder.and_then(|folder| Ok((build(&folder)?, folder)));
    let Some((page, folder)) = tally.check("the browser simulator is built", built) else {
        return;
    };
    let programs = snippets(&folder);
    tally.check("the programs that it writes compile", programs);
    let ready = browser().and_then(|browser| Ok((browser, expected(&folder)?)));
    let Some((browser, expected)) = tally.need("the browser simulator in a browser", ready) else {
        return;
    };
    let lines = drive(&page, &folder, &browser, &expected);
    for line in tally
        .need("the browser simulator in a browser", lines)
        .unwrap_or_default()
    {
        let result = line
            .wrong
            .map_or(Ok(()), |wrong| Err(Problem::Failed(wrong)));
        tally.check(&format!("browser simulator: {}", line.check), result);
    }
}

/// A check that the script has made.
#[derive(Debug, Deserialize)]
struct Line {
    check: String,
    wrong: Option<String>,
}

fn drive(page: &Path, folder: &Path, browser: &Path, expected: &Value) -> Result<Vec<Line>> {
    let node = debian::which("node").ok_or("no node")?;
    let task = folder.join("task.json");
    fs::write(&task, expected.to_string()).map_err(|error| error.to_string())?;
    let script = paths::target_crate(CRATE).join("test/drive.mjs");
    let mut command = Command::new(node);
    command.arg(script).args([browser, page, task.as_path()]);
    let mut lines = Vec::new();
    let mut wrong = None;
    let done = child::tee(&mut command, |line| match serde_json::from_str(line) {
        Ok(line) => lines.push(line),
        Err(error) => wrong = Some(format!("{error}: {line}")),
    })?;
    match wrong {
        Some(wrong) => Err(wrong.into()),
        None if !done || lines.is_empty() => Err("the script stopped midway".into()),
        None => Ok(lines),
    }
}

/// A browser and what drives it.
fn browser() -> Result<PathBuf> {
    let found = || BROWSERS.iter().find_map(|name| debian::which(name));
    let complete = || found().filter(|_| debian::which("node").is_some());
    if let Some(browser) = complete() {
        return Ok(browser);
    }
    if debian::can_install() {
        debian::install(&[BROWSER_PACKAGE, NODE])?;
    }
    complete().ok_or_else(|| {
        Problem::Missing(format!(
            "no browser and Node to drive it: as root on Debian \
             `apt-get install {BROWSER_PACKAGE} {NODE}` brings them"
        ))
    })
}

/// What the command line makes of the scenes that the page is to show.
fn expected(folder: &Path) -> Result<Value> {
    let teapot = |panel: &(&str, &str)| {
        let mono = ["ssd1306-128x64", "sharp-400x240", "ssd1681-200x200"].contains(&panel.0);
        if mono {
            "scenes/mono_teapot.toml"
        } else {
            "scenes/teapot.toml"
        }
    };
    let mut panels = Vec::new();
    for panel in &PANELS {
        panels.push(made(folder, teapot(panel), panel, "raster")?);
    }
    let mut dropped = Vec::new();
    for files in DROPPED {
        let mut case = made(folder, files[0], &PANELS[0], "raster")?;
        let paths = files.iter().map(|file| paths::root().join(file));
        case["files"] = json!(paths.collect::<Vec<_>>());
        dropped.push(case);
    }
    let rays = made(folder, "scenes/teapot.toml", &PANELS[2], "ray")?;
    Ok(json!({ "folder": folder, "panels": panels, "dropped": dropped, "rays": rays }))
}

/// Renders and bakes a scene for a panel.
fn made(
    folder: &Path,
    scene: &str,
    (panel, dithering): &(&str, &str),
    renderer: &str,
) -> Result<Value> {
    let stem = Path::new(scene).file_stem().unwrap_or_default();
    let name = format!("{}-{panel}-{renderer}", stem.to_string_lossy());
    let file = |kind: &str| folder.join(format!("{name}.{kind}"));
    let on = ["--display", panel, "--dithering", dithering];
    let (picture, blob) = (file("png"), file("fxl"));
    let render = ["render", scene, "--renderer", renderer];
    fixel(&[&render[..], &on].concat(), &picture)?;
    let how = if renderer == "ray" {
        "--ray"
    } else {
        "--raster"
    };
    fixel(&[&["bake", scene, how][..], &on].concat(), &blob)?;
    let (size, pixels) = pixels(&picture)?;
    let raw = file("rgb");
    fs::write(&raw, pixels).map_err(|error| error.to_string())?;
    Ok(json!({
        "scene": scene,
        "panel": panel,
        "dithering": dithering,
        "size": size,
        "pixels": raw,
        "blob": blob,
    }))
}

/// The command line, as a user has it.
fn fixel(arguments: &[&str], output: &Path) -> Result<()> {
    let mut command = Command::new("cargo");
    child::without_outer_package(&mut command);
    command
        .args(["run", "--quiet", "--package", "fixel-cli", "--"])
        .args(arguments)
        .arg("--output")
        .arg(output)
        .current_dir(paths::root());
    child::visibly(&mut command)
}

/// Size, and red, green and blue by rows.
fn pixels(path: &Path) -> Result<([u32; 2], Vec<u8>)> {
    let wrong = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let file = fs::File::open(path).map_err(|error| wrong(&error))?;
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().map_err(|error| wrong(&error))?;
    let bytes = reader.output_buffer_size().ok_or("too large a picture")?;
    let mut pixels = vec![0; bytes];
    let info = reader
        .next_frame(&mut pixels)
        .map_err(|error| wrong(&error))?;
    Ok(([info.width, info.height], pixels))
}

/// Scene, panel, dithering, rays: one of each kind of program.
const PROGRAMS: [(&str, &str, &str, bool); 8] = [
    ("scenes/teapot.toml", "st7789-240x240", "none", false),
    ("scenes/teapot.toml", "ssd1306-128x64", "none", false),
    (
        "scenes/teapot.toml",
        "ssd1327-128x128",
        "floyd_steinberg",
        false,
    ),
    ("scenes/teapot.toml", "sharp-400x240", "bayer8", true),
    ("scenes/antialiased.toml", "st7789-320x240", "none", false),
    (
        "scenes/antialiased.toml",
        "ssd1681-200x200",
        "blue_noise",
        false,
    ),
    ("scenes/direct.toml", "st7789-320x240", "none", false),
    ("scenes/teapot.toml", "st7735-160x128", "none", true),
];

/// Compiles the programs that the page writes, one of each kind, as modules of one library
/// without the standard one.
fn snippets(folder: &Path) -> Result<()> {
    let folder = folder.join("programs");
    let source = folder.join("src");
    fs::create_dir_all(&source).map_err(|error| error.to_string())?;
    let write = |name: &str, bytes: &[u8]| {
        let path = source.join(name);
        fs::write(&path, bytes).map_err(|error| format!("{}: {error}", path.display()))
    };
    let mut library = "#![no_std]\n".to_owned();
    let files = all_files()?;
    for (number, (scene, panel, dithering, rays)) in PROGRAMS.into_iter().enumerate() {
        let (program, blob, name) = program(&files, scene, panel, dithering, rays)?;
        write(&format!("program_{number}.rs"), program.as_bytes())?;
        write(&format!("{name}.fxl"), &blob)?;
        library += &format!("pub mod program_{number};\n");
    }
    write("lib.rs", library.as_bytes())?;
    let manifest = format!(
        "[workspace]\n[package]\nname = \"programs\"\nedition = \"2024\"\n[dependencies]\n\
         fixel = {{ path = {:?} }}\nembedded-graphics-core = \"0.4\"\n",
        paths::root()
    );
    let path = folder.join("Cargo.toml");
    fs::write(&path, manifest).map_err(|error| format!("{}: {error}", path.display()))?;
    // The versions that everything else here has.
    let lock = fs::copy(paths::root().join("Cargo.lock"), folder.join("Cargo.lock"));
    lock.map_err(|error| error.to_string())?;
    let mut command = Command::new("cargo");
    child::without_outer_package(&mut command);
    command
        .args(["check", "--quiet"])
        .env("RUSTFLAGS", "-D warnings")
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .current_dir(&folder);
    child::visibly(&mut command)
}

/// Scenes with their meshes and textures.
fn all_files() -> Result<Vec<(String, Vec<u8>)>> {
    let mut files = Vec::new();
    for folder in ["scenes", "scenes/meshes", "scenes/textures"] {
        let entries =
            fs::read_dir(paths::root().join(folder)).map_err(|error| error.to_string())?;
        for entry in entries.flatten() {
            if let Ok(bytes) = fs::read(entry.path()) {
                files.push((
                    format!("{folder}/{}", entry.file_name().to_string_lossy()),
                    bytes,
                ));
            }
        }
    }
    Ok(files)
}

/// What the page's program for a scene is, with the scene baked, and its name.
fn program(
    files: &[(String, Vec<u8>)],
    scene: &str,
    panel: &str,
    dithering: &str,
    rays: bool,
) -> Result<(String, Vec<u8>, String)> {
    let mut session = fixel_simulator::Session::default();
    let mut call = |what: u32, input: &[u8]| {
        let answer = session.call(what, input);
        if answer.done {
            Ok(answer)
        } else {
            Err(Problem::Failed(answer.text))
        }
    };
    for (path, bytes) in files {
        let length = (path.len() as u32).to_le_bytes();
        call(2, &[&length[..], path.as_bytes(), bytes].concat())?;
    }
    let open = json!({ "path": scene, "panel": panel, "dithering": dithering, "rays": rays });
    let facts = call(3, open.to_string().as_bytes())?.text;
    let facts: Value = serde_json::from_str(&facts).map_err(|error| error.to_string())?;
    let name = facts["name"].as_str().unwrap_or_default().to_owned();
    let blob = call(5, &[])?.bytes;
    Ok((call(6, &[])?.text, blob, name))
}
