//! Lines and marks over the surfaces, by the rules that [`fixel_scene::Look`] and
//! the scene format state, worked out here in their own way.
//!
//! A line takes the pixels of the diamond rule of OpenGL and Direct3D: along its
//! longer extent (x if both are the same) the pixels whose centre line it crosses,
//! from the end with the lower coordinate up to but not including the other, and at
//! its ends those pixels whose diamond (less than half a pixel from the centre, by
//! |x| + |y|) holds the end. In a mesh without triangles the end of a line is left
//! to the one that starts there, if there is one.
//!
//! Where a line passes within [`DOUBT_PX`] of where another pixel would be taken,
//! no 12 bits of sub-pixels can be held to the choice: such pixels are noted.

use crate::bitmap::bitmap;
use crate::fog::fog_part;
use crate::geometry::Placing;
use crate::hit::{Hit, Layer};
use crate::light::Lit;
use crate::view::View;
use crate::window::Window;
use fixel_scene::{Fog, Look, Representation, Scene, Space};
use glam::DVec3;
use std::collections::{HashMap, HashSet};

/// Positions on the screen have 12 sub-pixel bits, rounded, after vertices have
/// been rounded to a grid: together less than this.
const DOUBT_PX: f64 = 1.0 / 1024.0;

/// Something that may be seen at a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub actor: usize,
    pub element: usize,
    pub depth_lsb: f64,
}

/// Lines and marks, whether seen or hidden.
#[derive(Clone, Debug, Default)]
pub(crate) struct Overlay {
    /// By pixel number.
    candidates: HashMap<usize, Vec<Candidate>>,
    /// Pixels whose choice hangs on rounding.
    doubtful: HashSet<usize>,
}

impl Overlay {
    /// The depth of a line or a mark at a pixel, if it is there.
    pub fn depth_lsb(&self, actor: usize, element: usize, pixel: usize) -> Option<f64> {
        let here = self.candidates.get(&pixel)?.iter();
        let own = here.filter(|c| [c.actor, c.element] == [actor, element]);
        own.map(|c| c.depth_lsb).reduce(f64::max)
    }

    /// Whether rounding decides which of two pixels a line or a mark takes here.
    pub fn is_doubtful(&self, pixel: usize) -> bool {
        self.doubtful.contains(&pixel)
    }
}

/// Draws every actor's lines or marks over the surfaces of the first of some windows,
/// where none of the others is: those that are tested for
/// depth first, then the others over everything.
pub(crate) fn draw(
    scene: &Scene,
    windows: &[Window],
    frame: u32,
    width: u32,
    (pixels, layers): (&mut [Option<Hit>], &mut [Vec<Layer>]),
) -> Overlay {
    let mut overlay = Overlay::default();
    let Some((window, later)) = windows.split_first() else {
        return overlay;
    };
    let (view, geometry) = (&window.view, &window.geometry);
    for tested in [true, false] {
        for (index, actor) in scene.actors.iter().enumerate() {
            if actor.look.depth_test != tested {
                continue;
            }
            let mut canvas = Canvas {
                look: &actor.look,
                view,
                placing: geometry.placing(scene, view, index, frame),
                actor: index,
                material: actor.material,
                corner: window.corner.map(i64::from),
                size: window.size.map(i64::from),
                width: width.into(),
                later,
                fog: scene.fog,
                pixels,
                layers,
                overlay: &mut overlay,
            };
            match actor.look.representation {
                Representation::Surface => {}
                Representation::Wireframe | Representation::HiddenLine => canvas.lines(),
                Representation::Points => canvas.marks(),
            }
        }
    }
    overlay
}

/// One actor on the way to the picture.
struct Canvas<'a> {
    look: &'a Look,
    view: &'a View,
    placing: Placing<'a>,
    actor: usize,
    material: usize,
    /// The window's first column and row, its columns and rows.
    corner: [i64; 2],
    size: [i64; 2],
    /// Columns of the picture.
    width: i64,
    /// Windows over this one.
    later: &'a [Window],
    fog: Option<Fog>,
    pixels: &'a mut [Option<Hit>],
    /// Blended surfaces before them.
    layers: &'a mut [Vec<Layer>],
    overlay: &'a mut Overlay,
}

/// A place on the screen.
#[derive(Clone, Copy)]
struct Spot {
    /// Pixels from the top left.
    px: [f64; 2],
    depth_lsb: f64,
    /// Distance along the line of sight.
    w: f64,
}

impl Canvas<'_> {
    /// Where a vertex is in view space; on the screen, its pixels.
    fn vertex(&self, index: u32) -> DVec3 {
        match self.look.space {
            Space::World => self.view.to_view(self.placing.places[index as usize]),
            Space::Screen => self.placing.mesh.positions[index as usize].into(),
        }
    }

    fn spot(&self, p: DVec3) -> Spot {
        match self.look.space {
            Space::World => Spot {
                px: self.view.to_screen(p),
                depth_lsb: self.view.depth_lsb(p.z),
                w: p.z,
            },
            Space::Screen => Spot {
                px: [p.x, p.y],
                depth_lsb: 65535.0,
                w: self.view.range()[0],
            },
        }
    }

    /// Rounding to a sub-pixel changes nothing here.
    fn is_exact(&self, px: [f64; 2]) -> bool {
        self.look.space == Space::Screen && px.iter().all(|c| (c * 4096.0).fract() == 0.0)
    }

    fn lines(&mut self) {
        let mesh = self.placing.mesh;
        let starts: HashSet<u32> = mesh.edges.iter().map(|edge| edge[0]).collect();
        for (number, [from, to]) in mesh.edges.iter().enumerate() {
            let element = mesh.triangles.len() + number;
            let chained = mesh.triangles.is_empty() && starts.contains(to);
            let (p, q) = (self.vertex(*from), self.vertex(*to));
            let (mut part, [near, far]) = ([0.0, 1.0], self.view.range());
            if self.look.space == Space::World {
                // The part between near and far.
                for (limit, sign) in [(near, 1.0), (far, -1.0)] {
                    let (a, b) = (sign * (p.z - limit), sign * (q.z - limit));
                    if a < 0.0 && b < 0.0 {
                        part = [1.0, 0.0];
                    } else if a < 0.0 {
                        part[0] = f64::max(part[0], a / (a - b));
                    } else if b < 0.0 {
                        part[1] = f64::min(part[1], a / (a - b));
                    }
                }
            }
            if part[0] > part[1] {
                continue;
            }
            let ends = part.map(|t| self.spot(p + (q - p) * t));
            let lit = [*from, *to].map(|vertex| self.placing.lit_vertex(vertex as usize));
            // An end that was cut off is not a vertex.
            let own = [true, !(chained && part[1] == 1.0)];
            self.line(element, ends, own, |u| {
                let t = part[0] + (part[1] - part[0]) * u;
                Lit::weighted([lit[0], lit[1], lit[1]], [1.0 - t, t, 0.0])
            });
        }
    }

    /// One line on the screen; `lit` takes the way along it in space, 0..=1.
    fn line(&mut self, element: usize, ends: [Spot; 2], own: [bool; 2], lit: impl Fn(f64) -> Lit) {
        let [mut a, mut b] = ends;
        let mut own = own;
        let off = [b.px[0] - a.px[0], b.px[1] - a.px[1]];
        let along = usize::from(off[1].abs() > off[0].abs());
        let across = 1 - along;
        let turned = b.px[along] < a.px[along];
        if turned {
            (a, b) = (b, a);
            own.reverse();
        }
        let length = b.px[along] - a.px[along];
        let doubt = if self.is_exact(a.px) && self.is_exact(b.px) {
            0.0
        } else {
            DOUBT_PX
        };
        let width = i64::from(self.look.line_width);
        let first = (a.px[along].floor() as i64 - 1).max(0);
        let last = (b.px[along].floor() as i64 + 1).min(self.size[along] - 1);
        for pixel in first..=last {
            let centre = pixel as f64 + 0.5;
            let (has, mut doubtful) = belongs(pixel, along, [a.px, b.px], own, doubt);
            if !has && !doubtful {
                continue;
            }
            let way = if length > 0.0 {
                (centre - a.px[along]) / length
            } else {
                0.0
            };
            let place =
                a.px[across] + (b.px[across] - a.px[across]) * way - (width - 1) as f64 / 2.0;
            let first = place.floor() as i64;
            let near_border = (place - place.round()).abs() < doubt;
            doubtful |= near_border;
            let on_line = way.clamp(0.0, 1.0);
            // In space the way goes with w.
            let depth_lsb = a.depth_lsb + (b.depth_lsb - a.depth_lsb) * on_line;
            let in_space = if self.view.is_perspective() {
                on_line / b.w / ((1.0 - on_line) / a.w + on_line / b.w)
            } else {
                on_line
            };
            let w = a.w + (b.w - a.w) * in_space;
            let light = lit(if turned { 1.0 - in_space } else { in_space });
            for n in 0..width {
                let at = |across_pixel: i64| {
                    let mut at = [pixel; 2];
                    at[across] = across_pixel;
                    at
                };
                if has {
                    self.put(element, at(first + n), (depth_lsb, w), light);
                }
                if doubtful {
                    self.doubt(at(first + n));
                }
            }
            if near_border {
                let other = if place.round() > place {
                    first + 1
                } else {
                    first - 1
                };
                for n in 0..width {
                    let mut at = [pixel; 2];
                    at[across] = other + n;
                    self.doubt(at);
                }
            }
        }
    }

    fn marks(&mut self) {
        let mesh = self.placing.mesh;
        let bitmap = bitmap(&self.look.mark);
        let [near, far] = self.view.range();
        for index in 0..mesh.positions.len() {
            let p = self.vertex(index as u32);
            if self.look.space == Space::World && !(near <= p.z && p.z <= far) {
                continue;
            }
            let spot = self.spot(p);
            let lit = self.placing.lit_vertex(index);
            let element = mesh.triangles.len() + mesh.edges.len() + index;
            let corner = [0, 1].map(|axis| spot.px[axis] + bitmap.corner[axis]);
            let doubt = if self.is_exact(spot.px) {
                0.0
            } else {
                DOUBT_PX
            };
            let near_border = corner.map(|c| (c - c.round()).abs() < doubt);
            let first = corner.map(|c| c.floor() as i64);
            for [x, y] in &bitmap.pixels {
                let at = [first[0] + x, first[1] + y];
                self.put(element, at, (spot.depth_lsb, spot.w), lit);
                if near_border != [false; 2] {
                    for dy in -1..=1 {
                        for dx in -1..=1 {
                            self.doubt([at[0] + dx, at[1] + dy]);
                        }
                    }
                }
            }
        }
    }

    fn number(&self, [x, y]: [i64; 2]) -> Option<usize> {
        let inside = (0..self.size[0]).contains(&x) && (0..self.size[1]).contains(&y);
        let [left, top] = self.corner;
        let (x, y) = (left + x, top + y);
        let covered = |window: &Window| window.place(x as u32, y as u32).is_some();
        (inside && !self.later.iter().any(covered)).then(|| (y * self.width + x) as usize)
    }

    fn doubt(&mut self, at: [i64; 2]) {
        if let Some(number) = self.number(at) {
            self.overlay.doubtful.insert(number);
        }
    }

    /// `depth` in units of the buffer, and along the line of sight.
    fn put(&mut self, element: usize, at: [i64; 2], (depth_lsb, w): (f64, f64), lit: Lit) {
        let Some(number) = self.number(at) else {
            return;
        };
        let depth_lsb = (depth_lsb + f64::from(self.look.bias)).min(65535.0);
        let candidate = Candidate {
            actor: self.actor,
            element,
            depth_lsb,
        };
        self.overlay
            .candidates
            .entry(number)
            .or_default()
            .push(candidate);
        let behind = self.pixels[number].map_or(f64::NEG_INFINITY, |hit| hit.depth_lsb);
        if self.look.depth_test && depth_lsb <= behind {
            return;
        }
        // What is over everything is over them too.
        let shown = self.look.depth_test;
        self.layers[number].retain(|layer| shown && layer.depth_lsb > depth_lsb);
        self.pixels[number] = Some(Hit {
            depth_lsb,
            actor: self.actor,
            triangle: element,
            material: self.material,
            weights: [0.0; 3],
            level: lit.level,
            colour: lit.colour.into(),
            margin_lsb: depth_lsb - behind,
            hidden: false,
            texel: None,
            texels: [([0.0; 3], 0.0); 4],
            own_and_gloss: [lit.own.into(), lit.gloss.into()],
            texture_place: None,
            fog: self.fog.map_or(0.0, |fog| fog_part(&fog, w)),
        });
    }
}

/// Whether a line has the pixel number `pixel` along its longer extent, and whether
/// that hangs on less than `doubt`.
fn belongs(
    pixel: i64,
    along: usize,
    ends: [[f64; 2]; 2],
    own: [bool; 2],
    doubt: f64,
) -> (bool, bool) {
    let centre = pixel as f64 + 0.5;
    let [low, high] = ends.map(|end| end[along]);
    let mut has = low <= centre && centre < high;
    let mut doubtful = ends.iter().any(|end| (end[along] - centre).abs() < doubt);
    let mut left_out = false;
    for (end, own) in ends.into_iter().zip(own) {
        let across = end[1 - along];
        let off = (end[along] - centre).abs() + (across - across.floor() - 0.5).abs();
        let same_pixel = end[along].floor() as i64 == pixel;
        if same_pixel && off < 0.5 {
            has |= own;
            left_out |= !own;
        }
        doubtful |= (off - 0.5).abs() < doubt && (end[along] - centre).abs() < 0.5 + doubt;
    }
    (has && !left_out, doubtful)
}
