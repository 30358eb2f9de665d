//! Depth of steep faces and levels in perspective: the two places where a pixel
//! is worked out from more than its vertices' rounded positions.

use proptest::prelude::*;

use super::{BOTH, is_tiny, levels};
use fixel::frame::Band;
use fixel::math::{FineDepth, FineLevel};
use fixel::raster::{Fill, draw_triangle};
use fixel::vertex::{ClipVertex, ScreenVertex, project};
use fixel::view::{ActorView, DepthMap};

const SIZE: (u16, u16) = (40, 30);

/// Positions as projection has them before rounding: 64ths of a sub-pixel.
const PX: i32 = 64 << 12;

/// A parallel view in which clip coordinates are 64ths of a sub-pixel from the
/// screen's middle.
fn view() -> ActorView {
    ActorView {
        far: i32::MAX,
        parallel_shift: 6,
        parallel_guard: i32::MAX,
        middle: [i32::from(SIZE.0) << 11, i32::from(SIZE.1) << 11],
        depth: DepthMap::Parallel {
            base: 0,
            reference: 0,
            mantissa: 0,
            shift: 0,
        },
        ..ActorView::ZERO
    }
}

/// A vertex at a place in 64ths of a sub-pixel from the screen's corner, as
/// projection rounds it.
fn vertex((x, y): (i32, i32), z: u32, level: u16) -> ScreenVertex {
    let [mx, my] = view().middle.map(|m| m << 6);
    let clip = ClipVertex {
        x: x - mx,
        y: y - my,
        distance: 1,
        level: 0,
    };
    let projected = project(&view(), &clip);
    projected
        .with_depth(FineDepth::from_bits(z))
        .lit(FineLevel::from_bits(level))
}

/// Depths and levels of one triangle on a cleared screen.
fn draw(vertices: &[ScreenVertex; 3], perspective: bool) -> (Vec<u16>, Vec<u8>) {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    let (mut index, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(SIZE.0, &mut index, &mut depth).expect("a band");
    let mut target = band.target(0, SIZE.1);
    target.clear(|_| 0);
    let table = levels();
    let fill = || Fill::Gouraud(&table);
    draw_triangle(&mut target, vertices.each_ref(), BOTH, perspective, fill);
    (target.depths.to_vec(), target.indices.to_vec())
}

/// A triangle's plane in f64, from places that were not rounded.
struct Exact {
    corners: [(f64, f64); 3],
    area: f64,
}

impl Exact {
    fn new(corners: [(i32, i32); 3]) -> Self {
        let corners =
            corners.map(|(x, y)| (f64::from(x) / f64::from(PX), f64::from(y) / f64::from(PX)));
        let [(ax, ay), (bx, by), (cx, cy)] = corners;
        let area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        Self { corners, area }
    }

    /// Weights of the corners at a pixel's centre.
    fn weights(&self, x: usize, y: usize) -> [f64; 3] {
        let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
        let [(ax, ay), (bx, by), (cx, cy)] = self.corners;
        let b = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / self.area;
        let c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / self.area;
        [1.0 - b - c, b, c]
    }

    /// Change of an attribute a pixel, to the right and down.
    fn slope(&self, values: [f64; 3]) -> [f64; 2] {
        let at = |x, y| mix(self.weights(x, y), values);
        [at(1, 0) - at(0, 0), at(0, 1) - at(0, 0)]
    }
}

fn mix(weights: [f64; 3], values: [f64; 3]) -> f64 {
    (0..3).map(|i| weights[i] * values[i]).sum()
}

fn range(v: [f64; 3]) -> (f64, f64) {
    let high = v.iter().copied().fold(0.0, f64::max);
    (v.iter().copied().fold(f64::MAX, f64::min), high)
}

fn pixels(plane: &[u16]) -> impl Iterator<Item = (usize, usize, usize)> {
    let width = usize::from(SIZE.0);
    (0..plane.len())
        .filter(|i| plane[*i] != 0)
        .map(move |i| (i, i % width, i / width))
}

fn place() -> impl Strategy<Value = (i32, i32)> {
    let along = |pixels: i32| {
        prop_oneof![
            4 => -PX..(pixels + 1) * PX,
            1 => -1000 * PX..1000 * PX,
        ]
    };
    (along(SIZE.0.into()), along(SIZE.1.into()))
}

/// Any triangle, and one that is a few pixels or less across: steep.
fn triangle() -> impl Strategy<Value = [(i32, i32); 3]> {
    let any = (place(), place(), place()).prop_map(|(a, b, c)| [a, b, c]);
    let thin = (place(), place(), 0i64..=1000, 1i32..4 * PX).prop_map(|(a, b, t, off)| {
        let mix = |a: i32, b: i32| (i64::from(a) + (i64::from(b) - i64::from(a)) * t / 1000) as i32;
        [a, b, (mix(a.0, b.0) + off, mix(a.1, b.1))]
    });
    prop_oneof![any, thin, super::tiny((SIZE.0.into(), SIZE.1.into()))]
}

/// Depths of which many stand at an end of the range, as after clipping.
fn depth() -> impl Strategy<Value = u32> {
    prop_oneof![2 => 9u32..=65535 << 4, 1 => Just(9), 1 => Just(65535 << 4)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn steep_depth_is_that_of_the_unrounded_plane(
        corners in triangle(),
        raw in prop::array::uniform3(depth()),
        perspective in any::<bool>(),
    ) {
        let vertices = core::array::from_fn(|i| vertex(corners[i], raw[i], 0));
        let exact = Exact::new(corners);
        // Smaller than this, the rounded triangle may be the other way round, and
        // there is no plane to speak of.
        let sliver = exact.area.abs() < 1.0;
        let z = raw.map(|z| f64::from(z) / 16.0);
        let (low, high) = range(z);
        let [right, down] = exact.slope(z).map(f64::abs);
        // A position is off by half a sub-pixel; from 1024 units a pixel on (of what is a
        // pixel or two, 2048), by a 16th of one.
        let fine = if is_tiny(&vertices) { 2060.0 } else { 1030.0 };
        let off = if right.max(down) < fine { 8192.0 } else { 65536.0 };
        let (depths, _) = draw(&vertices, perspective);
        for (i, x, y) in pixels(&depths) {
            let weights = exact.weights(x, y);
            let got = f64::from(depths[i]);
            prop_assert!(got >= low - 1.0 && got <= high + 1.0, "depth {} leaves {}..{}", got, low, high);
            if sliver {
                continue;
            }
            // Rounding, 2^-17 a pixel, a weight's 2^-20 of the range twice.
            let mut most = 0.5 + 0.03 + 0.13 + (right + down) / off;
            if weights.iter().any(|w| *w < 0.0) {
                // Inside only by rounding: held within the vertices' range.
                most += (right + down) / 8192.0;
            }
            let want = mix(weights, z);
            prop_assert!((got - want).abs() <= most, "{} {}: {} instead of {}, slope {} {}, at most {}", x, y, got, want, right, down, most);
        }
    }
}
