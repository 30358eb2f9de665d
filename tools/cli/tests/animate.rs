//! `fixel animate`.

mod common;

use common::*;

/// The square turns once in two frames: from the back it is not seen.
const BLUE: [u8; 3] = [0, 0, 255];

#[test]
fn a_gif_has_every_frame_in_the_frames_own_colours() {
    let folder = Folder::new();
    folder.fixel("animate scene.toml -o a.gif --fps 30").ok();
    let file = std::fs::File::open(folder.path("a.gif")).unwrap();
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(file).unwrap();
    assert_eq!((decoder.width(), decoder.height()), (8, 4));
    let mut frames = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        frames.push((frame.delay, frame.buffer.to_vec()));
    }
    folder.fixel("render scene.toml -o one.png").ok();
    let (.., rendered) = read_png(folder.path("one.png"));
    let rgb: Vec<u8> = frames[0]
        .1
        .chunks(4)
        .flat_map(|p| p[..3].to_vec())
        .collect();
    assert_eq!(rgb, rendered);
    assert!(frames[1].1.chunks(4).all(|p| p[..3] == BLUE));
    // 3.33 and 6.67 hundredths of a second.
    assert_eq!([frames[0].0, frames[1].0], [3, 3]);
    assert_eq!(frames.len(), 2);
}

#[test]
fn an_apng_and_a_folder_have_the_same_frames() {
    let folder = Folder::new();
    folder.fixel("animate scene.toml -o a.png --frames 3").ok();
    let file = std::io::BufReader::new(std::fs::File::open(folder.path("a.png")).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
    folder.fixel("animate scene.toml -o many --frames 3").ok();
    for name in ["frame_0000.png", "frame_0001.png", "frame_0002.png"] {
        let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut rgb).unwrap();
        let (width, height, _, single) = read_png(folder.path("many").join(name));
        assert_eq!((width, height), (8, 4));
        assert!(single == rgb, "{name}");
    }
    assert_eq!(std::fs::read_dir(folder.path("many")).unwrap().count(), 3);
}

#[test]
fn a_baked_scene_moves_alike() {
    let folder = Folder::new();
    folder.fixel("bake scene.toml -o a.fxl").ok();
    folder.fixel("animate a.fxl -o a.gif --size 16x8").ok();
    folder.fixel("animate scene.toml -o b.gif --size 16x8").ok();
    let read = |name| std::fs::read(folder.path(name)).unwrap();
    assert!(read("a.gif") == read("b.gif"));
}

#[test]
fn what_is_refused_leaves_nothing() {
    let folder = Folder::new();
    let still = std::fs::read_to_string(folder.path("scene.toml")).unwrap();
    folder.write("still.toml", still.split("[animation]").next().unwrap());
    let line = folder.fixel("animate still.toml -o a.gif").fails();
    assert!(line.contains("nothing moves"), "{line}");
    let line = folder.fixel("animate scene.toml -o a.mp4").fails();
    assert!(line.contains(".gif or .png"), "{line}");
    assert_eq!(folder.names(), ["scene.toml", "square.obj", "still.toml"]);
}

/// About its own middle, wherever that is.
#[test]
fn a_bare_mesh_turns_once() {
    let folder = Folder::new();
    // Two plates that cross, far aside.
    let plates = "v 40 -1 9\nv 42 -1 9\nv 42 1 9\nv 40 1 9\nf 1 2 3 4\nf 4 3 2 1\n\
                  v 41 -1 8\nv 41 -1 10\nv 41 2 10\nv 41 2 8\nf 5 6 7 8\nf 8 7 6 5\n";
    folder.write("plates.obj", plates);
    folder.fixel("animate plates.obj -o film --frames 4").ok();
    let names = folder.fixel("animate plates.obj -o all").stderr();
    assert!(names.contains("60 frames"), "{names}");
    folder.fixel("render plates.obj -o still.png").ok();
    let frame = |number| read_png(folder.path(&format!("film/frame_000{number}.png"))).3;
    assert!(frame(0) == read_png(folder.path("still.png")).3);
    let covered = |number: u32| {
        let words = format!("render plates.obj -o one.png --stats - --frame {number}");
        let stats: serde_json::Value = serde_json::from_str(&folder.fixel(&words).ok()).unwrap();
        stats["covered_px"].as_u64().unwrap()
    };
    assert!(frame(0) != frame(1));
    let all: Vec<u64> = (0..60).step_by(5).map(covered).collect();
    assert!(all.iter().all(|px| *px > 500), "{all:?}");
}
