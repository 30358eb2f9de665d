//! What `Scene::embedded` takes although no baker wrote it: nonsense is drawn, but nothing
//! overflows or panics, and every frame comes to an end.

use fixel::Scene;
use fixel_bake::Baked;
use fixel_host::{Options, render, render_rays};
use fixel_tests::fuzz::made_good;
use fixel_tests::made::Random;
use fixel_tests::root;

fn baked(name: &str) -> Baked {
    let path = root().join(format!("tests/data/{name}.toml"));
    match name {
        "rays" => fixel_tests::load_for_rays(&path).1,
        _ => fixel_tests::load(&path).1,
    }
}

fn words(bytes: &[u8]) -> Vec<u32> {
    let words = bytes.chunks_exact(4);
    words
        .map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]]))
        .collect()
}

/// Draws a small picture.
fn draw(scene: &Scene<'_>) {
    let (width, height) = (scene.frame_width().min(24), scene.frame_height().min(16));
    if scene.is_direct() {
        fixel_host::direct(scene, (width, height), 5, 3, scene.dither());
        return;
    }
    let options = Options {
        width,
        height,
        frame: 3,
        band_rows: Some(5),
        ..Options::of(scene)
    };
    render(scene, &options);
    if scene.has_rays() {
        render_rays(scene, &options);
    }
}

/// Changes 1 to 12 bytes anywhere, half of them among the records, `count` times, and draws
/// what is taken: how many that are, and how many of them `Scene::parse` refuses.
fn changed(name: &str, seed: u64, count: usize) -> (usize, usize) {
    let baked = baked(name);
    let mut random = Random(seed);
    let mut pick =
        |range: std::ops::Range<usize>| range.start + (random.next() * range.len() as f64) as usize;
    let (mut taken, mut refused) = (0, 0);
    for _ in 0..count {
        let mut bytes = baked.bytes().to_vec();
        for _ in 0..pick(1..13) {
            let records = bytes.len().min(2500);
            let end = [bytes.len(), records][pick(0..2)];
            let value = [0, 0x7f, 0x80, 0xff, pick(0..256), pick(0..256)][pick(0..6)];
            bytes[pick(16..end)] = value as u8;
        }
        let words = words(&made_good(&bytes).expect("long enough"));
        let bytes = bytemuck::cast_slice(&words);
        if let Ok(scene) = Scene::embedded(bytes) {
            draw(&scene);
            taken += 1;
            refused += usize::from(Scene::parse(bytes).is_err());
        }
    }
    (taken, refused)
}

#[test]
fn what_no_baker_wrote_is_drawn_to_the_end() {
    let count = std::env::var("FIXEL_CASES").map_or(2000, |count| count.parse().expect("a number"));
    for name in ["small", "moving", "lines", "panes", "rays"] {
        let (taken, refused) = changed(name, 7, count);
        assert!(
            taken > count / 4 && refused > count / 8,
            "{name}: {taken} taken, {refused} that `Scene::parse` refuses"
        );
    }
}

#[test]
fn what_was_baked_is_the_same_scene() {
    for name in ["small", "moving", "lines", "panes", "rays"] {
        let baked = baked(name);
        let scene = Scene::embedded(baked.bytes()).expect("baked");
        let checked = Scene::parse(baked.bytes()).expect("baked");
        assert_eq!(format!("{scene:?}"), format!("{checked:?}"));
    }
}

#[test]
fn a_changed_bit_is_refused() {
    let baked = baked("small");
    for bit in 0..8 * baked.bytes().len() {
        let mut words = words(baked.bytes());
        words[bit / 32] ^= 1 << (bit % 32);
        assert!(
            Scene::embedded(bytemuck::cast_slice(&words)).is_err(),
            "bit {bit}"
        );
    }
}
