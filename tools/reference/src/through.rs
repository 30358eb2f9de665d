//! How what is behind a face shows through.

use fixel_scene::{Material, Scene, Transparency};

/// How what is behind a face shows through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Through {
    /// Not at all.
    Opaque,
    /// At some pixels: see [`Transparency::ScreenDoor`].
    Door(ScreenDoor),
    /// Mixed; of the colour seen, so much is the face's.
    Blend(f64),
}

/// A pattern of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ScreenDoor {
    /// How many of them are drawn before this material.
    before: usize,
    opacity: f64,
}

impl ScreenDoor {
    /// Whether the surface is drawn at a pixel of its viewport.
    pub fn draws(&self, [x, y]: [u32; 2]) -> bool {
        // Bayer's recursion: M of twice the size is 4 M + (0 2 / 3 1), the corners of
        // each square of the smaller size in turn.
        let (mut threshold, mut side) = (0, 4);
        for weight in [1, 4, 16] {
            let corner = (x / side % 2, y / side % 2);
            threshold += weight
                * match corner {
                    (0, 0) => 0,
                    (1, 0) => 2,
                    (0, 1) => 3,
                    _ => 1,
                };
            side /= 2;
        }
        let shifted = (threshold + 64 - 16 * (self.before % 4)) % 64;
        (shifted as f64) < (64.0 * self.opacity).round()
    }
}

impl Through {
    /// Of each material of a scene.
    pub fn all(scene: &Scene) -> Vec<Self> {
        let mut before = 0;
        let mut of = |material: &Material| {
            let opacity = material.opacity;
            match material.transparency {
                _ if opacity >= 1.0 => Self::Opaque,
                Transparency::Blend => Self::Blend(opacity),
                Transparency::ScreenDoor => {
                    let door = ScreenDoor { before, opacity };
                    before += 1;
                    Self::Door(door)
                }
            }
        };
        scene.materials.iter().map(&mut of).collect()
    }
}
