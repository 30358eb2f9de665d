//! State, worker, file and script together, for whoever has a window, and for who has none.

use std::collections::VecDeque;
use std::path::PathBuf;

use crate::canvas::Canvas;
use crate::draw::Picture;
use crate::event::{Effect, Event};
use crate::frame::{self, Look};
use crate::source::Loader;
use crate::state::State;
use crate::step::Step;
use crate::variant::Job;
use crate::watch::Watch;
use crate::worker::{Reply, Worker};

/// Seconds between looks at the files.
const LOOK: f64 = 0.15;

/// What a view begins with.
pub struct Start {
    /// What the user sees first.
    pub state: State,
    /// How the file is loaded anew.
    pub load: Loader,
    /// The file.
    pub path: PathBuf,
    /// Window pixels that a panel pixel takes; none: as many as fit.
    pub zoom: Option<u32>,
    /// The script, if there is one.
    pub steps: Vec<Step>,
}

/// All but the window.
pub struct View {
    /// What the user sees.
    pub state: State,
    name: String,
    picture: Option<Picture>,
    worker: Worker,
    asked: Option<Job>,
    /// The job that could not be done, so that it is not asked for again and again.
    failed: Option<Job>,
    watch: Watch,
    since_look: f64,
    loading: bool,
    steps: VecDeque<Step>,
    scripted: bool,
}

/// How a script goes on.
#[derive(Debug, PartialEq, Eq)]
pub enum Going {
    /// It waits for a picture.
    Waits,
    /// The window is to be closed.
    Ends,
}

impl View {
    /// Begins to draw; `reply` gets to [`View::receive`] what the worker says.
    pub fn new(start: Start, reply: impl Fn(Reply) + Send + 'static) -> Self {
        let Start {
            mut state,
            load,
            path,
            steps,
            ..
        } = start;
        if !steps.is_empty() {
            // What is tested does not hang on time.
            state.pause();
        }
        let stem = path.file_stem().unwrap_or_default();
        let mut view = Self {
            state,
            name: stem.to_string_lossy().into_owned(),
            picture: None,
            watch: Watch::new(&path),
            worker: Worker::start(path, load, reply),
            asked: None,
            failed: None,
            since_look: 0.0,
            loading: false,
            scripted: !steps.is_empty(),
            steps: steps.into(),
        };
        view.ask();
        view
    }

    /// The window's title.
    pub fn title(&self) -> String {
        format!("{} - fixel", self.name)
    }

    /// Asks for the picture that is wanted now.
    fn ask(&mut self) {
        let job = self.state.job();
        if self.asked.as_ref() != Some(&job) {
            self.worker.draw(job.clone());
            self.asked = Some(job);
            self.failed = None;
        }
    }

    /// Whether what is shown is what is wanted, or cannot be had.
    pub fn is_settled(&self) -> bool {
        let job = Some(&self.asked).and_then(Option::as_ref);
        let drawn = self.picture.as_ref().filter(|picture| picture.whole);
        !self.loading && (drawn.map(|picture| &picture.job) == job || self.failed.as_ref() == job)
    }

    /// Takes in what the worker says; whether the window is to be drawn anew.
    pub fn receive(&mut self, reply: Reply) -> bool {
        match reply {
            Reply::Picture(picture) => {
                let wanted = Some(&picture.job) == self.asked.as_ref();
                // A coarse picture of what was wanted before is no news.
                if !wanted && !picture.whole {
                    return false;
                }
                if wanted {
                    self.state.handle(Event::Drawn);
                }
                self.picture = Some(*picture);
            }
            Reply::Failed(job, error) => {
                if Some(job.as_ref()) != self.asked.as_ref() {
                    return false;
                }
                eprintln!("fixel: {error}");
                self.failed = Some(*job);
                self.state.handle(Event::Failed(error));
            }
            Reply::Loaded(loaded) => {
                self.loading = false;
                if let Err(error) = &loaded {
                    eprintln!("fixel: {error}");
                }
                self.state.handle(Event::Loaded(loaded));
                self.ask();
            }
        }
        true
    }

    /// Lets time go by; whether the window is to be drawn anew.
    pub fn tick(&mut self, seconds: f64) -> bool {
        self.since_look += seconds;
        if self.since_look >= LOOK {
            self.since_look = 0.0;
            if self.watch.poll() {
                self.loading = true;
                self.worker.load();
            }
        }
        let moving = self.state.is_moving();
        let settled = self.is_settled();
        self.state.handle(Event::Tick(seconds, settled));
        self.ask();
        moving
    }

    /// Takes in what the user does; whether to close.
    pub fn handle(&mut self, event: Event) -> bool {
        let effect = self.state.handle(event);
        self.ask();
        match effect {
            Some(Effect::Quit) => return true,
            Some(Effect::Print(text)) => print!("{text}"),
            Some(Effect::Screenshot) => self.screenshot(),
            None => {}
        }
        false
    }

    /// Writes the panel's pixels beside earlier ones in the current folder.
    fn screenshot(&mut self) {
        let name = |number: u32| PathBuf::from(format!("{}-{number}.png", self.name));
        let free = (1..10_000).map(name).find(|path| !path.exists());
        let said = match free
            .ok_or_else(|| "too many pictures".into())
            .and_then(|path| {
                self.write_panel(&path)?;
                Ok::<_, String>(path)
            }) {
            Ok(path) => format!("wrote {}", path.display()),
            Err(error) => error,
        };
        eprintln!("{said}");
        self.state.say(said);
    }

    fn write_panel(&self, path: &std::path::Path) -> Result<(), String> {
        let picture = self.picture.as_ref().ok_or("nothing is drawn yet")?;
        let png = fixel_output::png_rgb(picture.width, picture.height, &picture.rgb);
        fixel_output::write(path, &png.map_err(|error| error.to_string())?)?;
        Ok(())
    }

    /// The window's pixels.
    pub fn frame(&self, look: &Look) -> Canvas {
        frame::draw(&self.state, self.picture.as_ref(), look)
    }

    /// Goes on in the script as far as it goes; none if there is no script.
    ///
    /// # Errors
    /// If a picture cannot be written.
    pub fn go_on(&mut self, look: &Look) -> Result<Option<Going>, String> {
        if !self.scripted {
            return Ok(None);
        }
        while self.is_settled() {
            match self.steps.pop_front() {
                None => return Ok(Some(Going::Ends)),
                Some(Step::Do(event)) => {
                    if self.handle(in_parts(event, self.state.size())) {
                        return Ok(Some(Going::Ends));
                    }
                }
                Some(Step::Copy(from, to)) => {
                    let bytes = std::fs::read(&from);
                    let bytes = bytes.map_err(|error| format!("{}: {error}", from.display()))?;
                    fixel_output::write(&to, &bytes)?;
                }
                Some(Step::Reload) => {
                    self.loading = true;
                    self.worker.load();
                }
                Some(Step::Panel(path)) => self.write_panel(&path)?,
                Some(Step::Window(path)) => {
                    let canvas = self.frame(look);
                    let bytes = |pixel: &u32| {
                        let [_, rgb @ ..] = pixel.to_be_bytes();
                        rgb
                    };
                    let rgb: Vec<[u8; 3]> = canvas.pixels.iter().map(bytes).collect();
                    let png = fixel_output::png_rgb(canvas.width, canvas.height, &rgb);
                    fixel_output::write(&path, &png.map_err(|error| error.to_string())?)?;
                }
                Some(Step::Say) => {
                    println!("{}", self.state.headline());
                    println!("{}", self.state.error().unwrap_or("no error"));
                }
            }
        }
        Ok(Some(Going::Waits))
    }
}

/// A script's ways of the mouse are in pixels of the panel.
fn in_parts(event: Event, size: [u32; 2]) -> Event {
    match event {
        Event::Drag(button, [right, down], shift) => {
            let [width, height] = size.map(f64::from);
            Event::Drag(button, [right / width, down / height], shift)
        }
        other => other,
    }
}
