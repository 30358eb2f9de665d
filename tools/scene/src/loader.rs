//! Reading a scene, from where and for which panel.

use std::path::Path;

use crate::description::Scene;
use crate::error::Error;
use crate::files::{Disk, Files, Origin};
use crate::panel::Screen;
use crate::{bare, file, mesh};

/// Bytes of a scene file: what is read of it takes up to a hundred times as many.
const MAX_TEXT: usize = 8 << 20;

/// Reads a scene or a bare mesh as [`crate::load`] does, from other files or for another
/// panel than the scene's.
///
/// ```
/// use std::path::Path;
/// use fixel_scene::{InMemory, Loader, Panel, Screen};
///
/// let mut files = InMemory::default();
/// let triangle = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// files.insert(Path::new("triangle.obj"), triangle.to_vec());
/// let panel = *Panel::named("ssd1306-128x64").unwrap();
/// let loader = Loader::new(&files).on(Screen { panel, dithering: None });
/// let (scene, notes) = loader.load(Path::new("triangle.obj"))?;
/// assert_eq!((scene.display.width, scene.display.height), (128, 64));
/// assert!(notes.is_empty());
/// # Ok::<(), fixel_scene::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Loader<'a> {
    files: &'a dyn Files,
    screen: Option<Screen>,
}

impl Default for Loader<'_> {
    /// The files of this machine.
    fn default() -> Self {
        Self::new(&Disk)
    }
}

impl<'a> Loader<'a> {
    /// From these files.
    pub fn new(files: &'a dyn Files) -> Self {
        let screen = None;
        Self { files, screen }
    }

    /// For a panel: its size and colour instead of those that `[display]` says. What is
    /// framed automatically is framed for it; where the panel is narrower for its height
    /// than the scene's display, cameras with a place of their own see so much more in
    /// height that they see as much in width.
    #[must_use]
    pub fn on(self, screen: Screen) -> Self {
        Self {
            screen: Some(screen),
            ..self
        }
    }

    /// The scene, and notes for the user, one line each, on what the meshes have that a
    /// scene does not, such as a glTF file's skins.
    ///
    /// # Errors
    /// The first mistake found: what, in which file, and in which line of it.
    pub fn load(&self, path: &Path) -> Result<(Scene, Vec<String>), Error> {
        let origin = Origin {
            path,
            files: self.files,
        };
        let mut notes = Vec::new();
        let scene = if mesh::extension(path) == "toml" {
            let bytes = self.files.read(path);
            let bytes = bytes.map_err(|what| Error::new(path, what))?;
            if bytes.len() > MAX_TEXT {
                let found = bytes.len();
                let what = format!(
                    "has {found} bytes; expected at most {MAX_TEXT}, and meshes in files of their own"
                );
                return Err(Error::new(path, what));
            }
            let text = std::str::from_utf8(&bytes).map_err(|error| {
                let line = mesh::line_of(&bytes, error.valid_up_to());
                Error::at_line(path, line, "not UTF-8; expected a TOML file in UTF-8")
            })?;
            file::parse(origin, text, self.screen, &mut notes)?
        } else {
            mesh::check_name(path).map_err(|_| {
                if let Err(what) = self.files.read(path) {
                    return Error::new(path, what);
                }
                let meshes = mesh::EXTENSIONS.join(", .");
                let what = "is not a kind of file that can be read; expected one of .toml";
                Error::new(path, format!("{what}, .{meshes}"))
            })?;
            bare::scene(origin, self.screen, &mut notes)?
        };
        Ok((scene, notes))
    }
}
