//! Panels by name: `panel = "st7789-240x240"` stands for width, height and colour.

use crate::bare;
use crate::description::{ColourFormat, Display, PanelDithering, Scene};

/// A panel in the orientation that its name says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Panel {
    /// As scene files and commands call it.
    pub name: &'static str,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// What a pixel can be.
    pub colour: ColourFormat,
    /// How a frame gets there.
    pub feed: Feed,
}

/// How a frame gets onto a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feed {
    /// Over a serial bus, after which the glass may take its time.
    Serial {
        /// The fastest clock that the controller's data sheet allows for writing, or that
        /// boards commonly run it at, in Hz: a bit each.
        hz: u32,
        /// Bits of a pixel on the bus.
        pixel_bits: u32,
        /// Bits of a row beside its pixels: its address, a trailer.
        row_bits: u32,
        /// Until the next frame may come, in milliseconds; 0: at once.
        settle_ms: u32,
    },
    /// It shows what is in memory, so many thousand frames a thousand seconds.
    Memory {
        /// Thousandths of a frame a second.
        millihertz: u32,
    },
}

impl Panel {
    /// The panel of a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        PANELS.iter().find(|panel| panel.name == name)
    }

    /// Bits of a whole frame on its bus; 0 if it has none.
    pub fn frame_bits(&self) -> u32 {
        match self.feed {
            Feed::Serial {
                pixel_bits,
                row_bits,
                ..
            } => (self.width * pixel_bits + row_bits) * self.height,
            Feed::Memory { .. } => 0,
        }
    }

    /// Seconds from frame to frame when the bus never waits.
    pub fn frame_seconds(&self) -> f64 {
        match self.feed {
            Feed::Serial { hz, settle_ms, .. } => {
                f64::from(self.frame_bits()) / f64::from(hz) + f64::from(settle_ms) / 1e3
            }
            Feed::Memory { millihertz } => 1e3 / f64::from(millihertz),
        }
    }
}

/// A colour panel on SPI.
const fn colour(name: &'static str, width: u32, height: u32, hz: u32) -> Panel {
    Panel {
        name,
        width,
        height,
        colour: ColourFormat::Rgb565,
        feed: Feed::Serial {
            hz,
            pixel_bits: 16,
            row_bits: 0,
            settle_ms: 0,
        },
    }
}

/// A black-and-white one on SPI.
const fn mono(name: &'static str, width: u32, height: u32, feed: (u32, u32, u32)) -> Panel {
    let (hz, row_bits, settle_ms) = feed;
    Panel {
        name,
        width,
        height,
        colour: ColourFormat::Mono,
        feed: Feed::Serial {
            hz,
            pixel_bits: 1,
            row_bits,
            settle_ms,
        },
    }
}

const MHZ: u32 = 1_000_000;

/// All panels that have a name. Clocks are those of writing: of the ST7789 62.5 MHz, of the
/// GC9A01 and the ILI9341 what boards run them at (data sheets: 100 and 10 MHz), of the rest
/// the data sheets'. E-paper takes 300 ms (partial refresh) after its data.
pub const PANELS: &[Panel] = &[
    colour("st7789-240x240", 240, 240, 62_500_000),
    colour("st7789-320x240", 320, 240, 62_500_000),
    colour("st7789-240x320", 240, 320, 62_500_000),
    colour("st7789-135x240", 135, 240, 62_500_000),
    colour("ili9341-320x240", 320, 240, 40 * MHZ),
    colour("ili9341-240x320", 240, 320, 40 * MHZ),
    colour("gc9a01-240x240", 240, 240, 62_500_000),
    colour("st7735-128x160", 128, 160, 15 * MHZ),
    colour("st7735-160x128", 160, 128, 15 * MHZ),
    colour("ssd1351-128x128", 128, 128, 20 * MHZ),
    Panel {
        name: "ssd1327-128x128",
        width: 128,
        height: 128,
        colour: ColourFormat::Gray4,
        feed: Feed::Serial {
            hz: 10 * MHZ,
            pixel_bits: 4,
            row_bits: 0,
            settle_ms: 0,
        },
    },
    mono("ssd1306-128x64", 128, 64, (10 * MHZ, 0, 0)),
    mono("sh1107-128x128", 128, 128, (4 * MHZ, 0, 0)),
    mono("uc8151-296x128", 296, 128, (10 * MHZ, 0, 300)),
    mono("ssd1680-296x128", 296, 128, (20 * MHZ, 0, 300)),
    mono("ssd1681-200x200", 200, 200, (20 * MHZ, 0, 300)),
    mono("sharp-400x240", 400, 240, (2 * MHZ, 16, 0)),
    Panel {
        name: "gba-240x160",
        width: 240,
        height: 160,
        colour: ColourFormat::Rgb565,
        feed: Feed::Memory { millihertz: 59_727 },
    },
];

/// Ways of dithering by name, as `display.dithering` has them.
pub const DITHERINGS: &[(&str, PanelDithering)] = &[
    ("none", PanelDithering::None),
    ("bayer4", PanelDithering::Bayer4),
    ("bayer8", PanelDithering::Bayer8),
    ("blue_noise", PanelDithering::BlueNoise),
    ("floyd_steinberg", PanelDithering::FloydSteinberg),
];

/// A panel that a scene is loaded for, whatever its `[display]` says of size and colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screen {
    /// The panel.
    pub panel: Panel,
    /// How it shows greys between its own; without, as the scene says, or by blue noise if
    /// its display is no such panel. Nothing to a panel of more than 16 greys.
    pub dithering: Option<PanelDithering>,
}

impl Screen {
    /// How the panel is dithered, of a scene for a display of this colour, dithered so.
    pub fn dithering(&self, colour: ColourFormat, own: PanelDithering) -> PanelDithering {
        // A colour display is not dithered, so the scene says nothing of it: without, dim
        // things would be black altogether.
        let own = match colour.is_dithered() {
            true => own,
            false => PanelDithering::BlueNoise,
        };
        if self.panel.colour.is_dithered() {
            self.dithering.unwrap_or(own)
        } else {
            PanelDithering::None
        }
    }

    /// A scene's display on this panel.
    pub(crate) fn of(&self, display: Display) -> Display {
        Display {
            width: self.panel.width,
            height: self.panel.height,
            colour: self.panel.colour,
            dithering: self.dithering(display.colour, display.dithering),
            ..display
        }
    }

    /// A scene that was loaded for another display, without loading it anew: as
    /// [`Loader::on`](crate::Loader::on), but that cameras that were framed automatically
    /// stay where they are and see more in height too. Only panels of RGB565 do without a
    /// palette.
    pub fn apply(&self, scene: &mut Scene) {
        let widening = self.widening(scene.display.width, scene.display.height);
        let own = scene.viewports.iter_mut();
        let own = own.filter_map(|viewport| viewport.camera.as_mut());
        for camera in own.chain([&mut scene.camera]) {
            camera.projection.widen(widening);
        }
        scene.display = self.of(scene.display.clone());
        if scene.source.bare {
            scene.display.background = bare::background(self.panel.colour);
        }
        scene.palette.direct &= self.panel.colour == ColourFormat::Rgb565;
    }

    /// How much more than before is to be seen in height, so that nothing is lost in width
    /// to a panel that is narrower for its height than a picture of `width` by `height`:
    /// a factor of at least 1.
    pub fn widening(&self, width: u32, height: u32) -> f64 {
        let aspect = |width: u32, height: u32| f64::from(width) / f64::from(height);
        (aspect(width, height) / aspect(self.panel.width, self.panel.height)).max(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Loader;
    use crate::description::Background;
    use crate::files::InMemory;
    use std::path::Path;

    /// Loaded for it or shown on it: a mesh alone has black behind it where greys are dithered.
    #[test]
    fn no_stars_behind_a_bare_mesh() {
        let mut files = InMemory::default();
        let mesh = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        files.insert(Path::new("a.obj"), mesh.to_vec());
        let screen = |name| Screen {
            panel: *Panel::named(name).unwrap(),
            dithering: None,
        };
        let load = |loader: Loader<'_>| loader.load(Path::new("a.obj")).unwrap().0;
        let (grey, coloured) = (screen("ssd1306-128x64"), screen("st7789-240x240"));
        let black = Background::Solid([0.0; 3]);
        assert_eq!(load(Loader::new(&files).on(grey)).display.background, black);
        let mut scene = load(Loader::new(&files).on(coloured));
        assert_ne!(scene.display.background, black);
        grey.apply(&mut scene);
        assert_eq!(scene.display.background, black);
        coloured.apply(&mut scene);
        assert_ne!(scene.display.background, black);
    }

    #[test]
    fn names_say_the_size_and_are_different() {
        for (i, panel) in PANELS.iter().enumerate() {
            let size = format!("-{}x{}", panel.width, panel.height);
            assert!(panel.name.ends_with(&size), "{}", panel.name);
            let first = PANELS.iter().position(|other| other.name == panel.name);
            assert_eq!(first, Some(i), "{}", panel.name);
        }
    }

    #[test]
    fn frames_a_second() {
        let rate = |name| 1.0 / Panel::named(name).unwrap().frame_seconds();
        // 320 * 240 * 16 bits at 62.5 MHz; (400 + 16) * 240 at 2 MHz.
        assert!((rate("st7789-320x240") - 50.86).abs() < 0.01);
        assert!((rate("sharp-400x240") - 20.03).abs() < 0.01);
        assert!((rate("gba-240x160") - 59.727).abs() < 1e-9);
        assert!((rate("ssd1681-200x200") - 3.31).abs() < 0.01);
    }

    #[test]
    fn dithering_is_what_was_asked_for_or_the_scene_says_or_suits_the_panel() {
        use ColourFormat::{Gray4, Mono, Rgb565};
        use PanelDithering::{Bayer4, BlueNoise, None as Not};
        let on = |name, asked, colour, own| {
            let panel = *Panel::named(name).unwrap();
            let screen = Screen {
                panel,
                dithering: asked,
            };
            screen.dithering(colour, own)
        };
        assert_eq!(on("ssd1306-128x64", None, Rgb565, Not), BlueNoise);
        assert_eq!(on("ssd1306-128x64", None, Mono, Not), Not);
        assert_eq!(on("ssd1306-128x64", None, Gray4, Bayer4), Bayer4);
        assert_eq!(on("ssd1306-128x64", Some(Not), Rgb565, Not), Not);
        assert_eq!(on("st7789-240x240", Some(Bayer4), Mono, Bayer4), Not);
    }

    #[test]
    fn a_narrower_panel_sees_more_in_height() {
        let screen = |name| Screen {
            panel: *Panel::named(name).unwrap(),
            dithering: None,
        };
        assert!((screen("st7789-240x240").widening(320, 240) - 4.0 / 3.0).abs() < 1e-12);
        assert_eq!(screen("ssd1306-128x64").widening(320, 240), 1.0);
    }
}
