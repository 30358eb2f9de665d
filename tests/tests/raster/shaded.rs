//! Pixels that are shaded one by one: those of the triangle, with attributes of its plane; and
//! triangles that are left to be interpolated in space.

use std::cell::RefCell;

use proptest::prelude::*;

use super::surface::{corner, slenderness, weights};
use super::{BOTH, draw, is_tiny, raw};
use fixel::frame::Band;
use fixel::math::{Depth, SUBPX_BITS};
use fixel::raster::{Change, Drawn, Fill, How, RUN_FRACTION, ShadePixel, Values, draw_shaded};
use fixel::vertex::ScreenVertex;

const SIZE: (u16, u16) = (120, 60);
const COUNT: usize = 3;

/// A pixel's place, depth and attributes.
type Pixel = ([i32; 2], Depth, Values<COUNT>);

/// Takes down every pixel.
struct Seeing {
    pixels: RefCell<Vec<Pixel>>,
    corners: [Values<COUNT>; 3],
    hides: bool,
    contrast: u32,
}

impl ShadePixel<COUNT, u8> for Seeing {
    type Corners = ();
    type Begun = ();

    fn set(&self, corners: &mut [Values<COUNT>; 3]) -> Option<()> {
        *corners = self.corners;
        Some(())
    }

    fn begin(&self, (): &(), _: Change, _: [Change; COUNT]) -> Option<()> {
        Some(())
    }

    fn pixel(
        &self,
        (): &(),
        place: [i32; 2],
        z: u32,
        values: &Values<COUNT>,
        behind: u8,
    ) -> Option<u8> {
        let depth = (z >> 16) as Depth;
        self.pixels.borrow_mut().push((place, depth, *values));
        Some(behind + 1)
    }

    fn hides(&self) -> bool {
        self.hides
    }

    fn contrast(&self, _: &[Values<COUNT>; 3]) -> u32 {
        self.contrast
    }
}

/// What became of a triangle, its pixels, and indices and depths afterwards.
fn shaded(
    vertices: &[ScreenVertex; 3],
    values: [[i32; COUNT]; 3],
    (hides, contrast): (bool, u32),
) -> (Option<Drawn>, Vec<Pixel>, Vec<u8>, Vec<Depth>) {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    let (mut index, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(SIZE.0, &mut index, &mut depth).expect("a band");
    let mut target = band.target(0, SIZE.1);
    target.clear(|_| 0);
    let seeing = Seeing {
        pixels: RefCell::default(),
        corners: values.map(|all| all.map(|v| v << RUN_FRACTION)),
        hides,
        contrast,
    };
    let drawn = draw_shaded(&mut target, vertices.each_ref(), BOTH, &seeing);
    (drawn, seeing.pixels.into_inner(), index, depth)
}

/// Anywhere, or within some pixels of each other.
fn places() -> impl Strategy<Value = [(i32, i32); 3]> {
    let one = 1 << SUBPX_BITS;
    let near = (
        (0..100 * one, 0..45 * one),
        prop::array::uniform3((0..16 * one, 0..16 * one)),
    );
    prop_oneof![
        prop::array::uniform3(corner(SIZE.0)),
        super::tiny((100, 45)),
        near.prop_map(|((x, y), all)| all.map(|(dx, dy)| (x + dx, y + dy))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4_000))]

    #[test]
    fn pixels_are_those_of_the_triangle_with_attributes_of_its_plane(
        places in places(),
        depths in prop::array::uniform3(1u32 << 4..65_535 << 4),
        values in prop::array::uniform3(prop::array::uniform3(-(1 << 15)..=1 << 15)),
        hides in any::<bool>(),
    ) {
        let vertices: [_; 3] = std::array::from_fn(|i| raw(places[i].0, places[i].1, depths[i], 0));
        let (drawn, pixels, index, depth) = shaded(&vertices, values, (hides, 0));
        let Some(drawn) = drawn else {
            // Nothing is drawn of what is left to another.
            prop_assert!(pixels.is_empty() && index.iter().all(|i| *i == 0));
            return Ok(());
        };
        let (flat_depth, flat) = draw(vertices.each_ref(), SIZE, SIZE.1, Fill::Flat(1));
        prop_assert_eq!(index, flat);
        prop_assert_eq!(drawn.how == How::Filled || pixels.is_empty(), true);
        let none = vec![0; flat_depth.len()];
        let expected = if hides { &flat_depth } else { &none };
        if is_tiny(&vertices) {
            // Those of one index go by weights, which may round otherwise.
            prop_assert!(depth.iter().zip(expected).all(|(a, b)| a.abs_diff(*b) <= 1));
        } else {
            prop_assert_eq!(&depth, expected);
        }

        let slender = slenderness(&vertices);
        for ([x, y], z, own) in pixels {
            let flat = flat_depth[y as usize * usize::from(SIZE.0) + x as usize];
            prop_assert!(z.abs_diff(flat) <= u16::from(is_tiny(&vertices)));
            let (_, weights) = weights(&vertices, [x, y]);
            for (i, own) in own.into_iter().enumerate() {
                let exact = (0..3).map(|k| weights[k] * f64::from(values[k][i])).sum::<f64>();
                let own = f64::from(own) / f64::from(1 << RUN_FRACTION);
                // A gradient's last bit over the screen, and 2^-26 of what it is made of.
                let allowed = 0.25 + 4e-3 * slender;
                prop_assert!(
                    (own - exact).abs() <= allowed,
                    "{own} instead of {exact}, {allowed} allowed, at {x}, {y}",
                );
            }
        }
    }
}

/// A triangle so many pixels wide whose corners are so deep.
fn deep(width: i32, [near, far]: [u32; 2]) -> [ScreenVertex; 3] {
    let one = 1 << SUBPX_BITS;
    [(10, 10, near), (10 + width, 12, far), (12, 50, far)]
        .map(|(x, y, z)| raw(x * one, y * one, z << 4, 0))
}

#[test]
fn what_distance_would_bend_is_left_to_others() {
    let full = (true, 255 << 6);
    let drawn = |width, depths, how| shaded(&deep(width, depths), [[0; COUNT]; 3], how).0;
    // By a 64th of the depth, full light is off by a level.
    assert!(drawn(30, [32_500, 32_000], full).is_some());
    assert!(drawn(30, [32_505, 32_000], full).is_none());
    // A quarter of it by a 16th.
    assert!(drawn(30, [33_900, 32_000], (true, 255 << 4)).is_some());
    assert!(drawn(30, [34_100, 32_000], (true, 255 << 4)).is_none());
    assert!(drawn(30, [60_000, 32_000], (true, 0)).is_some());
    assert!(drawn(3, [32_505, 32_000], full).is_none());
}
