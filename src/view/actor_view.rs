//! One actor in one frame.

use super::{DepthMap, FINE_ROW_FRACTION, Lens, ModelFrame, ModelLights, ROW_FRACTION, ViewFrame};
use crate::math::{MAX_SCREEN, SUBPX_BITS, keep_rolled, rolled, square, square_root};
use crate::scene::{Actor, Material, Mesh, Place, Scene, Shading};

/// The eye as an actor's grid sees it.
#[derive(Clone, Copy, Debug)]
pub enum EyeInGrid {
    /// A place, in grid steps from the grid's centre (perspective).
    Point([i64; 3]),
    /// The direction of sight, Q30 (parallel).
    Direction([i32; 3]),
}

/// Grid points of one actor go through this to clip space.
///
/// A clip coordinate is `(row . q + constant) >> row_fraction`, for rows x, y (down) and
/// distance. All three are in one unit, chosen for the actor so that none
/// exceeds `2^limit`; x and y are also scaled by the lens's mantissas. So the
/// screen position is `x / distance * 2^lens.exponent` sub-pixels from the
/// middle (perspective) or `x >> parallel_shift` (parallel).
#[derive(Clone, Copy, Debug)]
pub struct ActorView {
    /// [`ROW_FRACTION`], or [`FINE_ROW_FRACTION`] for a fine mesh.
    pub row_fraction: u32,
    /// Coefficients, `row_fraction` fractional bits.
    pub rows: [[i32; 3]; 3],
    /// Values at the grid's centre, `row_fraction` fractional bits.
    pub constants: [i64; 3],
    /// For each row, the length of its linear part: a sphere of radius r grid
    /// steps changes the coordinate by at most `(r * this) >> row_fraction`.
    pub row_lengths: [i32; 3],
    /// The same for `x - k * distance` and `y - k * distance`, with k such that
    /// these are 0 at the screen's sides.
    pub side_lengths: [i32; 2],
    /// Distance of the near plane in clip units; at least 1 for perspective.
    pub near: i32,
    /// Distance of the far plane in clip units.
    pub far: i32,
    /// The lens of the frame.
    pub lens: Lens,
    /// Whether screen positions are divided by distance.
    pub perspective: bool,
    /// Right shift from a parallel clip coordinate to sub-pixels; negative:
    /// left.
    pub parallel_shift: i32,
    /// From distance to depth.
    pub depth: DepthMap,
    /// The eye, for back-face culling of whole meshlets.
    pub eye: EyeInGrid,
    /// The lights, of a material that is not `full`.
    pub lights: ModelLights,
    /// Where the grid is, for lights that have a place.
    pub model: ModelFrame,
    /// The material.
    pub material: Material,
    /// The mesh: the actor's own, or the level that does from here.
    pub mesh: Mesh,
    /// Half the screen, in raw sub-pixels.
    pub middle: [i32; 2],
    /// `log2` of the largest ratio of a clip coordinate to its distance whose
    /// screen position stays within [`MAX_SCREEN`]; may be negative.
    pub guard_shift: i32,
    /// The largest clip coordinate whose screen position stays within
    /// [`MAX_SCREEN`] (parallel).
    pub parallel_guard: i32,
}

impl ActorView {
    /// All zero, so that working memory starts as zeros: no actor's view.
    pub const ZERO: Self = Self {
        row_fraction: 0,
        rows: [[0; 3]; 3],
        constants: [0; 3],
        row_lengths: [0; 3],
        side_lengths: [0; 2],
        near: 0,
        far: 0,
        lens: Lens {
            mantissas: [0; 2],
            exponent: 0,
        },
        perspective: false,
        parallel_shift: 0,
        depth: DepthMap::ZERO,
        eye: EyeInGrid::Point([0; 3]),
        lights: ModelLights::NONE,
        material: Material {
            shading: Shading::Flat,
            power: 0,
            ..Material::PLAIN
        },
        model: ModelFrame::ZERO,
        mesh: Mesh {
            first_meshlet: 0,
            meshlets: 0,
            radius: 0,
            face_normals: false,
            fine: None,
            colours: None,
            coordinates: None,
            levels: (0, 0),
            error: 0,
        },
        middle: [0; 2],
        guard_shift: 0,
        parallel_guard: 0,
    };

    /// Brings one actor that is at `place` before the camera.
    pub fn new(frame: &ViewFrame, scene: &Scene<'_>, actor: &Actor, place: &Place) -> Self {
        let mut view = Self::ZERO;
        view.set(frame, scene, actor, place);
        view
    }

    /// The same where the view stays: half a kilobyte that needs no room on the stack.
    #[inline(never)]
    pub fn set(&mut self, frame: &ViewFrame, scene: &Scene<'_>, actor: &Actor, place: &Place) {
        let mesh = scene.mesh(actor.mesh);
        let material = scene.material(actor.material);
        let to_world = place.rotation;
        let to_view = to_world.then(&frame.rotation);
        let (step_mantissa, step_exponent) = place.step(actor);

        // The grid's centre in view space, world units in Q30.
        let [ox, oy, oz] = to_world.apply_wide(place.scaled(actor.offset));
        let [px, py, pz] = place.position.minus(frame.eye).map(|c| c << 14);
        let [cx, cy, cz] = frame.rotation.apply_wide([px + ox, py + oy, pz + oz]);
        let distance = cz.wrapping_neg();
        let cx = cx + sheared(frame, distance);
        let centre = [cx, -cy, distance]; // y down, distance along the line of sight

        // A sphere about it, in the same units, and the actor's clip unit.
        let radius = (u64::from(mesh.radius) * u64::from(step_mantissa)) >> 1;
        let radius = shift(radius as i64, step_exponent).saturating_add(1);
        let farthest = centre.iter().fold(0, |m: i64, c| m.max(c.abs()));
        // Sheared, a sphere reaches less than twice as far.
        let radius = radius << u32::from(frame.is_sheared());
        let reach = farthest.saturating_add(radius);
        let reach_bits = 64 - reach.leading_zeros() as i32;
        let limit = coordinate_bits(frame);
        let down = reach_bits - limit; // Q30 world units >> down = clip units
        let scale = 30 - down;

        let [kappa_x, kappa_y] = frame.lens.mantissas.map(i64::from);
        let mantissa = i64::from(step_mantissa);
        let row_fraction = if mesh.fine.is_some() {
            FINE_ROW_FRACTION
        } else {
            ROW_FRACTION
        };
        let row_shift = step_exponent + scale + row_fraction as i32 - 30;
        let [x, y, z] = &to_view.rows;
        let step = |c: i32| (i64::from(c) * mantissa) >> 31;
        let mut rows = [[0; 3]; 3];
        let [row_x, row_y, row_d] = &mut rows;
        let entries = x.iter().zip(y).zip(z);
        let slots = row_x.iter_mut().zip(row_y).zip(row_d);
        for (((to_x, to_y), to_d), ((x, y), z)) in slots.zip(entries) {
            let z = step(*z);
            let x = step(*x) + sheared(frame, -z);
            let lens = |kappa: i64, v: i64| (v * kappa + (1 << 30)) >> 31;
            *to_x = shift_round(lens(kappa_x, x), row_shift) as i32;
            *to_y = shift_round(-lens(kappa_y, step(*y)), row_shift) as i32;
            *to_d = shift_round(-z, row_shift) as i32;
            keep_rolled();
        }
        let [tx, ty, td] = centre;
        let constant = |v: i64| shift_round(v, row_fraction as i32 - down);
        let constants = [
            constant(scale_q31(kappa_x, tx)),
            constant(scale_q31(kappa_y, ty)),
            constant(td),
        ];

        let world_to_clip = |v: i64| {
            let least = if frame.perspective {
                1
            } else {
                i64::from(i32::MIN)
            };
            shift_round(v, scale - 16).max(least).min(i32::MAX.into()) as i32
        };
        let near = world_to_clip(frame.near);
        let middle = [frame.width, frame.height].map(|s| i32::from(s) << (SUBPX_BITS - 1));
        let row_lengths = rows.map(row_length);
        // Field by field, so that none is made elsewhere first; all are here.
        let Self {
            row_fraction: own_row_fraction,
            rows: own_rows,
            constants: own_constants,
            row_lengths: own_row_lengths,
            side_lengths: own_side_lengths,
            near: own_near,
            far,
            lens: own_lens,
            perspective,
            parallel_shift,
            depth,
            eye,
            lights,
            model,
            material: own_material,
            mesh: own_mesh,
            middle: own_middle,
            guard_shift: own_guard_shift,
            parallel_guard,
        } = self;
        lights.set(scene, &material, &to_world);
        *own_row_fraction = row_fraction;
        *own_rows = rows;
        *own_constants = constants;
        *own_row_lengths = row_lengths;
        *own_side_lengths = side_lengths(frame, row_lengths, middle);
        *own_near = near;
        *far = world_to_clip(frame.far);
        *own_lens = frame.lens;
        *perspective = frame.perspective;
        *parallel_shift = scale - frame.lens.exponent;
        *depth = DepthMap::new(frame, scale, near);
        *eye = eye_in_grid(frame, actor, place);
        *model = ModelFrame::new(actor, place);
        *own_material = material;
        *own_mesh = mesh;
        *own_middle = middle;
        *own_guard_shift = guard_shift(frame.lens);
        *parallel_guard =
            shift(MAX_SCREEN.into(), scale - frame.lens.exponent).min(i32::MAX.into()) as i32;
        if cfg!(feature = "lod") && mesh.levels.1 != 0 {
            self.choose_level(scene);
        }
    }

    /// The clip coordinate of the screen's side, which is `half` sub-pixels from
    /// its middle, at `distance`; rounded down.
    #[inline(never)]
    pub fn side_at(&self, half: i64, distance: i64) -> i64 {
        if self.perspective {
            side_at(self.lens, half, distance)
        } else {
            shift(half, self.parallel_shift)
        }
    }

    /// A parallel clip coordinate in 64ths of a sub-pixel from the screen's
    /// middle, rounded to nearest; what is farther than any place on a screen stays so.
    #[inline(never)]
    pub fn parallel(&self, v: i32) -> i32 {
        const FAR: i64 = 1 << 30;
        shift_round(v.into(), 6 - self.parallel_shift).clamp(-FAR, FAR) as i32
    }
}

/// See [`ActorView::side_lengths`]. x, y and distance are perpendicular.
#[inline(never)]
fn side_lengths(frame: &ViewFrame, [x, y, d]: [i32; 3], middle: [i32; 2]) -> [i32; 2] {
    let [middle_x, middle_y] = middle;
    let side = |length: i32, half: i32| {
        let along = if frame.perspective {
            side_at(frame.lens, half.into(), d.into())
        } else {
            0
        };
        // A sheared x leans by so much along the distance.
        let lean = sheared(frame, d.into()).unsigned_abs();
        let along = along.unsigned_abs().saturating_add(lean).min(1 << 31);
        rounded_up(square_root(square(length) + along * along))
    };
    let mut sides = [[x, middle_x], [y, middle_y]];
    for [own, half] in rolled(&mut sides) {
        *own = side(*own, *half);
        keep_rolled();
    }
    sides.map(|[length, _]| length)
}

/// What an eye's shear adds to x at a distance; below 2^60 with it.
fn sheared(frame: &ViewFrame, distance: i64) -> i64 {
    if !frame.is_sheared() {
        return 0;
    }
    // The shear is below 2^30.
    scale_q31(i64::from(frame.shear) * 2, distance)
}

/// The clip coordinate that projects to `half` sub-pixels at `distance`.
fn side_at(lens: Lens, half: i64, distance: i64) -> i64 {
    // half has at most 20 bits, distance 32.
    shift(half * distance, lens.exponent.wrapping_neg())
}

fn guard_shift(lens: Lens) -> i32 {
    MAX_SCREEN.ilog2() as i32 - lens.exponent
}

/// Bits of a clip coordinate: as many as projection can normalise without
/// losing the highest.
fn coordinate_bits(frame: &ViewFrame) -> i32 {
    if frame.perspective {
        (31 - guard_shift(frame.lens)).clamp(16, 28)
    } else {
        28
    }
}

/// Rounded up length of a row.
#[inline(never)]
pub(super) fn row_length([a, b, c]: [i32; 3]) -> i32 {
    rounded_up(square_root([a, b, c].map(square).iter().sum()))
}

/// More than a root of which this is the part before the point.
fn rounded_up(root: u32) -> i32 {
    root.min(i32::MAX as u32 - 1) as i32 + 1
}

#[inline(never)]
fn eye_in_grid(frame: &ViewFrame, actor: &Actor, place: &Place) -> EyeInGrid {
    let to_model = place.rotation.transposed();
    if !frame.perspective {
        let [x, _, mut z] = frame.rotation.rows;
        for (z, x) in z.iter_mut().zip(x) {
            // At most 1.2: a shear is at most 0.6.
            *z = z.wrapping_add(sheared(frame, x.into()) as i32);
        }
        return EyeInGrid::Direction(to_model.apply(z).map(i32::wrapping_neg));
    }
    let from_pivot = frame.eye.minus(place.position).map(|c| c << 14);
    let [x, y, z] = to_model.apply_wide(from_pivot);
    let [ox, oy, oz] = place.scaled(actor.offset);
    // World units in Q30 over a step of mantissa * 2^(exponent - 31); 16 bits
    // of the mantissa are enough to cull by.
    let (mantissa, exponent) = place.step(actor);
    let divisor = i64::from(mantissa >> 16);
    let mut point = [x - ox, y - oy, z - oz];
    for c in rolled(&mut point) {
        let quotient = (*c << 14).checked_div(divisor).unwrap_or(0);
        *c = shift(quotient, 31 - 16 - 30 - 14 - exponent).clamp(-(1 << 40), 1 << 40);
        keep_rolled();
    }
    EyeInGrid::Point(point)
}

/// `a * v / 2^31` for `|v| < 2^48` and `a < 2^31`, rounded down.
#[inline(never)]
fn scale_q31(a: i64, v: i64) -> i64 {
    let (high, low) = (v >> 16, v & 0xffff);
    (a * high + ((a * low) >> 16)) >> 15
}

#[inline(never)]
fn shift(v: i64, by: i32) -> i64 {
    if by >= 0 {
        v.saturating_mul(1i64 << by.min(62))
    } else {
        v >> by.wrapping_neg().min(63)
    }
}

#[inline(never)]
fn shift_round(v: i64, by: i32) -> i64 {
    if by >= 0 {
        shift(v, by)
    } else {
        let down = by.wrapping_neg().min(62);
        v.saturating_add(1i64 << (down - 1)) >> down
    }
}
