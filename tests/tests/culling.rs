//! What is culled has no pixel to show, and what is not stays within the rows
//! that it was said to touch: every meshlet is drawn whatever its verdict.

use std::sync::LazyLock;

use fixed::types::U8F24;
use fixel::clip::clip;
use fixel::cull::{Sight, Verdict, judge};
use fixel::math::{Angle, Factor, Vec3, World};
use fixel::raster::{Fill, Sides, draw_triangle};
use fixel::scene::layout::{CONE_TRIANGLES, MESHLET_VERTICES};
use fixel::scene::{Camera, Cull, Meshlet, Placement, Projection};
use fixel::vertex::{Room, ScreenVertex, Used, transform_meshlet, vertex};
use fixel::view::{ActorView, MeshletRows, ViewFrame};
use fixel::{Band, Scene};
use fixel_bake::Baked;
use fixel_tests::{load, root};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

const SIZE: (u16, u16) = (48, 36);

static SCENES: LazyLock<Vec<Baked>> = LazyLock::new(|| {
    let names = [
        "bunny",
        "teapot",
        "behind_camera",
        "cube",
        "slivers",
        "far_clip",
    ];
    names
        .iter()
        .map(|name| load(&root().join(format!("scenes/{name}.toml"))).1)
        .collect()
});

/// The rows that a meshlet's triangles have pixels in, those whose numbers are asked for,
/// half-open; `None` if there are none.
fn rows_drawn(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    asked: impl Fn(usize) -> bool,
) -> Option<(u16, u16)> {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(SIZE.0, &mut indices, &mut depths).expect("a band");
    let mut target = band.target(0, SIZE.1);
    target.clear(|_| 0);
    let sides = Sides {
        front: view.material.cull != Cull::Front,
        back: view.material.cull != Cull::Back,
    };
    let mut vertices = [ScreenVertex::ZERO; MESHLET_VERTICES];
    let mut room = Room {
        vertices: &mut vertices,
        colours: &mut [],
    };
    transform_meshlet(scene, view, meshlet, &Used::ALL, &mut room);
    let rows = MeshletRows::new(view, meshlet);
    let all = scene.meshlet_triangles(meshlet).iter().enumerate();
    for (_, indices) in all.filter(|(number, _)| asked(*number)) {
        let corners = indices.map(|i| &vertices[usize::from(i)]);
        let mut draw = |triangle: [&ScreenVertex; 3]| {
            draw_triangle(&mut target, triangle, sides, view.perspective, || {
                Fill::Flat(1)
            });
        };
        if corners.iter().all(|v| !v.is_outside()) {
            draw(corners);
            continue;
        }
        let polygon = clip(
            view,
            indices.map(|i| vertex(scene, &rows, view, meshlet, i)),
        );
        if let Some((first, rest)) = polygon.vertices().split_first() {
            rest.windows(2)
                .for_each(|pair| draw([first, &pair[0], &pair[1]]));
        }
    }
    let lit = |row: &[u16]| row.iter().any(|z| *z != 0);
    let rows: Vec<bool> = target.depths.chunks(SIZE.0.into()).map(lit).collect();
    let first = rows.iter().position(|lit| *lit)?;
    let last = rows.iter().rposition(|lit| *lit)?;
    Some((first as u16, last as u16 + 1))
}

/// A camera in and around the scene: where it stands, as a multiple of the scene's
/// own camera's distance, and the rest.
#[derive(Clone, Debug)]
struct View {
    scene: usize,
    sight: [f64; 3],
    distance: f64,
    aside: [f64; 3],
    parallel: bool,
    opening: f64,
    near: f64,
    range: f64,
    turn: [u32; 3],
    cull: Cull,
}

fn case() -> impl Strategy<Value = View> {
    let place = (
        0usize..6,
        prop::array::uniform3(-1.0..1.0f64),
        -4.0..1.5f64,
        prop::array::uniform3(-0.5..0.5f64),
    );
    let lens = (any::<bool>(), -5.0..1.5f64, -7.0..0.5f64, -4.0..4.0f64);
    let culls = [Cull::Back, Cull::Front, Cull::None];
    (
        place,
        lens,
        any::<[u32; 3]>(),
        prop::sample::select(culls.to_vec()),
    )
        .prop_map(
            |((scene, sight, distance, aside), (parallel, opening, near, range), turn, cull)| {
                View {
                    scene,
                    sight,
                    distance: distance.exp2(),
                    aside,
                    parallel,
                    opening: opening.exp2(),
                    near: near.exp2(),
                    range: range.exp2(),
                    turn,
                    cull,
                }
            },
        )
}

fn camera(case: &View, own: &Camera) -> Camera {
    let f = |v: Vec3| v.to_bits().map(|c| f64::from(c) / 65536.0);
    let (eye, focus) = (f(own.position), f(own.focal_point));
    let reach = (0..3)
        .map(|i| (eye[i] - focus[i]).powi(2))
        .sum::<f64>()
        .sqrt();
    let length = case
        .sight
        .iter()
        .map(|c| c * c)
        .sum::<f64>()
        .sqrt()
        .max(0.01);
    let focus = [0, 1, 2].map(|i| focus[i] + case.aside[i] * reach);
    let eye = [0, 1, 2].map(|i| focus[i] + case.sight[i] / length * reach * case.distance);
    let to_world = |v: [f64; 3]| Vec3::from_bits(v.map(|c| (c * 65536.0) as i32));
    let near = reach * case.near * case.distance;
    Camera {
        position: to_world(eye),
        focal_point: to_world(focus),
        view_up: Vec3::from_bits([1 << 20, 1 << 22, 1 << 18]),
        projection: if case.parallel {
            Projection::Parallel {
                half_height: World::from_num(reach * case.opening.min(1.0)),
            }
        } else {
            Projection::Perspective {
                tan_half_angle: U8F24::from_num(case.opening),
            }
        },
        near: World::from_num(near.max(0.001)),
        far: World::saturating_from_num(near + reach * case.range),
        range_exponent: 0,
    }
}

#[derive(Default)]
struct Counts {
    meshlets: usize,
    drawn: usize,
    culled: usize,
    /// Triangles of meshlets that cones were asked of.
    triangles: usize,
    /// Those that cones leave out.
    behind: usize,
}

impl Counts {
    /// What a cone says is seen from behind has no pixel.
    fn check_cones(
        &mut self,
        scene: &Scene<'_>,
        view: &ActorView,
        (number, meshlet): (u32, &Meshlet),
    ) -> Result<(), TestCaseError> {
        if view.material.cull != Cull::Back {
            return Ok(());
        }
        let sight = Sight::new(view, meshlet);
        let cones = scene.meshlet_cones(number, meshlet);
        let behind = |triangle: usize| sight.is_behind(cones[triangle / CONE_TRIANGLES]);
        prop_assert_eq!(
            rows_drawn(scene, view, meshlet, behind),
            None,
            "cones of meshlet {}",
            number
        );
        let triangles = usize::from(meshlet.triangles);
        self.triangles += triangles;
        self.behind += (0..triangles).filter(|t| behind(*t)).count();
        Ok(())
    }
}

fn check(case: &View, counts: &mut Counts) -> Result<(), TestCaseError> {
    let scene = SCENES[case.scene].scene().expect("baked a moment ago");
    let camera = camera(case, &scene.pose(0).camera);
    let frame = ViewFrame::new(&camera, SIZE.0, SIZE.1);
    for number in 0..scene.actor_count() {
        let actor = scene.actor(number);
        let placement = Placement {
            position: Vec3::from_bits(actor.position),
            orientation: case.turn.map(Angle::from_bits),
            scale: Factor::ONE,
        };
        let mut view = ActorView::new(&frame, &scene, &actor, &placement.into());
        view.material.cull = case.cull;
        let mesh = scene.mesh(actor.mesh);
        for m in mesh.first_meshlet..mesh.first_meshlet + mesh.meshlets {
            let meshlet = scene.meshlet(m).expect("in range");
            let drawn = rows_drawn(&scene, &view, &meshlet, |_| true);
            counts.check_cones(&scene, &view, (m, &meshlet))?;
            counts.meshlets += 1;
            counts.drawn += usize::from(drawn.is_some());
            match judge(&view, &meshlet, SIZE.1, 0) {
                Verdict::Visible(visible) => {
                    if let Some((first, end)) = drawn {
                        prop_assert!(
                            visible.first_row <= first && end <= visible.end_row,
                            "actor {} meshlet {}: rows {}..{} drawn, {:?}",
                            number,
                            m,
                            first,
                            end,
                            visible
                        );
                    }
                }
                verdict => {
                    counts.culled += 1;
                    prop_assert_eq!(drawn, None, "actor {} meshlet {}: {:?}", number, m, verdict);
                }
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn what_is_culled_has_nothing_to_show(case in case()) {
        check(&case, &mut Counts::default())?;
    }
}

/// Of the meshlets that show nothing, most are found out by their bounds alone.
#[test]
fn most_of_what_shows_nothing_is_culled() {
    let mut runner = TestRunner::deterministic();
    let mut counts = Counts::default();
    for _ in 0..1000 {
        let case = case().new_tree(&mut runner).expect("a case").current();
        check(&case, &mut counts).expect("culled rightly");
    }
    let hidden = counts.meshlets - counts.drawn;
    assert!(
        counts.culled * 100 > hidden * 80,
        "{} of {hidden} are culled",
        counts.culled
    );
    // Half of all face away, and of a cube none does without its neighbours in a cone.
    assert!(
        counts.behind * 100 > counts.triangles * 30,
        "{} of {} are left out by cones",
        counts.behind,
        counts.triangles
    );
}
