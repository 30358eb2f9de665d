//! Lights in an actor's own space, so that normals need no turning.

use crate::math::{FineLevel, Level, Rotation, decode_octahedral};
use crate::scene::layout::LIGHTS;
use crate::scene::{Material, Scene};

/// What reaches an actor's surface, with the material's coefficients.
#[derive(Clone, Copy, Debug)]
pub struct ModelLights {
    /// Level without any directional light, raw [`FineLevel`].
    ambient: u32,
    /// Towards each light, times its level: 1/1024 of a level is 1.
    lights: [[i32; 3]; LIGHTS],
    /// How many there are.
    count: usize,
}

const FULL: u32 = 255 << 6;

impl ModelLights {
    /// Darkness.
    pub const NONE: Self = Self {
        ambient: 0,
        lights: [[0; 3]; LIGHTS],
        count: 0,
    };

    /// The scene's lights as an actor with `rotation` (model to world) and
    /// `material` meets them.
    pub fn new(scene: &Scene<'_>, material: &Material, rotation: &Rotation) -> Self {
        let mut lights = Self::NONE;
        lights.set(scene, material, rotation);
        lights
    }

    /// The same where they stay.
    #[inline(never)]
    pub fn set(&mut self, scene: &Scene<'_>, material: &Material, rotation: &Rotation) {
        let to_model = rotation.transposed();
        let found = scene.lights();
        self.ambient = material.ambient.into();
        self.count = found.len().min(LIGHTS);
        self.lights = [[0; 3]; LIGHTS];
        for (slot, light) in self.lights.iter_mut().zip(found) {
            // Intensity (16 bits, up to 32) times diffuse (16 bits, up to 1)
            // times 255 levels of 1024 steps: 23 bits and a sign at most.
            let [intensity, ..] = light.colour;
            let strength = (u64::from(intensity) * u64::from(material.diffuse)) >> 16;
            let strength = (strength * 255) >> 6;
            *slot = to_model
                .apply(light.towards)
                .map(|c| i64::from(c).wrapping_mul(strength as i64))
                .map(|c| (c.wrapping_add(1 << 29) >> 30) as i32);
        }
    }

    /// The light level of a vertex with an octahedral normal in two bytes: `ambient
    /// + sum of max(0, N . l) * diffuse * intensity`, at most 255.
    #[inline]
    pub fn level(&self, [u, v]: [i8; 2]) -> FineLevel {
        let (normal, recip) = decode_octahedral([u, v].map(i32::from), 0);
        self.sum(normal, 0, recip)
    }

    /// The same for a normal of a fine mesh: 4 bits more each, in one byte.
    #[inline(always)]
    pub fn fine_level(&self, [u, v]: [i8; 2], low: u8) -> FineLevel {
        let [low_u, low_v] = [low & 15, low >> 4].map(i32::from);
        let code = [i32::from(u) << 4 | low_u, i32::from(v) << 4 | low_v];
        let (normal, recip) = decode_octahedral(code, 4);
        self.sum(normal, 4, recip)
    }

    /// The same for a face's normal: 10 bits and a sign each for x, y and z, from
    /// the lowest, 511 is 1; length 1.
    #[inline]
    pub fn face_level(&self, normal: u32) -> FineLevel {
        const RECIP: u32 = ((1 << 24) + 255) / 511;
        let part = |shift: u32| (normal as i32) << shift >> 22;
        let normal = [part(22), part(12), part(2)];
        // Two bits less of the lights keep the product within 30.
        self.sum(normal, 2, RECIP)
    }

    /// Ambient and the lights' sum. `recip` is 2^22 over the length of the normal
    /// `/ 2^extra`.
    #[inline(always)]
    fn sum(&self, [x, y, z]: [i32; 3], extra: u32, recip: u32) -> FineLevel {
        let mut level = self.ambient;
        for light in self.lights.iter().take(self.count) {
            let [lx, ly, lz] = light.map(|c| c >> extra);
            let [x, y, z] = [x.wrapping_mul(lx), y.wrapping_mul(ly), z.wrapping_mul(lz)];
            let dot = x.wrapping_add(y).wrapping_add(z).max(0) as u32;
            // 65535 is past full light for every length; see the test.
            level += ((dot >> 9).min(65535) * recip) >> 17;
        }
        FineLevel::from_bits(level.min(FULL) as u16)
    }
}

/// A level rounded to a table's index.
#[inline(always)]
pub fn round_level(level: FineLevel) -> Level {
    ((u32::from(level.to_bits()) + 32) >> 6) as Level
}
