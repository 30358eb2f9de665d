//! Damaged blobs: refused with a reason, or drawn safely, never a panic.

use fixel::scene::{self, Field, SceneError, Section, layout};
use fixel_bake::Baked;
use fixel_host::{Options, render};
use fixel_tests::fuzz::{features, made_good};

fn small() -> Baked {
    fixel_tests::load(&fixel_tests::root().join("tests/data/small.toml")).1
}

/// Parents, and key frames of actors and of the camera.
fn moving() -> Baked {
    fixel_tests::load(&fixel_tests::root().join("tests/data/moving.toml")).1
}

/// The blob as words, with the checksum made good after a change.
fn with_change(baked: &Baked, change: impl FnOnce(&mut [u8])) -> Vec<u32> {
    let mut bytes = baked.bytes().to_vec();
    change(&mut bytes);
    let mut words: Vec<u32> = bytes
        .chunks_exact(4)
        .map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]]))
        .collect();
    words[3] = scene::checksum(&words[layout::CHECKED_FROM / 4..]);
    words
}

fn parse(words: &[u32]) -> Result<(), SceneError> {
    let bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
    Baked::from_bytes(&bytes).map(|_| ())
}

#[test]
fn each_kind_of_damage_has_its_error() {
    let baked = small();
    let bytes = baked.bytes();
    let refused = |bytes: &[u8]| Baked::from_bytes(bytes).expect_err("damaged");
    assert!(matches!(
        refused(&bytes[..40]),
        SceneError::TooShort { bytes: 40 }
    ));
    assert!(matches!(
        refused(&bytes[..bytes.len() - 4]),
        SceneError::Length { .. }
    ));
    let mut changed = bytes.to_vec();
    changed[0] = b'X';
    assert!(matches!(refused(&changed), SceneError::NotAScene));
    let mut changed = bytes.to_vec();
    changed[4] = 9;
    assert!(matches!(
        refused(&changed),
        SceneError::Version { found: 9 }
    ));
    let mut changed = bytes.to_vec();
    let last = changed.len() - 1;
    changed[last] ^= 1;
    assert!(matches!(refused(&changed), SceneError::Checksum { .. }));
    // A slice that starts off a word.
    let mut shifted = vec![0; bytes.len() + 8];
    let off = (0..4)
        .find(|o| (shifted.as_ptr() as usize + o) % 4 == 1)
        .expect("one of four");
    shifted[off..off + bytes.len()].copy_from_slice(bytes);
    let result = fixel::Scene::parse(&shifted[off..off + bytes.len()]);
    assert!(matches!(result, Err(SceneError::Misaligned)));
}

#[test]
fn an_index_out_of_range_is_named() {
    let baked = moving();
    let table = |section: usize| 4 * (layout::HEADER_WORDS + 2 * section);
    let place = |section: usize| {
        let at = table(section);
        let word = &baked.bytes()[at..at + 4];
        u32::from_le_bytes([word[0], word[1], word[2], word[3]]) as usize
    };
    let section = |wanted: Section| {
        Section::ALL
            .iter()
            .position(|s| *s == wanted)
            .expect("all sections are listed")
    };
    let cases = [
        // The first actor's mesh, the first triangle's first vertex, the first
        // shade's first index.
        (Section::Actors, 1, Section::Actors, Field::Mesh),
        (
            Section::Triangles,
            0,
            Section::Triangles,
            Field::VertexIndex,
        ),
        (Section::Meshlets, 14, Section::Meshlets, Field::Count),
        // The first track's actor, its quantity, its first key, its keys.
        (Section::Tracks, 0, Section::Tracks, Field::Target),
        (Section::Tracks, 2, Section::Tracks, Field::Quantity),
        (Section::Tracks, 4, Section::Tracks, Field::FirstKey),
        (Section::Tracks, 8, Section::Tracks, Field::Count),
        // A key's frame after the next one's.
        (Section::Keys, 0, Section::Keys, Field::Frame),
        (Section::Actors, 48, Section::Actors, Field::Parent),
    ];
    for (part, offset, wanted_section, wanted_field) in cases {
        let at = place(section(part)) + offset;
        let words = with_change(&baked, |bytes| bytes[at] = 200);
        match parse(&words) {
            Err(SceneError::Record { section, field, .. }) => {
                assert_eq!((section, field), (wanted_section, wanted_field));
            }
            other => panic!("{part:?}: {other:?}"),
        }
    }
}

#[test]
fn the_features_that_a_scene_needs_are_stated() {
    let baked = moving();
    let scene = baked.scene().unwrap();
    let stated = scene.header().features;
    assert_eq!(stated, scene.features_used());
    assert_ne!(stated, 0);
    let parsed = |wanted: u16| {
        let words = with_change(&baked, |bytes| {
            let (all, wanted) = (features(u16::MAX), features(wanted));
            let words = bytes.as_chunks_mut::<4>().0;
            for ((word, all), wanted) in words.iter_mut().zip(all).zip(wanted) {
                *word = (u32::from_le_bytes(*word) & !all | wanted).to_le_bytes();
            }
        });
        parse(&words)
    };
    assert_eq!(parsed(stated), Ok(()));
    // More than it uses harms none, but what is used is stated, and there is no tenth.
    assert_eq!(parsed((1 << layout::FEATURES) - 1), Ok(()));
    for bit in (0..layout::FEATURES).filter(|bit| stated >> bit & 1 != 0) {
        let refused = SceneError::Header {
            field: Field::Features,
            value: i64::from(stated & !(1 << bit)),
        };
        assert_eq!(parsed(stated & !(1 << bit)), Err(refused));
    }
    assert!(parsed(stated | 1 << layout::FEATURES).is_err());
}

#[test]
fn a_vertex_beyond_a_sphere_is_named() {
    let baked = small();
    let section = |wanted: Section| {
        let at = 4 * (layout::HEADER_WORDS + 2 * wanted as usize);
        let word: [u8; 4] = baked.bytes()[at..at + 4].try_into().expect("a word");
        u32::from_le_bytes(word) as usize
    };
    // The meshlet's radius, a step short; the mesh's, as small as there is.
    let meshlet = section(Section::Meshlets) + 12;
    let mesh = section(Section::Meshes) + 8;
    let short = vec![baked.bytes()[meshlet] - 1];
    let least = layout::LEAST_RADIUS.to_le_bytes().to_vec();
    for (at, radius) in [(meshlet, short), (mesh, least)] {
        let words = with_change(&baked, |bytes| {
            bytes[at..at + radius.len()].copy_from_slice(&radius);
        });
        let refused = parse(&words).expect_err("a vertex is outside");
        let SceneError::Record { section, field, .. } = refused else {
            panic!("{refused}");
        };
        assert_eq!((section, field), (Section::Vertices, Field::Distance));
    }
}

#[test]
fn every_truncation_is_refused() {
    for baked in [small(), moving(), lines(), rays()] {
        for length in 0..baked.bytes().len() {
            let cut = &baked.bytes()[..length];
            assert!(Baked::from_bytes(cut).is_err(), "{length} bytes");
        }
        // And if length and checksum are made good: all that there is is of use.
        for length in (layout::PREFIX_BYTES..baked.bytes().len()).step_by(4) {
            let cut = made_good(&baked.bytes()[..length]).expect("long enough");
            assert!(Baked::from_bytes(&cut).is_err(), "{length} bytes");
        }
    }
}

/// The checksum, the head's own words and the length see any change of a byte.
#[test]
fn every_value_of_every_byte_is_refused() {
    let baked = small();
    let mut bytes = baked.bytes().to_vec();
    for at in 0..bytes.len() {
        for flip in 1..=u8::MAX {
            bytes[at] ^= flip;
            assert!(Baked::from_bytes(&bytes).is_err(), "byte {at}, {flip:#x}");
            bytes[at] ^= flip;
        }
    }
    assert!(Baked::from_bytes(&bytes).is_ok());
}

/// All that is not a surface.
fn lines() -> Baked {
    fixel_tests::load(&fixel_tests::root().join("tests/data/lines.toml")).1
}

/// A triangle mesh, a ball, an ellipsoid, a mirror, glass.
fn rays() -> Baked {
    fixel_tests::load_for_rays(&fixel_tests::root().join("tests/data/rays.toml")).1
}

#[test]
fn every_changed_byte_is_refused_or_drawn_safely() {
    for baked in [small(), moving(), lines()] {
        change_every_byte(&baked, layout::CHECKED_FROM, render);
    }
    let baked = rays();
    // What only rays read comes last.
    let table = 4 * (layout::HEADER_WORDS + 2 * Section::RaySettings as usize);
    let word = &baked.bytes()[table..table + 4];
    let from = u32::from_le_bytes([word[0], word[1], word[2], word[3]]) as usize;
    change_every_byte(&baked, from, fixel_host::render_rays);
}

fn change_every_byte(
    baked: &Baked,
    from: usize,
    render: fn(&fixel::Scene<'_>, &Options) -> fixel_host::Planes,
) {
    let (mut drawn, mut refused) = (0, 0);
    for at in from..baked.bytes().len() {
        for flip in [0x01, 0x80, 0xff] {
            let words = with_change(baked, |bytes| bytes[at] ^= flip);
            let bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
            match Baked::from_bytes(&bytes) {
                Ok(changed) => {
                    let scene = changed.scene().expect("parsed a moment ago");
                    let options = Options {
                        width: 24,
                        height: 16,
                        frame: 3,
                        band_rows: Some(5),
                        camera: None,
                    };
                    assert_eq!(render(&scene, &options).index.len(), 24 * 16);
                    drawn += 1;
                }
                Err(_) => refused += 1,
            }
        }
    }
    assert!(
        drawn > 100 && refused > 100,
        "{drawn} drawn, {refused} refused"
    );
}
