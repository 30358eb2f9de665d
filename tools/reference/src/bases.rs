//! The base colours of textures, and what light makes of them.

use crate::hit::Hit;
use crate::oklab::oklab;
use crate::path::Path;
use fixel_scene::Rgb;
use glam::DVec3;

/// The light of the truth as [`Frame::light`] has it.
pub(crate) struct Lights<'a> {
    paths: &'a [Path],
    bases: Vec<Nearest>,
}

impl<'a> Lights<'a> {
    /// For the materials of a scene.
    pub fn new(paths: &'a [Path]) -> Self {
        Self {
            paths,
            bases: paths.iter().map(Nearest::of).collect(),
        }
    }

    /// At one pixel, unrounded.
    pub fn of(&self, hit: &Hit) -> [f64; 3] {
        match self.paths[hit.material] {
            _ if hit.hidden => [0.0; 3],
            Path::Level(_) | Path::Textured { .. } => [hit.level; 3],
            Path::Colour | Path::TexturedColour { .. } => {
                let colour = self.bases[hit.material].colour(hit);
                colour.map(|channel| 255.0 * channel)
            }
        }
    }
}

/// The base colours of a path, in Oklab, and as they are.
pub(crate) struct Nearest(Vec<(DVec3, Rgb)>);

impl Nearest {
    pub fn of(path: &Path) -> Self {
        let unit = |base: &[u8; 3]| base.map(|c| f64::from(c) / 255.0);
        match path {
            Path::Textured { bases, .. } | Path::TexturedColour { bases } => {
                Self(bases.iter().map(|b| (oklab(unit(b)), unit(b))).collect())
            }
            _ => Self(Vec::new()),
        }
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// The nearest to a colour.
    pub fn index(&self, colour: Rgb) -> usize {
        let target = oklab(colour);
        let distance = |i: &usize| self.0[*i].0.distance_squared(target);
        let all = 0..self.0.len();
        all.min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    }

    /// The colour of a surface whose texels become these bases; as it is if there are
    /// none, or no known texels.
    pub fn colour(&self, hit: &Hit) -> Rgb {
        let parts = hit.texels.iter().map(|(_, weight)| weight).sum::<f64>();
        if self.0.is_empty() || parts == 0.0 {
            return hit.colour;
        }
        let seen = hit.texels.iter().filter(|(_, weight)| *weight > 0.0);
        let based = seen.map(|(texel, weight)| {
            let base = self.0[self.index(*texel)].1;
            base.map(|channel| channel * weight)
        });
        let texel = based.fold([0.0; 3], |sum, part| [0, 1, 2].map(|c| sum[c] + part[c]));
        let [own, gloss] = hit.own_and_gloss;
        [0, 1, 2].map(|c| (texel[c] * own[c] + gloss[c]).clamp(0.0, 1.0))
    }
}
