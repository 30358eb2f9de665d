//! Blobs whose numbers are all in range, and as extreme as the range allows:
//! whatever `Scene::parse` accepts is drawn without overflow or panic.

use std::sync::LazyLock;

use fixel::scene::layout;
use fixel_bake::Baked;
use fixel_host::{Options, render};
use proptest::prelude::*;

/// Words worth trying: ends of ranges and powers of two with their neighbours.
fn word() -> impl Strategy<Value = u32> {
    let near_power = (0u32..32, -1i32..=1, any::<bool>()).prop_map(|(bit, off, negative)| {
        let value = (1u32 << bit).wrapping_add_signed(off);
        if negative {
            value.wrapping_neg()
        } else {
            value
        }
    });
    prop_oneof![
        4 => near_power,
        1 => any::<u32>(),
        1 => 0u32..300,
        1 => (-70i32..40).prop_map(|v| v as u32),
    ]
}

fn baked(file: &str) -> Baked {
    fixel_tests::load(&fixel_tests::root().join(file)).1
}

static SMALL: LazyLock<Baked> = LazyLock::new(|| baked("tests/data/small.toml"));
static LARGE: LazyLock<[Baked; 4]> = LazyLock::new(|| {
    [
        "parallel",
        "viewports",
        "fog_exponential",
        "stereo_side_by_side",
    ]
    .map(|name| baked(&format!("scenes/{name}.toml")))
});

/// The blob with some words replaced and the checksum made good.
fn changed(baked: &Baked, changes: &[(usize, u32)]) -> Vec<u8> {
    let mut words: Vec<u32> = baked
        .bytes()
        .chunks_exact(4)
        .map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]]))
        .collect();
    for (at, value) in changes {
        words[*at] = *value;
    }
    words[3] = fixel::scene::checksum(&words[layout::CHECKED_FROM / 4..]);
    words.iter().flat_map(|w| w.to_le_bytes()).collect()
}

/// Draws a blob if it parses.
fn drawn(bytes: &[u8]) -> bool {
    let Ok(baked) = Baked::from_bytes(bytes) else {
        return false;
    };
    let scene = baked.scene().expect("parsed a moment ago");
    let options = Options {
        width: 24,
        height: 16,
        frame: 3,
        band_rows: Some(5),
        camera: None,
    };
    assert_eq!(render(&scene, &options).index.len(), 24 * 16);
    true
}

/// Words of the header that a scene has its numbers in.
const CAMERA: core::ops::Range<usize> = 4..layout::HEADER_WORDS;

/// Where a section's records begin, in words.
fn section(baked: &Baked, number: usize) -> usize {
    let at = 4 * (layout::HEADER_WORDS + 2 * number);
    let word = &baked.bytes()[at..at + 4];
    u32::from_le_bytes([word[0], word[1], word[2], word[3]]) as usize / 4
}

#[test]
fn any_word_of_the_records_may_be_extreme() {
    let baked = &*SMALL;
    let (lights, vertices) = (section(baked, 3), section(baked, 8));
    let mut count = 0;
    for at in CAMERA.chain(lights..vertices) {
        for bit in 0..32 {
            for value in [
                1u32 << bit,
                (1u32 << bit).wrapping_sub(1),
                (1u32 << bit).wrapping_neg(),
            ] {
                count += usize::from(drawn(&changed(baked, &[(at, value)])));
            }
        }
        for value in -70i32..70 {
            count += usize::from(drawn(&changed(baked, &[(at, value as u32)])));
        }
    }
    assert!(count > 1000, "{count} drawn");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn several_extreme_words_at_once(
        changes in prop::collection::vec((any::<prop::sample::Index>(), word()), 1..6),
        which in prop_oneof![9 => Just(None), 1 => (0..4usize).prop_map(Some)],
    ) {
        let baked: &Baked = which.map_or(&SMALL, |which| &LARGE[which]);
        let lights = section(baked, 3);
        let viewports = section(baked, 12)..section(baked, 13);
        let moves_and_fog = section(baked, 14)..section(baked, 17);
        let output = section(baked, 20)..baked.bytes().len() / 4;
        let places: Vec<usize> =
            CAMERA.chain(lights..section(baked, 8)).chain(viewports).chain(moves_and_fog).chain(output).collect();
        let changes: Vec<(usize, u32)> =
            changes.iter().map(|(at, value)| (places[at.index(places.len())], *value)).collect();
        drawn(&changed(baked, &changes));
    }
}
