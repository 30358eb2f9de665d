//! Attributes in perspective against f64: at every pixel of every run, whatever the
//! triangle, its distances and its attributes.

use std::cell::RefCell;

use proptest::prelude::*;

use super::{BOTH, raw};
use fixel::frame::Band;
use fixel::math::SUBPX_BITS;
use fixel::raster::{
    Corner, Cubic, FINE, Footprint, MOST_ATTRIBUTES, RUN_FRACTION, Run, Shade, SurfaceKind,
    draw_surface,
};
use fixel::vertex::ScreenVertex;

/// Wider than the longest run.
const SIZE: (u16, u16) = (240, 60);
const COUNT: usize = 3;
const DEPTH: u32 = 30_000;

/// A pixel and the attributes that its run has there.
struct Seen {
    place: [i32; 2],
    values: [f64; COUNT],
    /// What the run's curve may be off by.
    off: [f64; COUNT],
    /// Whether it is a run by itself.
    alone: bool,
}

/// Sees all pixels.
struct Seeing {
    seen: RefCell<Vec<Seen>>,
    /// Draws at most so many pixels of a run.
    most: usize,
    how: How,
}

/// How a triangle is drawn.
#[derive(Clone, Copy, Debug, Default)]
struct How {
    solid: bool,
    outlined: bool,
    /// How many pixels are in common at most, if they go along cubics.
    alike: Option<usize>,
}

/// Any of them.
fn hows() -> impl Strategy<Value = How> {
    let alike = prop::option::of(prop_oneof![Just(usize::MAX), 1..240_usize]);
    (any::<bool>(), any::<bool>(), alike).prop_map(|(solid, outlined, alike)| How {
        solid,
        outlined,
        alike,
    })
}

const ONE: f64 = (1 << RUN_FRACTION) as f64;

impl Shade<MOST_ATTRIBUTES> for Seeing {
    fn run(&self, run: Run<'_, MOST_ATTRIBUTES>) -> usize {
        let length = run.indices.len();
        let [column, row] = run.place;
        let drawn = length.min(self.most);
        for number in 0..drawn {
            let path = run.path;
            let all: [[f64; 3]; COUNT] = std::array::from_fn(|i| {
                [path.from[i], path.step[i], path.bend[i]].map(|v| f64::from(v) / ONE)
            });
            let t = number as f64;
            self.seen.borrow_mut().push(Seen {
                place: [column + number as i32, row],
                values: all.map(|[from, step, bend]| from + step * t + bend * t * (t - 1.0) / 2.0),
                // The bound of the parabola between a run's ends.
                off: all.map(|[_, step, _]| {
                    step.abs() * length as f64 / if self.how.outlined { 9600.0 } else { 150.0 }
                }),
                alone: length == 1,
            });
        }
        drawn
    }

    fn solid(&self) -> bool {
        self.how.solid
    }

    fn cubics(&self) -> bool {
        self.how.alike.is_some()
    }

    fn alike(&self, _: &Footprint, _: &Footprint, pixels: usize) -> (usize, usize) {
        (7, self.how.alike.map_or(pixels, |most| pixels.min(most)))
    }

    fn cubic(&self, pixels: Cubic<'_, MOST_ATTRIBUTES>) -> bool {
        assert_eq!(pixels.alike, 7);
        let length = pixels.indices.len() as i32;
        let [column, row] = pixels.place;
        assert_eq!(pixels.depths.is_none(), self.how.solid);
        if let Some((depths, depth)) = &pixels.depths {
            assert_eq!(depths.len(), pixels.indices.len());
            assert_eq!(*depth, (DEPTH << 16 | 1 << 15, 0));
        }
        let [from, to] = pixels.ends;
        for number in 0..length {
            let at = pixels.fours.at(number, self.how.outlined);
            self.seen.borrow_mut().push(Seen {
                place: [column + number, row],
                values: std::array::from_fn(|i| f64::from(at[i]) / ONE),
                off: std::array::from_fn(|i| {
                    let change = (f64::from(to[i]) - f64::from(from[i])) / ONE;
                    let fine = f64::from(1 << FINE) * ONE;
                    let bend = f64::from(pixels.fours.bend[i]) / fine;
                    let last =
                        bend + f64::from(pixels.fours.twist[i]) / fine * f64::from(length / 4);
                    // The bound of the cubic, and a line's of four pixels: of what is shorter
                    // nearness changes by less than 3/16, a line is off by a quarter of that.
                    let line = if length <= 4 {
                        change.abs() * 3.0 / 64.0
                    } else {
                        0.0
                    };
                    let cubic = if self.how.outlined { 100_000.0 } else { 2500.0 };
                    change.abs() / cubic + bend.abs().max(last.abs()) / 2.0 + line
                }),
                alone: false,
            });
        }
        true
    }
}

/// What is seen, with at most so many pixels of a run.
fn drawn(
    vertices: &[ScreenVertex; 3],
    corners: [Corner<MOST_ATTRIBUTES>; 3],
    most: usize,
    how: How,
) -> Vec<Seen> {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    let (mut index, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(SIZE.0, &mut index, &mut depth).expect("a band");
    let mut target = band.target(0, SIZE.1);
    target.clear(|_| 0);
    let kind = SurfaceKind {
        attributes: COUNT,
        footprint: how.alike.is_some(),
        outlined: how.outlined,
    };
    let seeing = Seeing {
        seen: RefCell::new(Vec::new()),
        most,
        how,
    };
    draw_surface(
        &mut target,
        vertices.each_ref(),
        BOTH,
        kind,
        &mut || corners,
        &seeing,
    );
    seeing.seen.into_inner()
}

/// How much longer than high: the square of the longest side over the doubled area.
pub(super) fn slenderness(vertices: &[ScreenVertex; 3]) -> f64 {
    let place = |i: usize| {
        let v = &vertices[i % 3];
        (v.x().to_num::<f64>(), v.y().to_num::<f64>())
    };
    let side = |i: usize| {
        let ((ax, ay), (bx, by)) = (place(i), place(i + 1));
        (ax - bx).powi(2) + (ay - by).powi(2)
    };
    side(0).max(side(1)).max(side(2)) / weights(vertices, [0; 2]).0
}

/// Doubled area in pixels squared, and the weights of the corners at a pixel's centre.
pub(super) fn weights(vertices: &[ScreenVertex; 3], [x, y]: [i32; 2]) -> (f64, [f64; 3]) {
    let (px, py) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let [(ax, ay), (bx, by), (cx, cy)] = vertices
        .each_ref()
        .map(|v| (v.x().to_num::<f64>(), v.y().to_num::<f64>()));
    let area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    let b = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / area;
    let c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / area;
    (area.abs(), [1.0 - b - c, b, c])
}

/// A place in and around a picture that is so wide.
pub(super) fn corner(width: u16) -> impl Strategy<Value = (i32, i32)> {
    let one = 1 << SUBPX_BITS;
    let x = prop_oneof![3 => -one..(i32::from(width) + 1) * one, 1 => -1900 * one..1900 * one];
    let y = prop_oneof![3 => -one..61 * one, 1 => -1900 * one..1900 * one];
    (x, y)
}

/// Near, far, and all the same.
fn distances() -> impl Strategy<Value = [i32; 3]> {
    prop_oneof![
        prop::array::uniform3(1 << 20..1 << 28),
        (1 << 16..1 << 28i32).prop_flat_map(|d| prop::array::uniform3(d..2 * d)),
        (1..1 << 28i32).prop_map(|d| [d; 3]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4_000))]

    #[test]
    fn attributes_are_right_at_every_pixel(
        places in prop::array::uniform3(corner(SIZE.0)),
        distances in distances(),
        values in prop::array::uniform3(prop::array::uniform3(-(1 << 15)..=1 << 15)),
        most in prop_oneof![Just(usize::MAX), 1..9_usize],
        how in hows(),
    ) {
        let vertices = places.map(|(x, y)| raw(x, y, DEPTH << 4, 0));
        let corner = |i: usize| {
            let mut attributes = [0; MOST_ATTRIBUTES];
            attributes[..COUNT].copy_from_slice(&values[i].map(|v| v << RUN_FRACTION));
            Corner { distance: distances[i], attributes }
        };
        let corners = [corner(0), corner(1), corner(2)];
        let slender = slenderness(&vertices);
        let nearest = f64::from(*distances.iter().min().expect("three"));
        let all = drawn(&vertices, corners, most, how);
        let places = |all: &[Seen]| all.iter().map(|seen| seen.place).collect::<Vec<_>>();
        prop_assert_eq!(places(&all), places(&drawn(&vertices, corners, usize::MAX, How::default())));
        for seen in all {
            let (area, weights) = weights(&vertices, seen.place);
            let near: [f64; 3] = std::array::from_fn(|i| weights[i] / f64::from(distances[i]));
            let whole: f64 = near.iter().sum();
            // In a sliver 20 bits of a weight are too few.
            if area < 2.0 || whole <= 0.0 {
                continue;
            }
            // How far this pixel is against the nearest corner: what was rounded there
            // counts so much more here.
            let far = 1.0 / (whole * nearest);
            for (i, value) in seen.values.into_iter().enumerate() {
                let exact = (0..3).map(|k| near[k] * f64::from(values[k][i])).sum::<f64>() / whole;
                // An eighth of a unit; the bound of the curve between a run's ends; gradients, of the attribute and of nearness, are good to 2^-28 of what
                // they are multiplied with.
                let gradient = 2.0 * slender * far * 5e-4;
                // Pixels that are worked out by themselves have weights of 20 bits.
                let spread = |k: usize| (f64::from(values[k][i]) - f64::from(values[0][i])).abs();
                let weights = if seen.alone {
                    (spread(1) + spread(2)) * far * f64::exp2(-20.0)
                } else {
                    0.0
                };
                let allowed = 0.125 + seen.off[i] + far * far * 2e-4 + gradient + weights;
                // Along cubics they are modulo 2^16, as attributes have RUN_FRACTION.
                let off = (value - exact).abs();
                let off = off.min((off - 65536.0).abs());
                prop_assert!(
                    off <= allowed,
                    "{value} instead of {exact}, {allowed} allowed, at {:?}", seen.place
                );
            }
        }
    }
}
