//! The pictures of `docs/how/`: each scene file in `docs/how/pictures` with its first
//! frame beside it, as a panel shows it.

use std::fs;
use std::path::{Path, PathBuf};

use crate::problem::Result;
use crate::{paths, picture, scene};

/// A frame: width, height and three bytes a pixel.
type Drawn = ((u16, u16), Vec<u8>);

/// Draws all anew.
pub fn run() -> Result<()> {
    for file in files()? {
        let ((width, height), rgb) = draw(&file)?;
        picture::write_png(&beside(&file), width.into(), height.into(), &rgb)?;
    }
    Ok(())
}

/// Fails if a picture is not what would be drawn now.
pub fn are_current() -> Result<()> {
    let mut old = Vec::new();
    for file in files()? {
        if read(&beside(&file)).ok() != Some(draw(&file)?) {
            old.push(scene::name(&file));
        }
    }
    if old.is_empty() {
        return Ok(());
    }
    let old = old.join(", ");
    Err(format!("in docs/how/pictures out of date: {old}: run `cargo xtask gallery`").into())
}

fn files() -> Result<Vec<PathBuf>> {
    let folder = paths::root().join("docs/how/pictures");
    let fail = |error| format!("{}: {error}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(&folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn beside(file: &Path) -> PathBuf {
    file.with_extension("png")
}

fn draw(file: &Path) -> Result<Drawn> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", file.display());
    let described = fixel_scene::load(file).map_err(|error| error.to_string())?;
    let baked = fixel_bake::bake(&described).map_err(|error| fail(&error))?;
    let core = fixel::Scene::parse(baked.bytes()).map_err(|error| fail(&error))?;
    let planes = fixel_host::render(&core, &fixel_host::Options::of(&core));
    let (pixels, size) = fixel_host::picture(&core, &planes);
    Ok((size, pixels.into_flattened()))
}

fn read(path: &Path) -> Result<Drawn> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let file = fs::File::open(path).map_err(|error| fail(&error))?;
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().map_err(|error| fail(&error))?;
    let mut rgb = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader.next_frame(&mut rgb).map_err(|error| fail(&error))?;
    rgb.truncate(frame.buffer_size());
    Ok(((frame.width as u16, frame.height as u16), rgb))
}
