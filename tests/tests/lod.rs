//! Level of detail: how far levels are seen off their mesh, and when they are taken.

use fixel::math::Vec3;
use fixel::scene::{Field, SceneError, Section, checksum, layout};
use fixel_bake::{Baked, bake};
use fixel_host::{Options, frame, levels};
use fixel_reference::{Report, Truth};
use fixel_scene::{Lod, Projection, Scene};
use fixel_tests::root;
use glam::DVec3;

fn load(name: &str) -> Scene {
    let path = root().join(format!("scenes/{name}.toml"));
    fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"))
}

/// The bunny alone, `distance` in front of the eye, in a picture of 160x120.
fn bunny(distance: f64, error: f64) -> Scene {
    let mut scene = load("bunny");
    scene.lod = Some(Lod { error });
    (scene.display.width, scene.display.height) = (160, 120);
    scene.camera.position = [0.0, 0.0, distance];
    scene.camera.focal_point = [0.0; 3];
    scene.camera.clipping_range = [1.0, 1000.0];
    scene
}

/// The levels that a blob's actors are drawn with in its own first picture.
fn shown(blob: &fixel::Scene<'_>) -> Vec<Vec<u32>> {
    levels(blob, &blob.pose(0), (blob.width(), blob.height()))
}

/// A picture with coverage apart: what is seen, and what should be.
fn compared(scene: &Scene) -> (Vec<bool>, Truth, Report) {
    let baked = bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let (drawn, _) = frame(&baked, &core, &Options::of(&core));
    let at = fixel_reference::Options {
        width: drawn.width,
        height: drawn.height,
        frame: 0,
    };
    let truth = fixel_reference::render(scene, at);
    let report = fixel_reference::compare(&truth, &drawn).unwrap_or_else(|e| panic!("{e}"));
    (
        drawn.actor.iter().map(|id| *id != 0).collect(),
        truth,
        report,
    )
}

/// Places that differ lie within a pixel of the outline if a level is off by a pixel at most.
#[test]
fn coverage_differs_within_the_bound_of_the_outline_alone() {
    for distance in [20.0, 40.0, 80.0, 160.0] {
        let (drawn, truth, report) = compared(&bunny(distance, 1.0));
        let covered: Vec<bool> = truth.pixels().iter().map(Option::is_some).collect();
        let width = truth.width() as usize;
        for i in (0..drawn.len()).filter(|i| drawn[*i] != covered[*i]) {
            // A pixel's centre that is less than a pixel from the outline has another kind of
            // pixel beside it.
            let beside = [i - 1, i + 1, i - width, i + width];
            let corners = [i - width - 1, i - width + 1, i + width - 1, i + width + 1];
            let mut around = beside.into_iter().chain(corners);
            assert!(
                around.any(|at| covered[at] != covered[i]),
                "{distance}: pixel {i} is in the middle of what is alike"
            );
        }
        let outline = (0..covered.len()).filter(|i| covered[*i]);
        let outline = outline
            .filter(|i| !(covered[i - 1] && covered[i + 1]))
            .count();
        let differ = report.coverage_mismatch_px;
        assert!(differ * 4 <= outline, "{distance}: {differ} of {outline}");
    }
}

/// What the core takes is never seen farther off than was asked for, as an f64 calculation
/// has it from the vertices, and it is not far more careful than that.
#[test]
fn from_farther_away_levels_are_coarser_and_within_the_bound() {
    let error = 0.5;
    let scene = bunny(400.0, error);
    let baked = bake(&scene).unwrap_or_else(|e| panic!("{e}"));
    let blob = baked.scene().expect("baked a moment ago");
    let actor = blob.actor(0);
    let (first, count) = blob.mesh(actor.mesh).levels;
    assert!(count >= 4, "{count} levels");
    let step = f64::from(actor.step_mantissa)
        * f64::exp2(f64::from(
            actor.step_exponent - 31 - i32::from(blob.world_exponent()),
        ));
    let off = |level: u32| match level.checked_sub(1) {
        Some(at) => f64::from(blob.mesh(first + at as u16).error) * step,
        None => 0.0,
    };
    let Projection::Perspective { view_angle } = scene.camera.projection else {
        panic!("the bunny is seen in perspective");
    };
    let half_angle = (view_angle / 2.0).to_radians().tan();
    let pixel = 2.0 * half_angle / 120.0;
    // The nearest vertex, turned and moved as the actor is.
    let placed = |p: &[f64; 3]| {
        let [x, _, _] = scene.actors[0].orientation.map(f64::to_radians);
        let turn = glam::DMat3::from_rotation_x(x);
        let origin = DVec3::from(scene.actors[0].origin);
        (turn * (DVec3::from(*p) - origin) + origin + DVec3::from(scene.actors[0].position)).z
    };
    let nearest = scene.meshes[0].positions.iter().map(placed);
    let nearest = nearest.fold(f64::NEG_INFINITY, f64::max);
    let mut before = 0;
    let mut seen = Vec::new();
    let mut pose = blob.pose(0);
    for distance in (12..400).step_by(2) {
        pose.camera.position = blob.world(Vec3::from_bits([0, 0, distance << 16]));
        let level = levels(&blob, &pose, (160, 120))[0][0];
        assert!(level >= before, "{distance}: {level} after {before}");
        let size = (f64::from(distance) - nearest) * pixel;
        let found = off(level) / size;
        assert!(found <= error, "{distance}: {found} pixels");
        if level < u32::from(count) {
            let next = off(level + 1) / size;
            assert!(next > error * 0.55, "{distance}: {next} pixels would do");
        }
        seen.push(level);
        before = level;
    }
    assert_eq!((seen[0], before), (0, count.into()));
}

#[test]
fn without_the_table_and_close_by_there_is_nothing_coarser() {
    let mut scene = bunny(12.0, 0.01);
    let baked = bake(&scene).unwrap_or_else(|e| panic!("{e}"));
    let blob = baked.scene().expect("baked a moment ago");
    assert_eq!(shown(&blob), [[0]]);
    scene.lod = None;
    let baked = bake(&scene).unwrap_or_else(|e| panic!("{e}"));
    let blob = baked.scene().expect("baked a moment ago");
    assert_eq!((blob.mesh_count(), blob.mesh(0).levels), (1, (0, 0)));
}

/// In two samples a pixel, a pixel of the picture is what counts; parallel views have one
/// size for all distances.
#[test]
fn the_bound_is_one_of_pixels_of_the_picture() {
    let level = |change: fn(&mut Scene)| {
        let mut scene = bunny(60.0, 0.5);
        change(&mut scene);
        let baked = bake(&scene).unwrap_or_else(|e| panic!("{e}"));
        let blob = baked.scene().expect("baked a moment ago");
        shown(&blob)[0][0]
    };
    let plain = level(|_| {});
    assert!(plain > 0);
    assert_eq!(level(|scene| scene.display.samples = [2, 2]), plain);
    let near = level(|scene| {
        scene.camera.projection = Projection::Parallel {
            parallel_scale: 60.0,
        };
    });
    let far = level(|scene| {
        scene.camera.projection = Projection::Parallel {
            parallel_scale: 60.0,
        };
        scene.camera.position[2] = 600.0;
    });
    assert!(near > 0 && near == far, "{near} {far}");
}

#[test]
fn a_level_that_is_not_there_is_refused() {
    let baked = bake(&bunny(60.0, 0.5)).unwrap_or_else(|e| panic!("{e}"));
    let section = Section::ALL.iter().position(|s| *s == Section::Meshes);
    let table = layout::HEADER_WORDS + 2 * section.expect("all sections are listed");
    let word = |bytes: &[u8], at: usize| {
        let b = &bytes[4 * at..4 * at + 4];
        u32::from_le_bytes([b[0], b[1], b[2], b[3]])
    };
    let meshes = word(baked.bytes(), table) as usize;
    let changed = |at: usize, to: u8| {
        let mut bytes = baked.bytes().to_vec();
        bytes[meshes + at] = to;
        let words: Vec<u32> = (0..bytes.len() / 4).map(|i| word(&bytes, i)).collect();
        let sum = checksum(&words[layout::CHECKED_FROM / 4..]);
        bytes[12..16].copy_from_slice(&sum.to_le_bytes());
        Baked::from_bytes(&bytes).map(|_| ())
    };
    // The first level's number; how many there are; what the first level has.
    for (at, to) in [(14, 200), (39, 200), (40 + 12, 15)] {
        match changed(at, to) {
            Err(SceneError::Record { section, field, .. }) => {
                assert_eq!((section, field), (Section::Meshes, Field::Level), "{at}");
            }
            other => panic!("{at}: {other:?}"),
        }
    }
}
