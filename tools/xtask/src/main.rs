//! The developer's commands: `cargo xtask test` is what continuous integration
//! runs, the others give the figures that the README and the tests stand on.
//!
//! Messages go to standard error. Figures go to standard output, as a table or
//! with `--json -` as one JSON object and nothing else.

mod accepted;
mod accuracy;
mod against;
mod bench;
mod bless;
mod board;
mod child;
mod debian;
mod device;
mod elf;
mod emulator;
mod examples;
mod firmware;
mod fit;
mod flash;
mod footprint;
mod fuzz;
mod gallery;
mod gba;
mod growth;
mod hostbench;
mod libretro;
mod links;
mod liquid;
mod measure;
mod package;
mod panels;
mod parallel;
mod parity;
mod paths;
mod peers;
mod picture;
mod pictures;
mod plot;
mod problem;
mod qemu;
mod readme;
mod report;
mod rp2040;
mod scaling;
mod scaling_levels;
mod scene;
mod screen;
mod small_chip;
mod soak;
mod supply;
mod template;
mod test;
mod toolchain;
mod uf2;
mod view;
mod web;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use serde_json::Value;

use board::Board;
use device::Named;
use measure::Target;
use problem::Result;
use report::Tally;

/// The developer's commands of fixel.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    command: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Everything that continuous integration runs: format, lints, tests,
    /// docs, firmware in emulators. The last line counts the checks.
    Test {
        /// Only this stage; may be given more than once
        #[arg(long, value_name = "NAME", value_parser = test::names())]
        stage: Vec<String>,
    },
    /// Compare every scene in scenes/ with the f64 reference.
    Accuracy {
        #[command(flatten)]
        json: Json,
        /// Write a page a scene and renderer, with pictures, heat maps and histograms, and an
        /// index over them, into this folder
        #[arg(long, value_name = "DIR")]
        report: Option<PathBuf>,
    },
    /// Render every scene in scenes/ on the host and on every emulated target,
    /// and fail if any byte differs.
    #[command(after_help = board::list())]
    Parity {
        #[command(flatten)]
        json: Json,
        /// Only the host and this board; may be given more than once
        #[arg(long, value_name = "BOARD", value_parser = board::find)]
        on: Vec<&'static Board>,
        /// Only these scenes, by name or file
        #[arg(value_name = "SCENE")]
        scenes: Vec<String>,
    },
    /// Instructions a frame of the bench scenes on every target.
    Bench {
        #[command(flatten)]
        json: Json,
        /// These scenes instead, by name or file
        #[arg(value_name = "SCENE")]
        scenes: Vec<String>,
        /// Print the README's table, with other renderers' figures beside ours
        #[arg(long, conflicts_with = "json")]
        markdown: bool,
        /// Beside the figures of another revision, or of a file that --json wrote
        #[arg(long, value_name = "REVISION|FILE", conflicts_with = "markdown")]
        against: Option<String>,
        /// Make the counts of today those that continuous integration accepts
        #[arg(long, conflicts_with_all = ["markdown", "against", "scenes"])]
        accept: bool,
        /// Wall time on this machine, beside other renderers'
        #[arg(long, conflicts_with_all = ["markdown", "against", "accept", "scenes"])]
        host: bool,
        /// With --host: what each renderer drew in frame 4 goes to this folder
        #[arg(long, value_name = "DIR", requires = "host")]
        pictures: Option<PathBuf>,
    },
    /// Instructions a ray against 1,000 to 100,000 triangles, held to a limit, and
    /// instructions a frame against pixels, actors and lights.
    Scaling {
        #[command(flatten)]
        json: Json,
        /// Write those of frames into docs/performance.md, and the plot beside it
        #[arg(long)]
        write: bool,
    },
    /// Fit what `fixel estimate` goes by to counts from emulators, and say how far it is off
    /// in scenes that nothing was fitted to.
    Fit {
        #[command(flatten)]
        json: Json,
        /// Take counts from a file that --json wrote, and make only those that it lacks
        #[arg(long, value_name = "FILE")]
        from: Option<PathBuf>,
        /// Measure what firmware takes in flash and stack, too
        #[arg(long)]
        firmware: bool,
    },
    /// Code, RAM and stack of a minimal firmware on every board, held to
    /// limits.
    Footprint(Json),
    /// Fuzz the core, the baker and the renderers against the reference, on the nightly
    /// toolchain. What is found stays in fuzz/artifacts.
    Fuzz {
        #[command(flatten)]
        json: Json,
        /// Only these
        #[arg(value_name = "FUZZER", value_parser = fuzz::names())]
        fuzzers: Vec<String>,
        /// Seconds for each
        #[arg(long, value_name = "N", default_value_t = 60)]
        seconds: u32,
    },
    /// Draw a flight that ends where it began again and again, on the host and on an
    /// emulated Cortex-M4F, and fail if any byte changes.
    Soak {
        #[command(flatten)]
        json: Json,
        /// Frames on the host
        #[arg(long, value_name = "N", default_value_t = 1_000_000)]
        host: u32,
        /// Frames on the board
        #[arg(long, value_name = "N", default_value_t = 10_000)]
        board: u32,
    },
    /// Build the demo firmware of a board with a scene linked in; prints the
    /// ELF file's path. For an RP2040 there is a UF2 file beside it. WebAssembly has no
    /// demo: its module takes a scene at run time.
    #[command(after_help = device::list())]
    Firmware(OnBoard),
    /// Render one frame on a board in its emulator, and write what its panel
    /// shows.
    #[command(after_help = device::list())]
    Run {
        #[command(flatten)]
        on: OnBoard,
        /// Which frame
        #[arg(long, default_value_t = 0)]
        frame: u32,
        /// Rows in a band, where the board has no panel that decides it
        #[arg(long, value_name = "ROWS", default_value_t = 16)]
        bands: u32,
        /// The picture
        #[arg(short, long, value_name = "FILE.png", default_value = "frame.png")]
        output: PathBuf,
    },
    /// Write the demo firmware to a real board: onto the drive that an RP2040 shows
    /// while its BOOTSEL button is held, or by probe-rs.
    #[command(after_help = device::list())]
    Flash(OnBoard),
    /// Build the browser simulator: one page, with everything in it, that needs no server.
    Web {
        /// The folder that gets index.html
        #[arg(short, long, value_name = "DIR", default_value = "target/web")]
        output: PathBuf,
    },
    /// Write docs/gallery.md anew: every scene with its golden frame; and the pictures of
    /// docs/how/.
    Gallery,
    /// Check the Markdown pages: gallery and pictures are what would be drawn now, links
    /// lead somewhere.
    Pages,
    /// Write the README's tables anew from fresh figures.
    Readme,
    /// Rewrite golden frames, after a person has looked at them.
    Bless,
}

#[derive(Debug, Args)]
struct Json {
    /// Write the figures as JSON to a file, or to standard output for `-`
    #[arg(long, value_name = "FILE|-")]
    json: Option<String>,
}

#[derive(Debug, Args)]
struct OnBoard {
    /// The board's name
    #[arg(value_name = "BOARD", value_parser = device::find)]
    board: Named,
    /// A scene's name (as in scenes/) or file [default: teapot, as it suits the panel]
    #[arg(long)]
    scene: Option<String>,
}

impl OnBoard {
    /// The scene asked for, or the board's.
    fn scene(&self) -> &str {
        let usual = match self.board {
            Named::Board(board) => board.scene,
            Named::Device(device) => device.scene,
        };
        self.scene.as_deref().unwrap_or(usual)
    }
}

fn main() -> ExitCode {
    match run(Cli::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run(task: Task) -> Result<()> {
    match task {
        Task::Test { stage } => test::run(&stage),
        Task::Accuracy { json, report } => figures(
            &json,
            |tally| accuracy::run(tally, report.as_deref()),
            accuracy::markdown,
        ),
        Task::Parity { json, on, scenes } => {
            let targets = Target::all_or_on(&on);
            figures(&json, |tally| parity::run(tally, targets, &scenes), pretty)
        }
        Task::Bench {
            json,
            scenes,
            markdown,
            against,
            accept,
            host,
            pictures,
        } => {
            if host {
                let run = |tally: &mut Tally| hostbench::run(tally, pictures.as_deref());
                return figures(&json, run, hostbench::markdown);
            }
            if accept {
                return figures(&json, accepted::accept, pretty);
            }
            if let Some(base) = against {
                let run = |tally: &mut Tally| against::run(tally, &base, &scenes);
                return figures(&json, run, against::shown);
            }
            let show = if markdown { bench::markdown } else { pretty };
            figures(&json, |tally| bench::run(tally, &scenes), show)
        }
        Task::Scaling { json, write } => {
            let run = |tally: &mut Tally| {
                let grown = growth::run(tally)?;
                if write {
                    growth::write(&grown)?;
                }
                let mut all = scaling::run(tally)?;
                if write {
                    scaling_levels::write(&all["levels"])?;
                }
                if let (Some(all), Some(grown)) = (all.as_object_mut(), grown.as_object()) {
                    all.extend(grown.clone());
                }
                Ok(all)
            };
            let show = |all: &Value| scaling::markdown(all) + "\n" + &growth::markdown(all);
            figures(&json, run, show)
        }
        Task::Fit {
            json,
            from,
            firmware,
        } => {
            let options = fit::Options { from, firmware };
            let run = |tally: &mut Tally| fit::run(tally, &options);
            figures(&json, run, |_| "fitted".into())
        }
        Task::Footprint(json) => figures(&json, footprint::run, footprint::markdown),
        Task::Fuzz {
            json,
            fuzzers,
            seconds,
        } => figures(
            &json,
            |tally| fuzz::run(tally, &fuzzers, seconds),
            fuzz::markdown,
        ),
        Task::Soak { json, host, board } => figures(
            &json,
            |tally| soak::run(tally, host, board),
            soak::markdown,
        ),
        Task::Firmware(on) => {
            let file = match on.board {
                Named::Board(board) => picture::build(board, on.scene())?,
                Named::Device(device) => panels::build(device, on.scene())?.path,
            };
            println!("{}", file.display());
            Ok(())
        }
        Task::Run {
            on,
            frame,
            bands,
            output,
        } => match on.board {
            Named::Board(board) => picture::run(board, on.scene(), frame, bands, &output),
            Named::Device(device) => panels::show(device, on.scene(), frame, &output),
        },
        Task::Flash(on) => match on.board {
            Named::Device(device) => flash::run(&panels::build(device, on.scene())?),
            Named::Board(board) => Err(format!(
                "nothing is known about writing to a real {}: `cargo xtask firmware` makes the file",
                board.name
            )
            .into()),
        },
        Task::Web { output } => {
            println!("{}", web::build(&output)?.display());
            Ok(())
        }
        Task::Gallery => gallery::run().and_then(|()| pictures::run()),
        Task::Pages => {
            let mut tally = Tally::default();
            test::pages(&mut tally);
            tally.result()
        }
        Task::Readme => readme::run(),
        Task::Bless => bless::run(),
    }
}

/// Makes figures, counts the checks on the way, and writes both.
fn figures(
    json: &Json,
    make: impl FnOnce(&mut Tally) -> Result<Value>,
    show: fn(&Value) -> String,
) -> Result<()> {
    let mut tally = Tally::default();
    let value = make(&mut tally)?;
    match &json.json {
        Some(to) => report::write_json(to, &value)?,
        None => println!("{}", show(&value)),
    }
    eprintln!("{}", tally.summary());
    tally.result()
}

fn pretty(value: &Value) -> String {
    serde_json::to_string_pretty(value).unwrap_or_default()
}
