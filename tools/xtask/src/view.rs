//! The window of `fixel view` on a virtual display: its pixels are `fixel render`'s, and real
//! keys, a real mouse and a saved file change them.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::problem::{Problem, Result};
use crate::report::Tally;
use crate::{child, debian, paths, screen};

/// What a window needs while it runs, besides programs: libraries, and Debian's packages.
const LIBRARIES: [&str; 6] = [
    "libX11.so.6",
    "libX11-xcb.so.1",
    "libXcursor.so.1",
    "libXi.so.6",
    "libxkbcommon.so.0",
    "libxkbcommon-x11.so.0",
];
const PACKAGES: [&str; 8] = [
    "xvfb",
    "xdotool",
    "libx11-6",
    "libx11-xcb1",
    "libxcursor1",
    "libxi6",
    "libxkbcommon0",
    "libxkbcommon-x11-0",
];

/// Until a picture is there.
const PATIENCE: Duration = Duration::from_secs(30);
/// Window pixels a panel pixel takes.
const ZOOM: usize = 2;

/// Two balls, of which nothing moves.
const SCENE: &str = r##"
[display]
width = 320
height = 240
background = "#203040"

[camera]
position = [0, 1, 8]

[[light]]
kind = "directional"
direction = [-1, -1, -1]

[[material]]
name = "red"
colour = "#e04030"

[[material]]
name = "green"
colour = "#40c060"

[[actor]]
sphere = 1
material = "red"

[[actor]]
sphere = 0.7
position = [1.5, 0.3, 0.5]
material = "green"
"##;

/// Checks the window.
pub fn run(tally: &mut Tally) {
    let ready = programs().and_then(|()| Window::open());
    let Some(mut window) = tally.need("the window of fixel view", ready) else {
        return;
    };
    type Check = fn(&mut Window) -> Result<()>;
    let checks: [(&str, Check); 8] = [
        ("shows what fixel render draws", |window| {
            window.focus()?;
            window.shows(SCENE, &[])
        }),
        ("draws wires when w is pressed", |window| {
            window.press("w")?;
            window.shows(&wires(), &[])
        }),
        ("draws surfaces when s is pressed", |window| {
            window.press("s")?;
            window.shows(SCENE, &[])
        }),
        (
            "turns with the mouse, and back when r is pressed",
            |window| {
                window.drag()?;
                window.shows_other_than(SCENE)?;
                window.press("r")?;
                window.shows(SCENE, &[])
            },
        ),
        ("shows the reference when v is pressed twice", |window| {
            window.press("v")?;
            window.press("v")?;
            window.shows(SCENE, &["--renderer", "reference"])?;
            window.press("v")?;
            window.press("v")?;
            window.shows(SCENE, &[])
        }),
        ("shows another panel when N is pressed", |window| {
            window.press("shift+n")?;
            let panel = SCENE.replace("width = 320\nheight = 240", "panel = \"gba-240x160\"");
            window.shows(&panel, &[])?;
            window.press("n")?;
            window.shows(SCENE, &[])
        }),
        (
            "follows its file, and keeps the picture when that is wrong",
            |window| {
                let blue = SCENE.replace("#40c060", "#4060c0");
                window.save(&blue)?;
                window.shows(&blue, &[])?;
                window.save("[display]\nwidth = \"wide\"\n")?;
                window.says("scene.toml:2")?;
                window.shows(&blue, &[])
            },
        ),
        ("closes when q is pressed", Window::closes),
    ];
    for (what, check) in checks {
        let result = check(&mut window);
        tally.check(&format!("the window of fixel view {what}"), result);
    }
}

fn wires() -> String {
    SCENE.replace("[[actor]]", "[[actor]]\nrepresentation = \"wireframe\"")
}

/// Installs what is missing, where that can be done.
fn programs() -> Result<()> {
    if !cfg!(target_os = "linux") {
        return Err(Problem::Missing(
            "a virtual display is known on Linux only".into(),
        ));
    }
    let there = || {
        let listed = child::output(Command::new("/sbin/ldconfig").arg("-p")).unwrap_or_default();
        let programs = ["Xvfb", "xdotool"]
            .iter()
            .all(|p| debian::which(p).is_some());
        programs && LIBRARIES.iter().all(|library| listed.contains(library))
    };
    if there() {
        return Ok(());
    }
    if debian::can_install() {
        debian::install(&PACKAGES)?;
    }
    if there() {
        return Ok(());
    }
    Err(Problem::Missing(format!(
        "no virtual display: `apt-get install {}` would bring it on Debian",
        PACKAGES.join(" ")
    )))
}

/// A process that ends with its owner.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// `fixel view` on a display of its own.
struct Window {
    viewer: Process,
    fixel: PathBuf,
    folder: PathBuf,
    display: String,
    /// Where the panel's pixels are on the screen, once they were seen.
    corner: [usize; 2],
    _server: Process,
}

impl Window {
    fn open() -> Result<Self> {
        let fixel = build()?;
        let folder = paths::work("view")?;
        let fail = |what: &Path, error: std::io::Error| format!("{}: {error}", what.display());
        let server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-screen",
                "0",
                "1280x1024x24",
                "-nolisten",
                "tcp",
            ])
            .arg("-fbdir")
            .arg(&folder)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = Process(server.map_err(|error| fail(Path::new("Xvfb"), error))?);
        let mut number = String::new();
        if let Some(stdout) = server.0.stdout.take() {
            let read = BufReader::new(stdout).read_line(&mut number);
            read.map_err(|error| fail(Path::new("Xvfb"), error))?;
        }
        let display = format!(":{}", number.trim());
        let scene = folder.join("scene.toml");
        fixel_output::write(&scene, SCENE.as_bytes())?;
        let log = folder.join("log.txt");
        let errors = fs::File::create(&log).map_err(|error| fail(&log, error))?;
        let viewer = Command::new(&fixel)
            .args(["view", "scene.toml", "--zoom", &ZOOM.to_string()])
            .current_dir(&folder)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(errors)
            .spawn();
        Ok(Self {
            viewer: Process(viewer.map_err(|error| fail(&fixel, error))?),
            fixel,
            folder,
            display,
            corner: [0; 2],
            _server: server,
        })
    }

    /// Real input.
    fn input(&self, arguments: &[&str]) -> Result<()> {
        let mut command = Command::new("xdotool");
        command.args(arguments).env("DISPLAY", &self.display);
        child::visibly(&mut command)
    }

    /// There is no window manager that would give it the keys.
    fn focus(&mut self) -> Result<()> {
        let mut id = None;
        self.until("no window was seen", |window| {
            let mut search = Command::new("xdotool");
            search.args(["search", "--onlyvisible", "--name", " - fixel"]);
            let found = child::output(search.env("DISPLAY", &window.display));
            id = found.and_then(|ids| ids.lines().next().map(str::to_owned));
            Ok(id.is_some())
        })?;
        self.input(&["windowfocus", "--sync", &id.unwrap_or_default()])
    }

    fn press(&mut self, key: &str) -> Result<()> {
        self.input(&["key", key])
    }

    fn drag(&mut self) -> Result<()> {
        let [x, y] = self.corner.map(|at| at + 60);
        let to = |x: usize, y: usize| [x.to_string(), y.to_string()];
        let ([x0, y0], [x1, y1]) = (to(x, y), to(x + 50, y + 20));
        self.input(&["mousemove", &x0, &y0, "mousedown", "1"])?;
        self.input(&["mousemove", &x1, &y1, "mouseup", "1"])
    }

    fn save(&mut self, text: &str) -> Result<()> {
        Ok(fixel_output::write(
            &self.folder.join("scene.toml"),
            text.as_bytes(),
        )?)
    }

    /// Tries until it is so.
    fn until(
        &mut self,
        what: &str,
        mut check: impl FnMut(&mut Self) -> Result<bool>,
    ) -> Result<()> {
        let end = Instant::now() + PATIENCE;
        while !check(self)? {
            if Instant::now() > end {
                let log = fs::read_to_string(self.folder.join("log.txt")).unwrap_or_default();
                let folder = self.folder.display();
                return Err(format!(
                    "{what} within {} s; the screen is in {folder}; it said: {log}",
                    PATIENCE.as_secs()
                )
                .into());
            }
            thread::sleep(Duration::from_millis(50));
        }
        Ok(())
    }

    /// What `fixel render` draws of a scene.
    fn rendered(&self, scene: &str, words: &[&str]) -> Result<screen::Picture> {
        let (file, png) = (
            self.folder.join("other.toml"),
            self.folder.join("other.png"),
        );
        fixel_output::write(&file, scene.as_bytes())?;
        let mut command = Command::new(&self.fixel);
        command
            .arg("render")
            .arg(&file)
            .arg("-o")
            .arg(&png)
            .args(words);
        child::visibly(&mut command)?;
        screen::read_png(&png)
    }

    fn screen(&self) -> Result<screen::Picture> {
        screen::read_xwd(&self.folder.join("Xvfb_screen0"))
    }

    fn shows(&mut self, scene: &str, words: &[&str]) -> Result<()> {
        let wanted = self.rendered(scene, words)?.enlarged(ZOOM);
        self.until("the picture was not seen", |window| {
            let found = window.screen()?.find(&wanted);
            window.corner = found.unwrap_or(window.corner);
            Ok(found.is_some())
        })
    }

    /// Nothing of what was there, but something.
    fn shows_other_than(&mut self, scene: &str) -> Result<()> {
        let before = self.rendered(scene, &[])?.enlarged(ZOOM);
        self.until("the picture did not change", |window| {
            let now = window.screen()?.part(window.corner, &before);
            let colours = now.pixels.iter().collect::<std::collections::HashSet<_>>();
            Ok(now != before && colours.len() > 8)
        })
    }

    fn says(&mut self, wanted: &str) -> Result<()> {
        self.until("the mistake was not told", |window| {
            let log = fs::read_to_string(window.folder.join("log.txt"));
            Ok(log.unwrap_or_default().contains(wanted))
        })
    }

    fn closes(&mut self) -> Result<()> {
        self.press("q")?;
        let mut status = None;
        self.until("it did not close", |window| {
            status = window
                .viewer
                .0
                .try_wait()
                .map_err(|error| error.to_string())?;
            Ok(status.is_some())
        })?;
        match status {
            Some(status) if status.success() => Ok(()),
            status => Err(format!("it ended with {status:?}").into()),
        }
    }
}

/// The `fixel` command as the tests have it.
fn build() -> Result<PathBuf> {
    let mut command = Command::new("cargo");
    child::without_outer_package(&mut command);
    command
        .args(["build", "--quiet", "--profile", "test"])
        .args(["--package", "fixel-cli", "--bin", "fixel"])
        .current_dir(paths::root());
    child::visibly(&mut command)?;
    let folder = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let folder = folder.unwrap_or_else(|| paths::root().join("target"));
    Ok(folder.join("debug/fixel"))
}
