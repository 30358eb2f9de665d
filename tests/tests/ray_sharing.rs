//! What rays share (beams of tiles, windows of triangles, lists of actors, what a coarse
//! pass found) changes how long a frame takes, and not a byte of it.

use std::convert::Infallible;

use fixel::display::Display;
use fixel::frame::BandRows;
use fixel::palette::Palette;
use fixel::ray::{KeptPixel, RayScratch, RayStats, render_frame, render_progressively};
use fixel::{Band, Scene};
use fixel_scene::{Aspect, Cull, Material, Projection, Shading, Viewport};
use fixel_tests::made::{Random, add, ball, empty, far_light, lamp, mesh, rectangle};
use fixel_tests::{load_for_rays, root};

/// Each frame's palette indices and depths.
#[derive(Default)]
struct Frames(Vec<(Vec<u8>, Vec<u16>)>);

impl Display for Frames {
    type Error = Infallible;

    fn begin(&mut self, _: &Palette<'_>) -> Result<(), Infallible> {
        self.0.push(Default::default());
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        let (indices, depths) = self.0.last_mut().expect("a frame begins first");
        indices.extend(rows.indices);
        depths.extend(rows.depths);
        Ok(())
    }
}

fn draw<const ACTORS: usize>(
    scene: &Scene<'_>,
    rows: u16,
    kept: Option<&mut [KeptPixel]>,
) -> (Frames, RayStats) {
    let width = scene.frame_width();
    let pixels = usize::from(width) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(width, &mut indices, &mut depths).expect("one row at least");
    let mut scratch = Box::new(RayScratch::<ACTORS>::new());
    let (work, frames) = (&mut scratch.workspace(), &mut Frames::default());
    let pose = scene.pose(3);
    let Ok(stats) = match kept {
        None => render_frame(scene, &pose, work, &mut band, frames),
        Some(kept) => render_progressively(scene, &pose, work, &mut band, frames, kept),
    };
    (std::mem::take(frames), stats)
}

/// Meshes, balls and rectangles anywhere, of any material, in light of both kinds.
fn anything(seed: u64) -> fixel_scene::Scene {
    let mut scene = empty();
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let plain = Material {
        ambient: 0.1,
        shading: Shading::Phong,
        ..Material::default()
    };
    scene.materials = vec![
        plain.clone(),
        Material {
            name: "hollow".into(),
            cull: [Cull::None, Cull::Front][seed as usize % 2],
            shading: Shading::Flat,
            ..plain.clone()
        },
        Material {
            name: "mirror".into(),
            reflectivity: 0.7,
            ..plain.clone()
        },
        Material {
            name: "glass".into(),
            opacity: 0.2,
            refractive_index: 1.4,
            ..plain
        },
    ];
    let names = ["sphere", "cube", "teapot", "bunny"];
    for n in 0..7 {
        let size = random.between(0.2, 1.2);
        let shape = match n {
            0 => rectangle(6.0, 4.0),
            1 => ball(0.8),
            _ => mesh(names[(random.next() * 4.0) as usize]),
        };
        let extent = shape
            .positions
            .iter()
            .flatten()
            .fold(0.0_f64, |m, c| m.max(c.abs()));
        let position = random.place(-2.0, 2.0);
        let actor = add(&mut scene, shape, position);
        actor.scale = [2.0 * size / extent; 3];
        actor.orientation = random.place(-180.0, 180.0);
        actor.material = (random.next() * 5.0) as usize % 4;
    }
    scene.camera.position = [random.between(-3.0, 3.0), random.between(-3.0, 3.0), 9.0];
    scene.camera.focal_point = [0.0; 3];
    scene.camera.clipping_range = [0.5, 40.0];
    if seed % 4 == 3 {
        scene.camera.projection = Projection::Parallel {
            parallel_scale: 3.0,
        };
    }
    scene.lights = vec![far_light([0.7, -1.0, -0.4]), lamp([-4.0, 7.0, 6.0])];
    (scene.display.width, scene.display.height) = (90, 67);
    scene
}

#[test]
fn rays_that_share_are_rays_by_themselves() {
    for seed in 1..=12 {
        let scene = anything(seed);
        let baked = fixel_bake::bake_for_rays(&scene).unwrap_or_else(|e| panic!("{e}"));
        let core = baked.scene().expect("baked a moment ago");
        let (shared, _) = draw::<64>(&core, core.frame_height(), None);
        let seen = shared.0[0].1.iter().filter(|depth| **depth != 0).count();
        assert!(seen > 500, "{seen} pixels of scene {seed} show something");
        // Of tiles of one row, with other windows; and with room for too few actors to
        // list them, ray by ray.
        for (how, (other, _)) in [
            ("in bands of a row", draw::<64>(&core, 1, None)),
            ("in bands of 7", draw::<64>(&core, 7, None)),
            ("ray by ray", draw::<1>(&core, core.frame_height(), None)),
            // Slots are shared, and where all are is known.
            ("with three slots", draw::<3>(&core, 16, None)),
        ] {
            assert!(shared.0 == other.0, "scene {seed} {how}");
        }
    }
}

/// More actors than there are slots, more than have a bit each, and more than are known: a
/// mirror and a lamp, from two cameras.
#[test]
fn actors_without_slots_are_met() {
    let mut scene = empty();
    scene.materials = vec![
        Material {
            shading: Shading::Flat,
            ..Material::default()
        },
        Material {
            name: "mirror".into(),
            reflectivity: 0.8,
            ..Material::default()
        },
    ];
    let mirror = add(&mut scene, rectangle(12.0, 12.0), [0.0, 0.0, -1.5]);
    (mirror.material, mirror.orientation) = (1, [90.0, 0.0, 0.0]);
    for number in 0..45 {
        let (column, row) = (f64::from(number % 9), f64::from(number / 9));
        let actor = add(&mut scene, mesh("cube"), [column - 4.0, row - 2.0, 0.0]);
        actor.scale = [0.3; 3];
        actor.orientation = [f64::from(number) * 7.0, 30.0, 0.0];
    }
    scene.camera.position = [1.0, 2.0, 11.0];
    scene.camera.focal_point = [0.0; 3];
    scene.camera.clipping_range = [0.5, 60.0];
    scene.lights = vec![far_light([0.4, -0.6, -1.0]), lamp([-3.0, 4.0, 5.0])];
    (scene.display.width, scene.display.height) = (96, 72);
    let mut beside = scene.camera;
    beside.position = [-6.0, 1.0, 9.0];
    let half = |left: f64, camera| Viewport {
        rectangle: [left, 0.0, 0.5, 1.0],
        camera,
        background: None,
        aspect: Aspect::Keep,
    };
    scene.viewports = vec![half(0.0, None), half(0.5, Some(beside))];
    let baked = fixel_bake::bake_for_rays(&scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let (all, _) = draw::<64>(&core, core.frame_height(), None);
    let seen = all.0[0].1.iter().filter(|depth| **depth != 0).count();
    assert!(seen > 2000, "{seen} pixels show something");
    for (how, (other, _)) in [
        ("with 7 slots, 42 known", draw::<7>(&core, 8, None)),
        ("with 8 slots, all known", draw::<8>(&core, 11, None)),
        ("with a slot, 6 known", draw::<1>(&core, 72, None)),
    ] {
        assert!(all.0 == other.0, "{how}");
    }
}

#[test]
fn the_last_of_several_passes_is_the_frame() {
    for path in [
        "scenes/ray/whitted.toml",
        "scenes/ray/bunny_shadow.toml",
        "scenes/viewport_cameras.toml",
        "scenes/fog_linear.toml",
        "scenes/stereo_side_by_side.toml",
        "scenes/parallel.toml",
        "scenes/antialiased.toml",
    ] {
        let (_, baked) = load_for_rays(&root().join(path));
        let scene = baked.scene().expect("baked a moment ago");
        let (width, height) = (scene.frame_width(), scene.frame_height());
        let smooth = scene.ray_settings().samples > 1;
        let (plain, once) = draw::<64>(&scene, 20, None);
        let blocks =
            |size: u16| usize::from(width.div_ceil(size)) * usize::from(height.div_ceil(size));
        for (room, passes) in [
            (0, 1),
            (blocks(8) - 1, 1),
            (blocks(8), 2),
            (blocks(4), 3),
            (blocks(2), 4),
        ] {
            let mut kept = vec![KeptPixel::default(); room];
            let (frames, stats) = draw::<64>(&scene, 20, Some(&mut kept));
            assert_eq!(frames.0.len(), passes, "{path} with room for {room}");
            assert!(
                frames.0.last() == plain.0.last(),
                "{path} with room for {room}"
            );
            if !smooth {
                assert_eq!(stats.rays, once.rays, "{path} with room for {room}");
            }
        }
    }
}

/// Each block of the first pass shows its first pixel.
#[test]
fn a_first_pass_shows_blocks() {
    let (_, baked) = load_for_rays(&root().join("scenes/bench/r2_bunny_shadow.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let width = usize::from(scene.frame_width());
    let (plain, _) = draw::<64>(&scene, scene.frame_height(), None);
    let mut kept = vec![KeptPixel::default(); 1200];
    let (frames, _) = draw::<64>(&scene, 12, Some(&mut kept));
    let ((plain, _), (first, _)) = (&plain.0[0], &frames.0[0]);
    for (at, index) in first.iter().enumerate() {
        let (x, y) = (at % width, at / width);
        assert_eq!(
            *index,
            plain[(y & !7) * width + (x & !7)],
            "column {x}, row {y}"
        );
    }
}
