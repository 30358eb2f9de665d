//! Each example draws what it drew when a person last looked.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use fixel_examples::desktop::EXAMPLES;

fn golden(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    folder.join(format!("{name}.png"))
}

fn read(path: &Path) -> Vec<u8> {
    let file = File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut reader = png::Decoder::new(BufReader::new(file))
        .read_info()
        .expect("a header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut pixels).expect("pixels");
    pixels.truncate(frame.buffer_size());
    pixels
}

/// `FIXEL_BLESS=1` (`cargo xtask bless`) writes them anew.
#[test]
fn golden_frames() {
    let mut differ = Vec::new();
    for example in EXAMPLES {
        let (size, pixels) = (example.draw)(example.shown()).expect("a scene");
        let path = golden(example.name);
        if std::env::var_os("FIXEL_BLESS").is_some() {
            let png = fixel_output::png_rgb(size.width, size.height, &pixels).expect("pixels");
            fixel_output::write(&path, &png).expect("room");
        } else if read(&path) != pixels.as_flattened() {
            differ.push(example.name);
        }
    }
    assert!(
        differ.is_empty(),
        "differ from their golden frames: {differ:?}"
    );
}

#[test]
fn examples_move() {
    for example in EXAMPLES.iter().filter(|example| example.frames > 1) {
        let frame = |number| (example.draw)(number).expect("a scene").1;
        assert!(
            frame(0) != frame(example.frames / 3),
            "{} stands still",
            example.name
        );
    }
}
