//! Damaged files are read or refused; they never panic.

use super::{load, samples};

#[test]
fn cut_at_any_length() {
    for (name, bytes) in samples::all() {
        for end in 0..bytes.len() {
            let result = load(name, &bytes[..end]);
            // Only line ends and what means nothing may be missing.
            let text = ["a.obj", "a.ply", "coloured.ply", "ascii.stl"].contains(&name);
            assert!(
                result.is_err() || (text && end + 16 > bytes.len()),
                "{name} {end}"
            );
        }
    }
}

#[test]
fn any_byte_changed() {
    for (name, bytes) in samples::all() {
        for at in 0..bytes.len() {
            for value in [0, 1, b' ', b'-', b'0', b'9', 0x7f, 0x80, 0xff] {
                let mut bytes = bytes.clone();
                bytes[at] = value;
                let _ = load(name, &bytes);
            }
        }
    }
}

#[test]
fn random_bytes_changed_inserted_and_removed() {
    // Numerical Recipes' generator: the same damage on every run.
    let mut state = 1_u32;
    let mut random = |below: usize| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as usize % below
    };
    for (name, bytes) in samples::all() {
        for _ in 0..3000 {
            let mut bytes = bytes.clone();
            for _ in 0..=random(4) {
                let at = random(bytes.len());
                match random(3) {
                    0 => bytes[at] = random(256) as u8,
                    1 => bytes.insert(at, random(256) as u8),
                    _ => {
                        bytes.drain(at..(at + random(8)).min(bytes.len()));
                    }
                }
            }
            let _ = load(name, &bytes);
        }
    }
}

#[test]
fn huge_counts_take_no_memory() {
    let many = samples::PLY.replace("vertex 4", "vertex 4000000000");
    assert_eq!(
        load("a.ply", many.as_bytes()).unwrap_err(),
        "a.ply: says it has 4000000000 items of \"vertex\", more than its bytes"
    );
    let mut stl = samples::stl_binary();
    stl[80..84].fill(0xff);
    load("a.stl", &stl).unwrap_err();
    let mut ply = samples::ply_binary(false);
    let list = ply.len() - 17;
    ply[list] = 0xff;
    load("a.ply", &ply).unwrap_err();
}
