//! The platforms that firmware is built for and run on.

/// How a QEMU machine is started.
#[derive(Debug)]
pub struct Qemu {
    /// The emulator's program.
    pub program: &'static str,
    /// The Debian package that has it.
    pub package: &'static str,
    /// Machine, and how many virtual nanoseconds an instruction takes.
    pub arguments: &'static [&'static str],
    /// Where the measuring firmware expects a scene.
    pub scene_address: u32,
}

/// What runs a board's firmware.
#[derive(Debug)]
pub enum Machine {
    /// QEMU, by semihosting.
    Qemu(Qemu),
    /// Node, by a script in the board's folder, which takes the arguments of the
    /// host's measuring program after the module.
    Node(&'static str),
    /// mGBA, by the front end in `targets/libretro`.
    Mgba,
}

/// One platform.
#[derive(Debug)]
pub struct Board {
    /// Its name in figures and on the command line.
    pub name: &'static str,
    /// What it is, in a few words.
    pub what: &'static str,
    /// Its crate in `targets/`.
    pub folder: &'static str,
    /// Rust's name of the target.
    pub target: &'static str,
    /// The measuring firmware's features, where they are not the crate's usual
    /// ones.
    pub features: Option<&'static str>,
    /// Its emulator.
    pub machine: Machine,
    /// Scenes that are compared there; all if there is no list.
    pub scenes: Option<&'static [&'static str]>,
    /// The scene that it shows if no other is asked for.
    pub scene: &'static str,
}

/// One scene of each kind of inner loop: flat, Gouraud and textured spans, textures pixel by
/// pixel, colours, fog with blending, the same without a palette, lines, and rays.
const EVERY_KERNEL: [&str; 10] = [
    "blend_fog",
    "direct_fog",
    "lines_markers_text",
    "many_actors",
    "r3_spheres_whitted",
    "spot",
    "textured_mesh",
    "w1_teapot_flat",
    "w2_teapot_gouraud",
    "w4_cube_textured",
];
/// What fits the micro:bit's 16 KB of RAM and the 128 KB of its flash that are kept
/// for a scene.
const SMALL: [&str; 3] = ["teapot_128x64", "w1_teapot_flat", "w6_bunny_64x64"];

const fn arm(arguments: &'static [&'static str], scene_address: u32) -> Machine {
    Machine::Qemu(Qemu {
        program: "qemu-system-arm",
        package: "qemu-system-arm",
        arguments,
        scene_address,
    })
}

/// The boards that are measured, and that every scene is compared on.
pub const BOARDS: [Board; 3] = [
    Board {
        name: "cortex-m0plus",
        what: "thumbv6m code, as for a Cortex-M0+, on QEMU's mps2-an385",
        folder: "cortex-m",
        target: "thumbv6m-none-eabi",
        features: None,
        machine: arm(
            &["-machine", "mps2-an385", "-icount", "shift=7"],
            0x0010_0000,
        ),
        scenes: None,
        scene: "teapot",
    },
    Board {
        name: "cortex-m4f",
        what: "Cortex-M4F, QEMU's mps2-an386",
        folder: "cortex-m",
        target: "thumbv7em-none-eabihf",
        features: None,
        machine: arm(
            &["-machine", "mps2-an386", "-icount", "shift=7"],
            0x0010_0000,
        ),
        scenes: None,
        scene: "teapot",
    },
    Board {
        name: "riscv32imc",
        what: "RISC-V with 32-bit integers and multiplication, QEMU's virt",
        folder: "riscv",
        target: "riscv32imc-unknown-none-elf",
        features: None,
        machine: Machine::Qemu(Qemu {
            program: "qemu-system-riscv32",
            package: "qemu-system-misc",
            arguments: &["-machine", "virt", "-bios", "none", "-icount", "shift=0"],
            scene_address: 0x8080_0000,
        }),
        scenes: None,
        scene: "teapot",
    },
];

/// Boards that show the same bytes once more, in a few scenes.
pub const OTHERS: [Board; 6] = [
    Board {
        name: "microbit",
        what: "Cortex-M0 with 16 KB of RAM, QEMU's microbit",
        folder: "cortex-m",
        target: "thumbv6m-none-eabi",
        features: Some("microbit,gouraud"),
        machine: arm(&["-machine", "microbit"], 0x0002_0000),
        scenes: Some(&SMALL),
        scene: "teapot_128x64",
    },
    Board {
        name: "cortex-m3",
        what: "Cortex-M3, QEMU's mps2-an385",
        folder: "cortex-m",
        target: "thumbv7m-none-eabi",
        features: None,
        machine: arm(
            &["-machine", "mps2-an385", "-icount", "shift=7"],
            0x0010_0000,
        ),
        scenes: Some(&EVERY_KERNEL),
        scene: "teapot",
    },
    Board {
        name: "cortex-m7",
        what: "Cortex-M7, QEMU's mps2-an500",
        folder: "cortex-m",
        target: "thumbv7em-none-eabihf",
        features: None,
        machine: arm(
            &["-machine", "mps2-an500", "-icount", "shift=7"],
            0x0010_0000,
        ),
        scenes: Some(&EVERY_KERNEL),
        scene: "teapot",
    },
    Board {
        name: "cortex-m33",
        what: "Cortex-M33, QEMU's mps2-an505",
        folder: "cortex-m",
        target: "thumbv8m.main-none-eabihf",
        features: None,
        machine: arm(&["-machine", "mps2-an505"], 0x1010_0000),
        scenes: Some(&EVERY_KERNEL),
        scene: "teapot",
    },
    Board {
        name: "wasm",
        what: "WebAssembly, in Node",
        folder: "wasm",
        target: "wasm32-unknown-unknown",
        features: None,
        machine: Machine::Node("run.mjs"),
        scenes: Some(&EVERY_KERNEL),
        scene: "teapot",
    },
    Board {
        name: "gba",
        what: "Game Boy Advance (ARM7TDMI), in mGBA",
        folder: "gba",
        target: "thumbv4t-none-eabi",
        features: None,
        machine: Machine::Mgba,
        scenes: Some(&EVERY_KERNEL),
        scene: "teapot",
    },
];

/// A small chip that a whole demo has to fit into, its scene with it: there is no room for the
/// measuring firmware. The linker has the chip's memory, QEMU's machine has more of it.
pub const SMALL_CHIP: Board = Board {
    name: "stm32f103",
    what: "STM32F103C8 (Cortex-M3, 64 KB of flash, 20 KB of RAM), on QEMU's netduino2",
    folder: "cortex-m",
    target: "thumbv7m-none-eabi",
    features: Some("stm32f103"),
    machine: arm(&["-machine", "netduino2"], 0),
    scenes: Some(&[]),
    scene: "teapot",
};

impl Board {
    /// Whether its firmware is an ELF file.
    pub fn is_elf(&self) -> bool {
        !matches!(self.machine, Machine::Node(_))
    }

    /// Whether a scene is compared there.
    pub fn takes(&self, scene: &str) -> bool {
        self.scenes.is_none_or(|scenes| scenes.contains(&scene))
    }
}

/// Every board.
pub fn all() -> impl Iterator<Item = &'static Board> {
    BOARDS.iter().chain(&OTHERS)
}

/// The board of that name; the error names those that there are.
pub fn find(name: &str) -> Result<&'static Board, String> {
    all().find(|board| board.name == name).ok_or_else(|| {
        let names: Vec<_> = all().map(|board| board.name).collect();
        format!("no board is called that; there are {}", names.join(", "))
    })
}

/// The names of all boards, with what they are, for the help text.
pub fn list() -> String {
    let mut text = String::from("Boards:\n");
    for board in all() {
        text.push_str(&format!("  {:<14} {}\n", board.name, board.what));
    }
    text
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_scenes_of_lists_exist() {
        for board in super::all() {
            for name in board.scenes.unwrap_or_default() {
                let file = crate::scene::file(name);
                assert!(file.exists(), "{}: {}", board.name, file.display());
            }
        }
    }
}
