//! One line.

use super::DepthRule;
use super::ramp::Ramp;
use crate::frame::Target;
use crate::math::{Divider, HALF_PX, SUBPX_BITS};
use crate::raster::Fill;
use crate::vertex::ScreenVertex;

/// A line between two vertices.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Its ends.
    pub vertices: [&'a ScreenVertex; 2],
    /// Whether a pixel whose diamond holds the end belongs to the line.
    pub ends: [bool; 2],
    /// Pixels, 1..=16.
    pub width: u8,
    /// Whether depth is proportional to 1 / w.
    pub perspective: bool,
}

/// A line as it is walked: from the end with the lower coordinate along `major`.
struct Walk {
    /// 0: x, 1: y.
    major: usize,
    /// The ends' coordinates, `major` first.
    from: [i32; 2],
    to: [i32; 2],
    /// Extent along `major`; 1 if there is none.
    length: Divider,
    /// Pixels along `major`, half-open.
    pixels: [i32; 2],
    /// Whether it begins at the line's second end.
    turned: bool,
}

/// Fractional bits of a depth on the way along a line.
const DEPTH_BITS: u32 = 13;
/// Fractional bits of a level.
const LEVEL_BITS: u32 = 16;
/// In perspective, levels are worked out each so many pixels.
const RUN_BITS: u32 = 3;

/// Draws the part of a line that is in the target, by the light levels of its vertices.
pub fn draw_line(target: &mut Target<'_>, line: &Line<'_>, rule: &DepthRule, fill: Fill<'_>) {
    draw(target, line, rule, |walk, ends, lead| {
        let levels = ends.map(|v| i32::from(v.level().to_bits()));
        let mut levels = Levels::new(walk, ends, levels, line.perspective, lead);
        move |n, _| fill.index(|| byte(levels.at(n)))
    });
}

/// The same by the `colours` of its vertices, in 1/64 of a level; `index` gets a pixel's
/// and its column and row.
pub fn draw_coloured_line<C>(
    target: &mut Target<'_, C>,
    line: &Line<'_>,
    rule: &DepthRule,
    colours: [[i32; 3]; 2],
    mut index: impl FnMut([u16; 3], [i32; 2]) -> C,
) {
    draw(target, line, rule, |walk, ends, lead| {
        let [from, to] = walk.in_order(colours);
        let channel = |c: i32, d: i32| Levels::new(walk, ends, [c, d], line.perspective, lead);
        let ([r, g, b], [s, h, c]) = (from, to);
        let mut channels = [channel(r, s), channel(g, h), channel(b, c)];
        move |n, place| {
            let lit = channels
                .each_mut()
                .map(|c| c.at(n).clamp(0, 255 << 6) as u16);
            Some(index(lit, place))
        }
    });
}

/// A level in 1/64 as a table's index.
#[inline(always)]
fn byte(level: i32) -> usize {
    ((level + (1 << 5)) >> 6).clamp(0, 255) as usize
}

/// Draws a line. `shade` gets the walk, the ends in its order and where along it its first
/// pixel is; what it gives is asked for the index of pixel `n` at a column and row.
#[inline(always)]
fn draw<C, S: FnMut(i32, [i32; 2]) -> Option<C>>(
    target: &mut Target<'_, C>,
    line: &Line<'_>,
    rule: &DepthRule,
    shade: impl FnOnce(&Walk, [&ScreenVertex; 2], i32) -> S,
) {
    if !in_rows(target, line) {
        return;
    }
    let Some(walk) = Walk::new(line) else {
        return;
    };
    let ends = walk.in_order(line.vertices);
    let [first, _] = walk.pixels;
    // Where the line's first pixel is, and the part of its pixels to draw.
    let lead = centre(first) - walk.from[0];
    let (begin, stop) = walk.in_target(target, line.width);
    if begin >= stop {
        return;
    }
    let depths = ends.map(|v| (v.z().to_bits() as i32) << (DEPTH_BITS - 4));
    let depth = Ramp::new(depths, &walk.length, lead);
    let mut shade = shade(&walk, ends, lead);
    let mut minor = Minor::new(&walk, begin, line.width);
    for along in begin..stop {
        let n = along - first;
        let here = rule.depth(depth.at(n), DEPTH_BITS);
        for across in minor.at..minor.at + i32::from(line.width) {
            let place = if walk.major == 0 {
                [along, across]
            } else {
                [across, along]
            };
            rule.put(target, place, here, || shade(n, place));
        }
        minor.advance();
    }
}

/// Whether a line may have pixels in the target's rows: a quick look, as most lines
/// of a mesh are in other bands.
#[inline(always)]
fn in_rows<C>(target: &Target<'_, C>, line: &Line<'_>) -> bool {
    let [a, b] = line.vertices.map(|v| v.y().to_bits());
    let off = (i32::from(line.width) + 1) << SUBPX_BITS;
    let (top, end) = (i32::from(target.top), i32::from(target.end));
    a.max(b) >= (top << SUBPX_BITS) - off && a.min(b) <= (end << SUBPX_BITS) + off
}

/// A pixel's centre.
fn centre(pixel: i32) -> i32 {
    (pixel << SUBPX_BITS) + HALF_PX
}

/// The first pixel whose centre is at or past `v`.
fn first_centre(v: i32) -> i32 {
    (v + (HALF_PX - 1)) >> SUBPX_BITS
}

/// The pixel along x and y whose diamond holds a place, if one does.
fn diamond(place: [i32; 2]) -> Option<[i32; 2]> {
    let pixel = place.map(|c| c >> SUBPX_BITS);
    let [x, y] = pixel;
    let [px, py] = place;
    let off = (px - centre(x)).abs() + (py - centre(y)).abs();
    (off < HALF_PX).then_some(pixel)
}

impl Walk {
    /// `None` if no pixel is on it.
    fn new(line: &Line<'_>) -> Option<Self> {
        let [mut from, mut to] = line.vertices.map(|v| [v.x().to_bits(), v.y().to_bits()]);
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let major = usize::from(dy.abs() > dx.abs());
        if major == 1 {
            from.reverse();
            to.reverse();
        }
        let mut ends = line.ends;
        let turned = to[0] < from[0];
        if turned {
            (from, to) = (to, from);
            ends.reverse();
        }
        let mut pixels = [first_centre(from[0]), first_centre(to[0])];
        let [first, end] = &mut pixels;
        // A diamond is the same whichever coordinate comes first.
        if let Some([pixel, _]) = diamond(from) {
            *first = if ends[0] {
                pixel.min(*first)
            } else {
                (pixel + 1).max(*first)
            };
        }
        if let Some([pixel, _]) = diamond(to) {
            *end = if ends[1] {
                (pixel + 1).max(*end)
            } else {
                pixel.min(*end)
            };
        }
        let walk = Self {
            major,
            from,
            to,
            length: Divider::new(to[0] - from[0]),
            pixels,
            turned,
        };
        (walk.pixels[0] < walk.pixels[1]).then_some(walk)
    }

    /// What belongs to the line's ends, in the order in which they are walked.
    fn in_order<T>(&self, [a, b]: [T; 2]) -> [T; 2] {
        if self.turned { [b, a] } else { [a, b] }
    }

    /// The pixels along `major` that may have any in the target.
    fn in_target<C>(&self, target: &Target<'_, C>, width: u8) -> (i32, i32) {
        let columns = (0, i32::from(target.width));
        let rows = (i32::from(target.top), i32::from(target.end));
        let (along, across) = if self.major == 0 {
            (columns, rows)
        } else {
            (rows, columns)
        };
        let [first, end] = self.pixels;
        let (mut begin, mut stop) = (first.max(along.0), end.min(along.1));
        let change = self.to[1] - self.from[1];
        // Two pixels more on either side than the crossings say.
        let margin = (2 + i32::from(width)) << SUBPX_BITS;
        let (low, high) = (
            (across.0 << SUBPX_BITS) - margin,
            (across.1 << SUBPX_BITS) + margin,
        );
        if change == 0 {
            if self.from[1] < low || self.from[1] > high {
                stop = begin;
            }
            return (begin, stop);
        }
        let steepness = Divider::new(change.abs());
        let crossing = |across: i32| {
            let way = i64::from(across) - i64::from(self.from[1]);
            let way = if change < 0 { -way } else { way };
            let (along, _) = steepness.floor_wide(way * i64::from(self.length.divisor()));
            self.from[0].saturating_add(along) >> SUBPX_BITS
        };
        let (enter, leave) = if change > 0 { (low, high) } else { (high, low) };
        begin = begin.max(crossing(enter));
        stop = stop.min(crossing(leave).saturating_add(1));
        (begin, stop)
    }
}

/// The first pixel across, pixel by pixel along.
struct Minor {
    at: i32,
    /// In sub-pixels, rounded down, and what that took in `1 / length`.
    place: i32,
    rest: i32,
    /// Change a pixel, the same way.
    step: i32,
    step_rest: i32,
    length: i32,
}

impl Minor {
    fn new(walk: &Walk, begin: i32, width: u8) -> Self {
        let change = i64::from(walk.to[1] - walk.from[1]);
        let way = change * i64::from(centre(begin) - walk.from[0]);
        let (along, rest) = walk.length.floor_wide(way);
        let (step, step_rest) = walk.length.floor_wide(change << SUBPX_BITS);
        let place = walk.from[1] + along - (i32::from(width) - 1) * HALF_PX;
        Self {
            at: place >> SUBPX_BITS,
            place,
            rest,
            step,
            step_rest,
            length: walk.length.divisor(),
        }
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.place += self.step;
        self.rest += self.step_rest;
        if self.rest >= self.length {
            self.rest -= self.length;
            self.place += 1;
        }
        self.at = self.place >> SUBPX_BITS;
    }
}

/// Light levels along a line.
struct Levels {
    linear: Ramp,
    /// In perspective: levels times depth, and depths.
    in_space: Option<(Ramp, Ramp)>,
    /// The line's last pixel.
    last: i32,
    /// The run of pixels that was met last, by its first one; its level there and
    /// the change a pixel, with 8 more bits.
    run: Option<i32>,
    level: [i32; 2],
}

impl Levels {
    /// From `levels` at the ends, in 1/64.
    fn new(
        walk: &Walk,
        ends: [&ScreenVertex; 2],
        levels: [i32; 2],
        perspective: bool,
        lead: i32,
    ) -> Self {
        let fixed = levels.map(|level| level << (LEVEL_BITS - 6));
        let [a, b] = levels;
        let in_space = (perspective && a != b).then(|| {
            // 14 bits of level and 16 of depth.
            let [da, db] = ends.map(|v| (v.z().to_bits() >> 4).max(1) as i32);
            let depths = [da << DEPTH_BITS, db << DEPTH_BITS];
            (
                Ramp::new([a * da, b * db], &walk.length, lead),
                Ramp::new(depths, &walk.length, lead),
            )
        });
        Self {
            linear: Ramp::new(fixed, &walk.length, lead),
            in_space,
            last: walk.pixels[1] - walk.pixels[0] - 1,
            run: None,
            level: [0; 2],
        }
    }

    /// At pixel `n`, in 1/64.
    #[inline(always)]
    fn at(&mut self, n: i32) -> i32 {
        let Some((products, depths)) = &self.in_space else {
            return self.linear.at(n) >> (LEVEL_BITS - 6);
        };
        let within = n & ((1 << RUN_BITS) - 1);
        let start = n - within;
        if self.run != Some(start) {
            self.run = Some(start);
            let end = (start + (1 << RUN_BITS)).min(self.last);
            let [from, to] = [start, end].map(|n| {
                let depth = (depths.at(n) >> DEPTH_BITS).max(1);
                products.at(n).checked_div(depth).unwrap_or(0)
            });
            let step = ((to - from) << 8).checked_div(end - start).unwrap_or(0);
            self.level = [from, step];
        }
        let [from, step] = self.level;
        from + ((step * within) >> 8)
    }
}
