//! Coverage after clipping: a floor that reaches from behind the eye to the
//! distance and far beyond both sides, cut into triangles in several ways, hits
//! each of its pixels once.

use fixel::Band;
use fixel::clip::clip;
use fixel::math::SubPx;
use fixel::raster::{Fill, Sides, draw_triangle};
use fixel::vertex::ClipVertex;
use fixel::view::{ActorView, ViewFrame};

const SIZE: (u16, u16) = (24, 16);

fn view() -> ActorView {
    let (_, baked) = fixel_tests::load(&fixel_tests::root().join("tests/data/small.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let pose = scene.pose(0);
    let frame = ViewFrame::new(&pose.camera, SIZE.0, SIZE.1);
    let actor = scene.actor(0);
    let mut view = ActorView::new(&frame, &scene, &actor, &pose.place(&scene, 0, &actor));
    // Room for places up to four times as far as the near plane.
    view.near /= 8;
    view.far = view.near * 4;
    view
}

/// A place in units of the near plane's distance: `side` and `down` in half
/// screen heights at distance 1.
fn place(view: &ActorView, side: f64, down: f64, distance: f64) -> ClipVertex {
    let near = f64::from(view.near);
    // x / distance * 2^exponent sub-pixels.
    let half = f64::from(SIZE.1) / 2.0 * f64::from(SubPx::ONE.to_bits());
    let lens = half / f64::from(view.lens.exponent).exp2() * near;
    ClipVertex {
        x: (side * lens) as i32,
        y: (down * lens) as i32,
        distance: (distance * near) as i32,
        level: 0,
    }
}

/// Hit counts as a drawing.
fn coverage(view: &ActorView, triangles: &[[ClipVertex; 3]]) -> Vec<String> {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    let mut counts = vec![0u8; pixels];
    for triangle in triangles {
        let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
        let mut band = Band::new(SIZE.0, &mut indices, &mut depths).expect("a band");
        let polygon = clip(view, *triangle);
        let Some((first, rest)) = polygon.vertices().split_first() else {
            continue;
        };
        for pair in rest.windows(2) {
            // Each part alone, so that two hits of one triangle count as two.
            let mut target = band.target(0, SIZE.1);
            target.clear(|_| 0);
            let sides = Sides {
                front: true,
                back: true,
            };
            draw_triangle(
                &mut target,
                [first, &pair[0], &pair[1]],
                sides,
                true,
                || Fill::Flat(1),
            );
            for (count, depth) in counts.iter_mut().zip(&*target.depths) {
                *count += u8::from(*depth != 0);
            }
        }
    }
    let digits = |row: &[u8]| row.iter().map(|n| char::from(b'0' + n)).collect();
    counts.chunks(SIZE.0.into()).map(digits).collect()
}

#[test]
fn a_floor_from_behind_the_eye_to_the_distance() {
    let view = view();
    let at = |side: f64, distance: f64| place(&view, side, 1.0, distance);
    let (a, b, c, d) = (
        at(-60.0, -3.0),
        at(60.0, -3.0),
        at(60.0, 2.9),
        at(-60.0, 2.9),
    );
    // Its far edge is 1 / 2.9 of the way down from the middle: 2.76 rows, so that
    // the fourth row below the middle is the first. At the near plane, 1 of the
    // way, it reaches the bottom.
    let wanted: Vec<String> = (0..16)
        .map(|row| {
            if row >= 11 {
                "1".repeat(24)
            } else {
                "0".repeat(24)
            }
        })
        .collect();
    assert_eq!(coverage(&view, &[[a, b, c], [a, c, d]]), wanted);
    assert_eq!(coverage(&view, &[[d, c, b], [a, d, b]]), wanted);
    // Cut at a point that lies behind the eye, and at one before it.
    for middle in [at(3.0, -1.0), at(-0.3, 1.7), at(0.0, 0.5)] {
        let fan = [
            [a, b, middle],
            [b, c, middle],
            [c, d, middle],
            [d, a, middle],
        ];
        assert_eq!(coverage(&view, &fan), wanted);
    }
}

#[test]
fn behind_the_eye_there_is_nothing() {
    let view = view();
    let at = |side: f64, distance: f64| place(&view, side, 1.0, distance);
    let behind = [at(-9.0, -0.5), at(9.0, -0.5), at(0.0, -9.0)];
    assert!(
        coverage(&view, &[behind])
            .iter()
            .all(|row| !row.contains('1'))
    );
    let before_near = [at(-9.0, 0.2), at(9.0, 0.2), at(0.0, 0.99)];
    assert!(
        coverage(&view, &[before_near])
            .iter()
            .all(|row| !row.contains('1'))
    );
}
