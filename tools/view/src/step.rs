//! Keys and mouse moves from a file, one a line, for tests:
//!
//! ```text
//! key w            a key: a letter, Left, Space, F1 ...
//! key Shift Left   with Shift
//! drag left 40 -5  the mouse, panel pixels to the right and down
//! wheel 2          turns of the wheel
//! seconds 0.5      time that the animation, or the bands, go on by
//! copy a b         a file takes another's place
//! reload           the file is loaded anew
//! panel a.png      the panel's pixels go to a file
//! window b.png     the window's
//! say              what is shown goes to standard output, and what is wrong
//! ```
//!
//! Each step but the first waits until the picture that the step before wants is there.

use std::path::{Path, PathBuf};

use crate::event::{Button, Event};
use crate::keys;

/// A line of a script.
#[derive(Debug)]
pub enum Step {
    /// What the user does.
    Do(Event),
    /// Writes the first file's bytes to the second.
    Copy(PathBuf, PathBuf),
    /// Loads the file anew.
    Reload,
    /// Writes the panel's pixels.
    Panel(PathBuf),
    /// Writes the window's pixels.
    Window(PathBuf),
    /// Prints what is shown and what is wrong.
    Say,
}

/// Reads a script.
///
/// # Errors
/// The first line that says nothing known.
pub fn read(path: &Path) -> Result<Vec<Step>, String> {
    let text = std::fs::read_to_string(path);
    let text = text.map_err(|error| format!("{}: {error}", path.display()))?;
    let lines = (1..).zip(text.lines());
    let lines = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    let step = |(number, line): (u32, &str)| {
        step(line).ok_or_else(|| {
            format!(
                "{}:{number}: `{line}` is unknown; expected e.g. key w, drag left 40 0, wheel 1, \
                 panel a.png",
                path.display()
            )
        })
    };
    lines.map(step).collect()
}

fn step(line: &str) -> Option<Step> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let number = |text: &str| text.parse::<f64>().ok().filter(|n| n.is_finite());
    Some(match *words.as_slice() {
        ["key", name] => Step::Do(Event::Key(keys::named(name)?, false)),
        ["key", "Shift", name] => Step::Do(Event::Key(keys::named(name)?, true)),
        ["drag", button, right, down] => {
            let button = match button {
                "left" => Button::Left,
                "middle" => Button::Middle,
                "right" => Button::Right,
                _ => return None,
            };
            Step::Do(Event::Drag(button, [number(right)?, number(down)?], false))
        }
        ["wheel", turns] => Step::Do(Event::Wheel(number(turns)?)),
        ["seconds", seconds] => Step::Do(Event::Tick(number(seconds)?, true)),
        ["copy", from, to] => Step::Copy(from.into(), to.into()),
        ["reload"] => Step::Reload,
        ["panel", file] => Step::Panel(file.into()),
        ["window", file] => Step::Window(file.into()),
        ["say"] => Step::Say,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        let lines = "# Says what.\nkey w\nkey Shift Left\n\ndrag right 1 -2\nwheel -1\nsay\n";
        std::fs::write(&path, lines).expect("room");
        assert_eq!(read(&path).expect("a script").len(), 5);
        for wrong in [
            "key",
            "key Lft",
            "drag up 1 1",
            "drag left 1 x",
            "jump",
            "wheel inf",
        ] {
            std::fs::write(&path, format!("key w\n{wrong}\n")).expect("room");
            let error = read(&path).expect_err("unknown");
            assert!(
                error.contains(&format!("a.txt:2: `{wrong}` is unknown")),
                "{error}"
            );
        }
        assert!(read(&folder.path().join("none")).is_err());
    }
}
