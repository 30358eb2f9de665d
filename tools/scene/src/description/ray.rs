//! How rays are cast.

/// How the ray caster works; the rasteriser has no use for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Whether lights cast shadows.
    pub shadows: bool,
    /// The most rays in a chain from the eye on, the eye's own counted, 1..=8; the
    /// next one would see the background.
    pub depth: u32,
    /// Rays of a pixel that differs from a neighbour: 1, 4, 8 or 16.
    pub samples: u32,
    /// A channel's difference, 0..=1, beyond which two neighbours differ. They also
    /// do where another actor is in front.
    pub threshold: f64,
    /// Shadow rays to a light that has edges, 1..=16.
    pub light_samples: u32,
}

impl Default for Ray {
    fn default() -> Self {
        Self {
            shadows: true,
            depth: 4,
            samples: 1,
            threshold: 0.1,
            light_samples: 4,
        }
    }
}
