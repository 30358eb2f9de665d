//! Which copy of a texture pixels show, by their footprints: against each pixel's own by f64.

use fixel::raster::Footprint;
use fixel::scene::{Scene, Texture};
use fixel::shade::Sampler;
use fixel_bake::{Baked, bake};
use fixel_tests::root;
use proptest::prelude::*;
use std::sync::LazyLock;

static FLOOR: LazyLock<Baked> = LazyLock::new(|| {
    let path = root().join("scenes/textured_floor.toml");
    let scene = fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    bake(&scene).unwrap_or_else(|e| panic!("{e}"))
});

/// A texture with copies, and a sampler with places that are its mesh's attributes times a number.
fn sampler<'a>(scene: &Scene<'a>) -> (Sampler<'a>, Texture, [f64; 2]) {
    let actors = (0..scene.actor_count()).map(|number| scene.actor(number));
    let (texture, coordinates) = actors
        .filter_map(|actor| {
            let texture = scene.texture(scene.material(actor.material).texture?)?;
            Some((texture, scene.mesh(actor.mesh).coordinates?))
        })
        .find(|(texture, _)| texture.copies > 2)
        .expect("a texture with copies");
    let sampler = Sampler::new(scene, texture, coordinates);
    // Texels, 16 fractional bits, to attributes.
    let attributes = sampler.attributes([1; 2]).map(f64::from);
    let times = std::array::from_fn(|axis| {
        let texels =
            f64::exp2(16.0 + f64::from(texture.size[axis]) - f64::from(coordinates.exponent));
        texels / attributes[axis]
    });
    (sampler, texture, times)
}

/// The most texels, 16 fractional bits, that a pixel goes along an axis.
fn most(footprint: &Footprint, step: &Footprint, pixel: i32, times: [f64; 2]) -> f64 {
    let along = |at: [i32; 2], step: [i32; 2]| {
        let axis = |i: usize| (f64::from(at[i]) + f64::from(step[i]) * f64::from(pixel)) * times[i];
        axis(0).abs().max(axis(1).abs())
    };
    along(footprint.across, step.across).max(along(footprint.down, step.down))
}

fn footprints(most: i32) -> impl Strategy<Value = Footprint> {
    prop::array::uniform4(-most..=most).prop_map(|[a, b, c, d]| Footprint {
        across: [a, b],
        down: [c, d],
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4_000))]

    #[test]
    fn pixels_that_are_alike_show_one_copy(
        footprint in prop_oneof![footprints(1 << 17), footprints(1 << 19)],
        step in prop_oneof![footprints(40), footprints(3_000)],
        pixels in 1..480_usize,
    ) {
        let scene = FLOOR.scene().unwrap();
        let (sampler, texture, times) = sampler(&scene);
        let copy = |pixel: usize| {
            let texels = most(&footprint, &step, pixel as i32, times) / 65536.0;
            let copy = (texels.max(1e-6).log2() + 0.5).floor();
            copy.clamp(0.0, f64::from(texture.copies - 1)) as usize
        };
        let (number, count) = sampler.alike(&footprint, &step, pixels);
        prop_assert!((1..=pixels).contains(&count), "{count} of {pixels}");
        for pixel in 0..count {
            prop_assert_eq!(copy(pixel), number, "pixel {} of {}", pixel, count);
        }
        // All of them, where nothing changes its sign.
        let one_sign = |at: [i32; 2], step: [i32; 2]| {
            (0..2).all(|i| at[i].signum() == (at[i] + step[i] * pixels as i32).signum())
        };
        if count < pixels && one_sign(footprint.across, step.across) && one_sign(footprint.down, step.down) {
            let next = most(&footprint, &step, count as i32, times) / 65536.0;
            // Rounded differently, or less and then more.
            let at_edge = ((next.log2() + 0.5).fract() - 0.5).abs() > 0.4999;
            let turns = (0..pixels).any(|pixel| {
                let at = |pixel: usize| most(&footprint, &step, pixel as i32, times);
                at(pixel + 1) > at(pixel) && at(1) < at(0)
            });
            prop_assert!(copy(count) != number || at_edge || turns);
        }
    }
}
