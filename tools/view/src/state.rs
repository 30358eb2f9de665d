//! What the user sees and how keys and mouse change it; knows no window.

mod names;

use std::sync::Arc;

use fixel_estimate::{BOARDS, Board};
use fixel_reference::camera_at;
use fixel_scene::{
    Camera, DITHERINGS, Display, PANELS, PanelDithering, Reach, Scene, Screen, Stereo,
};

use crate::camera;
use crate::event::{Button, Effect, Event};
use crate::keys::{self, Action};
use crate::source::Source;
use crate::variant::{Job, Renderer, Show, Variant};

/// Frames of an animation a second, as `fixel animate` has them.
const FRAMES_A_SECOND: f64 = 25.0;
/// Rows of a band, where bands are shown one by one.
pub const BAND_ROWS: u32 = 16;
/// Bands a second there.
const BANDS_A_SECOND: f64 = 12.0;
/// Degrees of an arrow key's turn, of the 200 of a picture's width.
const STEP: f64 = 5.0 / 200.0;
/// Part of the picture's height that an arrow key pans.
const PAN_STEP: f64 = 0.05;
/// How far a turn of the wheel goes: VTK's.
const WHEEL: f64 = 1.21;
/// How far a drag over the picture's height goes: VTK's, `1.1^20`.
const DRAG: f64 = 6.727_5;

/// What the user sees.
#[derive(Debug)]
pub struct State {
    source: Arc<Source>,
    reach: Reach,
    variant: Variant,
    camera: Option<Camera>,
    frame: u32,
    renderer: Renderer,
    show: Show,
    board: &'static Board,
    playing: bool,
    /// Seconds since the frame changed.
    since_frame: f64,
    /// Seconds since the first band, if bands are shown one by one.
    since_band: Option<f64>,
    help: bool,
    figures: bool,
    /// Of the file; of the picture.
    errors: [Option<String>; 2],
    note: Option<String>,
}

impl State {
    /// A scene as its file has it.
    pub fn new(source: Arc<Source>) -> Self {
        Self {
            reach: Reach::of(&source.scene),
            source,
            variant: Variant::default(),
            camera: None,
            frame: 0,
            renderer: Renderer::default(),
            show: Show::default(),
            board: &BOARDS[0],
            playing: true,
            since_frame: 0.0,
            since_band: None,
            help: false,
            figures: true,
            errors: [None, None],
            note: None,
        }
    }

    /// Begins on a panel.
    pub fn choose_screen(&mut self, screen: Screen) {
        let name = screen.panel.name;
        self.variant.panel = PANELS.iter().position(|panel| panel.name == name);
        self.variant.dithering = screen.dithering;
    }

    /// Begins with a renderer.
    pub fn choose_renderer(&mut self, renderer: Renderer) {
        self.renderer = renderer;
    }

    /// Begins with a board.
    pub fn choose_board(&mut self, board: &'static Board) {
        self.board = board;
    }

    /// Begins standing still.
    pub fn pause(&mut self) {
        self.playing = false;
    }

    /// The picture that is wanted.
    pub fn job(&self) -> Job {
        Job {
            source: Arc::clone(&self.source),
            variant: self.variant,
            camera: self.camera,
            frame: self.frame,
            renderer: self.renderer,
            show: self.show,
            board: self.board,
        }
    }

    /// The scene as it is in its file.
    pub fn scene(&self) -> &Scene {
        &self.source.scene
    }

    /// Whether time changes anything.
    pub fn is_moving(&self) -> bool {
        self.since_band.is_some() || self.playing && self.length().is_some()
    }

    /// How many bands of how many rows are there, if they are shown one by one.
    pub fn bands(&self) -> Option<u32> {
        self.since_band.map(|since| (since * BANDS_A_SECOND) as u32)
    }

    /// Whether the keys are shown.
    pub fn help(&self) -> bool {
        self.help
    }

    /// Whether the figures are shown.
    pub fn figures(&self) -> bool {
        self.figures
    }

    /// What is wrong with the file, or with the picture.
    pub fn error(&self) -> Option<&str> {
        self.errors.iter().flatten().next().map(String::as_str)
    }

    /// What was done last.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// Says what was done.
    pub fn say(&mut self, what: String) {
        self.note = Some(what);
    }

    /// What is shown, in words.
    pub fn headline(&self) -> String {
        let display = &self.display();
        let panel = match self.variant.panel.and_then(|panel| PANELS.get(panel)) {
            Some(panel) => panel.name.to_owned(),
            None => format!("{}x{}", display.width, display.height),
        };
        let mut words = vec![panel, format!("{:?}", display.colour).to_lowercase()];
        if display.colour.is_dithered() {
            words.push(names::dithering(display.dithering).into());
        }
        words.push(format!("by {}", self.renderer.name()));
        words.extend(
            self.variant
                .representation
                .map(|r| names::representation(r).into()),
        );
        if self.is_stereo() {
            words.push("stereo".into());
        }
        let shown = match self.show {
            Show::Picture => None,
            Show::Depth => Some("depth"),
            Show::Actors => Some("ids"),
            Show::Meshlets => Some("meshlets"),
            Show::Overdraw => Some("overdraw"),
        };
        words.extend(shown.map(|shown| format!("showing {shown}")));
        if let Some(length) = self.length() {
            let paused = if self.playing { "" } else { ", paused" };
            words.push(format!("frame {} of {length}{paused}", self.frame));
        }
        words.join(", ")
    }

    fn length(&self) -> Option<u32> {
        self.scene().animation.length()
    }

    /// Takes in what happens; says what has to be done outside.
    pub fn handle(&mut self, event: Event) -> Option<Effect> {
        match event {
            Event::Key(key, shift) => {
                let action = keys::action(key, shift)?;
                self.note = None;
                return self.act(action);
            }
            Event::Drag(button, by, shift) => match (button, shift) {
                (Button::Left, false) => self.rotate(by),
                (Button::Middle, _) | (Button::Left, true) => self.pan(by),
                (Button::Right, _) => self.zoom(DRAG.powf(-by[1])),
            },
            Event::Wheel(turns) => self.zoom(WHEEL.powf(turns)),
            Event::Tick(seconds, drawn) => self.tick(seconds, drawn),
            Event::Loaded(Ok(source)) => {
                self.reach = Reach::of(&source.scene);
                self.source = source;
                self.errors = [None, None];
                self.refit();
            }
            Event::Loaded(Err(error)) => self.errors[0] = Some(error),
            Event::Failed(error) => self.errors[1] = Some(error),
            Event::Drawn => self.errors[1] = None,
        }
        None
    }

    fn act(&mut self, action: Action) -> Option<Effect> {
        match action {
            Action::Represent(what) => self.variant.representation = Some(what),
            Action::Reset => self.camera = None,
            Action::Stereo => self.variant.stereo = Some(!self.is_stereo()),
            Action::Rotate(way) => self.rotate(way.map(|steps| steps * STEP)),
            Action::Pan(way) => self.pan_by_height(way.map(|steps| steps * PAN_STEP)),
            Action::Zoom(factor) => self.zoom(factor),
            Action::Renderer => self.renderer = after(&Renderer::ALL, self.renderer),
            Action::Panel(by) => self.next_panel(by),
            Action::Board(by) => self.next_board(by),
            Action::Dither => self.next_dithering(),
            Action::Show(what) => {
                let again = self.show == what;
                self.show = if again { Show::Picture } else { what };
            }
            Action::Bands => {
                self.since_band = match self.since_band {
                    Some(_) => None,
                    None => Some(0.0),
                };
            }
            Action::Pause => self.playing = !self.playing,
            Action::Step(by) => {
                self.playing = false;
                self.advance(by);
            }
            Action::Camera => {
                self.note = Some("the camera is on standard output".into());
                return Some(Effect::Print(camera::text(&self.camera_now())));
            }
            Action::Screenshot => return Some(Effect::Screenshot),
            Action::Help => self.help = !self.help,
            Action::Figures => self.figures = !self.figures,
            Action::Quit if self.help => self.help = false,
            Action::Quit => return Some(Effect::Quit),
        }
        None
    }

    /// The camera as it is seen through.
    fn camera_now(&self) -> Camera {
        self.camera
            .unwrap_or_else(|| camera_at(self.scene(), self.frame))
    }

    fn change_camera(&mut self, change: impl FnOnce(&mut Camera, &Reach)) {
        let mut camera = self.camera_now();
        change(&mut camera, &self.reach);
        self.camera = Some(camera);
        self.refit();
    }

    /// Near and far planes around all that there is.
    fn refit(&mut self) {
        if let Some(camera) = &mut self.camera {
            camera.clipping_range = self.reach.clipping_range(camera);
        }
    }

    fn rotate(&mut self, [right, down]: [f64; 2]) {
        self.change_camera(|camera, _| camera::rotate(camera, right, down));
    }

    /// Parts of the picture's width and height.
    fn pan(&mut self, [right, down]: [f64; 2]) {
        let [width, height] = self.size();
        self.pan_by_height([right * f64::from(width) / f64::from(height), down]);
    }

    fn pan_by_height(&mut self, [right, down]: [f64; 2]) {
        self.change_camera(|camera, _| camera::pan(camera, right, down));
    }

    fn zoom(&mut self, factor: f64) {
        self.change_camera(|camera, reach| camera::zoom(camera, factor, reach));
    }

    fn is_stereo(&self) -> bool {
        let own = self.scene().display.stereo != Stereo::None;
        self.variant.stereo.unwrap_or(own)
    }

    /// The panel that is shown.
    fn display(&self) -> Display {
        self.variant.display(&self.scene().display)
    }

    /// Its width and height.
    pub fn size(&self) -> [u32; 2] {
        let display = self.display();
        [display.width, display.height]
    }

    /// All panels, and the file's own display between the last and the first.
    fn next_panel(&mut self, by: i32) {
        let count = PANELS.len() as i32 + 1;
        let now = self.variant.panel.map_or(0, |panel| panel as i32 + 1);
        let next = (now + by).rem_euclid(count);
        self.variant.panel = usize::try_from(next - 1).ok();
        self.variant.dithering = None;
    }

    fn next_board(&mut self, by: i32) {
        let now = BOARDS
            .iter()
            .position(|board| board.name == self.board.name);
        let next = (now.unwrap_or(0) as i32 + by).rem_euclid(BOARDS.len() as i32);
        self.board = &BOARDS[next as usize];
        self.note = Some(format!("{}: {}", self.board.name, self.board.what));
    }

    fn next_dithering(&mut self) {
        let display = self.display();
        if display.colour.is_dithered() {
            let ways: Vec<PanelDithering> = DITHERINGS.iter().map(|(_, way)| *way).collect();
            let next = after(&ways, display.dithering);
            self.variant.dithering = Some(next);
        } else {
            self.note =
                Some("t dithers on grey panels of 2, 4 and 16 levels (n: next panel)".into());
        }
    }

    fn advance(&mut self, by: i32) {
        let frame = i64::from(self.frame) + i64::from(by);
        let length = i64::from(self.length().unwrap_or(1).max(1));
        self.frame = frame.rem_euclid(length) as u32;
    }

    fn tick(&mut self, seconds: f64, drawn: bool) {
        if let Some(since) = &mut self.since_band {
            if drawn {
                *since += seconds;
            }
            // All of them, and the whole for as long as two.
            let bands = self.size()[1].div_ceil(BAND_ROWS) + 2;
            if self.bands() > Some(bands) {
                self.since_band = Some(0.0);
                if self.playing {
                    self.advance(1);
                }
            }
            return;
        }
        if !self.is_moving() {
            return;
        }
        self.since_frame += seconds;
        // What takes longer to draw is shown slower, not in jumps.
        if drawn && self.since_frame >= 1.0 / FRAMES_A_SECOND {
            self.since_frame = (self.since_frame - 1.0 / FRAMES_A_SECOND).min(0.02);
            self.advance(1);
        }
    }
}

/// The next of a list, after the last the first.
fn after<T: Copy + PartialEq>(all: &[T], now: T) -> T {
    let place = all.iter().position(|one| *one == now).unwrap_or(0);
    all.get(place + 1).or(all.first()).copied().unwrap_or(now)
}

#[cfg(test)]
mod tests;
