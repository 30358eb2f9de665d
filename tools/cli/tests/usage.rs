//! Exit codes and messages.

mod common;

use common::*;

#[test]
fn wrong_usage_is_exit_code_2() {
    let folder = Folder::new();
    for words in [
        "",
        "draw scene.toml",
        "render",
        "render scene.toml --size 0x4",
        "render scene.toml --size 8",
        "render scene.toml --frame -1",
        "render scene.toml --bands 0",
        "render scene.toml --renderer magic",
        "render scene.toml -o a.png --depth-out a.png",
        "compare scene.toml --renderer reference",
        "bake scene.toml",
        "bake scene.toml -o a.fxl --colours 257",
        "bake scene.toml -o a.fxl --colours 1",
        "info",
        "animate scene.toml",
        "animate scene.toml -o a.gif --frames 0",
        "animate scene.toml -o a.gif --fps 0",
        "estimate scene.toml",
        "completions",
    ] {
        let run = folder.fixel(words);
        assert_eq!(run.code(), 2, "{words}: {}", run.stderr());
        assert_eq!(run.stdout(), "", "{words}");
    }
}

#[test]
fn wrong_words_are_told_with_what_is_expected() {
    let folder = Folder::new();
    for (words, told) in [
        (
            "render scene.toml -o a.jpg",
            "a.jpg: pictures are written as PNG",
        ),
        (
            "render scene.toml --depth-out a.tiff",
            "expected a name that ends in .png",
        ),
        (
            "render scene.toml --id-out a.gif",
            "expected a name that ends in .png",
        ),
        ("animate scene.toml -o a.jpg", "ends in .gif or .png"),
        ("render scene.toml -o -", "expected the name of a file"),
        ("bake scene.toml -o -", "expected the name of a file"),
        ("animate scene.toml -o -", "expected the name of a file"),
    ] {
        let line = folder.fixel(words).fails();
        assert!(line.contains(told), "{words}: {line}");
    }
    for (words, told) in [
        (
            "render scene.toml --frame -1",
            "-1 is not in 0..=4294967295",
        ),
        (
            "animate scene.toml -o a.gif --frames -5",
            "-5 is not in 1..=100000",
        ),
    ] {
        let run = folder.fixel(words);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(told), "{words}: {}", run.stderr());
    }
    assert_eq!(folder.names(), ["scene.toml", "square.obj"]);
    // Endings in capitals, and none.
    folder
        .fixel("render scene.toml -o A.PNG --depth-out depth")
        .ok();
    assert_eq!(
        folder.names(),
        ["A.PNG", "depth", "scene.toml", "square.obj"]
    );
}

#[test]
fn a_bad_scene_is_one_line_that_names_it() {
    let folder = Folder::new();
    folder.write("broken.toml", "[display]\nwidth = \"wide\"\n");
    folder.write("broken.obj", "v 1 2\n");
    for (words, wanted) in [
        ("render missing.toml", "missing.toml"),
        ("render broken.toml --renderer reference", "broken.toml:2"),
        ("compare broken.toml --json -", "broken.toml:2"),
        ("render broken.obj", "broken.obj:1"),
        ("info missing.fxl", "missing.fxl"),
    ] {
        let line = folder.fixel(words).fails();
        assert!(
            line.starts_with("fixel: ") && line.contains(wanted),
            "{words}: {line}"
        );
    }
    assert_eq!(
        folder.names(),
        ["broken.obj", "broken.toml", "scene.toml", "square.obj"]
    );
}

/// What only the baker sees has its place in the file too.
#[test]
fn what_cannot_be_baked_is_told_with_its_line() {
    let folder = Folder::new();
    let actor = "[[actor]]\nmesh = \"square.obj\"\n";
    let camera = "[camera]\nposition = [0, 0, 5]\nclipping_range = [1, 9]\n";
    let far =
        "[[light]]\nkind = \"ambient\"\n[[light]]\nkind = \"point\"\nposition = [1e9, 0, 0]\n";
    let glass = "[[material]]\nopacity = 0.5\n";
    for (text, wanted) in [
        (
            format!("{actor}{camera}{far}"),
            "scene.toml:8: light.position is 1000000000, out of range; expected within 32",
        ),
        (
            format!("{actor}{glass}{actor}representation = \"points\"\n"),
            "scene.toml:5: actor `actor 1`: lines or points of a material of opacity 0.5",
        ),
    ] {
        folder.write("scene.toml", &text);
        for command in [
            "render",
            "compare --json -",
            "bake -o a.fxl",
            "animate --frames 2 -o a.gif",
        ] {
            let line = folder.fixel(&format!("{command} scene.toml")).fails();
            assert!(
                line.starts_with(&format!("fixel: {wanted}")),
                "{command}: {line}"
            );
        }
    }
}

#[test]
fn help_has_examples_and_no_colour_for_files() {
    let folder = Folder::new();
    for command in [
        "render", "compare", "bake", "info", "animate", "view", "estimate",
    ] {
        let help = folder.fixel(&format!("{command} --help")).ok();
        assert!(help.contains(&format!("\n  fixel {command} ")), "{help}");
        assert!(!help.contains('\u{1b}'), "{help}");
    }
}

#[test]
fn completions_are_for_each_shell() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = folder.fixel(&format!("completions {shell}")).ok();
        assert!(
            script.contains("animate") && script.contains("renderer"),
            "{shell}"
        );
    }
    assert_eq!(folder.fixel("completions dos").code(), 2);
}

#[test]
fn a_scene_is_estimated_for_a_board() {
    let folder = Folder::new();
    let wrong = folder.fixel("estimate scene.toml --board pico");
    assert_eq!(wrong.code(), 2);
    let told = "no board is called pico; there are rp2040-st7789";
    assert!(wrong.stderr().contains(told), "{}", wrong.stderr());
    // The scene is 8x4 in colours, which the board's panel has not.
    let text = folder.fixel("estimate scene.toml --board microbit").ok();
    for told in ["frames a second", "picture: 128x64 on SSD1306", "Scratch<"] {
        assert!(text.contains(told), "{text}");
    }
    assert!(!text.contains("too many"), "{text}");
    for (board, panel) in [
        ("stm32l4", "picture: 8x4 on ST7789"),
        (
            "stm32l4 --display ssd1306-128x64",
            "picture: 128x64 on ssd1306",
        ),
        ("stm32l4 --display ssd1306-128x64", "1 bits a pixel"),
    ] {
        let text = folder.fixel(&format!("estimate scene.toml --board {board}"));
        assert!(text.ok().contains(panel), "{board}: {}", text.stdout());
    }
    // More than 64 KB with the code that is built for speed.
    folder.write("ball.toml", "[[actor]]\nsphere = 1\ndetail = 4\n");
    let text = folder.fixel("estimate ball.toml --board stm32f103c8").ok();
    assert!(text.contains("opt-level = 2"), "{text}");
    let figures = folder
        .fixel("estimate scene.toml --board stm32l4 --bands 2 --json -")
        .ok();
    assert!(figures.contains("\"band_rows\": 2,"), "{figures}");
    for field in [
        "flash_bytes",
        "ram_bytes",
        "instructions",
        "frames_a_second",
    ] {
        assert!(figures.contains(&format!("\"{field}\": ")), "{figures}");
    }
    folder.fixel("bake scene.toml --ray -o rays.fxl").ok();
    let line = folder.fixel("estimate rays.fxl --board microbit").fails();
    assert!(line.contains("baked for rays"), "{line}");
}

#[test]
fn a_scene_that_asks_for_rays_says_how_it_is_baked() {
    let folder = Folder::new();
    let scene = "[[light]]\nkind = \"directional\"\ndirection = [0, -1, -1]\n\
                 [[material]]\nname = \"mirror\"\nreflectivity = 0.5\n\
                 [[actor]]\nsphere = 1\nmaterial = \"mirror\"\n";
    folder.write("mirror.toml", scene);
    let message = folder.fixel("bake mirror.toml -o a.fxl").fails();
    for part in ["mirror.toml", "reflectivity", "--ray", "--raster"] {
        assert!(message.contains(part), "{message}");
    }
    folder.fixel("bake mirror.toml -o a.fxl --ray").ok();
    folder.fixel("bake mirror.toml -o b.fxl --raster").ok();
    assert_ne!(
        std::fs::read(folder.path("a.fxl")).expect("baked"),
        std::fs::read(folder.path("b.fxl")).expect("baked")
    );
    let both = folder.fixel("bake mirror.toml -o a.fxl --ray --raster");
    assert_eq!(both.code(), 2);
}

#[test]
fn a_scene_is_rendered_and_baked_for_a_panel() {
    let folder = Folder::new();
    let mut pictures = Vec::new();
    for words in [
        "render scene.toml -o a.png --display ssd1306-128x64 --dithering bayer8",
        "bake scene.toml -o a.fxl --display ssd1306-128x64 --dithering bayer8",
        "render a.fxl -o b.png",
        "bake scene.toml -o own.fxl",
        "bake own.fxl -o c.fxl --display ssd1306-128x64 --dithering bayer8",
        "render c.fxl -o c.png",
    ] {
        folder.fixel(words).ok();
    }
    for name in ["a.png", "b.png", "c.png"] {
        pictures.push(read_png(folder.path(name)));
    }
    let (width, height, ..) = pictures[0];
    assert_eq!((width, height), (128, 64));
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
    // A scene for a display of colours says nothing of greys.
    folder
        .fixel("render scene.toml -o d.png --display ssd1306-128x64")
        .ok();
    folder
        .fixel("render scene.toml -o e.png --display ssd1306-128x64 --dithering blue_noise")
        .ok();
    let [default, blue_noise] = ["d.png", "e.png"].map(|name| read_png(folder.path(name)));
    assert!(default == blue_noise && default != pictures[0]);
    let refused = folder.fixel("render scene.toml --display oled");
    assert_eq!(refused.code(), 2);
    assert!(refused.stderr().contains("ssd1306-128x64"));
}

#[test]
fn meshes_are_simplified_to_a_budget() {
    let folder = Folder::new();
    let sphere = "[[actor]]\nsphere = 1\n[[actor]]\nmesh = \"square.obj\"\n";
    folder.write("ball.toml", sphere);
    let run = folder.fixel("bake ball.toml -o a.fxl --max-triangles 200");
    assert_eq!(run.ok(), "");
    let told = run.stderr();
    assert!(
        told.contains("198 of 1280 triangles, off by at most"),
        "{told}"
    );
    let info = folder.fixel("info a.fxl").ok();
    assert!(info.contains("\ntriangles: 200\n"), "{info}");
    // Enough for all of it.
    let run = folder.fixel("bake ball.toml -o b.fxl --max-triangles 5000");
    assert!(!run.stderr().contains("off by"));
    let line = folder
        .fixel("bake ball.toml -o c.fxl --max-triangles 3")
        .fails();
    assert!(line.contains("cannot be simplified below"), "{line}");
    let line = folder
        .fixel("bake a.fxl -o c.fxl --max-triangles 100")
        .fails();
    assert!(line.contains("--max-triangles needs a scene"), "{line}");
    folder.write("lod.toml", &format!("[lod]\n{sphere}"));
    folder.fixel("bake lod.toml -o d.fxl").ok();
    let info = folder.fixel("info d.fxl").ok();
    assert!(info.contains("mesh 0: 1280 (0.00 %), 640 ("), "{info}");
    let run = folder.fixel("render lod.toml -o d.png --stats -").ok();
    let stats: serde_json::Value = serde_json::from_str(&run).unwrap();
    assert_eq!(stats["levels"][0].as_array().map(Vec::len), Some(2));
}
