//! `fixel render` with the reference renderer: the files and figures it gives.

mod common;

use common::*;

const RED: [u8; 3] = [255, 0, 0];
const BLUE: [u8; 3] = [0, 0, 255];

/// Left half `a`, right half `b`, 8x4.
fn halves<T: Copy>(a: T, b: T) -> Vec<T> {
    (0..32).map(|i| if i % 8 < 4 { a } else { b }).collect()
}

#[test]
fn all_outputs_show_the_scene() {
    let folder = Folder::new();
    let run = folder.fixel(
        "render scene.toml --renderer reference -o p.png --depth-out d.png --id-out i.png \
         --stats s.json",
    );
    assert_eq!(run.ok(), "");
    let (width, height, bits, bytes) = read_png(folder.path("p.png"));
    assert_eq!((width, height, bits), (8, 4, 8));
    assert_eq!(bytes, halves(RED, BLUE).as_flattened());
    assert_eq!(read_grey16(folder.path("d.png")), halves(32768, 0));
    assert_eq!(read_grey16(folder.path("i.png")), halves(1, 0));
    let stats = std::fs::read_to_string(folder.path("s.json")).unwrap();
    let stats: serde_json::Value = serde_json::from_str(&stats).unwrap();
    assert_eq!(stats["covered_px"], 16);
    assert_eq!(stats["renderer"], "reference");
    assert_eq!((&stats["width"], &stats["height"]), (&8.into(), &4.into()));
    let names = [
        "d.png",
        "i.png",
        "p.png",
        "s.json",
        "scene.toml",
        "square.obj",
    ];
    assert_eq!(folder.names(), names);
}

#[test]
fn without_a_name_the_picture_has_the_scenes() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("deep")).unwrap();
    std::fs::rename(
        folder.path("scene.toml"),
        folder.path("deep/some.scene.toml"),
    )
    .unwrap();
    std::fs::rename(folder.path("square.obj"), folder.path("deep/square.obj")).unwrap();
    folder
        .fixel("render deep/some.scene.toml --renderer reference")
        .ok();
    assert_eq!(folder.names(), ["deep", "some.scene.png"]);
}

#[test]
fn size_and_frame_are_obeyed() {
    let folder = Folder::new();
    folder
        .fixel("render scene.toml --renderer reference --size 4x4 -o small.png")
        .ok();
    let (width, height, _, bytes) = read_png(folder.path("small.png"));
    assert_eq!((width, height), (4, 4));
    assert_eq!(bytes.as_chunks().0[..4], [RED, RED, BLUE, BLUE]);
    // Half a turn: the square shows its back, which is left out.
    folder
        .fixel("render scene.toml --renderer reference --frame 1 --id-out i.png")
        .ok();
    assert_eq!(read_grey16(folder.path("i.png")), [0; 32]);
}

#[test]
fn standard_output_carries_one_json_object_and_nothing_else() {
    let folder = Folder::new();
    let out = folder
        .fixel("render scene.toml --renderer reference --stats -")
        .ok();
    let stats: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert!(stats["render_ms"].is_number() && stats.is_object());
}

#[test]
fn a_bare_mesh_is_framed() {
    let folder = Folder::new();
    let out = folder
        .fixel("render square.obj --renderer reference --stats -")
        .ok();
    let stats: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert!(stats["covered_px"].as_u64() > Some(100));
}

#[test]
fn an_existing_file_is_replaced_and_a_link_followed() {
    let folder = Folder::new();
    folder.write("old.png", "old");
    folder
        .fixel("render scene.toml --renderer reference -o old.png")
        .ok();
    assert_eq!(read_png(folder.path("old.png")).0, 8);
    #[cfg(unix)]
    {
        folder.write("target.png", "old");
        std::os::unix::fs::symlink("target.png", folder.path("link.png")).unwrap();
        folder
            .fixel("render scene.toml --renderer reference -o link.png")
            .ok();
        assert_eq!(read_png(folder.path("target.png")).0, 8);
        assert!(folder.path("link.png").is_symlink());
        folder
            .fixel("render scene.toml --renderer reference -o /dev/null")
            .ok();
        assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
    }
}

#[test]
fn an_output_that_cannot_be_written_leaves_nothing() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("taken")).unwrap();
    let before = folder.names();
    let line = folder
        .fixel("render scene.toml --renderer reference -o taken")
        .fails();
    assert!(line.contains("taken"), "{line}");
    let line = folder
        .fixel("render scene.toml --renderer reference -o no/such/p.png")
        .fails();
    assert!(line.contains("no/such/p.png"), "{line}");
    assert_eq!(folder.names(), before);
}

#[test]
fn a_report_is_one_page_that_needs_nothing_else() {
    let folder = Folder::new();
    for (renderer, maps) in [("raster", 4), ("ray", 5)] {
        folder
            .fixel(&format!(
                "compare scene.toml --renderer {renderer} --report out/a"
            ))
            .ok();
        assert_eq!(std::fs::read_dir(folder.path("out/a")).unwrap().count(), 1);
        let page = std::fs::read_to_string(folder.path("out/a/index.html")).unwrap();
        let sources = || page.split("src=\"").skip(1);
        let inside = "data:image/png;base64,iVBOR";
        assert!(sources().all(|source| source.starts_with(inside)));
        // Frame and truth change places; no shadows by raster.
        assert_eq!(sources().count(), 4 + maps, "{renderer}");
        assert_eq!(page.matches("<svg").count(), 3);
        assert!(!page.contains("http"), "nothing comes from elsewhere");
        let row = "<code>coverage_mismatch_px</code></td><td class=\"n\">0</td>";
        assert!(page.contains(row), "{page}");
    }
}

/// The house is one actor of the file, whatever materials its mesh has.
#[test]
fn parts_of_an_actor_show_its_number() {
    let folder = Folder::new();
    let house = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/house.toml");
    folder
        .fixel(&format!("bake {house} --ray -o house.fxl"))
        .ok();
    for scene in [house, "house.fxl"] {
        for renderer in ["raster", "ray", "reference"] {
            folder
                .fixel(&format!(
                    "render {scene} --renderer {renderer} --size 64x48 -o p.png --id-out i.png"
                ))
                .ok();
            let ids = read_grey16(folder.path("i.png"));
            let count = |wanted| ids.iter().filter(|id| **id == wanted).count();
            assert!(count(1) > 500 && count(2) > 500, "{scene}, {renderer}");
            assert!(ids.iter().all(|id| *id <= 2), "{scene}, {renderer}");
        }
    }
}
