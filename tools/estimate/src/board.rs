//! Boards: a processor, its memory, and the panel's bus.

use fixel_scene::{ColourFormat, Feed};

/// A board that a scene is estimated for.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it is, in a few words.
    pub what: &'static str,
    /// The target whose instruction counts hold for its core.
    pub target: &'static str,
    /// The processor's clock.
    pub clock_hz: u32,
    /// What an instruction takes.
    pub cycles: Cycles,
    /// For code and scene.
    pub flash_bytes: u64,
    /// Of all memory.
    pub ram_bytes: u64,
    /// What it shows pictures on.
    pub panel: Panel,
}

/// Cycles an instruction, on average.
#[derive(Clone, Copy, Debug)]
pub struct Cycles {
    /// So many.
    pub each: f64,
    /// Where the number is from.
    pub source: &'static str,
}

/// A panel and how its pixels get there.
#[derive(Clone, Copy, Debug)]
pub struct Panel {
    /// Its name.
    pub name: &'static str,
    /// What is on the board, by the name that scene files have for it.
    pub screen: &'static str,
    /// What a pixel takes on the bus.
    pub bits_a_pixel: u32,
    /// Bits a second on the bus; 0: the panel reads the memory by itself.
    pub bits_a_second: u32,
    /// How long it takes until a picture that was sent is seen, in milliseconds.
    pub refresh_ms: u32,
}

const IN_RP2040JS: Cycles = Cycles {
    each: 1.52,
    source: "cycles in rp2040js over instructions in QEMU, bands of 60 rows, W1 to W4",
};
const M0: Cycles = Cycles {
    each: 1.6,
    source: "reckoned: as on the Cortex-M0+, and a cycle more a taken branch; not measured",
};
const M3: Cycles = Cycles {
    each: 1.5,
    source: "reckoned: loads and taken branches take 2 to 3 cycles, flash has 2 wait states \
             behind a prefetch buffer; not measured",
};
const M4: Cycles = Cycles {
    each: 1.35,
    source: "reckoned: loads take up to 2, taken branches 2 to 4 cycles, flash is cached; \
             not measured",
};
const C3: Cycles = Cycles {
    each: 1.35,
    source: "reckoned: one instruction a cycle but for loads and taken branches, flash is \
             cached; not measured",
};

const fn st7789(bits_a_second: u32) -> Panel {
    Panel {
        name: "ST7789 on SPI",
        screen: "st7789-320x240",
        bits_a_pixel: 16,
        bits_a_second,
        refresh_ms: 0,
    }
}

const RP2040: Board = Board {
    name: "rp2040-st7789",
    what: "Raspberry Pi Pico with an ST7789",
    target: "cortex-m0plus",
    clock_hz: 133_000_000,
    cycles: IN_RP2040JS,
    flash_bytes: 2 << 20,
    ram_bytes: 264 << 10,
    panel: st7789(62_500_000),
};

/// All of them.
pub const BOARDS: [Board; 10] = [
    RP2040,
    Board {
        name: "rp2040-ssd1306",
        what: "Raspberry Pi Pico with an SSD1306",
        panel: Panel {
            name: "SSD1306 on SPI",
            screen: "ssd1306-128x64",
            bits_a_pixel: 1,
            bits_a_second: 8_000_000,
            refresh_ms: 0,
        },
        ..RP2040
    },
    Board {
        name: "rp2040-epaper",
        what: "Raspberry Pi Pico with an SSD1680, e-paper",
        panel: Panel {
            name: "SSD1680 on SPI",
            screen: "ssd1680-296x128",
            bits_a_pixel: 1,
            bits_a_second: 4_000_000,
            refresh_ms: 300,
        },
        ..RP2040
    },
    Board {
        name: "microbit",
        what: "BBC micro:bit (nRF51822, Cortex-M0) with an SSD1306",
        target: "cortex-m0plus",
        clock_hz: 16_000_000,
        cycles: M0,
        flash_bytes: 256 << 10,
        ram_bytes: 16 << 10,
        panel: Panel {
            name: "SSD1306 on SPI",
            screen: "ssd1306-128x64",
            bits_a_pixel: 1,
            bits_a_second: 8_000_000,
            refresh_ms: 0,
        },
    },
    Board {
        name: "stm32f103c8",
        what: "Blue Pill (Cortex-M3) with an ST7789",
        // It has the Cortex-M4's instructions but for those on halves of words, of which the
        // counted code has next to none.
        target: "cortex-m4f",
        clock_hz: 72_000_000,
        cycles: M3,
        flash_bytes: 64 << 10,
        ram_bytes: 20 << 10,
        panel: st7789(36_000_000),
    },
    Board {
        name: "stm32f405",
        what: "STM32F405 (Cortex-M4F) with an ST7789",
        target: "cortex-m4f",
        clock_hz: 168_000_000,
        cycles: M4,
        flash_bytes: 1 << 20,
        ram_bytes: 128 << 10,
        panel: st7789(42_000_000),
    },
    Board {
        name: "stm32l4",
        what: "STM32L476 (Cortex-M4F) with an ST7789",
        target: "cortex-m4f",
        clock_hz: 80_000_000,
        cycles: M4,
        flash_bytes: 1 << 20,
        ram_bytes: 96 << 10,
        panel: st7789(40_000_000),
    },
    Board {
        name: "nrf52840",
        what: "nRF52840 (Cortex-M4F) with an ST7789",
        target: "cortex-m4f",
        clock_hz: 64_000_000,
        cycles: M4,
        flash_bytes: 1 << 20,
        ram_bytes: 256 << 10,
        panel: st7789(32_000_000),
    },
    Board {
        name: "esp32c3",
        what: "ESP32-C3 (RISC-V) with an ST7789",
        target: "riscv32imc",
        clock_hz: 160_000_000,
        cycles: C3,
        flash_bytes: 4 << 20,
        ram_bytes: 400 << 10,
        panel: st7789(80_000_000),
    },
    Board {
        name: "gba",
        what: "Game Boy Advance (ARM7TDMI), its own panel",
        target: "cortex-m0plus",
        clock_hz: 16_777_216,
        cycles: Cycles {
            each: 2.3,
            source: "cycles in mGBA over instructions of the Cortex-M0+ in QEMU, whose Thumb \
                     code is nearly the same; code runs from the cartridge's bus of 16 bits",
        },
        flash_bytes: 32 << 20,
        ram_bytes: 288 << 10,
        panel: Panel {
            name: "its own, which reads the memory by itself",
            screen: "gba-240x160",
            bits_a_pixel: 8,
            bits_a_second: 0,
            refresh_ms: 0,
        },
    },
];

impl Board {
    /// The board with another panel, sent to as fast as both can.
    #[must_use]
    pub fn showing(&self, panel: &fixel_scene::Panel) -> Self {
        let panel = match panel.feed {
            Feed::Memory { .. } => Panel {
                name: panel.name,
                screen: panel.name,
                ..self.panel
            },
            Feed::Serial { hz, settle_ms, .. } => {
                let bits_a_pixel = match panel.colour {
                    ColourFormat::Mono => 1,
                    ColourFormat::Gray4 => 4,
                    _ => 16,
                };
                let hz = f64::from(match self.panel.bits_a_second {
                    0 => hz,
                    most => hz.min(most),
                });
                // What a row has beside its pixels slows these down.
                let pixels = f64::from(panel.width * panel.height * bits_a_pixel);
                Panel {
                    name: panel.name,
                    screen: panel.name,
                    bits_a_pixel,
                    bits_a_second: (hz * pixels / f64::from(panel.frame_bits())).round() as u32,
                    refresh_ms: settle_ms,
                }
            }
        };
        Self { panel, ..*self }
    }

    /// The board's own panel, if a scene for such a display does not show on it as it is:
    /// because it is larger, or in colours that the panel has not.
    pub fn instead_of(
        &self,
        (width, height): (u32, u32),
        colour: ColourFormat,
    ) -> Option<&'static fixel_scene::Panel> {
        let panel = fixel_scene::Panel::named(self.panel.screen)?;
        let sorted = |width: u32, height: u32| [width.min(height), width.max(height)];
        let [short, long] = sorted(panel.width, panel.height);
        let [least, most] = sorted(width, height);
        // What has colours shows greys too.
        let colours = colour == panel.colour || panel.colour == ColourFormat::Rgb565;
        (least > short || most > long || !colours).then_some(panel)
    }

    /// The board of that name; the error names those that there are.
    ///
    /// # Errors
    /// If none is called that.
    pub fn find(name: &str) -> Result<&'static Self, String> {
        BOARDS
            .iter()
            .find(|board| board.name == name)
            .ok_or_else(|| {
                let names: Vec<_> = BOARDS.iter().map(|board| board.name).collect();
                format!("no board is called {name}; there are {}", names.join(", "))
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_that_does_not_show_gets_the_boards_own_panel() {
        let instead = |board: &str, panel: &str| {
            let panel = fixel_scene::Panel::named(panel).expect("a panel");
            let board = Board::find(board).expect("a board");
            let instead = board.instead_of((panel.width, panel.height), panel.colour);
            instead.map(|panel| panel.name)
        };
        for board in &BOARDS {
            assert_eq!(
                instead(board.name, board.panel.screen),
                None,
                "{}",
                board.name
            );
        }
        assert_eq!(instead("stm32l4", "st7789-240x320"), None);
        assert_eq!(instead("stm32l4", "ssd1306-128x64"), None);
        assert_eq!(instead("stm32l4", "sharp-400x240"), Some("st7789-320x240"));
        assert_eq!(
            instead("microbit", "st7735-160x128"),
            Some("ssd1306-128x64")
        );
        assert_eq!(
            instead("microbit", "sh1107-128x128"),
            Some("ssd1306-128x64")
        );
    }

    #[test]
    fn the_slower_of_board_and_panel_sets_the_rate() {
        let rate = |panel: &str, board: &str| {
            let panel = fixel_scene::Panel::named(panel).expect("a panel");
            let board = Board::find(board).expect("a board").showing(panel);
            board.panel.bits_a_second
        };
        assert_eq!(rate("st7789-240x240", "stm32f405"), 42_000_000);
        assert_eq!(rate("st7735-160x128", "stm32f405"), 15_000_000);
        // 400 of 416 bits a row are pixels.
        assert_eq!(rate("sharp-400x240", "stm32f405"), 1_923_077);
        assert_eq!(rate("gba-240x160", "gba"), 0);
    }
}
