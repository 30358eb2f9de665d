use super::*;
use crate::math::{Rect, Vec3, World};
use crate::scene::{Camera, Projection};
use fixed::types::U8F24;

fn camera(projection: Projection) -> Camera {
    Camera {
        position: Vec3::from_ints(0, 0, 0),
        focal_point: Vec3::from_ints(0, 0, -1),
        view_up: Vec3::from_ints(0, 1, 0),
        projection,
        near: World::from_num(0.5),
        far: World::from_num(100),
        range_exponent: 0,
    }
}

const PERSPECTIVE: Projection = Projection::Perspective {
    tan_half_angle: U8F24::ONE,
};

/// Distances 1, 2, .. 31.
fn distances() -> [i32; STEPS] {
    core::array::from_fn(|i| (i as i32 + 1) << 16)
}

#[test]
fn rows_begin_at_their_distances() {
    let parallel = Projection::Parallel {
        half_height: World::from_num(1),
    };
    for (projection, perspective) in [(PERSPECTIVE, true), (parallel, false)] {
        let view = ViewFrame::new(&camera(projection), 64, 64);
        let depths = FogDepths::new(&view, &distances());
        for tenths in 6..400 {
            let w = f64::from(tenths) / 10.0;
            let exact = if perspective {
                0.5 / w
            } else {
                (100.0 - w) / 99.5
            } * 65535.0;
            let depth = (exact + 0.5) as Depth;
            let wanted = (tenths / 10).min(31) as usize;
            for from in [0, 7, 31] {
                let row = depths.row(depth, from);
                // On the distance itself either row will do.
                let near_step = tenths % 10 == 0;
                assert!(
                    row == wanted || near_step && row + 1 == wanted,
                    "{w}: {row}"
                );
                let (least, end) = depths.range(row);
                assert!((least..end).contains(&u32::from(depth)));
            }
        }
    }
}

#[test]
fn what_is_drawn_within_the_part_is_fogged_and_nothing_else() {
    let view = ViewFrame::new(&camera(PERSPECTIVE), 4, 2);
    let depths = FogDepths::new(&view, &distances());
    // Row r adds r to an index.
    let table: [[u8; 256]; FOG_ROWS] =
        core::array::from_fn(|r| core::array::from_fn(|i| (i + r) as u8));
    let at = |w: f64| (0.5 / w * 65535.0) as Depth;
    let row = [at(0.6), at(1.5), 0, at(99.0), at(2.5), at(0.6)];
    let mut buffer = [10u8; 12];
    let mut depth_buffer = [row, row].concat();
    let mut band = crate::Band::new(6, &mut buffer, &mut depth_buffer).unwrap();
    let part = Rect {
        left: 1,
        top: 1,
        right: 5,
        bottom: 2,
    };
    apply(&mut band.target(0, 2).part(&part), &table, &depths);
    assert_eq!(buffer, [10, 10, 10, 10, 10, 10, 10, 11, 10, 41, 12, 10]);
}
