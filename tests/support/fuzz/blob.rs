//! Blobs out of bytes: refused, or drawn safely.

use fixel::scene::{Header, Record, checksum, layout};
use fixel_bake::Baked;
use fixel_host::{Options, render, render_rays};

/// The largest frame that is drawn, so that many are.
const SIZE: (u16, u16) = (24, 16);

/// Reads a blob, as it is and with its head made good, and draws what is accepted.
pub fn blob(bytes: &[u8]) {
    drawn(bytes);
    if let Some(bytes) = made_good(bytes) {
        drawn(&bytes);
    }
}

/// With magic number, version, features, length and checksum as they should be, so that what
/// comes after them is looked at.
pub fn made_good(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut words: Vec<u32> = bytes
        .chunks_exact(4)
        .map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]]))
        .collect();
    // All features are asked for: more than are used harm none.
    let all = features((1 << layout::FEATURES) - 1);
    words
        .iter_mut()
        .zip(all)
        .for_each(|(word, bits)| *word |= bits);
    let checked = words.get(layout::CHECKED_FROM / 4..)?;
    let head = [
        layout::MAGIC,
        layout::VERSION,
        4 * words.len() as u32,
        checksum(checked),
    ];
    words[..4].copy_from_slice(&head);
    Some(words.iter().flat_map(|w| w.to_le_bytes()).collect())
}

/// The bits of a header's words that state these features.
pub fn features(features: u16) -> [u32; layout::HEADER_WORDS] {
    let none = Header {
        features: 0,
        ..Header::from_words(&[0; layout::HEADER_WORDS])
    };
    let (these, none) = (Header { features, ..none }.to_words(), none.to_words());
    std::array::from_fn(|word| these[word] ^ none[word])
}

fn drawn(bytes: &[u8]) {
    let Ok(baked) = Baked::from_bytes(bytes) else {
        return;
    };
    let scene = baked.scene().expect("parsed a moment ago");
    if scene.is_direct() {
        let frame = |rows| fixel_host::direct(&scene, SIZE, rows, 3, scene.dither());
        assert!(frame(5) == frame(64), "bands show");
        return;
    }
    let options = |rows| Options {
        width: SIZE.0,
        height: SIZE.1,
        frame: 3,
        band_rows: Some(rows),
        ..Options::of(&scene)
    };
    let (bands, whole) = (render(&scene, &options(5)), render(&scene, &options(64)));
    assert!(bands.index == whole.index, "bands show");
    assert!(bands.depth == whole.depth, "bands show in depths");
    if scene.has_rays() {
        let (bands, whole) = (
            render_rays(&scene, &options(5)),
            render_rays(&scene, &options(64)),
        );
        assert!(bands.index == whole.index, "bands show by rays");
    }
}
