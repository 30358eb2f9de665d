//! The window: winit's events in, softbuffer's pixels out.

use std::num::NonZeroU32;
use std::rc::Rc;
use std::time::{Duration, Instant};

use softbuffer::{Context, Surface};
use winit::application::ApplicationHandler;
use winit::dpi::{PhysicalPosition, PhysicalSize};
use winit::event::{ElementState, MouseButton, MouseScrollDelta, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, OwnedDisplayHandle};
use winit::keyboard::{Key as WindowKey, NamedKey};
use winit::window::{Window, WindowId};

use crate::event::{Button, Event};
use crate::frame::{self, Look};
use crate::keys::Key;
use crate::view::{Going, Start, View};
use crate::worker::Reply;

/// Between two pictures of what moves, and between looks at what does not.
const MOVING: Duration = Duration::from_millis(16);
const STILL: Duration = Duration::from_millis(80);
/// What a first window is at most, in pixels at a scale of 1.
const FIRST: [u32; 2] = [1120, 800];
/// Pixels of a touchpad's scrolling that are a turn of a wheel.
const SCROLL: f64 = 60.0;

/// Shows a window until it is closed.
///
/// # Errors
/// If there is no display, or a script's picture cannot be written.
pub fn run(start: Start) -> Result<(), String> {
    let no_display = |error: &dyn std::fmt::Display| {
        let why = reason(&error.to_string());
        format!(
            "no window can be opened: {why}; expected a display (X11 or Wayland on Linux), \
             or fixel render, which needs none"
        )
    };
    let events = EventLoop::<Reply>::with_user_event().build();
    let events = events.map_err(|error| no_display(&error))?;
    let context = Context::new(events.owned_display_handle());
    let context = context.map_err(|error| no_display(&error))?;
    let proxy = events.create_proxy();
    // Nobody listens any more when the window is closed.
    let reply = move |reply| drop(proxy.send_event(reply));
    let mut app = App {
        zoom: start.zoom,
        view: View::new(start, reply),
        context,
        shown: None,
        shift: false,
        button: None,
        mouse: PhysicalPosition::default(),
        last: Instant::now(),
        problem: None,
    };
    let ran = events.run_app(&mut app);
    ran.map_err(|error| no_display(&error))?;
    app.problem.map_or(Ok(()), Err)
}

/// What winit says, without the place in its own source.
fn reason(error: &str) -> String {
    let place = error.strip_prefix("os error at ");
    let why = place.and_then(|place| place.split_once(": "));
    let why = why.map_or(error, |(_, why)| why);
    why.trim_end_matches('.').to_owned()
}

type Pixels = Surface<OwnedDisplayHandle, Rc<Window>>;

struct App {
    view: View,
    context: Context<OwnedDisplayHandle>,
    zoom: Option<u32>,
    shown: Option<(Rc<Window>, Pixels)>,
    shift: bool,
    /// The one that is down.
    button: Option<Button>,
    mouse: PhysicalPosition<f64>,
    last: Instant,
    problem: Option<String>,
}

impl App {
    fn look(&self) -> Option<Look> {
        let (window, _) = self.shown.as_ref()?;
        let size = window.inner_size();
        Some(Look {
            size: [size.width.max(1), size.height.max(1)],
            scale: scale(window.scale_factor()),
            zoom: self.zoom,
        })
    }

    fn redraw(&self) {
        if let Some((window, _)) = &self.shown {
            window.request_redraw();
        }
    }

    fn open(&mut self, events: &ActiveEventLoop) -> Result<(), String> {
        let panel = self.view.state.size();
        let monitor = events.primary_monitor();
        let scale = scale(monitor.map_or(1.0, |monitor| monitor.scale_factor()));
        let most = FIRST.map(|side| side * scale);
        let zoom = self
            .zoom
            .unwrap_or_else(|| frame::fitting(panel, scale, most, true));
        let [width, height] = frame::wanted(panel, scale, zoom);
        let attributes = Window::default_attributes()
            .with_title(self.view.title())
            .with_inner_size(PhysicalSize::new(width, height));
        let window = events
            .create_window(attributes)
            .map_err(|e| e.to_string())?;
        let window = Rc::new(window);
        let surface = Surface::new(&self.context, Rc::clone(&window));
        self.shown = Some((window, surface.map_err(|e| e.to_string())?));
        Ok(())
    }

    fn paint(&mut self) -> Result<(), String> {
        let (Some(look), Some((_, surface))) = (self.look(), &mut self.shown) else {
            return Ok(());
        };
        let [Some(width), Some(height)] = look.size.map(NonZeroU32::new) else {
            return Ok(());
        };
        surface.resize(width, height).map_err(|e| e.to_string())?;
        let canvas = self.view.frame(&look);
        let mut buffer = surface.buffer_mut().map_err(|e| e.to_string())?;
        let length = buffer.len().min(canvas.pixels.len());
        buffer[..length].copy_from_slice(&canvas.pixels[..length]);
        buffer.present().map_err(|e| e.to_string())
    }

    fn handle(&mut self, events: &ActiveEventLoop, event: Event) {
        if self.view.handle(event) {
            events.exit();
        }
        self.redraw();
    }

    /// Ends the program if something went wrong.
    fn check(&mut self, events: &ActiveEventLoop, result: Result<(), String>) {
        if let Err(problem) = result {
            self.problem = Some(problem);
            events.exit();
        }
    }

    fn script(&mut self, events: &ActiveEventLoop) {
        let Some(look) = self.look() else {
            return;
        };
        let gone = self.view.go_on(&look);
        if gone == Ok(Some(Going::Ends)) {
            events.exit();
        }
        self.check(events, gone.map(|_| ()));
    }

    fn dragged(&mut self, events: &ActiveEventLoop, to: PhysicalPosition<f64>) {
        let from = std::mem::replace(&mut self.mouse, to);
        if let (Some(button), Some(look)) = (self.button, self.look()) {
            let place = frame::place(&self.view.state, &look).rect;
            let by = [
                (to.x - from.x) / f64::from(place.width.max(1)),
                (to.y - from.y) / f64::from(place.height.max(1)),
            ];
            self.handle(events, Event::Drag(button, by, self.shift));
        }
    }
}

impl ApplicationHandler<Reply> for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.shown.is_none() {
            let opened = self.open(events);
            self.check(events, opened);
        }
    }

    fn user_event(&mut self, events: &ActiveEventLoop, reply: Reply) {
        if self.view.receive(reply) {
            self.redraw();
        }
        self.script(events);
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        let pause = if self.view.state.is_moving() {
            MOVING
        } else {
            STILL
        };
        let now = Instant::now();
        let gone = now - self.last;
        if gone >= pause {
            self.last = now;
            if self.view.tick(gone.as_secs_f64()) {
                self.redraw();
            }
        }
        events.set_control_flow(ControlFlow::WaitUntil(self.last + pause));
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::RedrawRequested => {
                let painted = self.paint();
                self.check(events, painted);
            }
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => self.redraw(),
            WindowEvent::ModifiersChanged(now) => self.shift = now.state().shift_key(),
            WindowEvent::KeyboardInput { event, .. } if event.state == ElementState::Pressed => {
                if let Some(key) = key(&event.logical_key) {
                    self.handle(events, Event::Key(key, self.shift));
                }
            }
            WindowEvent::MouseInput { state, button, .. } => {
                let button = match button {
                    MouseButton::Left => Button::Left,
                    MouseButton::Middle => Button::Middle,
                    MouseButton::Right => Button::Right,
                    _ => return,
                };
                self.button = (state == ElementState::Pressed).then_some(button);
            }
            WindowEvent::CursorMoved { position, .. } => self.dragged(events, position),
            WindowEvent::MouseWheel { delta, .. } => {
                let turns = match delta {
                    MouseScrollDelta::LineDelta(_, lines) => lines.into(),
                    MouseScrollDelta::PixelDelta(by) => by.y / SCROLL,
                };
                self.handle(events, Event::Wheel(turns));
            }
            _ => {}
        }
    }
}

fn scale(factor: f64) -> u32 {
    (factor.round() as u32).clamp(1, 4)
}

fn key(key: &WindowKey) -> Option<Key> {
    Some(match key {
        WindowKey::Character(text) => Key::Char(text.chars().next()?),
        WindowKey::Named(NamedKey::Space) => Key::Char(' '),
        WindowKey::Named(NamedKey::ArrowLeft) => Key::Left,
        WindowKey::Named(NamedKey::ArrowRight) => Key::Right,
        WindowKey::Named(NamedKey::ArrowUp) => Key::Up,
        WindowKey::Named(NamedKey::ArrowDown) => Key::Down,
        WindowKey::Named(NamedKey::Escape) => Key::Escape,
        WindowKey::Named(NamedKey::Tab) => Key::Tab,
        WindowKey::Named(NamedKey::F1) => Key::F1,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reason_names_no_source_file() {
        let said = "os error at /a b/winit-0.30/src/mod.rs:765: neither DISPLAY nor X: is set.";
        assert_eq!(reason(said), "neither DISPLAY nor X: is set");
        assert_eq!(reason("no such thing"), "no such thing");
    }
}
