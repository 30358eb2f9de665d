//! Lines and marks: coverage as drawings, chains, bands, depths and levels.

mod coverage;
mod depth;
mod marks;

use fixel::frame::Band;
use fixel::line::{DepthRule, Line, draw_line};
use fixel::math::{FineDepth, FineLevel, SUBPX_BITS, SubPx};
use fixel::raster::Fill;
use fixel::vertex::{Rest, ScreenVertex};

const ONE: f64 = (1 << SUBPX_BITS) as f64;

/// Nearer wins, no bias.
const TESTED: DepthRule = DepthRule {
    test: true,
    bias: 0,
};

/// A vertex by raw sub-pixels, raw depth (16.4) and raw level (8.6).
fn raw(x: i32, y: i32, z: u32, level: u16) -> ScreenVertex {
    let place = [x, y].map(SubPx::from_bits);
    ScreenVertex::new(place, Rest::NONE, FineDepth::from_bits(z)).lit(FineLevel::from_bits(level))
}

/// A vertex by pixels, halfway deep.
fn at((x, y): (f64, f64)) -> ScreenVertex {
    raw((x * ONE) as i32, (y * ONE) as i32, 32768 << 4, 0)
}

/// A line of one pixel's width with both ends.
fn line<'a>(a: &'a ScreenVertex, b: &'a ScreenVertex) -> Line<'a> {
    Line {
        vertices: [a, b],
        ends: [true, true],
        width: 1,
        perspective: false,
    }
}

/// Depths and indices of lines on a cleared screen, drawn in bands.
fn draw(
    lines: &[Line<'_>],
    rule: &DepthRule,
    (width, height): (u16, u16),
    rows: u16,
    fill: Fill<'_>,
) -> (Vec<u16>, Vec<u8>) {
    in_bands((width, height), rows, |target| {
        for line in lines {
            draw_line(target, line, rule, fill);
        }
    })
}

fn in_bands(
    (width, height): (u16, u16),
    rows: u16,
    mut draw: impl FnMut(&mut fixel::frame::Target<'_>),
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
        draw(&mut target);
        all_depths.extend_from_slice(target.depths);
        all_indices.extend_from_slice(target.indices);
        top = end;
    }
    (all_depths, all_indices)
}

/// How often each pixel is hit by lines drawn one by one.
fn hits(lines: &[Line<'_>], size: (u16, u16), rows: u16) -> Vec<u8> {
    let mut counts = vec![0; usize::from(size.0) * usize::from(size.1)];
    for line in lines {
        let (depths, _) = draw(
            std::slice::from_ref(line),
            &TESTED,
            size,
            rows,
            Fill::Flat(1),
        );
        for (count, depth) in counts.iter_mut().zip(depths) {
            *count += u8::from(depth != 0);
        }
    }
    counts
}
