//! Runs the `fixel` command in a folder of its own.

#![allow(dead_code, reason = "each test file uses a part")]

use std::path::PathBuf;
use std::process::{Command, Output};

/// A folder with `scene.toml` (a lit red square over the left half of an 8x4
/// picture, on blue) and `square.obj`; gone when dropped.
pub struct Folder(tempfile::TempDir);

const SCENE: &str = r##"
[display]
width = 8
height = 4
background = "#0000ff"

[camera]
position = [0, 0, 5]
focal_point = [0, 0, 0]
projection = "parallel"
parallel_scale = 2
clipping_range = [1, 9]

[[light]]
kind = "directional"
direction = [0, 0, -1]

[[material]]
name = "red"
colour = "#ff0000"
shading = "flat"

[[actor]]
mesh = "square.obj"
material = "red"

[animation]
turntable = 2
"##;

const SQUARE: &str = "v -4 -2 0\nv 0 -2 0\nv 0 2 0\nv -4 2 0\nf 1 2 3 4\n";

impl Folder {
    pub fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.write("scene.toml", SCENE);
        folder.write("square.obj", SQUARE);
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    /// The names of the files here, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// Runs `fixel` here with words separated by spaces.
    pub fn fixel(&self, words: &str) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fixel"));
        command
            .current_dir(self.0.path())
            .args(words.split_whitespace());
        Run::of(&mut command)
    }
}

/// What a run left behind.
pub struct Run(Output);

impl Run {
    /// Runs a command to its end.
    pub fn of(command: &mut Command) -> Self {
        Self(command.output().unwrap())
    }

    pub fn code(&self) -> i32 {
        self.0.status.code().unwrap()
    }

    pub fn stdout(&self) -> String {
        String::from_utf8(self.0.stdout.clone()).unwrap()
    }

    pub fn stderr(&self) -> String {
        String::from_utf8(self.0.stderr.clone()).unwrap()
    }

    /// Asserts success; returns standard output.
    #[track_caller]
    pub fn ok(&self) -> String {
        assert_eq!(self.code(), 0, "{}", self.stderr());
        self.stdout()
    }

    /// Asserts exit code 1, one line on standard error and nothing on standard
    /// output; returns the line.
    #[track_caller]
    pub fn fails(&self) -> String {
        let line = self.stderr();
        assert_eq!(self.code(), 1, "{line}");
        assert_eq!(self.stdout(), "");
        assert_eq!(line.lines().count(), 1, "{line}");
        line
    }
}

/// A PNG's width, height, bits a channel and bytes of its pixels.
pub fn read_png(path: PathBuf) -> (u32, u32, u8, Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width, info.height, info.bit_depth as u8, bytes)
}

/// The 16-bit greys of a PNG.
pub fn read_grey16(path: PathBuf) -> Vec<u16> {
    let (_, _, bits, bytes) = read_png(path);
    assert_eq!(bits, 16);
    bytes
        .chunks_exact(2)
        .map(|b| u16::from_be_bytes([b[0], b[1]]))
        .collect()
}
