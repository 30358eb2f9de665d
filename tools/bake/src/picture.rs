//! Textures as pictures: sides that are powers of two, smaller copies, and what is seen
//! of them at a place.

use fixel_scene::{Filter, Rgb, Scene, Texturing, Wrap};
use glam::{DVec2, DVec3};

/// The longest side of a texture.
const MOST_TEXELS: u32 = 1024;

/// A colour and its alpha, each in 0..=1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Texel {
    pub colour: Rgb,
    pub alpha: f64,
}

/// Texels by rows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture {
    pub width: usize,
    pub height: usize,
    pub texels: Vec<Texel>,
}

impl Picture {
    /// A material's texture and, if it wants them, its smaller copies.
    pub(crate) fn copies(scene: &Scene, how: &Texturing) -> Vec<Self> {
        Self::new(&scene.textures[how.texture]).with_copies(how.mipmaps)
    }

    /// A texture with sides that are powers of two: each becomes the nearest one, by
    /// ratio, and at most [`MOST_TEXELS`]; new texels are the means of the area that
    /// they cover.
    fn new(texture: &fixel_scene::Texture) -> Self {
        let unit = |texel: &[u8; 4]| {
            let [red, green, blue, alpha] = texel.map(|channel| f64::from(channel) / 255.0);
            Texel {
                colour: [red, green, blue],
                alpha,
            }
        };
        let picture = Self {
            width: texture.width as usize,
            height: texture.height as usize,
            texels: texture.texels.iter().map(unit).collect(),
        };
        let [width, height] = [texture.width, texture.height].map(nearest_power);
        if [width, height] == [picture.width, picture.height] {
            picture
        } else {
            picture.resized(width, height)
        }
    }

    fn resized(&self, width: usize, height: usize) -> Self {
        let columns: Vec<_> = (0..width).map(|i| covered(i, width, self.width)).collect();
        let rows: Vec<_> = (0..height)
            .map(|j| covered(j, height, self.height))
            .collect();
        let mut texels = Vec::with_capacity(width * height);
        for row in &rows {
            for column in &columns {
                let of_row = |&(y, down): &(usize, f64)| {
                    let old = &self.texels[y * self.width..];
                    column
                        .iter()
                        .map(move |(x, across)| (old[*x], across * down))
                };
                texels.push(mean(row.iter().flat_map(of_row)));
            }
        }
        Self {
            width,
            height,
            texels,
        }
    }

    /// What is seen at a place, (0, 0) being the lower left corner of the picture and
    /// (1, 1) the upper right one: the texel around it, or a blend of the four whose
    /// centres are.
    pub(crate) fn seen(&self, how: &Texturing, place: DVec2) -> DVec3 {
        let at = DVec2::new(
            place.x * self.width as f64,
            (1.0 - place.y) * self.height as f64,
        );
        let nearest = self.texel(how.wrap, at.floor());
        if how.filter == Filter::Nearest {
            return nearest.colour.into();
        }
        let corner = (at - 0.5).floor();
        let part = at - 0.5 - corner;
        let (mut sum, mut whole) = (DVec3::ZERO, 0.0);
        for (dx, dy) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let along = |d: f64, part: f64| if d == 0.0 { 1.0 - part } else { part };
            let texel = self.texel(how.wrap, corner + DVec2::new(dx, dy));
            if texel.alpha >= how.alpha_test {
                let weight = along(dx, part.x) * along(dy, part.y);
                sum += weight * DVec3::from(texel.colour);
                whole += weight;
            }
        }
        if whole > 0.0 {
            sum / whole
        } else {
            nearest.colour.into()
        }
    }

    /// The texel of a whole column and row from the top left, wrapped.
    fn texel(&self, wrap: Wrap, at: DVec2) -> Texel {
        let within = |i: f64, size: usize| {
            let (i, size) = (i as i64, size as i64);
            let within = match wrap {
                Wrap::Clamp => i.clamp(0, size - 1),
                Wrap::Repeat => i.rem_euclid(size),
                Wrap::Mirror => {
                    let i = i.rem_euclid(2 * size);
                    i.min(2 * size - 1 - i)
                }
            };
            within as usize
        };
        self.texels[within(at.y, self.height) * self.width + within(at.x, self.width)]
    }

    /// Itself, and if wanted its halves.
    fn with_copies(self, wanted: bool) -> Vec<Self> {
        let mut copies = vec![self];
        while let Some(last) = copies.last().filter(|last| wanted && last.texels.len() > 1) {
            let (width, height) = ((last.width / 2).max(1), (last.height / 2).max(1));
            copies.push(last.resized(width, height));
        }
        copies
    }
}

/// The power of two that is nearest by ratio.
fn nearest_power(size: u32) -> usize {
    let lower = 1 << size.ilog2();
    // Above the geometric mean of two powers: size^2 > 2 lower^2.
    let up = u64::from(size) * u64::from(size) > 2 * lower * lower;
    let power = if up { 2 * lower } else { lower };
    power.min(MOST_TEXELS.into()) as usize
}

/// The old texels that a new one covers, and how much it covers of each.
fn covered(at: usize, new: usize, old: usize) -> Vec<(usize, f64)> {
    // In units of 1/new of an old texel, so that all is whole.
    let (start, end) = (at * old, (at + 1) * old);
    let part = |i: usize| end.min((i + 1) * new) - start.max(i * new);
    (start / new..end.div_ceil(new))
        .map(|i| (i, part(i) as f64))
        .collect()
}

/// The weighted mean, colours weighted by alpha too; of texels that nothing is seen
/// of, by their weights alone.
fn mean(parts: impl Iterator<Item = (Texel, f64)>) -> Texel {
    let (mut weights, mut alpha) = (0.0, 0.0);
    let (mut plain, mut seen) = ([0.0; 3], [0.0; 3]);
    for (texel, weight) in parts {
        weights += weight;
        alpha += weight * texel.alpha;
        plain = [0, 1, 2].map(|c| plain[c] + weight * texel.colour[c]);
        seen = [0, 1, 2].map(|c| seen[c] + weight * texel.alpha * texel.colour[c]);
    }
    let colour = if alpha > 0.0 {
        seen.map(|channel| channel / alpha)
    } else {
        plain.map(|channel| channel / weights)
    };
    Texel {
        colour,
        alpha: alpha / weights,
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A texture of these texels, in rows of `width`.
    pub(crate) fn picture(width: u32, texels: &[[u8; 4]]) -> fixel_scene::Texture {
        fixel_scene::Texture {
            name: "made".into(),
            width,
            height: texels.len() as u32 / width,
            texels: texels.to_vec(),
        }
    }

    #[test]
    fn sides_become_powers_of_two() {
        let sides = [1, 2, 3, 5, 6, 11, 12, 90, 91, 1024, 1500, 8192];
        let powers = [1, 2, 4, 4, 8, 8, 16, 64, 128, 1024, 1024, 1024];
        assert_eq!(sides.map(nearest_power), powers);
        // Three columns over two, and over four.
        assert_eq!(covered(0, 2, 3), [(0, 2.0), (1, 1.0)]);
        assert_eq!(covered(1, 2, 3), [(1, 1.0), (2, 2.0)]);
        assert_eq!(covered(1, 4, 3), [(0, 1.0), (1, 2.0)]);
        assert_eq!(covered(2, 4, 4), [(2, 4.0)]);
    }

    #[test]
    fn texels_are_the_means_of_what_they_cover() {
        let grey = |v: u8| [v, v, v, 255];
        let three = picture(3, &[grey(0), grey(90), grey(240)]);
        let resized = Picture::new(&three).resized(2, 1);
        let greys = resized.texels.iter().map(|t| (t.colour[0] * 255.0).round());
        assert_eq!(greys.collect::<Vec<_>>(), [30.0, 190.0]);
        let red = [200, 0, 0, 255];
        let half = Picture::new(&picture(2, &[red, [0, 99, 0, 0]])).resized(1, 1);
        assert_eq!(half.texels[0].alpha, 0.5);
        assert!((half.texels[0].colour[0] * 255.0 - 200.0).abs() < 1e-9);
        assert_eq!(half.texels[0].colour[1], 0.0);
    }

    #[test]
    fn places_are_blended_and_wrapped() {
        let grey = |v: u8| [v, v, v, 255];
        // 0 and 100 above 200 and 40.
        let four = Picture::new(&picture(2, &[0, 100, 200, 40].map(grey)));
        let seen = |filter, wrap, x, y| {
            let how = Texturing {
                filter,
                wrap,
                ..Texturing::new(0)
            };
            (four.seen(&how, DVec2::new(x, y)).x * 255.0).round()
        };
        let nearest = |x, y| seen(Filter::Nearest, Wrap::Repeat, x, y);
        assert_eq!([nearest(0.25, 0.75), nearest(1.75, -0.75)], [0.0, 40.0]);
        let blended = |x, y, wrap| seen(Filter::Bilinear, wrap, x, y);
        assert_eq!(blended(0.5, 0.75, Wrap::Repeat), 50.0);
        assert_eq!(blended(0.5, 0.5, Wrap::Clamp), 85.0);
        assert_eq!(blended(0.0, 0.75, Wrap::Repeat), 50.0);
        assert_eq!(blended(0.0, 0.75, Wrap::Mirror), 0.0);
    }
}
