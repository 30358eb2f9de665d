//! Panels by name: `panel = "st7789-240x240"` stands for width, height and
//! colour.

use crate::description::ColourFormat;

/// Name, width, height in pixels, colour depth.
type Panel = (&'static str, u32, u32, ColourFormat);

/// Panels in the orientation that their names say.
pub(super) const PANELS: &[Panel] = &[
    ("st7789-240x240", 240, 240, ColourFormat::Rgb565),
    ("st7789-320x240", 320, 240, ColourFormat::Rgb565),
    ("st7789-240x320", 240, 320, ColourFormat::Rgb565),
    ("st7789-135x240", 135, 240, ColourFormat::Rgb565),
    ("ili9341-320x240", 320, 240, ColourFormat::Rgb565),
    ("ili9341-240x320", 240, 320, ColourFormat::Rgb565),
    ("gc9a01-240x240", 240, 240, ColourFormat::Rgb565),
    ("st7735-128x160", 128, 160, ColourFormat::Rgb565),
    ("st7735-160x128", 160, 128, ColourFormat::Rgb565),
    ("ssd1351-128x128", 128, 128, ColourFormat::Rgb565),
    ("ssd1327-128x128", 128, 128, ColourFormat::Gray4),
    ("ssd1306-128x64", 128, 64, ColourFormat::Mono),
    ("sh1107-128x128", 128, 128, ColourFormat::Mono),
    ("uc8151-296x128", 296, 128, ColourFormat::Mono),
    ("ssd1681-200x200", 200, 200, ColourFormat::Mono),
];
