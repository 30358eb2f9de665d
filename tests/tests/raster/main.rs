//! Coverage as drawings, tilings, bands, and attributes against exact planes.

mod coverage;
mod perspective;
mod planes;
mod shaded;
mod steep;
mod surface;
mod tiling;

use fixel::frame::Band;
use fixel::math::{FineDepth, FineLevel, SUBPX_BITS, SubPx};
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
