//! Grid point to screen, against f64: any camera, place and scale.

use std::sync::LazyLock;

use fixed::types::U8F24;
use fixel::Scene;
use fixel::math::{Angle, Factor, MAX_SCREEN, Vec3, World, reciprocal};
use fixel::scene::{Actor, Camera, Meshlet, Placement, Projection};
use fixel::vertex::{ClipVertex, project};
use fixel::view::{ActorView, MeshletRows, ViewFrame};
use fixel_bake::Baked;
use fixel_tests::{load, root};
use proptest::prelude::*;

const SIZE: (u16, u16) = (320, 240);

/// A fine mesh and one that is not.
static SCENES: LazyLock<[Baked; 2]> = LazyLock::new(|| {
    ["cube", "bunny"].map(|name| load(&root().join(format!("scenes/{name}.toml"))).1)
});

type V = [f64; 3];

fn minus(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn unit(a: V) -> V {
    let length = dot(a, a).sqrt();
    a.map(|c| c / length)
}

fn world(v: Vec3) -> V {
    v.to_bits().map(|c| f64::from(c) / 65536.0)
}

/// Turned in the plane of axes `i` and `j`, from `i` towards `j`.
fn turned(v: V, i: usize, j: usize, angle: Angle) -> V {
    let angle = f64::from(angle.to_bits()) / 2f64.powi(32) * std::f64::consts::TAU;
    let (sin, cos) = angle.sin_cos();
    let mut out = v;
    out[i] = cos * v[i] - sin * v[j];
    out[j] = sin * v[i] + cos * v[j];
    out
}

/// What a case is made of.
#[derive(Clone, Debug)]
struct Case {
    fine: bool,
    camera: Camera,
    actor: Actor,
    /// A vertex as two meshlets have it: base, shifts and distance.
    meshlets: [([i32; 3], [u8; 3], [i16; 3]); 2],
    /// The vertex, in grid steps.
    point: [i32; 3],
}

fn bits(reach: i32) -> impl Strategy<Value = i32> {
    prop_oneof![-reach..reach, -(reach >> 6)..reach >> 6]
}

/// Places up to 8192 world units from the origin, as the baker makes them.
fn place() -> impl Strategy<Value = [i32; 3]> {
    prop::array::uniform3(bits(1 << 29))
}

fn camera() -> impl Strategy<Value = Camera> {
    let perspective = (-8.0..2.5f64).prop_map(|log| Projection::Perspective {
        tan_half_angle: U8F24::from_num(log.exp2()),
    });
    let parallel = (4.0..12.0f64).prop_map(|log| Projection::Parallel {
        half_height: World::from_num(log.exp2()),
    });
    let up = prop::array::uniform3(-(1 << 30)..1 << 30);
    (
        place(),
        place(),
        up,
        prop_oneof![3 => perspective.boxed(), 1 => parallel.boxed()],
        -6.0..11.0f64,
        1.0..12.0f64,
    )
        .prop_map(
            |(position, focal_point, view_up, projection, near, range)| {
                let near = near.exp2();
                Camera {
                    position: Vec3::from_bits(position),
                    focal_point: Vec3::from_bits(focal_point),
                    view_up: Vec3::from_bits(view_up),
                    projection,
                    near: World::from_num(near),
                    far: World::saturating_from_num(near + range.exp2()),
                    range_exponent: 0,
                }
            },
        )
}

fn case() -> impl Strategy<Value = Case> {
    let actor = (
        place(),
        any::<[u32; 3]>(),
        prop::array::uniform3(bits(1 << 27)),
        1u32 << 31..,
        -24i32..-8,
    );
    let target = (-1.2..1.2f64, -1.2..1.2f64, 0.0..13.0f64);
    let meshlet = || (prop::array::uniform3(0u8..=5), any::<[i16; 3]>());
    let point = prop::array::uniform3(-(1 << 19)..1 << 19);
    (
        any::<bool>(),
        camera(),
        actor,
        (meshlet(), meshlet()),
        point,
        target,
    )
        .prop_map(
            |(
                fine,
                camera,
                (position, orientation, offset, mantissa, exponent),
                (one, other),
                point,
                target,
            )| {
                let near_the_point = |(shifts, far): ([u8; 3], [i16; 3])| {
                    let base: [i32; 3] =
                        [0, 1, 2].map(|i| point[i] - (i32::from(far[i]) << shifts[i]));
                    // A base stays on the grid.
                    let base = base.map(|c| c.clamp(-(1 << 21), 1 << 21));
                    let far = [0, 1, 2].map(|i| ((point[i] - base[i]) >> shifts[i]) as i16);
                    (base, shifts, far)
                };
                let (one, other) = (near_the_point(one), near_the_point(other));
                let mut case = Case {
                    fine,
                    camera,
                    actor: Actor {
                        mesh: 0,
                        material: 0,
                        position,
                        orientation,
                        offset,
                        step_mantissa: mantissa,
                        step_exponent: exponent,
                        parent: None,
                        still: false,
                        part: false,
                    },
                    meshlets: [one, other],
                    point,
                };
                bring_before_the_camera(&mut case, target);
                case
            },
        )
}

/// Moves the actor so that the vertex is at a place of the screen (-1 and 1 are its
/// sides) and a distance from the near plane on (log2 of it), if the world holds
/// that.
fn bring_before_the_camera(case: &mut Case, (across, down, distance): (f64, f64, f64)) {
    let distance = case.camera.near.to_num::<f64>() + distance.exp2() - 1.0;
    let half_height = match case.camera.projection {
        Projection::Perspective { tan_half_angle } => distance * tan_half_angle.to_num::<f64>(),
        Projection::Parallel { half_height } => half_height.to_num(),
    };
    let half_width = half_height * f64::from(SIZE.0) / f64::from(SIZE.1);
    let [axis_x, axis_down, axis_away] = axes(&case.camera);
    let now = exact(case);
    let by = minus([across * half_width, down * half_height, distance], now);
    let by = [0, 1, 2].map(|i| axis_x[i] * by[0] + axis_down[i] * by[1] + axis_away[i] * by[2]);
    let position = [0, 1, 2].map(|i| f64::from(case.actor.position[i]) + by[i] * 65536.0);
    if position.iter().all(|c| c.abs() < f64::from(1 << 30)) {
        case.actor.position = position.map(|c| c as i32);
    }
}

/// Right, down and along the line of sight.
fn axes(camera: &Camera) -> [V; 3] {
    let back = unit(minus(world(camera.position), world(camera.focal_point)));
    let right = unit(cross(world(camera.view_up), back));
    [right, cross(back, right).map(|c| -c), back.map(|c| -c)]
}

/// Right, down and distance in world units.
fn exact(case: &Case) -> V {
    let actor = &case.actor;
    let step = f64::from(actor.step_mantissa) * f64::from(actor.step_exponent - 31).exp2();
    let offset = world(Vec3::from_bits(actor.offset));
    let local = [0, 1, 2].map(|i| offset[i] + f64::from(case.point[i]) * step);
    let [x, y, z] = actor.orientation.map(Angle::from_bits);
    let local = turned(turned(turned(local, 2, 0, y), 1, 2, x), 0, 1, z);
    let position = world(Vec3::from_bits(actor.position));
    let place = [0, 1, 2].map(|i| local[i] + position[i]);
    let from_eye = minus(place, world(case.camera.position));
    axes(&case.camera).map(|axis| dot(from_eye, axis))
}

fn view(scene: &Scene<'_>, case: &Case) -> ActorView {
    let frame = ViewFrame::new(&case.camera, SIZE.0, SIZE.1);
    let placement = Placement {
        position: Vec3::from_bits(case.actor.position),
        orientation: case.actor.orientation.map(Angle::from_bits),
        scale: Factor::ONE,
    };
    ActorView::new(&frame, scene, &case.actor, &placement.into())
}

fn check(case: &Case) -> Result<(), TestCaseError> {
    let scene = SCENES[usize::from(!case.fine)]
        .scene()
        .expect("baked a moment ago");
    let view = view(&scene, case);
    prop_assert_eq!(view.mesh.fine.is_some(), case.fine);

    let clips = case.meshlets.map(|(base, shifts, far)| {
        let meshlet = Meshlet {
            base,
            shifts,
            radius: 0,
            vertices: 1,
            triangles: 1,
            cone_axis: [0; 3],
            cone_cutoff: 127,
            first_vertex: 0,
            first_triangle: 0,
        };
        let rows = MeshletRows::new(&view, &meshlet);
        if case.fine {
            rows.apply_fine([0, 1, 2].map(|i| case.point[i] - base[i]))
        } else {
            rows.apply(far)
        }
    });
    // The vertex is the same from whatever meshlet, if both can say where it is.
    let on_grid = |(base, shifts, far): &([i32; 3], [u8; 3], [i16; 3])| {
        (0..3).all(|i| case.point[i] == base[i] + (i32::from(far[i]) << shifts[i]))
    };
    let said = case.meshlets.iter().position(|m| case.fine || on_grid(m));
    if case.meshlets.iter().all(|m| case.fine || on_grid(m)) {
        prop_assert_eq!(clips[0], clips[1]);
    }
    let Some(said) = said else {
        return Ok(());
    };
    let [x, y, distance] = clips[said];
    let screen = project(
        &view,
        &ClipVertex {
            x,
            y,
            distance,
            level: 0,
        },
    );

    let [right, down, away] = exact(case);
    let camera = &case.camera;
    let (near, far) = (camera.near.to_num::<f64>(), camera.far.to_num::<f64>());
    let half_height = f64::from(SIZE.1) / 2.0;
    let pixels = match camera.projection {
        Projection::Perspective { tan_half_angle } => half_height / tan_half_angle.to_num::<f64>(),
        Projection::Parallel { half_height: scale } => half_height / scale.to_num::<f64>(),
    };
    // Clip units a world unit.
    let unit = f64::from(view.parallel_shift + view.lens.exponent).exp2();
    if screen.is_outside() {
        return Ok(());
    }
    let scale = if view.perspective {
        pixels / away
    } else {
        pixels
    };
    let want_x = f64::from(SIZE.0) / 2.0 + right * scale;
    let want_y = half_height + down * scale;
    let want_z = if view.perspective {
        65535.0 * near / away
    } else {
        65535.0 * (far - away) / (far - near)
    };
    // What a world unit off, across and along, does to the screen and to depth.
    let (across, along, deep) = if view.perspective {
        let sub_px = 4096.0 * scale;
        (
            sub_px,
            [right, down].map(|c| sub_px * c.abs() / away),
            65535.0 * near / (away * away),
        )
    } else {
        (4096.0 * scale, [0.0; 2], 65535.0 / (far - near))
    };
    // How far a vertex may be off in the world: rotations are good to 2^-28, and a
    // clip coordinate rounds by a unit, its row's entries by half of one over the
    // 2^20 steps of the mesh.
    let length = |v: V| dot(v, v).sqrt();
    let offset = length(world(Vec3::from_bits(case.actor.offset)));
    let turned = (length([right, down, away]) + offset) * 2f64.powi(-28);
    let clip = if case.fine { 4.0 } else { 32.0 } / unit;
    let off = turned + clip;
    let [off_x, off_y] = along.map(|along| 0.51 + (across + along) * off);
    // Depths have 4 fractional bits; a parallel view's depth at the eye as well.
    let off_z = if view.perspective { 0.04 } else { 0.1 } + deep * off;
    let want_z = want_z.max(9.0 / 16.0);
    let [x, y] = [(screen.x(), want_x), (screen.y(), want_y)]
        .map(|(got, want)| (got.to_num::<f64>() - want).abs() * 4096.0);
    let z = (screen.z().to_num::<f64>() - want_z).abs();
    prop_assert!(
        x <= off_x,
        "x is off by {} sub-pixels, {} allowed",
        x,
        off_x
    );
    prop_assert!(
        y <= off_y,
        "y is off by {} sub-pixels, {} allowed",
        y,
        off_y
    );
    prop_assert!(z <= off_z, "depth is off by {}, {} allowed", z, off_z);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn vertices_are_where_they_belong(case in case()) {
        check(&case)?;
    }

    /// Also where the reciprocal's last bit may go either way.
    #[test]
    fn depth_never_grows_with_distance(case in case(), from in 0.0..1.0f64) {
        let scene = SCENES[0].scene().expect("baked a moment ago");
        let view = view(&scene, &case);
        let (near, far) = (view.near, view.far.min(view.near.saturating_add(1 << 28)));
        let first = near + (f64::from(far - near) * from.powi(4)) as i32;
        let depth = |d: i32| view.depth.depth(d, reciprocal(d as u32));
        for d in first..first.saturating_add(200).min(far) {
            prop_assert!(depth(d + 1) <= depth(d), "at distance {}", d);
        }
    }

    /// What the outcode lets through has a screen position within 2048 pixels of
    /// the screen's middle.
    #[test]
    fn the_guard_band_holds(case in case(), corner in any::<[bool; 2]>(), distance in 0.0..1.0f64) {
        let scene = SCENES[0].scene().expect("baked a moment ago");
        let view = view(&scene, &case);
        // Clip coordinates as the view makes them.
        let most = 1 << (31 - view.guard_shift).clamp(16, 28);
        let far = view.far.min(most - 1).max(view.near);
        let distance = view.near + (f64::from(far - view.near) * distance.powi(4)) as i32;
        // The farthest place along each axis that is within the guard, by halving.
        let inside = |x: i32, y: i32| {
            let vertex = ClipVertex { x, y, distance, level: 0 };
            let screen = project(&view, &vertex);
            (!screen.is_outside()).then_some(screen)
        };
        let sign = corner.map(|negative| if negative { -1 } else { 1 });
        let (mut low, mut high) = (0i32, most);
        while high - low > 1 {
            let middle = (low + high) / 2;
            match inside(sign[0] * middle, sign[1] * middle) {
                Some(_) => low = middle,
                None => high = middle,
            }
        }
        if let Some(screen) = inside(sign[0] * low, sign[1] * low) {
            let off = [screen.x().to_bits() - view.middle[0], screen.y().to_bits() - view.middle[1]];
            prop_assert!(off.iter().all(|c| c.abs() <= MAX_SCREEN), "{:?} sub-pixels from the middle", off);
            prop_assert!((0..2).all(|i| off[i] * sign[i] >= 0), "{:?} wrapped", off);
            // A power of two below what the lens would allow, at most.
            let reached = off[0].abs();
            prop_assert!(low == most - 1 || reached > MAX_SCREEN / 4, "the guard ends at {}", reached);
        }
    }
}
