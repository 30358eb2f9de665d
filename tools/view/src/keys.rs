//! Which key does what: one table for doing it and for saying it.

/// What a key can ask for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Draw every actor by its surface, edges, hidden edges or points.
    Represent(fixel_scene::Representation),
    /// The camera as the file has it, from the first frame.
    Reset,
    /// Two eyes, or one.
    Stereo,
    /// Turn the eye, in steps to the right and down.
    Rotate([f64; 2]),
    /// Move the eye, in steps to the right and down.
    Pan([f64; 2]),
    /// Nearer: above 1.
    Zoom(f64),
    /// The next way to render.
    Renderer,
    /// The next panel, or the one before.
    Panel(i32),
    /// The next board that is reckoned with, or the one before.
    Board(i32),
    /// The next way to dither on a grey panel.
    Dither,
    /// Something else instead of the picture, or the picture again.
    Show(super::variant::Show),
    /// Bands drawn one by one, or all at once.
    Bands,
    /// Stop and go on.
    Pause,
    /// A frame on or back.
    Step(i32),
    /// Print the camera.
    Camera,
    /// Write the panel's pixels to a file.
    Screenshot,
    /// Show or hide the keys.
    Help,
    /// Show or hide the figures.
    Figures,
    /// Close the window.
    Quit,
}

/// A key of the keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// What it writes.
    Char(char),
    /// An arrow.
    Left,
    /// An arrow.
    Right,
    /// An arrow.
    Up,
    /// An arrow.
    Down,
    /// Escape.
    Escape,
    /// Tab.
    Tab,
    /// F1.
    F1,
}

/// A row of the table: keys as they are shown, and what they do.
pub struct Row {
    /// How they are called.
    pub keys: &'static str,
    /// What they do.
    pub what: &'static str,
}

/// For the page of help, in two columns.
pub const HELP: [Row; 27] = {
    const fn row(keys: &'static str, what: &'static str) -> Row {
        Row { keys, what }
    }
    [
        row("drag", "rotate"),
        row("middle, Shift drag", "pan"),
        row("wheel, right drag", "zoom"),
        row("arrows", "rotate, with Shift pan"),
        row("+  -", "zoom"),
        row("r", "reset the camera"),
        row("c", "print the camera"),
        row("s", "surface"),
        row("w", "wireframe"),
        row("h", "hidden lines"),
        row("p", "points"),
        row("3", "stereo: red and cyan"),
        row("v", "raster, ray, reference"),
        row("n  N", "next panel, one before"),
        row("k  K", "next board, one before"),
        row("t", "dithering of a grey panel"),
        row("d", "depth"),
        row("i", "ids: actors"),
        row("m", "meshlets"),
        row("o", "overdraw"),
        row("b", "bands one by one"),
        row("Space", "pause, go on"),
        row(".  ,", "a frame on, a frame back"),
        row("x", "save the panel's picture"),
        row("Tab", "figures"),
        row("?  F1", "these keys"),
        row("q  e  Esc", "quit"),
    ]
};

/// What a key asks for.
pub fn action(key: Key, shift: bool) -> Option<Action> {
    use super::variant::Show;
    use fixel_scene::Representation::{HiddenLine, Points, Surface, Wireframe};
    let arrow = |way: [f64; 2]| {
        if shift {
            Action::Pan(way)
        } else {
            Action::Rotate(way)
        }
    };
    Some(match key {
        Key::Char('w') => Action::Represent(Wireframe),
        Key::Char('s') => Action::Represent(Surface),
        Key::Char('h') => Action::Represent(HiddenLine),
        Key::Char('p') => Action::Represent(Points),
        Key::Char('r') => Action::Reset,
        Key::Char('3') => Action::Stereo,
        Key::Left => arrow([-1.0, 0.0]),
        Key::Right => arrow([1.0, 0.0]),
        Key::Up => arrow([0.0, -1.0]),
        Key::Down => arrow([0.0, 1.0]),
        Key::Char('+' | '=') => Action::Zoom(1.1),
        Key::Char('-' | '_') => Action::Zoom(1.0 / 1.1),
        Key::Char('v') => Action::Renderer,
        Key::Char('n') => Action::Panel(1),
        Key::Char('N') => Action::Panel(-1),
        Key::Char('k') => Action::Board(1),
        Key::Char('K') => Action::Board(-1),
        Key::Char('t') => Action::Dither,
        Key::Char('d') => Action::Show(Show::Depth),
        Key::Char('i') => Action::Show(Show::Actors),
        Key::Char('m') => Action::Show(Show::Meshlets),
        Key::Char('o') => Action::Show(Show::Overdraw),
        Key::Char('b') => Action::Bands,
        Key::Char(' ') => Action::Pause,
        Key::Char('.') => Action::Step(1),
        Key::Char(',') => Action::Step(-1),
        Key::Char('c') => Action::Camera,
        Key::Char('x') => Action::Screenshot,
        Key::Char('?' | '/') | Key::F1 => Action::Help,
        Key::Tab => Action::Figures,
        Key::Char('q' | 'e') | Key::Escape => Action::Quit,
        Key::Char(_) => return None,
    })
}

/// A key by its name in a script: what it writes, or `Left`, `Space`, `F1` and so on.
pub fn named(name: &str) -> Option<Key> {
    let mut letters = name.chars();
    Some(match (name, letters.next(), letters.next()) {
        (_, Some(letter), None) => Key::Char(letter),
        ("Space", ..) => Key::Char(' '),
        ("Left", ..) => Key::Left,
        ("Right", ..) => Key::Right,
        ("Up", ..) => Key::Up,
        ("Down", ..) => Key::Down,
        ("Esc", ..) => Key::Escape,
        ("Tab", ..) => Key::Tab,
        ("F1", ..) => Key::F1,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever the help names does something.
    #[test]
    fn the_help_is_right() {
        let mut named_keys = 0;
        for row in HELP {
            for word in row.keys.split_whitespace() {
                let mouse = ["drag", "middle,", "Shift", "wheel,", "right", "arrows"];
                if mouse.contains(&word) {
                    continue;
                }
                let key = named(word);
                let does = key.and_then(|key| action(key, false));
                assert!(does.is_some(), "{word}");
                named_keys += 1;
            }
        }
        assert_eq!(named_keys, 30);
        assert_eq!(action(Key::Char('y'), false), None);
        assert_eq!(action(Key::Left, true), Some(Action::Pan([-1.0, 0.0])));
        assert_eq!(named("Left"), Some(Key::Left));
        assert_eq!(named("Lft"), None);
    }
}
