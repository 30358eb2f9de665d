//! `fixel view` without a window: keys and mouse moves from a file, pictures to files.

mod common;

use common::*;

/// Runs a script on `scene.toml`.
fn script(folder: &Folder, lines: &str) -> Run {
    folder.write("script.txt", lines);
    folder.fixel("view scene.toml --no-window --script script.txt")
}

fn panel(folder: &Folder, name: &str) -> Vec<u8> {
    read_png(folder.path(name)).3
}

#[test]
fn the_panel_is_what_render_draws() {
    let folder = Folder::new();
    script(
        &folder,
        "panel a.png\nkey v\nkey v\npanel b.png\nkey .\npanel c.png\n",
    )
    .ok();
    folder.fixel("render scene.toml -o r.png").ok();
    assert!(panel(&folder, "a.png") == panel(&folder, "r.png"));
    folder
        .fixel("render scene.toml --renderer reference -o r.png")
        .ok();
    assert!(panel(&folder, "b.png") == panel(&folder, "r.png"));
    folder
        .fixel("render scene.toml --renderer reference --frame 1 -o r.png")
        .ok();
    assert!(panel(&folder, "c.png") == panel(&folder, "r.png"));
}

/// Keys do to the picture what the words of a scene file do.
#[test]
fn keys_do_what_a_file_would() {
    let folder = Folder::new();
    let plain = std::fs::read_to_string(folder.path("scene.toml")).unwrap();
    script(
        &folder,
        "key w\npanel w.png\nkey s\nkey N\nkey N\nkey N\nsay\npanel mono.png\nkey t\npanel dithered.png\n",
    )
    .ok();
    let wires = plain.replace("[[actor]]", "[[actor]]\nrepresentation = \"wireframe\"");
    folder.write("wires.toml", &wires);
    let paper = "scene.toml --display ssd1681-200x200 --dithering";
    for (words, name) in [
        ("wires.toml", "w.png"),
        (&format!("{paper} blue_noise"), "mono.png"),
        (&format!("{paper} floyd_steinberg"), "dithered.png"),
    ] {
        folder.fixel(&format!("render {words} -o r.png")).ok();
        assert!(panel(&folder, name) == panel(&folder, "r.png"), "{name}");
    }
}

/// What `c` prints shows the same in a file.
#[test]
fn the_camera_can_be_carried_to_the_file() {
    let folder = Folder::new();
    let plain = std::fs::read_to_string(folder.path("scene.toml")).unwrap();
    let camera = script(&folder, "drag left 1 0.5\nwheel 1\nkey c\npanel a.png\n").ok();
    assert!(camera.starts_with("[camera]\nposition = ["), "{camera}");
    let start = plain.find("[camera]").unwrap();
    let end = plain.find("[[light]]").unwrap();
    let text = format!("{}{camera}{}", &plain[..start], &plain[end..]);
    folder.write("scene.toml", &text);
    folder.fixel("render scene.toml -o r.png").ok();
    let (seen, drawn) = (panel(&folder, "a.png"), panel(&folder, "r.png"));
    let off = seen
        .iter()
        .zip(&drawn)
        .filter(|(a, b)| a.abs_diff(**b) > 16);
    assert!(off.count() <= 3, "{seen:?}, {drawn:?}");
}

#[test]
fn a_mistake_in_the_file_shows_and_keeps_the_picture() {
    let folder = Folder::new();
    let good = std::fs::read_to_string(folder.path("scene.toml")).unwrap();
    folder.write("good.toml", &good.replace("#ff0000", "#00ff00"));
    folder.write("broken.toml", "[display]\nwidth = \"wide\"\n");
    let run = script(
        &folder,
        "panel a.png\nwindow b.png\ncopy broken.toml scene.toml\nreload\nsay\npanel c.png\n\
         window d.png\ncopy good.toml scene.toml\nreload\nsay\npanel e.png\n",
    );
    let said = run.ok();
    let errors: Vec<&str> = said.lines().skip(1).step_by(2).collect();
    assert!(errors[0].starts_with("scene.toml:2: "), "{said}");
    assert_eq!(errors[1], "no error");
    assert!(run.stderr().starts_with("fixel: scene.toml:2: "));
    let bytes = |name| panel(&folder, name);
    assert!(bytes("a.png") == bytes("c.png") && bytes("c.png") != bytes("e.png"));
    assert!(bytes("b.png") != bytes("d.png"), "the error is seen");
}

#[test]
fn wrong_words_are_told() {
    let folder = Folder::new();
    let line = script(&folder, "key w\njump\n").fails();
    assert!(line.contains("script.txt:2: `jump` is unknown"), "{line}");
    let line = folder.fixel("view missing.toml").fails();
    assert!(line.contains("missing.toml"), "{line}");
    let run = folder.fixel("view scene.toml --display st7790");
    assert_eq!(run.code(), 2);
    assert!(run.stderr().contains("st7789-240x240"));
    assert_eq!(folder.fixel("view scene.toml --no-window").code(), 2);
    assert_eq!(folder.fixel("view scene.toml --zoom 0").code(), 2);
}

#[test]
#[cfg(target_os = "linux")]
fn without_a_display_it_says_so() {
    let folder = Folder::new();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_fixel"));
    command
        .current_dir(folder.path(""))
        .args(["view", "scene.toml"]);
    command
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET");
    let line = Run::of(&mut command).fails();
    assert!(line.contains("no window can be opened"), "{line}");
}
