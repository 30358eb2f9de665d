//! Frames from a target: the host's program and the firmware in an emulator
//! print the same lines (`targets/runner`), and are driven alike.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use serde::Deserialize;

use crate::board::{self, BOARDS, Board};
use crate::firmware::{self, HostProfile};
use crate::problem::{Problem, Result};
use crate::report::Tally;
use crate::scene::Baked;
use crate::{child, emulator, parallel};

/// A run on the host that takes longer hangs.
const HOST_LIMIT: Duration = Duration::from_secs(300);
/// One band, however high the picture.
pub const ONE_BAND: u32 = 4096;

/// Where frames are rendered.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    /// This machine.
    Host(HostProfile),
    /// A board in its emulator.
    Board(&'static Board),
}

impl Target {
    /// The name in figures.
    pub fn name(self) -> &'static str {
        match self {
            Self::Host(HostProfile::Release) => "host",
            Self::Host(HostProfile::Checked) => "host-checked",
            Self::Board(board) => board.name,
        }
    }

    /// The host, then every board that is measured.
    pub fn measured() -> Vec<Self> {
        let boards = BOARDS.iter().map(Self::Board);
        std::iter::once(Self::Host(HostProfile::Release))
            .chain(boards)
            .collect()
    }

    /// The host, also as it is checked, and every board.
    pub fn all() -> Vec<Self> {
        let profiles = [HostProfile::Release, HostProfile::Checked];
        let hosts = profiles.into_iter().map(Self::Host);
        hosts.chain(board::all().map(Self::Board)).collect()
    }

    /// The host and these boards, or all if there are none.
    pub fn all_or_on(boards: &[&'static Board]) -> Vec<Self> {
        if boards.is_empty() {
            return Self::all();
        }
        let host = std::iter::once(Self::Host(HostProfile::Release));
        host.chain(boards.iter().copied().map(Self::Board))
            .collect()
    }

    /// Whether a scene is compared there, if no scene is asked for.
    pub fn takes(self, scene: &str) -> bool {
        match self {
            Self::Host(_) => true,
            Self::Board(board) => board.takes(scene),
        }
    }

    /// Builds the program, and gets what it needs.
    pub fn prepare(self) -> Result<Ready> {
        let program = match self {
            Self::Host(profile) => firmware::host(profile)?,
            Self::Board(board) => {
                let program = firmware::measuring(board)?;
                emulator::provide(board)?;
                program
            }
        };
        Ok(Ready {
            target: self,
            program,
        })
    }
}

/// The boards of these names, ready; one that cannot be is counted as missing.
pub fn boards(names: &[&str], what: &str, tally: &mut Tally) -> Vec<Ready> {
    let ready = parallel::check(tally, names, |name, tally| {
        let board = board::find(name).map_err(Problem::from);
        let ready = board.and_then(|board| Target::Board(board).prepare());
        tally.need(&format!("{what} on {name}"), ready)
    });
    ready.into_iter().flatten().collect()
}

/// A target with its program built.
#[derive(Clone, Debug)]
pub struct Ready {
    /// The target.
    pub target: Target,
    program: PathBuf,
}

/// One frame's line.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq)]
pub struct Frame {
    /// The frame's number.
    pub frame: u32,
    /// Picture width in pixels.
    pub width: u32,
    /// Picture height in pixels.
    pub height: u32,
    /// Pixels where something was drawn.
    pub covered: u64,
    /// Instructions; nanoseconds on the host.
    pub count: u64,
    /// Hash of the palette indices.
    pub index: String,
    /// Hash of the depths.
    pub depth: String,
    /// Hash of the RGB565 bytes.
    pub panel: String,
}

impl Ready {
    /// Renders frames `from..to` in bands of `band_rows` rows. The RGB565
    /// bytes of all frames go to `picture`, if one is given.
    pub fn frames(
        &self,
        scene: &Baked,
        frames: std::ops::Range<u32>,
        band_rows: u32,
        picture: Option<&Path>,
    ) -> Result<Vec<Frame>> {
        let drawn = self.drawn(scene, frames, band_rows, picture)?;
        Ok(drawn.frames)
    }

    /// The same, and how deep the stack went.
    pub fn drawn(
        &self,
        scene: &Baked,
        frames: std::ops::Range<u32>,
        band_rows: u32,
        picture: Option<&Path>,
    ) -> Result<Drawn> {
        let mut arguments = vec![
            frames.start.to_string(),
            frames.end.to_string(),
            band_rows.to_string(),
        ];
        arguments.extend(picture.map(|path| path.to_string_lossy().into_owned()));
        let text = match self.target {
            Target::Host(_) => {
                let mut command = Command::new(&self.program);
                command.arg(&scene.path).args(&arguments);
                let finished = child::bounded(&mut command, HOST_LIMIT)?;
                if !finished.success {
                    return Err(
                        format!("{}: {}", child::shown(&command), finished.stderr.trim()).into(),
                    );
                }
                finished.stdout
            }
            Target::Board(board) => emulator::render(board, &self.program, scene, &arguments)?,
        };
        let lines = parse(&text)?;
        if lines.len() != frames.len() {
            return Err(format!(
                "{} gave {} frames, not {}",
                self.target.name(),
                lines.len(),
                frames.len()
            )
            .into());
        }
        Ok(Drawn {
            frames: lines,
            stack: stack_bytes(&text),
        })
    }

    /// Counts loops of known length. Fails at the first wrong count; gives how
    /// many loops were right.
    pub fn counter_self_test(&self) -> Result<usize> {
        let Target::Board(board) = self.target else {
            return Err("the host does not count instructions".into());
        };
        let text = emulator::run(board, &self.program, &["selftest".into()])?;
        exact_loops(&text)
    }
}

/// What a program drew.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The frames.
    pub frames: Vec<Frame>,
    /// Most bytes of stack in use, from its start on, where the target paints it.
    pub stack: Option<u64>,
}

/// The stack's high-water mark among a program's lines.
pub fn stack_bytes(text: &str) -> Option<u64> {
    let mut lines = text.lines().filter(|line| line.starts_with("{\"stack\""));
    let value: serde_json::Value = serde_json::from_str(lines.next()?).ok()?;
    value["stack"].as_u64()
}

/// Frames among a program's lines.
fn parse(text: &str) -> Result<Vec<Frame>> {
    let frames = text.lines().filter(|line| line.starts_with("{\"frame\""));
    frames
        .map(|line| {
            serde_json::from_str(line)
                .map_err(|error| Problem::Failed(format!("not a frame ({error}): {line}")))
        })
        .collect()
}

/// A self-test's line.
#[derive(Debug, Deserialize)]
struct Loop {
    expected: u64,
    count: u64,
}

/// Fewest loops that a self-test runs: two kinds, and several lengths each.
const LOOPS: usize = 10;

fn exact_loops(text: &str) -> Result<usize> {
    let mut loops = 0;
    for line in text.lines() {
        let counted: Loop = serde_json::from_str(line)
            .map_err(|error| format!("not a self-test ({error}): {line}"))?;
        if counted.count != counted.expected {
            return Err(format!("the instruction counter is not exact: {line}").into());
        }
        loops += 1;
    }
    if loops < LOOPS {
        return Err(format!("the self-test ended after {loops} loops").into());
    }
    Ok(loops)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn loops(count: u64) -> String {
        let line = "{\"loop\":\"straight\",\"length\":3,\"expected\":4,\"count\":4}\n";
        let last = format!("{{\"loop\":\"memory\",\"expected\":8,\"count\":{count}}}\n");
        line.repeat(LOOPS) + &last
    }

    #[test]
    fn one_instruction_too_many_is_found() {
        assert_eq!(exact_loops(&loops(8)).ok(), Some(LOOPS + 1));
        assert!(exact_loops(&loops(9)).is_err());
    }

    #[test]
    fn a_self_test_that_ends_early_is_found() {
        assert!(exact_loops("").is_err());
        assert!(exact_loops("{\"error\":\"panic\"}\n").is_err());
    }

    #[test]
    fn frames_among_other_lines() {
        let text = "{\"frame\":2,\"width\":4,\"height\":3,\"covered\":5,\"count\":6,\
                    \"index\":\"a\",\"depth\":\"b\",\"panel\":\"c\"}\n{\"stack\":7}\n";
        let frames = parse(text).unwrap_or_default();
        assert_eq!(frames.len(), 1);
        assert_eq!(
            (stack_bytes(text), stack_bytes("{\"frame\":2}")),
            (Some(7), None)
        );
        assert!(parse("{\"frame\":2,\"wid").is_err());
    }
}
