//! Light levels against f64, for each of the three ways that a normal is stored.

use fixel::math::{Angle, Rotation};
use fixel::scene::Material;
use fixel::view::{ModelLights, round_level};
use fixel_scene::{Light, LightKind};
use fixel_tests::{load, root};
use proptest::prelude::*;

type V = [f64; 3];

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: V) -> V {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

/// The direction of an octahedral normal: `u` and `v` of `one`.
fn octahedral(u: f64, v: f64, one: f64) -> V {
    let z = one - u.abs() - v.abs();
    let fold = (-z).max(0.0);
    let toward_zero = |c: f64| if c >= 0.0 { c - fold } else { c + fold };
    unit([toward_zero(u), toward_zero(v), z])
}

/// The direction turned about y, x and z.
fn turned(v: V, orientation: [Angle; 3]) -> V {
    let turn = |v: V, i: usize, j: usize, angle: Angle| {
        let angle = f64::from(angle.to_bits()) / 2f64.powi(32) * std::f64::consts::TAU;
        let (sin, cos) = angle.sin_cos();
        let mut out = v;
        out[i] = cos * v[i] - sin * v[j];
        out[j] = sin * v[i] + cos * v[j];
        out
    };
    let [x, y, z] = orientation;
    turn(turn(turn(v, 2, 0, y), 1, 2, x), 0, 1, z)
}

fn lights() -> impl Strategy<Value = Vec<Light>> {
    let direction =
        prop::array::uniform3(-1.0..1.0f64).prop_filter("some direction", |d| dot(*d, *d) > 1e-3);
    let intensity = prop_oneof![0.0..1.5f64, 0.0..32.0f64, Just(32.0)];
    let light = (direction, intensity).prop_map(|(direction, intensity)| Light {
        kind: LightKind::Directional { direction },
        colour: [1.0; 3],
        intensity,
        edges: None,
    });
    prop::collection::vec(light, 0..=8)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn levels_are_the_sum_of_what_the_lights_give(
        lights in lights(),
        ambient in 0u16..=255 << 6,
        diffuse in 0u32..=1 << 16,
        orientation in any::<[u32; 3]>(),
        codes in prop::collection::vec((any::<[i8; 2]>(), any::<u8>(), prop::array::uniform3(-1.0..1.0f64)), 500),
    ) {
        let (mut description, _) = load(&root().join("tests/data/small.toml"));
        description.lights = lights.clone();
        let baked = fixel_bake::bake(&description).expect("eight lights at most");
        let scene = baked.scene().expect("baked a moment ago");
        let material = Material { ambient, diffuse, ..scene.material(0) };
        let orientation = orientation.map(Angle::from_bits);
        let rotation = Rotation::from_orientation(orientation);
        let model = ModelLights::new(&scene, &material, &rotation);

        // As the blob has them, so that only the arithmetic is measured.
        let exact = |normal: V| {
            let normal = turned(normal, orientation);
            let sum: f64 = scene
                .lights()
                .map(|light| {
                    let towards = light.towards.map(|c| f64::from(c) / 2f64.powi(30));
                    let strength = f64::from(light.colour[0]) / 65536.0 * f64::from(diffuse) / 65536.0;
                    dot(normal, towards).max(0.0) * strength * 255.0
                })
                .sum();
            (f64::from(ambient) / 64.0 + sum, sum)
        };
        let check = |what: &str, got: f64, normal: V| {
            let (exact, sum) = exact(normal);
            let want = exact.min(255.0);
            // Of each light, in 64ths: what is cut off its x, y and z, with a normal of length
            // 1 sqrt(3) at most; off their product, a unit of which is 32 over the length of an
            // octahedral normal, which is 127 / sqrt(3) at least (of a face's: 1/4); and off the
            // level. One over a normal's length is good to 2^-12.
            let cut = 3f64.sqrt() + 32.0 * 3f64.sqrt() / 127.0 + 1.0;
            let most = cut * lights.len() as f64 / 64.0 + sum.min(255.0) / 4096.0;
            prop_assert!((got - want).abs() <= most, "{}: {} instead of {}, {} allowed", what, got, want, most);
            Ok(())
        };
        for (code, low, direction) in codes {
            let [u, v] = code.map(|c| c.max(-127));
            if i32::from(u).abs() <= 127 && i32::from(v).abs() <= 127 {
                let got = model.level([u, v]).to_num::<f64>();
                check("octahedral", got, octahedral(u.into(), v.into(), 127.0))?;
                let [fu, fv] = [(u, low & 15), (v, low >> 4)].map(|(c, low)| f64::from(i32::from(c) * 16 + i32::from(low)));
                if fu.abs() <= 2032.0 && fv.abs() <= 2032.0 {
                    let got = model.fine_level([u, v], low).to_num::<f64>();
                    check("fine", got, octahedral(fu, fv, 2032.0))?;
                }
            }
            if dot(direction, direction) > 0.01 {
                let [x, y, z] = unit(direction).map(|c| (c * 511.0).round() as i32);
                let code = (x & 1023 | (y & 1023) << 10 | (z & 1023) << 20) as u32;
                let got = model.face_level(code).to_num::<f64>();
                // Not of length 1: up to half a 511th off in each component.
                let normal = [x, y, z].map(|c| f64::from(c) / 511.0);
                check("face", got, normal)?;
            }
        }
    }
}

#[test]
fn levels_round_to_the_nearest() {
    let level = |bits: u16| round_level(fixel::math::FineLevel::from_bits(bits));
    assert_eq!(level(0), 0);
    assert_eq!(level(31), 0);
    assert_eq!(level(32), 1);
    assert_eq!(level(254 * 64 + 32), 255);
    assert_eq!(level(255 * 64), 255);
}
