//! Calls of the core's public functions with whatever their arguments' types allow.

use std::sync::LazyLock;

use fixel::immediate::{Immediate, Pen};
use fixel::math::{Angle, Factor, SubPx, Vec3, World};
use fixel::render::Bands;
use fixel::scene::{Camera, Placement, Pose, Projection};
use fixel::view::{DisplayPoint, ViewFrame};
use fixel::{Band, Scene, Scratch};
use fixel_bake::Baked;

use super::numbers::Numbers;

static SCENES: LazyLock<Vec<Baked>> = LazyLock::new(|| {
    let files = ["small", "moving", "lines", "panes"];
    let path = |name| crate::root().join(format!("tests/data/{name}.toml"));
    files.map(|name| crate::load(&path(name)).1).into()
});

/// Calls one of them after the other for as long as there are bytes.
pub fn calls(bytes: &[u8]) {
    let mut n = Numbers(bytes);
    let baked = n.below(SCENES.len());
    let scene = SCENES[baked].scene().expect("baked by us");
    frame(&mut n, &scene);
}

fn vector(n: &mut Numbers<'_>) -> Vec3 {
    Vec3::from_bits([0; 3].map(|_| n.extreme()))
}

fn camera(n: &mut Numbers<'_>, own: Camera) -> Camera {
    let mut camera = own;
    for _ in 0..n.below(6) {
        match n.below(12) {
            0 => camera.position = vector(n),
            1 => camera.focal_point = vector(n),
            2 => camera.view_up = vector(n),
            3 => camera.near = World::from_bits(n.extreme()),
            4 => camera.far = World::from_bits(n.extreme()),
            5 => {
                let tan_half_angle = Factor::from_bits(n.extreme() as u32);
                camera.projection = Projection::Perspective { tan_half_angle };
            }
            6 => {
                let half_height = World::from_bits(n.extreme());
                camera.projection = Projection::Parallel { half_height };
            }
            7 => camera.range_exponent = n.byte(),
            8 => camera.azimuth(Angle::from_bits(n.word())),
            9 => camera.elevation(Angle::from_bits(n.word())),
            10 => camera.zoom(Factor::from_bits(n.extreme() as u32)),
            _ => camera.pan(World::from_bits(n.extreme()), World::from_bits(n.extreme())),
        }
    }
    camera
}

fn frame(n: &mut Numbers<'_>, scene: &Scene<'_>) {
    let mut pose: Pose<'_> = scene.pose(n.extreme() as u32);
    pose.camera = camera(n, pose.camera);
    pose.height = n.extreme() as u16 % 40;
    pose.turn = Angle::from_bits(n.word());
    pose.palette_shift = n.word() as u16;
    let moved: Vec<(u16, Placement)> = (0..n.below(3))
        .map(|_| {
            let placement = Placement {
                position: vector(n),
                orientation: [0; 3].map(|_| Angle::from_bits(n.word())),
                scale: Factor::from_bits(n.extreme() as u32),
            };
            (u16::from(n.byte()) % 4, placement)
        })
        .collect();
    pose.moved = &moved;
    let width = 1 + n.byte() as u16 % 40;
    points(n, &pose, width);

    let pixels = usize::from(width) * (1 + n.below(9));
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(width, &mut indices, &mut depths).expect("a row at least");
    let mut scratch = Box::new(Scratch::<4, 2, 2>::new());
    let mut work = scratch.workspace();
    let mut immediate = Immediate::new(scene, &pose, u16::from(n.byte()) % 4, width);
    let mut bands = Bands::new(scene, &pose, &mut work, &mut band);
    let mut left = *n;
    while let Some(mut target) = bands.next_target() {
        let n = &mut Numbers(left.0);
        for _ in 0..n.below(5) {
            let pen = Pen {
                index: n.byte(),
                width: n.byte(),
                depth_test: n.byte() & 1 == 0,
                bias: n.extreme() as u16,
            };
            let (a, b, c) = (vector(n), vector(n), vector(n));
            match n.below(6) {
                0 => immediate.line(&mut target, [a, b], pen),
                1 => immediate.triangle(&mut target, [a, b, c]),
                2 => immediate.sphere(&mut target, a, b.x),
                3 => immediate.point(&mut target, a, n.byte(), pen),
                4 => immediate.set_material(n.extreme() as u16),
                _ => {
                    let levels = [(a, n.byte()), (b, n.byte()), (c, n.byte())];
                    immediate.ramp_triangle(&mut target, levels, immediate.ramp());
                }
            }
        }
        left = *n;
        left = Numbers(left.0);
    }
}

fn points(n: &mut Numbers<'_>, pose: &Pose<'_>, width: u16) {
    let view = ViewFrame::new(&pose.camera, width, pose.height.max(1));
    let place = vector(n);
    let _ = view.world_to_view(place);
    let _ = view.view_to_world(place);
    if let Some(ndc) = view.view_to_ndc(place) {
        let display = view.ndc_to_display(ndc);
        let _ = (view.display_to_ndc(display), view.ndc_to_view(ndc));
    }
    let _ = view.world_to_display(place);
    let [x, y] = [0; 2].map(|_| SubPx::from_bits(n.extreme()));
    let depth = fixed::types::I8F24::from_bits(n.extreme());
    let _ = view.display_to_world(DisplayPoint { x, y, depth });
    let _ = view.ray(x, y);
}
