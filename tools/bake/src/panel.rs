//! A baked scene for another panel than it was baked for.

use fixel_scene::{ColourFormat, Screen};

use crate::blob::{Baked, seal};
use crate::error::{BakeError, Problem};
use crate::records::{colour_format, panel_dithering};
use crate::unbake;

/// Raw bits of the largest tangent of half a view angle: 179 degrees.
const WIDEST: f64 = 114.0 * 16_777_216.0;

impl Baked {
    /// The same for a panel: its size, colour and dithering stand in the header instead of
    /// those that were baked, and the camera sees as much in width as it did
    /// ([`Screen::widening`]). The palette stays, so baking the scene anew for the panel
    /// (see [`fixel_scene::Loader::on`]) may look better.
    ///
    /// # Errors
    /// For a scene without a palette, which shows on panels of RGB565 alone.
    pub fn on(&self, screen: &Screen) -> Result<Self, BakeError> {
        let scene = self.scene()?;
        let mut header = *scene.header();
        let panel = &screen.panel;
        if header.direct && panel.colour != ColourFormat::Rgb565 {
            let what = "a scene baked without a palette on a panel of another colour than rgb565";
            return Err(Problem::NotYet { what: what.into() }.into());
        }
        let (width, height) = (u32::from(header.width), u32::from(header.height));
        let widened = f64::from(header.camera.half_height) * screen.widening(width, height);
        header.camera.half_height = widened.min(WIDEST).round() as u32;
        header.width = panel.width as u16;
        header.height = panel.height as u16;
        let own = unbake::panel_dithering(scene.panel_dithering());
        let dithering = screen.dithering(unbake::colour_format(scene.colour_format()), own);
        header.colour_format = colour_format(panel.colour);
        header.panel_dithering = panel_dithering(dithering) as u8;
        let mut words = self.words().to_vec();
        seal(&mut words, header);
        Ok(Self::of_words(words, self.sources.clone()))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use fixel::scene::{self as core_scene, PanelDithering};
    use fixel_scene::{Disk, Loader, Panel};

    use super::*;

    fn screen(name: &str) -> Screen {
        Screen {
            panel: *Panel::named(name).unwrap(),
            dithering: Some(fixel_scene::PanelDithering::BlueNoise),
        }
    }

    /// Of the teapot, the header is all that a panel changes.
    #[test]
    fn the_scene_baked_anew_is_the_same() {
        let path = Path::new("../../scenes/teapot.toml");
        let bake = |loader: Loader<'_>| crate::bake(&loader.load(path).unwrap().0).unwrap();
        let baked = bake(Loader::new(&Disk));
        for name in ["st7789-240x240", "ssd1306-128x64"] {
            let own = bake(Loader::new(&Disk).on(screen(name)));
            let on = baked.on(&screen(name)).unwrap();
            let [own, on] = [&own, &on].map(|baked| baked.scene().unwrap());
            let [mut first, mut second] = [*own.header(), *on.header()];
            let angles = [&mut first, &mut second].map(|header| &mut header.camera.half_height);
            assert!(angles[0].abs_diff(*angles[1]) <= 1, "{name}");
            *angles[0] = *angles[1];
            (first.length, first.checksum) = (second.length, second.checksum);
            // The palette suits what is seen.
            first.dither_spread = second.dither_spread;
            assert_eq!(first, second, "{name}");
        }
        let oled = baked.on(&screen("ssd1306-128x64")).unwrap();
        let oled = oled.scene().unwrap();
        assert_eq!(oled.colour_format(), core_scene::ColourFormat::Mono);
        assert_eq!(oled.panel_dithering(), PanelDithering::BlueNoise);
    }

    #[test]
    fn without_a_palette_there_is_no_grey() {
        let direct = fixel_scene::load(Path::new("../../scenes/direct.toml")).unwrap();
        let direct = crate::bake(&direct).unwrap();
        assert!(direct.on(&screen("st7789-240x240")).is_ok());
        assert!(direct.on(&screen("ssd1306-128x64")).is_err());
    }
}
