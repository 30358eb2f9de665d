extern crate std;
use super::*;
use crate::ray::ray::FAR;

/// Xorshift; from -1 to 1.
fn next(state: &mut u64) -> f64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

#[test]
fn a_sphere_that_is_met_is_not_missed() {
    let mut state = 0x9e37_79b9_7f4a_7c15;
    let (mut met, mut missed) = (0, 0);
    for size in [3e2, 2e4, 1.3e6, 9e8] {
        for _ in 0..60_000 {
            let mut place = || [0; 3].map(|_| next(&mut state) * size);
            let (centre, origin, way, aside) = (place(), place(), place(), place());
            let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
            let way = way.map(|c| c / length);
            let radius = (next(&mut state).powi(2) * size * 0.3).max(1.0);
            let parts = centre.iter().zip(origin).zip(way);
            let middle: f64 = parts.clone().map(|((c, o), d)| (c - o) * d).sum();
            let off = parts.map(|((c, o), d)| (c - o - middle * d).powi(2));
            let beside = off.sum::<f64>().sqrt();
            let meets = beside < radius && middle > 0.0;
            let bits = |v: [f64; 3]| v.map(|c| c as i32);
            let unit = Unit::of((size * 1.2) as u32);
            let sphere = unit.sphere(bits(centre), radius.ceil() as i32);
            let ray = Ray {
                origin: bits(origin),
                direction: way.map(|c| (c * f64::from(1 << 30)) as i32),
                near: 0,
                far: FAR,
                on: 0,
            };
            // A ray beside it that is thick enough, half of the times.
            let length = aside.iter().map(|c| c * c).sum::<f64>().sqrt();
            let around = (next(&mut state) * size * 0.2).max(0.0);
            let by = aside.map(|c| c / length * around * 0.999);
            let beside = Ray {
                origin: bits([0, 1, 2].map(|axis| origin[axis] + by[axis])),
                ..ray
            };
            let coarse = unit.ray(&beside, around.ceil() as u32);
            let is_missed = coarse.is_some_and(|coarse| sphere.missed(&coarse));
            assert!(!(meets && is_missed), "{ray:?} {sphere:?}");
            met += u32::from(meets);
            missed += u32::from(is_missed);
        }
    }
    // It does tell most of them.
    assert!(met > 1000 && missed > 180_000, "{met} {missed}");
}

#[test]
fn far_rays_are_not_told() {
    let unit = Unit::of(100);
    for c in [i32::MIN, 1 << 15, i32::MAX] {
        let ray = Ray {
            origin: [c, 0, 0],
            direction: [1 << 30, 0, 0],
            near: 0,
            far: FAR,
            on: 0,
        };
        assert!(unit.ray(&ray, 0).is_none(), "{c}");
    }
}
