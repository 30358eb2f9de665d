//! Textures: copies of half the size, and the colour at a place.
//! [`fixel_scene::Texturing`] says what is meant.

use fixel_scene::{Filter, Texturing, Wrap};
use glam::{DVec2, DVec3, DVec4};

/// A texture and its smaller copies.
#[derive(Clone, Debug)]
pub(crate) struct Texture {
    copies: Vec<Copy>,
}

/// One size of a texture.
#[derive(Clone, Debug)]
struct Copy {
    width: usize,
    height: usize,
    /// Red, green, blue, alpha, each in 0..=1.
    texels: Vec<DVec4>,
}

/// What a texture shows at a pixel.
#[derive(Clone, core::marker::Copy, Debug, PartialEq)]
pub(crate) struct Texel {
    /// Red, green, blue.
    pub colour: DVec3,
    /// What it is blended of, with weights whose sum is 1.
    pub parts: [(DVec3, f64); 4],
    /// Whether it passes the alpha test.
    pub passes: bool,
}

impl Texture {
    /// The picture with all smaller copies.
    pub fn new(texture: &fixel_scene::Texture) -> Self {
        let unit = |texel: &[u8; 4]| DVec4::from(texel.map(f64::from)) / 255.0;
        let picture = Copy {
            width: texture.width as usize,
            height: texture.height as usize,
            texels: texture.texels.iter().map(unit).collect(),
        };
        let mut copies = vec![picture];
        while let Some(half) = copies.last().and_then(Copy::half) {
            copies.push(half);
        }
        Self { copies }
    }

    /// The place in the picture of texture coordinates, in texels.
    pub fn place(&self, [u, v]: [f64; 2]) -> DVec2 {
        let picture = &self.copies[0];
        DVec2::new(u * picture.width as f64, (1.0 - v) * picture.height as f64)
    }

    /// What is seen at a place of the picture whose neighbours a pixel to the right
    /// and down are so many texels away.
    pub fn texel(&self, place: DVec2, steps: [DVec2; 2], how: &Texturing) -> Texel {
        let number = if how.mipmaps { self.number(steps) } else { 0 };
        let copy = &self.copies[number];
        let picture = &self.copies[0];
        let shrink = DVec2::new(
            copy.width as f64 / picture.width as f64,
            copy.height as f64 / picture.height as f64,
        );
        copy.texel(place * shrink, how)
    }

    /// Which copy is right where a pixel is so many texels.
    fn number(&self, steps: [DVec2; 2]) -> usize {
        let largest = steps[0].abs().max(steps[1].abs()).max_element();
        let number = (largest.log2() + 0.5).floor();
        number.clamp(0.0, (self.copies.len() - 1) as f64) as usize
    }
}

impl Copy {
    /// Half as wide and high, unless it is a single texel.
    fn half(&self) -> Option<Self> {
        if self.width == 1 && self.height == 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let columns = |i: usize| 2 * i..(2 * i + 2).min(self.width);
        let rows = |j: usize| 2 * j..(2 * j + 2).min(self.height);
        let mut texels = Vec::with_capacity(width * height);
        for j in 0..height {
            for i in 0..width {
                let from = rows(j).flat_map(|y| columns(i).map(move |x| (x, y)));
                texels.push(mean(from.map(|(x, y)| self.texels[y * self.width + x])));
            }
        }
        Some(Self {
            width,
            height,
            texels,
        })
    }

    fn texel(&self, place: DVec2, how: &Texturing) -> Texel {
        let (column, row) = (place.x.floor() as i64, place.y.floor() as i64);
        let own = self.wrapped(column, row, how.wrap);
        let passes = |texel: DVec4| texel.w >= how.alpha_test;
        let mut parts = [(own.truncate(), 0.0); 4];
        match how.filter {
            Filter::Nearest => parts[0].1 = 1.0,
            Filter::Bilinear => {
                let (x, y) = (place.x - 0.5, place.y - 0.5);
                let (right, down) = (x - x.floor(), y - y.floor());
                let mut sum = 0.0;
                for (i, across) in [1.0 - right, right].into_iter().enumerate() {
                    for (j, along) in [1.0 - down, down].into_iter().enumerate() {
                        let (column, row) =
                            (x.floor() as i64 + i as i64, y.floor() as i64 + j as i64);
                        let texel = self.wrapped(column, row, how.wrap);
                        if passes(texel) {
                            parts[2 * i + j] = (texel.truncate(), across * along);
                            sum += across * along;
                        }
                    }
                }
                parts = parts.map(|(colour, weight)| (colour, weight / sum));
            }
        }
        Texel {
            colour: parts.iter().map(|(colour, weight)| *colour * *weight).sum(),
            parts,
            passes: passes(own),
        }
    }

    fn wrapped(&self, column: i64, row: i64, wrap: Wrap) -> DVec4 {
        let at = |i: i64, size: usize| {
            let size = size as i64;
            let within = match wrap {
                Wrap::Clamp => i.clamp(0, size - 1),
                Wrap::Repeat => i.rem_euclid(size),
                Wrap::Mirror => {
                    let m = i.rem_euclid(2 * size);
                    if m < size { m } else { 2 * size - 1 - m }
                }
            };
            within as usize
        };
        self.texels[at(row, self.height) * self.width + at(column, self.width)]
    }
}

/// The mean of some texels, colours weighted by alpha; of texels that nothing is
/// seen of, the plain mean of the colours.
fn mean(texels: impl Iterator<Item = DVec4>) -> DVec4 {
    let (mut count, mut plain, mut seen) = (0.0, DVec4::ZERO, DVec3::ZERO);
    for texel in texels {
        count += 1.0;
        plain += texel;
        seen += texel.truncate() * texel.w;
    }
    let colour = if plain.w > 0.0 {
        seen / plain.w
    } else {
        plain.truncate() / count
    };
    colour.extend(plain.w / count)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Greys 0, 1, 2, .. of 255, without anything that shows through.
    fn greys(width: u32, height: u32) -> fixel_scene::Texture {
        fixel_scene::Texture {
            name: "greys".into(),
            width,
            height,
            texels: (0..width * height)
                .map(|i| [i as u8, i as u8, i as u8, 255])
                .collect(),
        }
    }

    fn how(filter: Filter, wrap: Wrap) -> Texturing {
        Texturing {
            filter,
            wrap,
            ..Texturing::new(0)
        }
    }

    /// The grey of 255 where a pixel is `step` texels.
    fn grey(texture: &Texture, place: [f64; 2], step: f64, how: &Texturing) -> f64 {
        let steps = [DVec2::new(step, 0.0), DVec2::new(0.0, step / 2.0)];
        texture.texel(place.into(), steps, how).colour.y * 255.0
    }

    #[test]
    fn v_goes_up() {
        let texture = Texture::new(&greys(4, 2));
        assert_eq!(texture.place([0.0, 1.0]), DVec2::ZERO);
        assert_eq!(texture.place([0.5, 0.25]), DVec2::new(2.0, 1.5));
        assert_eq!(texture.place([-1.0, 2.0]), DVec2::new(-4.0, -2.0));
    }

    #[test]
    fn the_nearest_texel_is_the_one_around() {
        let texture = Texture::new(&greys(4, 2));
        let nearest = how(Filter::Nearest, Wrap::Clamp);
        for (place, wanted) in [([0.0, 0.0], 0.0), ([3.99, 0.99], 3.0), ([1.5, 1.0], 5.0)] {
            assert_eq!(grey(&texture, place, 1.0, &nearest), wanted);
        }
    }

    #[test]
    fn beyond_the_edges_it_is_clamped_repeated_or_mirrored() {
        let texture = Texture::new(&greys(4, 1));
        let row = |wrap| {
            let how = how(Filter::Nearest, wrap);
            let at = |x: i32| grey(&texture, [f64::from(x) + 0.5, 0.5], 1.0, &how) as i32;
            (-5..10).map(at).collect::<Vec<_>>()
        };
        assert_eq!(
            row(Wrap::Clamp),
            [0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 3, 3]
        );
        assert_eq!(
            row(Wrap::Repeat),
            [3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1]
        );
        assert_eq!(
            row(Wrap::Mirror),
            [3, 3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0, 0, 1]
        );
    }

    #[test]
    fn bilinear_is_linear_between_the_middles_of_texels() {
        let texture = Texture::new(&greys(4, 2));
        let close = |wrap, place, wanted: f64| {
            let found = grey(&texture, place, 1.0, &how(Filter::Bilinear, wrap));
            assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
        };
        close(Wrap::Clamp, [1.5, 0.5], 1.0);
        close(Wrap::Clamp, [2.25, 0.5], 1.75);
        close(Wrap::Clamp, [2.25, 0.75], 1.75 + 1.0);
        close(Wrap::Clamp, [0.1, 0.1], 0.0);
        // A quarter beyond the first column's middle, half way up to the last row.
        close(Wrap::Repeat, [0.25, 0.0], (0.25 * 3.0) + 2.0);
        close(Wrap::Mirror, [0.25, 0.0], 0.0);
    }

    #[test]
    fn copies_are_means_and_the_right_one_is_taken() {
        let texture = Texture::new(&greys(5, 2));
        assert_eq!(texture.copies.len(), 3);
        let sizes = [(5, 2), (2, 1), (1, 1)];
        for (copy, size) in texture.copies.iter().zip(sizes) {
            assert_eq!((copy.width, copy.height), size);
        }
        let nearest = how(Filter::Nearest, Wrap::Clamp);
        let at = |x, step| grey(&texture, [x, 1.0], step, &nearest);
        // (0 + 1 + 5 + 6) / 4 and (2 + 3 + 7 + 8) / 4; the fifth column is lost.
        for (x, step, wanted) in [
            (0.5, 1.41, 5.0),
            (0.5, 1.42, 3.0),
            (2.4, 2.0, 3.0),
            (2.6, 2.82, 5.0),
            (2.6, 2.84, 4.0),
            (2.6, 1e9, 4.0),
            (0.5, 0.0, 5.0),
        ] {
            let found = at(x, step);
            assert!((found - wanted).abs() < 1e-9, "{x} {step}: {found}");
        }
        let without = Texturing {
            mipmaps: false,
            ..nearest
        };
        assert_eq!(grey(&texture, [0.5, 1.0], 9.0, &without), 5.0);
    }

    #[test]
    fn what_is_not_seen_gives_no_colour() {
        let mut picture = greys(2, 2);
        picture.texels = vec![
            [200, 0, 0, 255],
            [0, 100, 0, 0],
            [100, 0, 0, 51],
            [0, 0, 0, 0],
        ];
        let texture = Texture::new(&picture);
        let small = texture.copies[1].texels[0] * 255.0;
        assert!((small.x - (200.0 + 20.0) / 1.2).abs() < 1e-9);
        assert_eq!((small.y, small.w), (0.0, 76.5));
        let mut how = how(Filter::Bilinear, Wrap::Clamp);
        how.alpha_test = 0.3;
        let steps = [DVec2::X, DVec2::Y];
        let at = |x, y| texture.texel(DVec2::new(x, y), steps, &how);
        assert!(at(0.9, 0.9).passes && !at(1.1, 0.9).passes && !at(0.9, 1.1).passes);
        // Only the first texel passes, so it alone gives the colour.
        assert!((at(0.9, 0.9).colour * 255.0).distance(DVec3::new(200.0, 0.0, 0.0)) < 1e-9);
        // Of the smallest copy, 76.5 of 255 pass a test for 0.3.
        let far = [DVec2::splat(4.0); 2];
        assert!(texture.texel(DVec2::ONE, far, &how).passes);
    }
}
