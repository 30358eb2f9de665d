//! Calls that draw.

use super::lit::{self, Shine};
use crate::clip::{clip, clip_line};
use crate::frame::Target;
use crate::light::Lit;
use crate::line::{DepthRule, Line, Mark, draw_line, draw_mark};
use crate::math::{Level, Rect, Rotation, Unit3, Vec3};
use crate::raster::{Fill, Sides, draw_triangle};
use crate::scene::{Cull, Pose, Scene};
use crate::vertex::{ClipVertex, ScreenVertex, project};
use crate::view::{ActorView, ViewFrame, round_level};

/// Draws geometry that the application makes, into the bands of a frame.
///
/// Made once a frame, for one viewport, and used in each of its bands:
///
/// ```
/// # use fixel::{Scene, math::Vec3, render::Bands, immediate::{Immediate, Pen}};
/// # fn frame(scene: &Scene<'_>, bands: &mut Bands<'_, '_>, path: &[Vec3], send: impl Fn(&[u8])) {
/// let pose = scene.pose(0);
/// let mut immediate = Immediate::new(scene, &pose, 0, 320);
/// while let Some(mut target) = bands.next_target() {
///     immediate.polyline(&mut target, path, Pen { index: 7, width: 2, ..Pen::ONE_PIXEL });
///     send(target.into_finished().indices);
/// }
/// # }
/// ```
///
/// Places are in the world, which is the scene's space moved and scaled by a power of two:
/// [`Scene::world`] brings them there. What goes by call knows the palette, the scene's
/// lights, materials, cameras and clipping planes; it has no texture, and neither fog nor
/// transparency of its own. About 1.2 KB: a local variable of the drawing loop.
#[derive(Debug)]
pub struct Immediate<'a> {
    scene: &'a Scene<'a>,
    pub(super) view: ActorView,
    shine: Shine,
    /// The viewport.
    rect: Rect,
    /// Half of its height, for how large things are.
    pub(super) half_height: u16,
}

/// How lines are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pen {
    /// Palette index.
    pub index: u8,
    /// Pixels, 1..=16.
    pub width: u8,
    /// Whether what is nearer hides it.
    pub depth_test: bool,
    /// Depth units (of 65,535) that it is nearer than it lies, so that it is seen on a
    /// surface.
    pub bias: u16,
}

impl Pen {
    /// A line of one pixel of entry 0 that is hidden by what is before it.
    pub const ONE_PIXEL: Self = Self {
        index: 0,
        width: 1,
        depth_test: true,
        bias: 2,
    };

    fn rule(&self) -> DepthRule {
        DepthRule {
            test: self.depth_test,
            bias: self.bias,
        }
    }
}

impl<'a> Immediate<'a> {
    /// For a viewport of a frame as wide as its bands, with the first material.
    pub fn new(scene: &'a Scene<'a>, pose: &Pose<'_>, viewport: u16, frame_width: u16) -> Self {
        let placed = scene.place_viewport(viewport, pose, frame_width, pose.height);
        let view = ActorView::of_world(&ViewFrame::of(&placed), scene, 0);
        let mut immediate = Self {
            scene,
            view,
            shine: Shine::NONE,
            rect: placed.rect,
            half_height: placed.rect.height() / 2,
        };
        immediate.shine.set(scene, &immediate.view, &placed.camera);
        immediate
    }

    /// Lights what comes next as a material: its place in the scene file.
    pub fn set_material(&mut self, material: u16) {
        let material = self.scene.material(material);
        self.view
            .lights
            .set(self.scene, &material, &Rotation::IDENTITY);
        self.view.material = material;
    }

    /// The part of a line between two places that is before the camera, its ends included.
    pub fn line(&self, target: &mut Target<'_>, ends: [Vec3; 2], pen: Pen) {
        self.segment(target, ends, pen, true);
    }

    /// Lines from each place to the next; pixels where two meet are drawn once.
    pub fn polyline(&self, target: &mut Target<'_>, places: &[Vec3], pen: Pen) {
        let mut segments = places.windows(2).peekable();
        while let Some(segment) = segments.next() {
            if let [from, to] = segment {
                let last = segments.peek().is_none();
                self.segment(target, [*from, *to], pen, last);
            }
        }
    }

    fn segment(&self, target: &mut Target<'_>, ends: [Vec3; 2], pen: Pen, last: bool) {
        let clip_ends = ends.map(|place| self.clip_vertex(place, 0));
        let projected = clip_ends.each_ref().map(|end| project(&self.view, end));
        let mut vertices = projected;
        let mut last = last;
        if ScreenVertex::any_outside(projected.each_ref()) {
            if ScreenVertex::all_outside(projected.each_ref()) {
                return;
            }
            let Some(clipped) = clip_line(&self.view, clip_ends) else {
                return;
            };
            vertices = clipped.map(|(vertex, _)| vertex);
            let [_, end] = projected;
            last |= end.is_outside();
        }
        let line = Line {
            vertices: vertices.each_ref(),
            ends: [true, last],
            width: pen.width.clamp(1, 16),
            perspective: self.view.perspective,
        };
        let target = &mut target.part(&self.rect);
        draw_line(target, &line, &pen.rule(), Fill::Flat(pen.index));
    }

    /// A small picture of single bits at a place, `pen.width` of no use.
    pub fn mark(&self, target: &mut Target<'_>, place: Vec3, mark: &Mark<'_>, pen: Pen) {
        let point = project(&self.view, &self.clip_vertex(place, 0));
        if !point.is_outside() {
            let target = &mut target.part(&self.rect);
            draw_mark(target, &point, mark, &pen.rule(), |_| Some(pen.index));
        }
    }

    /// A square of `size` pixels at a place.
    pub fn point(&self, target: &mut Target<'_>, place: Vec3, size: u8, pen: Pen) {
        const FULL: [u8; 4 * 32] = [0xff; 4 * 32];
        let size = size.clamp(1, 32);
        let bits = usize::from(size).div_ceil(8) * usize::from(size);
        // Bits beyond the width would be drawn too: whole bytes, then what is left.
        let mut rows = FULL;
        let in_row = usize::from(size).div_ceil(8);
        let beyond = (in_row * 8 - usize::from(size)) as u32;
        for row in rows.chunks_exact_mut(in_row) {
            if let Some(last) = row.last_mut() {
                *last = last.unbounded_shl(beyond);
            }
        }
        let mark = Mark {
            width: size.into(),
            height: size.into(),
            offset: [1 - i16::from(size); 2],
            bits: rows.get(..bits).unwrap_or_default(),
        };
        self.mark(target, place, &mark, pen);
    }

    /// A triangle in the material's light, one colour over all of it, from the side where
    /// its corners go round counter-clockwise; other sides as the material says.
    pub fn triangle(&self, target: &mut Target<'_>, corners: [Vec3; 3]) {
        let Some(normal) = lit::face_normal(corners) else {
            return;
        };
        let index = self.index(lit::middle(corners), normal);
        self.filled_triangle(target, corners, index);
    }

    /// A triangle of one palette entry.
    pub fn filled_triangle(&self, target: &mut Target<'_>, corners: [Vec3; 3], index: u8) {
        let corners = corners.map(|place| self.clip_vertex(place, 0));
        self.fill(target, corners, Fill::Flat(index));
    }

    /// A triangle between levels, each of which has its palette entry in `ramp`: a
    /// material's ([`Immediate::ramp`]) with levels from [`Immediate::level`], or the
    /// application's own, such as from cold to hot.
    #[cfg(feature = "gouraud")]
    pub fn ramp_triangle(
        &self,
        target: &mut Target<'_>,
        corners: [(Vec3, Level); 3],
        ramp: &[u8; 256],
    ) {
        let corners = corners.map(|(place, level)| self.clip_vertex(place, i32::from(level) << 6));
        self.fill(target, corners, Fill::Gouraud(ramp));
    }

    /// The material's palette entry at each light level; of a material that goes by colour
    /// (one in coloured light, for instance), nothing of use.
    pub fn ramp(&self) -> &'a [u8; 256] {
        self.scene.shade(&self.view.material)
    }

    /// The light level of the material at a place with a normal of length 1.
    pub fn level(&self, place: Vec3, normal: Unit3) -> Level {
        if self.is_full() {
            let [level, ..] = self.lit(place, normal);
            return ((u32::from(level) + 32) >> 6).min(255) as Level;
        }
        round_level(self.view.lights.face_level(lit::packed(normal)))
    }

    /// The palette entry of the material's light at a place.
    pub fn index(&self, place: Vec3, normal: Unit3) -> u8 {
        if self.is_full() && self.view.material.coloured {
            return lit::nearest(self.scene, self.lit(place, normal));
        }
        let level = self.level(place, normal);
        self.ramp()
            .get(usize::from(level))
            .copied()
            .unwrap_or_default()
    }

    fn lit(&self, place: Vec3, normal: Unit3) -> Lit {
        self.shine
            .lit(self.scene, &self.view.material, place, normal)
    }

    /// Whether the material's light is more than grey light from infinitely far.
    fn is_full(&self) -> bool {
        cfg!(feature = "light") && self.view.material.full
    }

    fn clip_vertex(&self, place: Vec3, level: i32) -> ClipVertex {
        let [x, y, distance] = self.view.world_to_clip(place);
        ClipVertex {
            x,
            y,
            distance,
            level,
        }
    }

    fn fill(&self, target: &mut Target<'_>, corners: [ClipVertex; 3], fill: Fill<'_>) {
        let target = &mut target.part(&self.rect);
        let cull = self.view.material.cull;
        let sides = Sides {
            front: cull != Cull::Front,
            back: cull != Cull::Back,
        };
        let perspective = self.view.perspective;
        let projected = corners.each_ref().map(|corner| project(&self.view, corner));
        if !ScreenVertex::any_outside(projected.each_ref()) {
            draw_triangle(target, projected.each_ref(), sides, perspective, || fill);
            return;
        }
        if ScreenVertex::all_outside(projected.each_ref()) {
            return;
        }
        let polygon = clip(&self.view, corners);
        let Some((first, rest)) = polygon.vertices().split_first() else {
            return;
        };
        for pair in rest.windows(2) {
            if let [b, c] = pair {
                draw_triangle(target, [first, b, c], sides, perspective, || fill);
            }
        }
    }
}
