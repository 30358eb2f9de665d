//! What the page has open.

use std::path::{Path, PathBuf};

use fixel_bake::Baked;
use fixel_host::{Options, Planes, is_dithered, picture, render, render_rays};
use fixel_scene::{DITHERINGS, InMemory, Loader, Panel, PanelDithering, Reach, Screen};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::catalogue::{catalogue, panel};
use crate::eye::{View, height_at_focus, moved, reach};
use crate::requests::{Asked, Frame, Open};
use crate::{boards, facts, samples, snippet};

/// What comes of a call.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    /// Whether what was asked for was done; if not, the text says what is wrong.
    pub done: bool,
    /// JSON, or a message.
    pub text: String,
    /// Pixels (red, green, blue, 255 each) or a file.
    pub bytes: Vec<u8>,
}

/// Files, the scene that is shown, and from where.
#[derive(Debug, Default)]
pub struct Session {
    files: InMemory,
    shown: Option<Shown>,
}

/// A scene on a panel.
#[derive(Debug)]
struct Shown {
    baked: Baked,
    panel: Panel,
    rays: bool,
    name: String,
    /// Where everything gets: centre and radius of a sphere an actor, in world units.
    reach: Vec<([f64; 3], f64)>,
    view: View,
}

type Result<T> = std::result::Result<T, String>;

impl Session {
    /// Does what is asked for:
    ///
    /// 0. the catalogue of panels, ways of dithering and samples;
    /// 1. forgets all files;
    /// 2. takes a file: the length of its path in 4 bytes, little-endian, the path, the rest;
    /// 3. opens a scene ([`Open`]) and says what is in it;
    /// 4. draws a [`Frame`];
    /// 5. hands over the baked scene;
    /// 6. writes a program that shows it;
    /// 7. estimates what a frame takes on a board ([`Asked`]).
    pub fn call(&mut self, what: u32, input: &[u8]) -> Answer {
        let nothing = |text: String| (text, Vec::new());
        let result = match what {
            0 => Ok(nothing(catalogue().to_string())),
            1 => {
                self.files = InMemory::default();
                Ok(Default::default())
            }
            2 => self.file(input).map(|()| Default::default()),
            3 => parse(input)
                .and_then(|open| self.open(&open))
                .map(|facts| nothing(facts.to_string())),
            4 => parse(input).and_then(|frame| self.frame(frame)),
            5 => self
                .shown()
                .map(|shown| (String::new(), shown.baked.bytes().to_vec())),
            6 => self.snippet().map(nothing),
            7 => parse(input)
                .and_then(|asked| self.estimate(&asked))
                .map(|estimate| nothing(estimate.to_string())),
            _ => Err(format!("there is no call {what}")),
        };
        match result {
            Ok((text, bytes)) => Answer {
                done: true,
                text,
                bytes,
            },
            Err(text) => Answer {
                text,
                ..Answer::default()
            },
        }
    }

    fn shown(&mut self) -> Result<&mut Shown> {
        self.shown
            .as_mut()
            .ok_or_else(|| "no scene is open".to_owned())
    }

    fn file(&mut self, input: &[u8]) -> Result<()> {
        let (length, rest) = input.split_first_chunk().ok_or("a file has no name")?;
        let length = u32::from_le_bytes(*length) as usize;
        let (path, bytes) = rest.split_at_checked(length).ok_or("a file has no name")?;
        let path = std::str::from_utf8(path).map_err(|error| error.to_string())?;
        self.files.insert(Path::new(path), bytes.to_vec());
        Ok(())
    }

    /// Bakes a scene for a panel. What was open stays if this one is refused.
    fn open(&mut self, open: &Open) -> Result<Value> {
        let panel = panel(&open.panel)?;
        let dithering = open.dithering.as_deref().map(dithering).transpose()?;
        let screen = Screen { panel, dithering };
        let path = Path::new(&open.path);
        let (baked, rays, notes, scene) = if is_baked(path) {
            let bytes = self.read(path)?;
            let named = |error: &dyn std::fmt::Display| format!("{}: {error}", open.path);
            let baked = Baked::from_bytes(&bytes).map_err(|error| named(&error))?;
            let baked = baked.on(&screen).map_err(|error| named(&error))?;
            let scene = baked.scene().map_err(|error| named(&error))?;
            let rays = open.rays.unwrap_or(false);
            if rays && !scene.has_rays() {
                let what = "is not baked for rays; expected one made by fixel bake --ray";
                return Err(named(&what));
            }
            let description = fixel_bake::unbake(&scene);
            (baked, rays, Vec::new(), description)
        } else {
            let (scene, notes) = self.load(path, screen)?;
            let rays = open.rays.unwrap_or(scene.asks_for_rays().is_some());
            let bake = if rays {
                fixel_bake::bake_for_rays
            } else {
                fixel_bake::bake
            };
            let baked = bake(&scene)
                .map_err(|error| scene.error(error.element, &error.to_string()).to_string())?;
            (baked, rays, notes, scene)
        };
        let core = baked.scene().map_err(|error| error.to_string())?;
        let stem = path.file_stem().unwrap_or_default();
        let answer = json!({
            "name": stem.to_string_lossy(),
            "rays": rays,
            "notes": notes,
            "triangles": core.triangle_count(),
            "vertices": core.vertex_count(),
            "meshlets": core.meshlet_count(),
            "actors": scene.actors.iter().filter(|actor| !actor.part).count(),
            "blob_bytes": baked.bytes().len(),
            "mesh_bytes": core.mesh_bytes(),
            "ram_bytes": facts::ram_bytes(&core, &panel, rays),
            "band_rows": facts::band_rows(rays),
            "has_palette": !core.is_direct(),
            "frames": scene.animation.length(),
        });
        let reach = reach(&core, &Reach::of(&scene));
        // Whoever only changes the panel goes on seeing what was seen.
        let world = |scene: &fixel::Scene<'_>| {
            let header = scene.header();
            (
                header.world_exponent,
                header.world_centre,
                header.centre_exponent,
            )
        };
        let same = |shown: &Shown| {
            let before = shown.baked.scene();
            shown.name == open.path && before.is_ok_and(|before| world(&before) == world(&core))
        };
        let before = self.shown.take().filter(same);
        let view = before.map_or(View::OWN, |shown| shown.view);
        self.shown = Some(Shown {
            baked,
            panel,
            rays,
            name: open.path.clone(),
            reach,
            view,
        });
        Ok(answer)
    }

    /// A scene of the user's files, or a sample.
    fn load(&self, path: &Path, screen: Screen) -> Result<(fixel_scene::Scene, Vec<String>)> {
        let load = |files: &InMemory| Loader::new(files).on(screen).load(path);
        let loaded = if self.files.paths().next().is_some() {
            load(&self.files)
        } else {
            load(&sample_files())
        };
        loaded.map_err(|error| error.to_string())
    }

    fn read(&self, path: &Path) -> Result<Vec<u8>> {
        use fixel_scene::Files;
        let named = |what: String| format!("{}: {what}", path.display());
        self.files.read(path).map_err(named)
    }

    /// Draws a frame; its pixels, and what it took.
    fn frame(&mut self, frame: Frame) -> Result<(String, Vec<u8>)> {
        let shown = self.shown()?;
        let core = shown.baked.scene().map_err(|error| error.to_string())?;
        let view = &mut shown.view;
        if frame.reset {
            *view = View::OWN;
        }
        let own = core.pose(frame.number).camera;
        if frame.zoom > 0.0 {
            view.zoom = (view.zoom * frame.zoom).clamp(0.25, 20.0);
        }
        if frame.moves() {
            let zoomed = view.of(own).unwrap_or(own);
            let from = view.camera.unwrap_or(own);
            let height = height_at_focus(&zoomed);
            view.camera = Some(moved(from, &frame, height, &shown.reach));
        }
        let camera = view.of(own);
        let options = Options {
            width: shown.panel.width as u16,
            height: shown.panel.height as u16,
            frame: frame.number,
            band_rows: Some(facts::band_rows(shown.rays) as u16),
            camera,
        };
        let draw = if shown.rays { render_rays } else { render };
        let planes = draw(&core, &options);
        let (pixels, (width, height)) = picture(&core, &planes);
        let covered = covered(&planes);
        let pose = core.pose(frame.number);
        let palette = fixel::render::palette(&core, &pose);
        let colours = palette
            .entries()
            .map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}"));
        let stats = planes.stats;
        let answer = json!({
            "width": width,
            "height": height,
            "covered_px": covered,
            "triangles_drawn": stats.triangles_drawn,
            "meshlets_transformed": stats.meshlets_transformed,
            "dithered": is_dithered(&core),
            "palette": colours.collect::<Vec<_>>(),
            "moved": camera.is_some(),
        });
        let bytes = pixels.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]);
        Ok((answer.to_string(), bytes.collect()))
    }

    fn estimate(&mut self, asked: &Asked) -> Result<Value> {
        let shown = self.shown()?;
        if shown.rays {
            return Ok(Value::Null);
        }
        let core = shown.baked.scene().map_err(|error| error.to_string())?;
        let (bytes, rows) = (shown.baked.bytes().len(), facts::band_rows(false) as u16);
        let of = (asked.number, rows);
        boards::estimate(&core, bytes, &shown.panel, &asked.board, of)
    }

    fn snippet(&mut self) -> Result<String> {
        let shown = self.shown()?;
        let core = shown.baked.scene().map_err(|error| error.to_string())?;
        let path = PathBuf::from(&shown.name);
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        Ok(snippet::program(&core, &shown.panel, &stem, shown.rays))
    }
}

fn parse<T: DeserializeOwned>(input: &[u8]) -> Result<T> {
    serde_json::from_slice(input).map_err(|error| error.to_string())
}

fn is_baked(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("fxl"))
}

fn dithering(name: &str) -> Result<PanelDithering> {
    let found = DITHERINGS.iter().find(|(known, _)| *known == name);
    let unknown = || format!("there is no dithering {name}");
    found.map(|(_, way)| *way).ok_or_else(unknown)
}

fn sample_files() -> InMemory {
    let mut files = InMemory::default();
    for (path, bytes) in samples::FILES {
        files.insert(Path::new(path), bytes.to_vec());
    }
    files
}

/// Pixels that are not background.
fn covered(planes: &Planes) -> usize {
    planes.depth.iter().filter(|depth| **depth != 0).count()
}

#[cfg(test)]
mod tests;
