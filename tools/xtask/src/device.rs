//! Boards with a panel: their demo firmware shows a scene whose object buttons turn.

use crate::board::{self, Board};

/// A board and what hangs on it.
#[derive(Debug)]
pub struct Device {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it is, in a few words.
    pub what: &'static str,
    /// Its crate in `targets/`.
    pub folder: &'static str,
    /// Rust's name of the target.
    pub target: &'static str,
    /// The firmware in that crate.
    pub binary: &'static str,
    /// Its features.
    pub features: &'static str,
    /// Columns and rows of its panel.
    pub size: (u16, u16),
    /// The panel's pixels.
    pub pixels: Pixels,
    /// Whether the whole of each picture is sent, in which case a frame costs as many bytes
    /// as the last one.
    pub sends_all: bool,
    /// The scene that it shows if no other is asked for.
    pub scene: &'static str,
    /// Its name in the emulator's script.
    pub panel: &'static str,
}

/// What a panel's pixels are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// 5, 6 and 5 bits, the high byte first.
    Rgb565,
    /// Black or white.
    Mono,
}

impl Device {
    /// Bytes of a picture as the emulator writes it: a pixel of one bit has a byte there.
    pub fn picture_bytes(&self) -> usize {
        let pixels = usize::from(self.size.0) * usize::from(self.size.1);
        match self.pixels {
            Pixels::Rgb565 => 2 * pixels,
            Pixels::Mono => pixels,
        }
    }
}

const RP2040: Device = Device {
    name: "rp2040-st7789",
    what: "Raspberry Pi Pico with an ST7789, 320x240, in rp2040js",
    folder: "rp2040",
    target: "thumbv6m-none-eabi",
    binary: "st7789",
    features: "",
    size: (320, 240),
    pixels: Pixels::Rgb565,
    sends_all: true,
    scene: "teapot",
    panel: "st7789",
};

/// All of them.
pub const DEVICES: [Device; 4] = [
    RP2040,
    Device {
        name: "rp2040-st7789-240",
        what: "the same with an ST7789 of 240x240",
        features: "square",
        size: (240, 240),
        panel: "square",
        ..RP2040
    },
    Device {
        name: "rp2040-ssd1306",
        what: "the same with an SSD1306, an OLED of 128x64",
        binary: "ssd1306",
        size: (128, 64),
        pixels: Pixels::Mono,
        scene: "mono_teapot",
        panel: "ssd1306",
        ..RP2040
    },
    Device {
        name: "rp2040-epaper",
        what: "the same with an SSD1680, e-paper of 296x128",
        binary: "epaper",
        size: (296, 128),
        pixels: Pixels::Mono,
        sends_all: false,
        scene: "mono_teapot",
        panel: "epaper",
        ..RP2040
    },
];

/// What a name on the command line stands for.
#[derive(Clone, Copy, Debug)]
pub enum Named {
    /// A board whose firmware measures.
    Board(&'static Board),
    /// A board with a panel.
    Device(&'static Device),
}

impl Named {
    fn describe(self) -> (&'static str, &'static str) {
        match self {
            Self::Board(board) => (board.name, board.what),
            Self::Device(device) => (device.name, device.what),
        }
    }
}

fn all() -> impl Iterator<Item = Named> {
    let boards = board::all().map(Named::Board);
    boards.chain(DEVICES.iter().map(Named::Device))
}

/// The board of that name; the error names those that there are.
pub fn find(name: &str) -> Result<Named, String> {
    let found = all().find(|named| named.describe().0 == name);
    found.ok_or_else(|| {
        let names: Vec<_> = all().map(|named| named.describe().0).collect();
        format!("no board is called that; there are {}", names.join(", "))
    })
}

/// The names of all boards, with what they are, for the help text.
pub fn list() -> String {
    let mut text = String::from("Boards:\n");
    for (name, what) in all().map(Named::describe) {
        text.push_str(&format!("  {name:<17} {what}\n"));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_and_scenes_exist() {
        assert!(matches!(find("cortex-m4f"), Ok(Named::Board(_))));
        for device in &DEVICES {
            assert!(
                matches!(find(device.name), Ok(Named::Device(found)) if found.name == device.name)
            );
            assert!(
                crate::scene::file(device.scene).exists(),
                "{}",
                device.scene
            );
        }
        assert!(find("rp2040").is_err());
    }
}
