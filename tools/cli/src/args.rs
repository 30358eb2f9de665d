//! The command line's words. Scripts rely on them: they only ever grow.

use crate::examples::*;
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use fixel_estimate::Board;
use fixel_scene::{Panel, PanelDithering};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Fixed-point 3D for displays on microcontrollers: render, compare and bake
/// scenes.
#[derive(Debug, Parser)]
#[command(name = "fixel", version)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render one frame to a PNG file.
    Render(Render),
    /// Hold a frame against the f64 reference: coverage, depth, light, colour.
    Compare(Compare),
    /// Turn a scene or a mesh into one .fxl file for flash.
    Bake(Bake),
    /// Say what is in a .fxl file.
    Info(Info),
    /// Render many frames to a GIF, an APNG or a folder.
    Animate(Animate),
    /// Show a scene in a window, as its panel shows it.
    View(View),
    /// Flash, RAM, instructions and frames a second on a board.
    Estimate(Estimate),
    /// Print what makes a shell complete the words of this command.
    Completions(Completions),
}

/// What a command works on.
#[derive(Clone, Debug, Args)]
pub struct Input {
    /// A scene (.toml), a mesh (.obj, .glb, .gltf, .stl, .ply) or a baked
    /// scene (.fxl).
    pub scene: PathBuf,
    /// A folder whose files the scene may name too, besides those below its own folder, this
    /// one, and the folder above with a .git; may be given several times. FIXEL_ALLOW has
    /// such folders, separated as those of PATH.
    #[arg(long, value_name = "FOLDER", hide_short_help = true)]
    pub allow: Vec<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = RENDER)]
pub struct Render {
    #[command(flatten)]
    pub input: Input,
    /// The picture [default: the scene's name with .png, in this folder].
    #[arg(short, long, value_name = "FRAME.png")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub frame: Frame,
    /// How to render.
    #[arg(long, value_enum, default_value_t)]
    pub renderer: Renderer,
    /// Rows in a band [default: the whole picture in one]. The pictures are
    /// the same; the reference renderer has no bands.
    #[arg(long, value_name = "ROWS", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub bands: Option<u32>,
    /// The depth buffer as a 16-bit grey PNG; 0 where nothing is seen.
    #[arg(long, value_name = "D.png")]
    pub depth_out: Option<PathBuf>,
    /// 16-bit grey PNG: 0 background, otherwise 1 + the actor's index in the file. Such small
    /// numbers look black: `i` in fixel view shows them in colours, and so does any program
    /// that stretches greys, such as magick I.png -auto-level seen.png.
    #[arg(long, value_name = "I.png")]
    pub id_out: Option<PathBuf>,
    /// Figures about the frame as JSON; - for standard output.
    #[arg(long, value_name = "S.json|-")]
    pub stats: Option<Destination>,
    #[command(flatten)]
    pub screen: Screen,
}

/// A panel instead of the scene's display.
#[derive(Debug, Args)]
pub struct Screen {
    /// For this panel: its size and colour instead of the scene's. Such as st7789-240x240; a
    /// wrong name lists them.
    #[arg(long, value_name = "PANEL", value_parser = panel)]
    pub display: Option<Panel>,
    /// How it shows greys between its own [default: as the scene says, or blue_noise if that
    /// is for a display of colours]: none, bayer4, bayer8, blue_noise, floyd_steinberg.
    #[arg(long, value_name = "WAY", value_parser = dithering, requires = "display")]
    pub dithering: Option<PanelDithering>,
}

impl Screen {
    /// The panel, if one was named.
    pub fn get(&self) -> Option<fixel_scene::Screen> {
        self.display.map(|panel| fixel_scene::Screen {
            panel,
            dithering: self.dithering,
        })
    }
}

fn panel(name: &str) -> Result<Panel, String> {
    let known = || fixel_scene::PANELS.iter().map(|panel| panel.name);
    let unknown = || format!("expected one of {}", known().collect::<Vec<_>>().join(", "));
    Panel::named(name).copied().ok_or_else(unknown)
}

fn dithering(name: &str) -> Result<PanelDithering, String> {
    let known = || fixel_scene::DITHERINGS.iter();
    let names = || {
        known()
            .map(|(name, _)| *name)
            .collect::<Vec<_>>()
            .join(", ")
    };
    let found = known().find(|(known, _)| *known == name);
    found
        .map(|(_, way)| *way)
        .ok_or_else(|| format!("expected one of {}", names()))
}

#[derive(Debug, Args)]
#[command(after_help = COMPARE)]
pub struct Compare {
    #[command(flatten)]
    pub input: Input,
    #[command(flatten)]
    pub frame: Frame,
    /// What to hold against the reference.
    #[arg(long, value_enum, default_value_t)]
    pub renderer: Tested,
    /// Rows in a band [default: the whole picture in one].
    #[arg(long, value_name = "ROWS", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub bands: Option<u32>,
    /// The figures as JSON; - for standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<Destination>,
    /// A page with pictures, heat maps, histograms and figures in this folder: index.html,
    /// which needs no other file.
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
}

/// Which frame, how large.
#[derive(Debug, Args)]
pub struct Frame {
    /// Picture size in pixels [default: the scene's display].
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Frame of the animation.
    #[arg(
        long = "frame",
        value_name = "N",
        default_value_t = 0,
        allow_negative_numbers = true
    )]
    pub number: u32,
}

#[derive(Debug, Args)]
#[command(after_help = BAKE)]
pub struct Bake {
    #[command(flatten)]
    pub input: Input,
    /// The baked scene.
    #[arg(short, long, value_name = "OUT.fxl")]
    pub output: PathBuf,
    /// Simplify the scene's meshes, the largest ones, to at most N triangles in total; how
    /// far they then are off is said on standard error.
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub max_triangles: Option<u32>,
    /// Colours of the palette, 2 to 256 [default: as the scene says].
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(2..=256))]
    pub colours: Option<u32>,
    /// With what the ray caster needs: a hierarchy of boxes over each mesh, and more.
    #[arg(long)]
    pub ray: bool,
    /// For the rasteriser alone, though the scene asks for rays.
    #[arg(long, conflicts_with = "ray")]
    pub raster: bool,
    #[command(flatten)]
    pub screen: Screen,
}

#[derive(Debug, Args)]
#[command(after_help = INFO)]
pub struct Info {
    /// A baked scene.
    #[arg(value_name = "FILE.fxl")]
    pub file: PathBuf,
}

#[derive(Debug, Args)]
#[command(after_help = ANIMATE)]
pub struct Animate {
    #[command(flatten)]
    pub input: Input,
    /// A .gif, an animated .png, or a folder for single pictures
    /// (frame_0000.png and so on).
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// How many frames [default: until the animation starts again]. A mesh alone turns once
    /// in them, or in 60.
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: Option<u32>,
    /// How to render.
    #[arg(long, value_enum, default_value_t)]
    pub renderer: Tested,
    /// Frames a second.
    #[arg(long, value_name = "N", default_value_t = 25, allow_negative_numbers = true,
          value_parser = clap::value_parser!(u16).range(1..=100))]
    pub fps: u16,
    /// Picture size in pixels [default: the scene's display].
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
}

#[derive(Debug, Args)]
#[command(after_help = VIEW)]
pub struct View {
    #[command(flatten)]
    pub input: Input,
    #[command(flatten)]
    pub screen: Screen,
    /// The board whose instructions and frames a second are reckoned [default: the first]; a
    /// wrong name lists them.
    #[arg(long, value_name = "NAME", value_parser = Board::find)]
    pub board: Option<&'static Board>,
    /// How to render to begin with.
    #[arg(long, value_enum, default_value_t)]
    pub renderer: Renderer,
    /// Screen pixels a panel pixel takes [default: as fits].
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..=16))]
    pub zoom: Option<u32>,
    /// Keys and mouse moves from a file, one a line, as if they were made in the window; for
    /// tests.
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub script: Option<PathBuf>,
    /// With --script: without a window.
    #[arg(long, requires = "script", hide_short_help = true)]
    pub no_window: bool,
}

#[derive(Debug, Args)]
#[command(after_help = COMPLETIONS)]
pub struct Completions {
    /// The shell.
    #[arg(value_enum)]
    pub shell: Shell,
}

#[derive(Debug, Args)]
#[command(after_help = ESTIMATE)]
pub struct Estimate {
    #[command(flatten)]
    pub input: Input,
    #[command(flatten)]
    pub screen: Screen,
    /// The board; a wrong name lists them.
    #[arg(long, value_name = "NAME", value_parser = Board::find)]
    pub board: &'static Board,
    /// Rows in a band, at most [default: 16, or as many as the board has the RAM for].
    #[arg(long, value_name = "ROWS", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub bands: Option<u32>,
    /// Frame of the animation.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        allow_negative_numbers = true
    )]
    pub frame: u32,
    /// The figures as JSON; - for standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<Destination>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Renderer {
    /// The fixed-point rasteriser, as on a microcontroller.
    #[default]
    Raster,
    /// The fixed-point ray caster.
    Ray,
    /// The f64 reference for the rasteriser.
    Reference,
    /// The f64 reference for the ray caster: shadows, mirrors, glass.
    RayReference,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Tested {
    /// The fixed-point rasteriser, as on a microcontroller.
    #[default]
    Raster,
    /// The fixed-point ray caster.
    Ray,
}

/// A picture's size in pixels, each 1 to 2048.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub width: u32,
    pub height: u32,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str| text.parse().ok().filter(|v| (1..=2048).contains(v));
        text.split_once('x')
            .and_then(|(w, h)| {
                Some(Self {
                    width: side(w)?,
                    height: side(h)?,
                })
            })
            .ok_or_else(|| {
                "expected WIDTHxHEIGHT in pixels, each 1 to 2048, such as 320x240".into()
            })
    }
}

/// Where JSON goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Destination {
    /// Standard output, which then carries nothing else.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl Destination {
    /// The file, if it is one.
    pub fn file(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
        }
    }
}

impl FromStr for Destination {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(if text == "-" {
            Self::Stdout
        } else {
            Self::File(text.into())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_sound() {
        Cli::command().debug_assert();
    }

    /// Each command has some, and they are right.
    #[test]
    fn examples() {
        for command in Cli::command().get_subcommands() {
            let name = command.get_name();
            let text = command.get_after_help().map(ToString::to_string);
            let text = text.unwrap_or_default();
            let examples = text
                .lines()
                .filter_map(|line| line.strip_prefix("  fixel "));
            let mut count = 0;
            for example in examples {
                let words = example.split(" > ").next().unwrap_or(example);
                let words = std::iter::once("fixel").chain(words.split_whitespace());
                let parsed = Cli::try_parse_from(words);
                assert!(example.starts_with(name) && parsed.is_ok(), "{example}");
                count += 1;
            }
            assert!(count > 0, "{name} has no example");
        }
    }

    #[test]
    fn sizes() {
        assert_eq!(
            "320x240".parse(),
            Ok(Size {
                width: 320,
                height: 240
            })
        );
        for wrong in [
            "", "320", "320x", "x240", "0x240", "320x0", "2049x1", "320X240", "1x2x3",
        ] {
            assert!(wrong.parse::<Size>().is_err(), "{wrong}");
        }
    }
}
