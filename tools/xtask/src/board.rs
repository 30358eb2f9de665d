//! The platforms that firmware is built for and run on.

/// How an emulator is started.
#[derive(Debug)]
pub struct Machine {
    /// The emulator's program.
    pub program: &'static str,
    /// The Debian package that has it.
    pub package: &'static str,
    /// Machine, and how many virtual nanoseconds an instruction takes.
    pub arguments: &'static [&'static str],
    /// Where the measuring firmware expects a scene.
    pub scene_address: u32,
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
    /// Its emulator.
    pub machine: Machine,
}

/// Every board that an emulator runs.
pub const BOARDS: [Board; 3] = [
    Board {
        name: "cortex-m0plus",
        what: "thumbv6m code, as for a Cortex-M0+, on QEMU's mps2-an385",
        folder: "cortex-m",
        target: "thumbv6m-none-eabi",
        machine: Machine {
            program: "qemu-system-arm",
            package: "qemu-system-arm",
            arguments: &["-machine", "mps2-an385", "-icount", "shift=7"],
            scene_address: 0x0020_0000,
        },
    },
    Board {
        name: "cortex-m4f",
        what: "Cortex-M4F, QEMU's mps2-an386",
        folder: "cortex-m",
        target: "thumbv7em-none-eabihf",
        machine: Machine {
            program: "qemu-system-arm",
            package: "qemu-system-arm",
            arguments: &["-machine", "mps2-an386", "-icount", "shift=7"],
            scene_address: 0x0020_0000,
        },
    },
    Board {
        name: "riscv32imc",
        what: "RISC-V with 32-bit integers and multiplication, QEMU's virt",
        folder: "riscv",
        target: "riscv32imc-unknown-none-elf",
        machine: Machine {
            program: "qemu-system-riscv32",
            package: "qemu-system-misc",
            arguments: &["-machine", "virt", "-bios", "none", "-icount", "shift=0"],
            scene_address: 0x8080_0000,
        },
    },
];

/// The board of that name; the error names those that there are.
pub fn find(name: &str) -> Result<&'static Board, String> {
    BOARDS
        .iter()
        .find(|board| board.name == name)
        .ok_or_else(|| {
            let names: Vec<_> = BOARDS.iter().map(|board| board.name).collect();
            format!("no board is called that; there are {}", names.join(", "))
        })
}

/// The names of all boards, with what they are, for the help text.
pub fn list() -> String {
    let mut text = String::from("Boards:\n");
    for board in &BOARDS {
        text.push_str(&format!("  {:<14} {}\n", board.name, board.what));
    }
    text
}
