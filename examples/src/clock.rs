//! A wireframe clock on a monochrome OLED of 128x64: hands as actors, and beside them the
//! time in letters of `embedded-graphics`.

use core::fmt::Write;

use embedded_graphics::mono_font::ascii::{FONT_6X10, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, text::Text};
use fixel::math::Angle;
use fixel::{Display, Renderer, Scene, SceneError};

static SCENE: &[u8] = fixel::include_scene!(OUT_DIR, "clock.fxl");
/// Places among the actors of `scenes/clock.toml`.
const DIAL: u16 = 0;
const HOURS: u16 = 1;
const MINUTES: u16 = 2;

/// The clock: 128 columns in bands of 8 rows, the pages of an SSD1306.
#[derive(Debug)]
pub struct Clock {
    scene: Scene<'static>,
    renderer: Renderer<128, 8, 16, 2, 3>,
}

impl Clock {
    /// Checks the scene.
    ///
    /// # Errors
    /// If it is damaged.
    pub fn new() -> Result<Self, SceneError> {
        Ok(Self {
            scene: Scene::embedded(SCENE)?,
            renderer: Renderer::new(),
        })
    }

    /// Shows a second of the day.
    ///
    /// # Errors
    /// Those of the display.
    pub fn draw<P: Display>(
        &mut self,
        second: u32,
        date: &str,
        panel: &mut P,
    ) -> Result<(), P::Error> {
        let (scene, mut pose) = (&self.scene, self.scene.pose(0));
        // The dial sways by 40 degrees either way, once in 40 seconds.
        let sway = Angle::fraction(second, 40).sin_cos().0 / 9 * 4;
        let swayed = [Angle::ZERO, Angle::from_bits(sway as u32), Angle::ZERO];
        // Clockwise is about -z.
        let hand = |seconds| {
            let angle = Angle::fraction(second, seconds).to_bits().wrapping_neg();
            [Angle::ZERO, Angle::ZERO, Angle::from_bits(angle)]
        };
        let moved = [
            pose.turned(scene, DIAL, swayed),
            pose.turned(scene, HOURS, hand(12 * 3600)),
            pose.turned(scene, MINUTES, hand(3600)),
        ];
        pose.moved = &moved;

        let mut time = heapless::String::<8>::new();
        // It has five letters.
        let _ = write!(time, "{:02}:{:02}", second / 3600 % 24, second / 60 % 60);
        let style = |font: &'static MonoFont<'static>| MonoTextStyle::new(font, BinaryColor::On);
        self.renderer.draw_over(scene, &pose, panel, |over| {
            let Ok(_) = Text::new(&time, Point::new(70, 32), style(&FONT_10X20)).draw(over);
            let Ok(_) = Text::new(date, Point::new(72, 48), style(&FONT_6X10)).draw(over);
        })?;
        Ok(())
    }
}
