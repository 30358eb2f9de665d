//! The template for new firmware, as `cargo generate` would expand it: built for each of its
//! chips, and what it draws in its emulator held against what the host draws.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use fixel_host::Options;

use crate::board::{self, Machine};
use crate::problem::Result;
use crate::report::Tally;
use crate::{child, examples, liquid, paths, qemu};

/// The chips that the template knows.
const CHIPS: [&str; 2] = ["rp2040", "qemu"];
/// What `cargo generate` reads and does not copy.
const SETTINGS: &str = "cargo-generate.toml";
/// A run that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(60);

/// Builds and runs them.
pub fn run(tally: &mut Tally) {
    for chip in CHIPS {
        let folder = std::env::temp_dir().join(format!("fixel-template-{chip}"));
        let built = expand(chip, &folder).and_then(|()| build(&folder));
        let built = tally.check(&format!("template for {chip}"), built);
        if chip == "qemu" && built.is_some() {
            let same = picture(&folder).and_then(|picture| check(&folder, &picture));
            tally.check("the template draws what the host draws", same);
        }
        // Another run finds none.
        let _ = fs::remove_dir_all(&folder);
    }
}

fn build(folder: &Path) -> Result<()> {
    child::visibly(&mut examples::for_chip("build", folder)?)
}

/// The template in a folder of its own.
fn expand(chip: &str, folder: &Path) -> Result<()> {
    let root = paths::root();
    let source = root.join("template");
    let values = [
        ("project-name", "firmware"),
        ("chip", chip),
        ("fixel_path", &root.to_string_lossy()),
    ];
    // There may be one of an earlier run.
    let _ = fs::remove_dir_all(folder);
    for file in files(&source)? {
        let inside = file.strip_prefix(&source).unwrap_or(&file);
        let other = |other: &&str| *other != chip && inside.ends_with(format!("board/{other}.rs"));
        if inside == Path::new(SETTINGS) || CHIPS.iter().any(other) {
            continue;
        }
        let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", file.display());
        let text = fs::read_to_string(&file).map_err(|error| fail(&error))?;
        let text = liquid::expand(&text, &values).map_err(|error| fail(&error))?;
        let to = folder.join(inside);
        let made = to.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&to, text))
            .map_err(|error| fail(&error))?;
    }
    // The versions that are tested here.
    let lock = fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"));
    lock.map_err(|error| format!("Cargo.lock: {error}"))?;
    Ok(())
}

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let fail = |error| format!("{}: {error}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        if path.is_dir() {
            files.extend(self::files(&path)?);
        } else {
            files.push(path);
        }
    }
    Ok(files)
}

/// What the firmware draws in its emulator: the pixels of a PPM file.
fn picture(folder: &Path) -> Result<Vec<u8>> {
    if let Machine::Qemu(machine) = &board::find("cortex-m0plus")?.machine {
        qemu::provide(machine)?;
    }
    let run = child::bounded(&mut examples::for_chip("run", folder)?, LIMIT)?;
    if !run.success {
        return Err(format!("{}{}", run.stdout, run.stderr).into());
    }
    let file = folder.join("frame.ppm");
    let bytes = fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let pixels = bytes.strip_prefix(b"P6 240 240 255\n".as_slice());
    Ok(pixels.ok_or("frame.ppm is no picture of 240x240")?.to_vec())
}

/// Holds it against what the host draws of the same scene, in the panel's 16 bits.
fn check(folder: &Path, drawn: &[u8]) -> Result<()> {
    let scene = fixel_scene::load(&folder.join("scene.toml")).map_err(|error| error.to_string())?;
    let baked = fixel_bake::bake(&scene).map_err(|error| error.to_string())?;
    let scene = baked.scene().map_err(|error| error.to_string())?;
    let planes = fixel_host::render(&scene, &Options::of(&scene));
    let (pixels, _) = fixel_host::picture(&scene, &planes);
    let rgb565 = |[r, g, b]: [u8; 3]| (r >> 3, g >> 2, b >> 3);
    let drawn: Vec<_> = drawn.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    if drawn.len() != pixels.len() {
        return Err(format!("{} pixels, not {}", drawn.len(), pixels.len()).into());
    }
    let pairs = drawn.into_iter().zip(pixels);
    match pairs.filter(|(a, b)| rgb565(*a) != rgb565(*b)).count() {
        0 => Ok(()),
        differ => Err(format!("{differ} pixels differ").into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the README shows is what is compiled.
    #[test]
    fn the_readme_shows_the_template() {
        let read = |file: &str| fs::read_to_string(paths::root().join(file)).unwrap_or_default();
        let program = read("template/src/main.rs");
        assert!(!program.is_empty() && program.lines().count() <= 25);
        assert!(read("README.md").contains(&program));
    }
}
