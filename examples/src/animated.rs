//! Scenes that move by themselves: all there is to do is to draw them.

use fixel::{Display, Renderer, Scene, SceneError, include_scene};

/// A triangle whose corners have colours of their own; 240 columns.
pub static HELLO_TRIANGLE: &[u8] = include_scene!(OUT_DIR, "hello_triangle.fxl");
/// A logo that shines while it spins; 320 columns.
pub static SPINNING_LOGO: &[u8] = include_scene!(OUT_DIR, "spinning_logo.fxl");
/// Hills coloured by their height; 320 columns.
pub static HEAT_MAP: &[u8] = include_scene!(OUT_DIR, "heat_map.fxl");
/// The earth in the sun's light; 240 columns.
pub static GLOBE: &[u8] = include_scene!(OUT_DIR, "globe.fxl");

/// One of them, in bands of 16 rows of a panel of `WIDTH` columns.
#[derive(Debug)]
pub struct Animated<const WIDTH: usize> {
    scene: Scene<'static>,
    renderer: Renderer<WIDTH, 16>,
}

impl<const WIDTH: usize> Animated<WIDTH> {
    /// Checks the scene.
    ///
    /// # Errors
    /// If it is damaged.
    pub fn new(scene: &'static [u8]) -> Result<Self, SceneError> {
        Ok(Self {
            scene: Scene::embedded(scene)?,
            renderer: Renderer::new(),
        })
    }

    /// Draws a frame of the animation.
    ///
    /// # Errors
    /// Those of the display.
    pub fn draw<P: Display>(&mut self, frame: u32, panel: &mut P) -> Result<(), P::Error> {
        let pose = self.scene.pose(frame);
        self.renderer.draw(&self.scene, &pose, panel)?;
        Ok(())
    }
}
