//! Places in a texture, pixel by pixel over small triangles, against f64.

use std::sync::LazyLock;

use fixel::raster::Change;
use fixel::scene::{Coordinates, Scene, Texture};
use fixel::shade::{Sampler, SmallTexture};
use fixel_bake::{Baked, bake};
use fixel_tests::root;
use proptest::prelude::*;

/// Texels that places may be off by.
const MOST_OFF: f64 = 1.0 / 400.0;
/// Texels from the first corner's place on.
const MOST_TEXELS: f64 = 32.0;

static GLOBES: LazyLock<Baked> = LazyLock::new(|| {
    let path = root().join("scenes/textured_mesh.toml");
    let scene = fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    bake(&scene).unwrap_or_else(|e| panic!("{e}"))
});

/// The texture of an actor and its mesh's coordinates.
fn of(scene: &Scene<'_>, number: u16) -> (Texture, Coordinates) {
    let actor = scene.actor(number);
    let texture = scene.material(actor.material).texture;
    let texture = texture.and_then(|texture| scene.texture(texture));
    let coordinates = scene.mesh(actor.mesh).coordinates;
    texture.zip(coordinates).expect("a textured actor")
}

/// Weights of a pixel's corners.
fn weights() -> impl Strategy<Value = [f64; 3]> {
    (0.0..=1.0f64, 0.0..=1.0f64).prop_map(|(a, b)| {
        let (a, b) = if a + b > 1.0 {
            (1.0 - a, 1.0 - b)
        } else {
            (a, b)
        };
        [a, b, 1.0 - a - b]
    })
}

fn mix(weights: [f64; 3], values: [f64; 3]) -> f64 {
    weights.into_iter().zip(values).map(|(w, v)| w * v).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn places_are_those_of_the_plane_in_space(
        first in prop::array::uniform2(-8_000i32..8_000),
        offs in prop::array::uniform2(prop::array::uniform2(-9_000i32..=9_000)),
        mirrored in any::<bool>(),
        nearest in 1u32 << 12..1 << 20,
        farther in prop::array::uniform2(0.0..0.125f64),
        in_space in any::<bool>(),
        weights in weights(),
    ) {
        let baked = &*GLOBES;
        let scene = baked.scene().unwrap();
        let (texture, coordinates) = of(&scene, mirrored.into());
        let sampler = Sampler::new(&scene, texture, coordinates);
        let [u, v] = first;
        let corners = [[0, 0], offs[0], offs[1]].map(|[du, dv]| [(u + du) as i16, (v + dv) as i16]);
        let depths = [0.0, farther[0], farther[1]].map(|part| nearest - (f64::from(nearest) * part) as u32);
        // Places without the coordinates' origin, which is the same for all.
        let exact: [_; 2] = std::array::from_fn(|axis| {
            let unit = f64::from(1u32 << texture.size[axis]) / f64::from(1u32 << coordinates.exponent);
            let places = corners.map(|corner| f64::from(corner[axis]) * unit);
            if !in_space {
                return mix(weights, places);
            }
            let near = depths.map(f64::from);
            let products = std::array::from_fn(|k| places[k] * near[k]);
            mix(weights, products) / mix(weights, near)
        });
        let mut attributes = corners.map(|corner| sampler.attributes(corner));
        let small = {
            let [a, b, c] = &mut attributes;
            SmallTexture::new(&sampler, [a, b, c], in_space.then_some(depths))
        };
        let sizes = texture.size.map(|size| f64::from(1u32 << size));
        let places = corners.map(|corner| -> [f64; 2] {
            std::array::from_fn(|axis| {
                let whole = f64::from(coordinates.origin[axis]) + f64::from(corner[axis]);
                whole / f64::from(1u32 << coordinates.exponent) * sizes[axis]
            })
        });
        let near = (0..2).all(|axis| {
            places.iter().all(|place| (place[axis] - places[0][axis]).abs() < MOST_TEXELS)
        });
        // Where a picture turns round.
        let crossed = mirrored && (0..2).any(|axis| {
            let periods = places.map(|place| (place[axis] / sizes[axis]).floor());
            periods.iter().any(|period| *period != periods[0])
        });
        prop_assert!(small.is_none() || near, "{places:?}");
        let Some(small) = small else {
            let fine = nearest >= 1 << 15;
            prop_assert!(!near || crossed || !fine, "{places:?} could be had");
            return Ok(());
        };
        let still = Change { x: 0, y: 0 };
        let texels = small.begin(&sampler, still, [still; 2]).expect("one copy");
        let own = [0, 1].map(|axis| mix(weights, attributes.map(|a| f64::from(a[axis]))).round() as i32);
        let depth = mix(weights, depths.map(f64::from));
        let place = texels.place((depth * 4096.0) as u32 + (1 << 15), own);
        let origin = sampler.attributes([0; 2]);
        prop_assert_eq!(origin, [0; 2]);
        for axis in 0..2 {
            let period = f64::from(1u32 << texture.size[axis]);
            let at = f64::from(place[axis]) / 65536.0 - f64::from(coordinates.origin[axis]) * period
                / f64::from(1u32 << coordinates.exponent);
            let off = at - exact[axis];
            // Modulo what a place counts to.
            let off = off - (off / 65536.0).round() * 65536.0;
            prop_assert!(off.abs() < MOST_OFF, "{at} instead of {}", exact[axis]);
        }
        let (picture, _) = sampler.point([0; 2]);
        prop_assert_eq!(texels.nearest(place), sampler.nearest(&picture, place));
    }
}
