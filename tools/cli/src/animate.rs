//! `fixel animate`.

use crate::args::Tested;
use crate::progress::Progress;
use crate::{args, input, output};
use anyhow::{Context, Result, bail, ensure};
use fixel::Scene;
use fixel_host::Options;
use std::borrow::Cow;
use std::fs;
use std::path::Path;

/// What is written.
enum Kind {
    Gif,
    Apng,
    Folder,
}

/// Frames one after the other.
struct Film<'a> {
    scene: &'a Scene<'a>,
    options: Options,
    renderer: Tested,
    frames: u32,
    fps: u16,
    progress: Progress,
}

/// A frame as the panel shows it.
struct Picture {
    rgb: Vec<[u8; 3]>,
    /// Palette indices and colours of the same pixels, if each is an entry's.
    indexed: Option<(Vec<u8>, Vec<[u8; 3]>)>,
}

/// Renders the frames of an animation and writes them.
pub fn run(args: &args::Animate) -> Result<()> {
    output::refuse_stdout(&args.output)?;
    let kind = kind(&args.output)?;
    let name = || args.input.scene.display().to_string();
    let mut input = input::load(&args.input, &[Some(&args.output)])?;
    let Some(frames) = args.frames.or(input.scene.animation.length()) else {
        bail!(
            "{}: nothing moves; expected [animation] with frames, a turntable or a \
             palette_cycle, or --frames N",
            name()
        );
    };
    if input.scene.source.bare {
        // A whole turn, however long.
        input.scene.animation.turntable = Some(frames);
    }
    let baked = match args.renderer {
        Tested::Raster => input.bake(),
        Tested::Ray => input.bake_for_rays(),
    };
    let baked = baked?;
    let scene = baked.scene()?;
    let mut options = Options::of(&scene);
    if let Some(size) = args.size {
        (options.width, options.height) = (size.width as u16, size.height as u16);
    }
    let film = Film {
        scene: &scene,
        options,
        renderer: args.renderer,
        frames,
        fps: args.fps,
        progress: Progress::new("frames", frames.into()),
    };
    match kind {
        Kind::Gif => output::write(&args.output, &film.gif()?)?,
        Kind::Apng => output::write(&args.output, &film.apng()?)?,
        Kind::Folder => film.folder(&args.output)?,
    }
    drop(film.progress);
    eprintln!(
        "wrote {} ({}x{}, {frames} frames)",
        args.output.display(),
        options.width,
        options.height
    );
    Ok(())
}

/// By the extension, which a folder does not have; a folder that is there is one.
fn kind(path: &Path) -> Result<Kind> {
    let extension = path.extension().map(|e| e.to_ascii_lowercase());
    match extension.as_deref().and_then(|e| e.to_str()) {
        _ if path.is_dir() => Ok(Kind::Folder),
        Some("gif") => Ok(Kind::Gif),
        Some("png" | "apng") => Ok(Kind::Apng),
        None => Ok(Kind::Folder),
        Some(_) => bail!(
            "{}: expected a name that ends in .gif or .png, or a folder, such as turn.gif",
            path.display()
        ),
    }
}

impl Film<'_> {
    fn picture(&self, frame: u32) -> Picture {
        let options = Options {
            frame,
            ..self.options
        };
        let planes = match self.renderer {
            Tested::Raster => fixel_host::render(self.scene, &options),
            Tested::Ray => fixel_host::render_rays(self.scene, &options),
        };
        let (rgb, _) = fixel_host::picture(self.scene, &planes);
        let plain = !self.scene.output().is_resolved() && !fixel_host::is_dithered(self.scene);
        let indexed = plain.then(|| (planes.index, fixel_host::colours(self.scene, frame)));
        self.progress.step();
        Picture { rgb, indexed }
    }

    fn pictures(&self) -> impl Iterator<Item = Picture> {
        (0..self.frames).map(|frame| self.picture(frame))
    }

    /// The exact colours: a GIF has a palette as the frame has. Pixels that are means
    /// of samples or of two eyes have too many, and get the nearest of 256.
    fn gif(&self) -> Result<Vec<u8>> {
        let Options { width, height, .. } = self.options;
        let mut file = Vec::new();
        let first = fixel_host::colours(self.scene, 0);
        let mut encoder = gif::Encoder::new(&mut file, width, height, first.as_flattened())?;
        encoder.set_repeat(gif::Repeat::Infinite)?;
        let mut shown = 0;
        for (number, picture) in (1..).zip(self.pictures()) {
            // Hundredths of a second, so that the sum keeps the pace.
            let until = number * 100 / u32::from(self.fps);
            let frame = match picture.indexed {
                Some((index, palette)) => gif::Frame {
                    width,
                    height,
                    palette: (palette != first).then(|| palette.as_flattened().to_vec()),
                    buffer: Cow::Owned(index),
                    ..gif::Frame::default()
                },
                None => gif::Frame::from_rgb_speed(width, height, picture.rgb.as_flattened(), 10),
            };
            let delay = (until - shown) as u16;
            encoder.write_frame(&gif::Frame { delay, ..frame })?;
            shown = until;
        }
        drop(encoder);
        Ok(file)
    }

    fn apng(&self) -> Result<Vec<u8>> {
        let Options { width, height, .. } = self.options;
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, width.into(), height.into());
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_animated(self.frames, 0)?;
        encoder.set_frame_delay(1, self.fps)?;
        let mut writer = encoder.write_header()?;
        for picture in self.pictures() {
            writer.write_image_data(picture.rgb.as_flattened())?;
        }
        writer.finish()?;
        Ok(file)
    }

    /// One file a frame, each whole.
    fn folder(&self, folder: &Path) -> Result<()> {
        let fail = || format!("cannot make the folder {}", folder.display());
        fs::create_dir_all(folder).with_context(fail)?;
        ensure!(folder.is_dir(), "{} is not a folder", folder.display());
        let Options { width, height, .. } = self.options;
        let digits = (self.frames - 1).to_string().len().max(4);
        for (number, picture) in self.pictures().enumerate() {
            let path = folder.join(format!("frame_{number:0digits$}.png"));
            let png = output::png_rgb(width.into(), height.into(), &picture.rgb)?;
            output::write(&path, &png)?;
        }
        Ok(())
    }
}
