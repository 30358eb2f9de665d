//! A dashboard in two dimensions with a gear box in three: `embedded-graphics` draws over
//! each band before it goes to the panel, so nothing flickers.

use core::fmt::Write;

use embedded_graphics::mono_font::ascii::{FONT_6X10, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, text::Text};
use fixel::math::Angle;
use fixel::{Display, Renderer, Scene, SceneError};

static SCENE: &[u8] = fixel::include_scene!(OUT_DIR, "dashboard.fxl");
/// Places among the actors of `scenes/dashboard.toml`.
const WHEEL: u16 = 0;
const PINION: u16 = 1;
/// Teeth of the wheel for each of the pinion.
const RATIO: u32 = 2;

/// As in the scene's palette.
const ORANGE: Rgb565 = Rgb565::new(31, 38, 4);
const EMPTY: Rgb565 = Rgb565::new(5, 14, 10);

/// What the machine measures.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// How far the wheel has turned.
    pub turn: Angle,
    /// Revolutions a minute, 0..=3000.
    pub speed: u32,
    /// Degrees Celsius, 0..=120.
    pub oil: u32,
    /// Per cent of the highest load.
    pub load: u32,
}

/// The dashboard.
#[derive(Debug)]
pub struct Dashboard {
    scene: Scene<'static>,
    renderer: Renderer<320, 16>,
}

impl Dashboard {
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

    /// Shows a reading.
    ///
    /// # Errors
    /// Those of the display.
    pub fn draw<P: Display>(&mut self, reading: &Reading, panel: &mut P) -> Result<(), P::Error> {
        let (scene, mut pose) = (&self.scene, self.scene.pose(0));
        let wheel = reading.turn.to_bits();
        // The other way round, and half a tooth on.
        let pinion = wheel
            .wrapping_mul(RATIO)
            .wrapping_neg()
            .wrapping_add(u32::MAX / 24);
        let about_z = |bits| [Angle::ZERO, Angle::ZERO, Angle::from_bits(bits)];
        let moved = [
            pose.turned(scene, WHEEL, about_z(wheel)),
            pose.turned(scene, PINION, about_z(pinion)),
        ];
        pose.moved = &moved;

        let gauges = [
            ("SPEED", reading.speed, "rpm", 3000),
            ("OIL", reading.oil, "C", 120),
            ("LOAD", reading.load, "%", 100),
        ];
        self.renderer.draw_over(scene, &pose, panel, |over| {
            let style = |font: &'static MonoFont<'static>| MonoTextStyle::new(font, Rgb565::WHITE);
            let title = Text::new("GEAR BOX 1", Point::new(14, 30), style(&FONT_10X20));
            let Ok(_) = title.draw(over);
            for (y, (name, value, unit, most)) in (66..).step_by(58).zip(gauges) {
                let mut text = heapless::String::<16>::new();
                // Numbers of that size fit.
                let _ = write!(text, "{value} {unit}");
                let Ok(_) = Text::new(name, Point::new(14, y), style(&FONT_6X10)).draw(over);
                let Ok(_) = Text::new(&text, Point::new(14, y + 20), style(&FONT_10X20)).draw(over);
                let length = (value.min(most) * 106).checked_div(most).unwrap_or(0);
                for (width, colour) in [(106, EMPTY), (length, ORANGE)] {
                    let bar = Rectangle::new(Point::new(14, y + 28), Size::new(width, 6));
                    let Ok(()) = bar
                        .into_styled(PrimitiveStyle::with_fill(colour))
                        .draw(over);
                }
            }
        })?;
        Ok(())
    }
}
