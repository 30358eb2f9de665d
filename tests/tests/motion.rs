//! Where the core has things in a frame, against the reference: chains of parents
//! with every kind of part, key frames, and the camera's moves.

use fixel::scene::{Actor as Record, Place};
use fixel_bake::bake;
use fixel_scene::{
    Actor, Animation, Camera, Key, Projection, Quantity, Scene, Target, Track, load,
};
use fixel_tests::root;
use glam::{DMat3, DVec3};
use proptest::prelude::*;

fn plain() -> Scene {
    load(&root().join("scenes/cube.toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// Where the core has a grid point of an actor; world units.
fn placed(place: &Place, actor: &Record, grid: DVec3) -> DVec3 {
    let step = f64::from(actor.step_mantissa) * f64::from(actor.step_exponent - 31).exp2();
    let local = DVec3::from(actor.offset.map(f64::from)) / 65536.0 + grid * step;
    let rows = place
        .rotation
        .rows
        .map(|row| row.map(|c| f64::from(c) / f64::exp2(30.0)));
    let turn = DMat3::from_cols_array_2d(&rows).transpose();
    let factor = place.scale.to_num::<f64>();
    DVec3::from(place.position.to_bits().map(f64::from)) / 65536.0 + turn * local * factor
}

/// The world's origin in scene units.
fn centre(core: &fixel::Scene<'_>) -> DVec3 {
    let header = core.header();
    DVec3::from(header.world_centre.map(f64::from)) * f64::from(header.centre_exponent).exp2()
}

/// Largest distance in world units between where the core and the reference have a
/// vertex, less what the mesh's grid rounds.
fn farthest_off(scene: &Scene, frame: u32) -> f64 {
    let baked = bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    // In grid steps, the blob's triangles in the blob's order.
    let grids = fixel_bake::unbake(&core);
    let unit = f64::from(core.world_exponent()).exp2();
    let centre = centre(&core);
    let pose = core.pose(frame);
    let mut most: f64 = 0.0;
    for (index, actor) in scene.actors.iter().enumerate() {
        let record = core.actor(index as u16);
        let place = pose.place(&core, index as u16, &record);
        let matrix = fixel_reference::actor_matrix(scene, index, frame);
        let mesh = &scene.meshes[actor.mesh];
        for p in &grids.meshes[usize::from(record.mesh)].positions {
            let found = placed(&place, &record, DVec3::from(*p));
            let exact = |p: &[f64; 3]| (matrix.transform_point3(DVec3::from(*p)) - centre) * unit;
            let nearest = mesh.positions.iter().map(|p| exact(p).distance(found));
            let step = placed(&place, &record, DVec3::X) - placed(&place, &record, DVec3::ZERO);
            // The nearest of 27 grid points is not always taken.
            let rounded = 1.5 * 3.0_f64.sqrt() * step.length();
            most = most.max(nearest.fold(f64::INFINITY, f64::min) - rounded);
        }
    }
    most
}

fn numbers(range: f64) -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-range..range)
}

/// Scales of one, two or three factors, some negative.
fn scales() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![
        (0.4..2.0f64).prop_map(|s| [s; 3]),
        prop::array::uniform3(0.4..2.0f64),
        (
            prop::array::uniform3(0.4..2.0f64),
            prop::array::uniform3(any::<bool>())
        )
            .prop_map(|(s, flip)| [0, 1, 2].map(|i| if flip[i] { -s[i] } else { s[i] })),
    ]
}

/// An actor with every kind of part; half of them without shear and matrix.
fn actor() -> impl Strategy<Value = Actor> {
    let shear = prop_oneof![Just([0.0; 6]), prop::array::uniform6(-0.3..0.3f64)];
    let matrix = prop_oneof![
        Just(fixel_scene::IDENTITY),
        prop::array::uniform12(-0.3..0.3f64).prop_map(|m| {
            let mut rows = fixel_scene::IDENTITY;
            for (i, m) in m.iter().enumerate() {
                rows[i / 4][i % 4] += m;
            }
            rows
        }),
    ];
    let parts = (
        numbers(2.0),
        numbers(3.0),
        numbers(180.0),
        scales(),
        shear,
        matrix,
    );
    parts.prop_map(
        |(origin, position, orientation, scale, shear, matrix)| Actor {
            origin,
            position,
            orientation,
            scale,
            shear,
            matrix,
            ..Actor::default()
        },
    )
}

/// The cube's scene with other actors; each after the first may have one before it
/// as its parent.
fn family(actors: Vec<Actor>, parents: &[usize]) -> Scene {
    let mut scene = plain();
    scene.animation = Animation::default();
    scene.actors = actors;
    for (index, actor) in scene.actors.iter_mut().enumerate() {
        actor.name = format!("actor {index}");
        actor.parent = (parents[index] < index).then(|| parents[index]);
    }
    scene
}

/// A world position has 16 fractional bits, and each parent rounds once.
const CLOSE: f64 = 4.0 / 65536.0;
/// Key frames have angles in 2^-24 turns: half of it in radians.
const ANGLE: f64 = 1.9e-7;
/// How far a scene reaches, in world units.
const REACH: f64 = 8192.0;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn still_families(
        actors in prop::collection::vec(actor(), 5),
        parents in prop::array::uniform5(0usize..6),
    ) {
        let scene = family(actors, &parents);
        let off = farthest_off(&scene, 0);
        prop_assert!(off < CLOSE, "{} units off", off);
    }

    /// What moves: positions and factors anywhere, turns where the space is even.
    #[test]
    fn moving_families(
        mut actors in prop::collection::vec(actor(), 4),
        parents in prop::array::uniform4(0usize..5),
        keys in prop::collection::vec((0usize..4, 0u32..40, numbers(2.0), 0.3..3.0f64), 6),
        turns in prop::collection::vec((0u32..40, numbers(720.0)), 2..5),
        frame in 0u32..50,
    ) {
        // The first one, which turns, has an even space; the last one is alone.
        actors[0].matrix = fixel_scene::IDENTITY;
        let mut scene = family(actors, &parents);
        let mut track = |target, quantity, keys: Vec<(u32, [f64; 3])>| {
            let mut keys: Vec<Key> =
                keys.into_iter().map(|(frame, value)| Key { frame, value }).collect();
            keys.sort_by_key(|key| key.frame);
            keys.dedup_by_key(|key| key.frame);
            if !keys.is_empty() {
                scene.animation.tracks.push(Track { target, quantity, keys });
            }
        };
        track(Target::Actor(0), Quantity::Orientation, turns);
        for who in 0..4 {
            let own = || keys.iter().filter(|key| key.0 == who);
            let positions = own().map(|key| (key.1, key.2)).collect();
            track(Target::Actor(who), Quantity::Position, positions);
            let factors = own().map(|key| (key.1, [key.3, 0.0, 0.0])).collect();
            track(Target::Actor(who), Quantity::Scale, factors);
        }
        scene.animation.frames = Some(45);
        let off = farthest_off(&scene, frame);
        // Factors of up to 3 on factors of up to 3 enlarge what was rounded.
        let most = 40.0 * CLOSE + 3.0 * ANGLE * REACH;
        prop_assert!(off < most, "{} units off", off);
    }

    #[test]
    fn camera_moves(
        (position, focal_point) in (numbers(5.0), numbers(1.0)),
        view_up in numbers(1.0),
        parallel in any::<bool>(),
        moves in ((-80.0..80.0f64), (-60.0..60.0f64), (-200.0..200.0f64)),
        factors in ((0.4..3.0f64), (0.5..3.0f64)),
        pan in ((-2.0..2.0f64), (-2.0..2.0f64)),
    ) {
        let mut scene = plain();
        let sight = DVec3::from(focal_point) - DVec3::from(position);
        let up = DVec3::from(view_up);
        // Up is far from the line of sight, before and after the moves.
        prop_assume!(sight.length() > 1.0 && up.length() > 0.1);
        prop_assume!(sight.normalize().cross(up.normalize()).length() > 0.4);
        let elevation = sight.normalize().dot(up.normalize()).asin().to_degrees();
        prop_assume!((elevation - moves.1).abs() < 70.0);
        scene.camera = Camera {
            position,
            focal_point,
            view_up,
            projection: if parallel {
                Projection::Parallel { parallel_scale: 1.5 }
            } else {
                Projection::Perspective { view_angle: 40.0 }
            },
            clipping_range: [0.1, 100.0],
        };
        let values = [
            (Quantity::Azimuth, [moves.0, 0.0, 0.0]),
            (Quantity::Elevation, [moves.1, 0.0, 0.0]),
            (Quantity::Roll, [moves.2, 0.0, 0.0]),
            (Quantity::Dolly, [factors.0, 0.0, 0.0]),
            (Quantity::Zoom, [factors.1, 0.0, 0.0]),
            (Quantity::Pan, [pan.0, pan.1, 0.0]),
        ];
        let track = |(quantity, value)| Track {
            target: Target::Camera,
            quantity,
            keys: vec![Key { frame: 0, value }],
        };
        scene.animation.tracks = values.map(track).into();
        let wanted = fixel_reference::camera_at(&scene, 0);
        let baked = bake(&scene).unwrap_or_else(|e| panic!("{e}"));
        let core = baked.scene().expect("baked a moment ago");
        let unit = f64::from(core.world_exponent()).exp2();
        let centre = centre(&core);
        let camera = core.pose(0).camera;
        let place = |v: fixel::math::Vec3| DVec3::from(v.to_bits().map(f64::from)) / 65536.0;
        for (what, found, wanted) in [
            ("eye", camera.position, wanted.position),
            ("focus", camera.focal_point, wanted.focal_point),
        ] {
            let off = place(found).distance((DVec3::from(wanted) - centre) * unit);
            prop_assert!(off < CLOSE + 4.0 * ANGLE * REACH, "{}: {} units off", what, off);
        }
        let off = place(camera.view_up).normalize().distance(DVec3::from(wanted.view_up).normalize());
        prop_assert!(off < 4.0 * ANGLE, "up is off by {}", off);
        let (found, wanted) = match (camera.projection, wanted.projection) {
            (
                fixel::scene::Projection::Perspective { tan_half_angle },
                Projection::Perspective { view_angle },
            ) => (tan_half_angle.to_num::<f64>(), (view_angle.to_radians() / 2.0).tan()),
            (
                fixel::scene::Projection::Parallel { half_height },
                Projection::Parallel { parallel_scale },
            ) => (half_height.to_num::<f64>(), parallel_scale * unit),
            _ => panic!("another projection"),
        };
        prop_assert!((found / wanted - 1.0).abs() < 1e-5, "{} is not {}", found, wanted);
    }
}

#[test]
fn what_turns_in_an_uneven_space_is_refused() {
    let mut scene = family(vec![Actor::default(), Actor::default()], &[2, 0]);
    scene.actors[0].scale = [1.0, 2.0, 1.0];
    scene.actors[1].name = "hand".into();
    scene.animation.tracks = vec![Track {
        target: Target::Actor(1),
        quantity: Quantity::Orientation,
        keys: vec![Key {
            frame: 0,
            value: [0.0; 3],
        }],
    }];
    let error = bake(&scene).expect_err("refused").to_string();
    assert!(error.starts_with("actor `hand` turns"), "{error}");
    scene.actors[0].scale = [2.0; 3];
    assert!(bake(&scene).is_ok());
}

#[test]
fn a_long_chain_of_parents_is_refused() {
    let chain = |length: usize| {
        let parents: Vec<usize> = (0..length).map(|i| i.wrapping_sub(1)).collect();
        bake(&family(vec![Actor::default(); length], &parents))
    };
    assert!(chain(17).is_ok());
    let error = chain(18).expect_err("refused").to_string();
    assert_eq!(error, "17 parents above an actor; expected at most 16");
}

/// The picture stays, index by index, while the colours of its lamps go round.
#[test]
fn a_palette_goes_round() {
    let scene = load(&root().join("scenes/palette_cycle.toml")).unwrap_or_else(|e| panic!("{e}"));
    let baked = bake(&scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let at = |frame| {
        let options = fixel_host::Options {
            frame,
            ..fixel_host::Options::of(&core)
        };
        let index = fixel_host::render(&core, &options).index;
        (index, fixel_host::colours(&core, frame))
    };
    let (index, colours) = at(0);
    for (frame, shift) in [(1, 0), (2, 1), (23, 11), (24, 0), (31, 3)] {
        let (same, moved) = at(frame);
        assert!(same == index, "frame {frame}");
        for (entry, moved) in moved.iter().enumerate() {
            let source = if entry < 12 {
                (entry + shift) % 12
            } else {
                entry
            };
            assert_eq!(*moved, colours[source], "frame {frame}, entry {entry}");
        }
    }
    // All lamps have colours of their own, which are the first ones.
    assert!((0..12).all(|entry| index.contains(&entry)));
    let unbaked = fixel_bake::unbake(&core);
    assert_eq!(unbaked.animation, scene.animation);
}
