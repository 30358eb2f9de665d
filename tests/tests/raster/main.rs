//! Coverage as drawings, tilings, bands, and attributes against exact planes.

mod coverage;
mod perspective;
mod planes;
mod shaded;
mod steep;
mod surface;
mod tiling;

use proptest::prelude::*;

use fixel::frame::Band;
use fixel::math::{FineDepth, FineLevel, HALF_PX, SUBPX_BITS, SubPx};
use fixel::raster::{Fill, Sides, draw_triangle};
use fixel::vertex::{Rest, ScreenVertex};

const BOTH: Sides = Sides {
    front: true,
    back: true,
};

/// Identity: the index is the level.
fn levels() -> [u8; 256] {
    std::array::from_fn(|i| i as u8)
}

/// A vertex by raw sub-pixels, raw depth (16.4) and raw level (8.6).
fn raw(x: i32, y: i32, z: u32, level: u16) -> ScreenVertex {
    let place = [x, y].map(SubPx::from_bits);
    ScreenVertex::new(place, Rest::NONE, FineDepth::from_bits(z)).lit(FineLevel::from_bits(level))
}

/// A vertex by pixels, halfway deep.
fn at(x: f64, y: f64) -> ScreenVertex {
    let one = f64::from(1 << SUBPX_BITS);
    raw((x * one) as i32, (y * one) as i32, 32768 << 4, 0)
}

/// Most columns and rows of what is drawn by weights.
const TINY: i32 = 4 << SUBPX_BITS;

/// Corners within four pixels of each other, on a screen of so many pixels.
fn tiny((width, height): (i32, i32)) -> impl Strategy<Value = [(i32, i32); 3]> {
    let first = (0..width << SUBPX_BITS, 0..height << SUBPX_BITS);
    // On centres now and then.
    let off = prop_oneof![3 => 0..TINY, 1 => (0..8).prop_map(|halves| halves << (SUBPX_BITS - 1))];
    let all = prop::array::uniform3((off.clone(), off));
    (first, any::<bool>(), all).prop_map(|((x, y), even, all)| {
        let whole = |c: i32| if even { c & !(HALF_PX - 1) } else { c };
        all.map(|(dx, dy)| (whole(x) + dx, whole(y) + dy))
    })
}

/// Any depths, or such as lie close together.
fn depths() -> impl Strategy<Value = [u16; 3]> {
    let near = (any::<u16>(), prop::array::uniform3(0..2_100u16));
    prop_oneof![
        any::<[u16; 3]>(),
        near.prop_map(|(least, more)| more.map(|more| least.saturating_add(more))),
    ]
}

/// Whether they may be drawn by weights.
fn is_tiny(vertices: &[ScreenVertex; 3]) -> bool {
    [ScreenVertex::x, ScreenVertex::y].iter().all(|axis| {
        let places = vertices.each_ref().map(|v| axis(v).to_bits());
        let (least, most) = (places.iter().min(), places.iter().max());
        most.zip(least)
            .is_some_and(|(most, least)| most - least < TINY)
    })
}

/// Depths and indices of one triangle on a cleared screen, drawn in bands of
/// `rows` rows.
fn draw(
    triangle: [&ScreenVertex; 3],
    (width, height): (u16, u16),
    rows: u16,
    fill: Fill<'_>,
) -> (Vec<u16>, Vec<u8>) {
    let pixels = usize::from(width) * usize::from(rows);
    let (mut index, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(width, &mut index, &mut depth).expect("a band");
    let (mut all_depths, mut all_indices) = (Vec::new(), Vec::new());
    let mut top = 0;
    while top < height {
        let end = (top + rows).min(height);
        let mut target = band.target(top, end);
        target.clear(|_| 0);
        draw_triangle(&mut target, triangle, BOTH, false, || fill);
        all_depths.extend_from_slice(target.depths);
        all_indices.extend_from_slice(target.indices);
        top = end;
    }
    (all_depths, all_indices)
}

/// How often each pixel is hit by triangles drawn one by one.
fn hits(triangles: &[[&ScreenVertex; 3]], size: (u16, u16), rows: u16) -> Vec<u8> {
    let mut counts = vec![0; usize::from(size.0) * usize::from(size.1)];
    for triangle in triangles {
        let (depths, _) = draw(*triangle, size, rows, Fill::Flat(1));
        for (count, depth) in counts.iter_mut().zip(depths) {
            *count += u8::from(depth != 0);
        }
    }
    counts
}
