//! An attitude indicator on a round panel of 240x240: a ball is turned by what a gyroscope
//! would say.

use fixel::math::Angle;
use fixel::{Display, Renderer, Scene, SceneError};

static SCENE: &[u8] = fixel::include_scene!(OUT_DIR, "attitude.fxl");
/// Places among the actors of `scenes/attitude.toml`.
const BALL: u16 = 0;
const POINTER: u16 = 1;

/// The instrument.
#[derive(Debug)]
pub struct Attitude {
    scene: Scene<'static>,
    renderer: Renderer<240, 16>,
}

impl Attitude {
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

    /// Shows how an aircraft lies: nose up, right wing down, and where it heads.
    ///
    /// # Errors
    /// Those of the display.
    pub fn draw<P: Display>(
        &mut self,
        [pitch, roll, heading]: [Angle; 3],
        panel: &mut P,
    ) -> Result<(), P::Error> {
        let mut pose = self.scene.pose(0);
        // Heading first, then pitch, then roll: the order in which actors turn.
        let moved = [
            pose.turned(&self.scene, BALL, [pitch, heading, roll]),
            pose.turned(&self.scene, POINTER, [Angle::ZERO, Angle::ZERO, roll]),
        ];
        pose.moved = &moved;
        self.renderer.draw(&self.scene, &pose, panel)?;
        Ok(())
    }
}
