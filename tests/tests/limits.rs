//! Fixed capacities of a scene: at the bound it is drawn as the reference has it; one over,
//! and far over, it is refused with the bound. (Capacities of an application's working
//! memory change no byte: see frames.rs and ray_sharing.rs.)

use std::path::Path;

use fixel_host::Options;
use fixel_scene::{InMemory, Loader, Scene};

const HEAD: &str = "[display]\nwidth = 64\nheight = 48\n[camera]\nposition = [0, 0, 6]\n\
    focal_point = [0, 0, 0]\n";
const CUBE: &str = "[[actor]]\nmesh = \"cube.obj\"\norientation = [30, 40, 0]\n";

fn load_text(text: &str) -> Result<Scene, String> {
    let mut files = InMemory::default();
    let cube = fixel_tests::root().join("scenes/meshes/cube.obj");
    let cube = std::fs::read(cube).expect("a mesh of the repository");
    files.insert(Path::new("cube.obj"), cube);
    files.insert(Path::new("t.toml"), text.into());
    let loaded = Loader::new(&files).load(Path::new("t.toml"));
    loaded
        .map(|(scene, _)| scene)
        .map_err(|error| error.to_string())
}

/// Loads, bakes and draws; gives the pixels that the reference covers and those that differ.
fn drawn(text: &str) -> Result<(usize, usize), String> {
    let scene = load_text(&format!("{HEAD}{text}"))?;
    let baked = fixel_bake::bake(&scene).map_err(|error| error.to_string())?;
    let core = baked.scene().map_err(|error| error.to_string())?;
    let planes = fixel_host::render(&core, &Options::of(&core));
    let of = fixel_reference::Options {
        width: planes.size.0.into(),
        height: planes.size.1.into(),
        frame: 0,
    };
    let truth = fixel_reference::render(&scene, of);
    let covered = truth.covered_px();
    let pixels = truth.pixels().iter().zip(&planes.depth);
    let differ = pixels.filter(|(hit, z)| hit.is_some() != (**z != 0));
    Ok((covered, differ.count()))
}

/// A capacity: its bound, what the message for more says, and a scene with so many.
struct Capacity {
    what: &'static str,
    most: usize,
    message: &'static str,
    scene: fn(usize) -> String,
}

fn repeated(count: usize, text: impl Fn(usize) -> String) -> String {
    (0..count).map(text).collect()
}

const CAPACITIES: [Capacity; 6] = [
    Capacity {
        what: "lights",
        most: 8,
        message: "at most 8",
        scene: |count| {
            let light = |i| {
                format!(
                    "[[light]]\nkind = \"directional\"\ndirection = [{i}, -1, -1]\n\
                     intensity = 0.1\n"
                )
            };
            format!("{}{CUBE}", repeated(count, light))
        },
    },
    Capacity {
        what: "viewports",
        most: 8,
        message: "at most 8",
        scene: |count| {
            let side = 1.0 / count as f64;
            let one = |i| {
                let left = side * i as f64;
                format!("[[viewport]]\nrectangle = [{left}, 0, {side}, 1]\n")
            };
            format!("{}{CUBE}", repeated(count, one))
        },
    },
    Capacity {
        what: "parents above an actor",
        most: 16,
        message: "16",
        scene: |count| {
            let one = |i| {
                let parent = match i {
                    0 => String::new(),
                    i => format!("parent = \"a{}\"\n", i - 1),
                };
                format!(
                    "[[actor]]\nname = \"a{i}\"\nmesh = \"cube.obj\"\nposition = [0.05, 0, 0]\n{parent}"
                )
            };
            repeated(count + 1, one)
        },
    },
    Capacity {
        what: "letters of a text",
        most: 200,
        message: "1..=200",
        scene: |count| {
            let letters = "a".repeat(count);
            format!("{CUBE}[[text]]\ntext = \"{letters}\"\nposition = [0, 0, 0]\n")
        },
    },
    Capacity {
        what: "points of a line",
        most: 10_000,
        message: "at most 10000",
        scene: |count| {
            let point = |i| {
                format!(
                    "[{}, {}, 1],",
                    (i % 97) as f64 / 97.0,
                    (i % 89) as f64 / 89.0
                )
            };
            format!("{CUBE}[[line]]\npoints = [{}]\n", repeated(count, point))
        },
    },
    Capacity {
        what: "palette entries",
        most: 256,
        message: "256",
        scene: |count| format!("{CUBE}[palette]\ncolours = {count}\n"),
    },
];

#[test]
fn at_the_bound_all_is_drawn() {
    for capacity in &CAPACITIES {
        let (covered, differ) = drawn(&(capacity.scene)(capacity.most))
            .unwrap_or_else(|error| panic!("{} {}: {error}", capacity.most, capacity.what));
        assert!(covered > 50, "{}: {covered} pixels", capacity.what);
        assert!(
            differ * 100 <= covered,
            "{}: {differ} of {covered} pixels differ",
            capacity.what
        );
    }
}

#[test]
fn beyond_the_bound_it_is_refused() {
    for capacity in &CAPACITIES {
        for count in [capacity.most + 1, capacity.most * 3] {
            let error =
                drawn(&(capacity.scene)(count)).expect_err(&format!("{count} {}", capacity.what));
            assert!(
                error.contains(capacity.message),
                "{count} {}: {error}",
                capacity.what
            );
        }
    }
}

#[test]
fn pictures_are_up_to_2048_pixels_wide() {
    let wide = |width: u32| {
        let head = HEAD.replace("width = 64", &format!("width = {width}"));
        load_text(&format!("{head}{CUBE}"))
    };
    assert!(wide(2048).is_ok());
    let error = wide(2049).expect_err("too wide");
    assert!(error.contains("2048"), "{error}");
}

#[test]
fn a_camera_all_but_at_its_focal_point_looks_where_it_should() {
    let picture = |focal_point: [f64; 3]| {
        let mut scene = load_text(&format!("{HEAD}{CUBE}")).expect("a scene");
        (scene.camera.position, scene.camera.focal_point) = ([0.0; 3], focal_point);
        scene.camera.clipping_range = [0.1, 20.0];
        scene.actors[0].position = [3.0, 1.0, -3.0];
        let baked = fixel_bake::bake(&scene).map_err(|error| error.to_string())?;
        let core = baked.scene().map_err(|error| error.to_string())?;
        Ok::<_, String>(fixel_host::render(&core, &Options::of(&core)).depth)
    };
    let expected = picture([3.0, 0.0, -3.0]).expect("a picture");
    assert!(expected.iter().any(|depth| *depth != 0));
    for near in [1e-3, 1e-6, 1e-12, 1e-100] {
        assert!(
            picture([near, 0.0, -near]) == Ok(expected.clone()),
            "{near}"
        );
    }
    let refused = picture([0.0; 3]).expect_err("no direction");
    assert!(
        refused.contains("expected position and focal_point apart"),
        "{refused}"
    );
}
