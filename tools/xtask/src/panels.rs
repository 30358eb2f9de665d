//! The firmware of boards with a panel, in an emulator: what the panel shows is what the host
//! renders, to the bit, whatever buttons are pressed.

use std::fs;
use std::path::Path;

use fixel::math::Angle;

use crate::device::{DEVICES, Device, Pixels};
use crate::firmware::{self, Demo};
use crate::problem::Result;
use crate::report::Tally;
use crate::rp2040::{self, Report, Shown};
use crate::scene::{self, Baked};
use crate::{flash, footprint, picture};

/// Frames that are compared.
const FRAMES: u32 = 5;
/// The buttons that are pressed meanwhile, and how the object then stands: the frame of its
/// animation, and its turn in steps of the buttons.
const PRESSES: [&str; 3] = ["right=1..3", "left=4..5", "stop=2..4"];
const STANDS: [(u32, i32); FRAMES as usize] = [(0, 0), (1, 1), (2, 2), (2, 2), (2, 1)];
/// A device and a scene that draws faster than the bus sends, so that what the firmware does
/// when the last byte of a band goes out is seen too.
const WAITING: (&Device, &str) = (&DEVICES[0], "w1_teapot_flat");
/// Most bytes of stack, of the core and the demo: what `docs/reliability.md` promises.
const STACK_LIMIT: u64 = 8 * 1024;
/// Cycles of waiting that show it.
const WAITED: u64 = 10_000;
/// Of a full turn, in 65536ths.
const STEP: i32 = 1024;

/// Builds a device's firmware with a scene linked in, as an ELF file and as UF2.
pub fn build(device: &Device, scene_name: &str) -> Result<Demo> {
    let demo = firmware::device(device, &scene::bake(scene_name)?)?;
    flash::write_uf2(&demo.path)?;
    picture::say_size(device.name, &demo.image);
    Ok(demo)
}

/// Runs a device up to a frame of a scene, says what each took, and writes what the panel
/// shows as PNG.
pub fn show(device: &Device, scene_name: &str, frame: u32, to: &Path) -> Result<()> {
    let demo = build(device, scene_name)?;
    let shown = rp2040::run(device, &demo.path, frame.saturating_add(1), &[])?;
    for Shown { report, bus, .. } in &shown {
        eprintln!(
            "{}: frame {}, {} cycles of drawing, {} of waiting; the bus takes {} for {} bytes",
            device.name, report.frame, report.drawing, report.waiting, bus.sending, bus.bytes
        );
    }
    let last = shown.last().ok_or("no frame")?;
    let rgb = match device.pixels {
        Pixels::Rgb565 => picture::rgb888(&last.pixels),
        Pixels::Mono => last.pixels.iter().flat_map(|bit| [bit * 255; 3]).collect(),
    };
    let (width, height) = device.size;
    picture::write_png(to, width.into(), height.into(), &rgb)?;
    eprintln!("{}", to.display());
    Ok(())
}

/// Every device in its emulator.
pub fn run(tally: &mut Tally) {
    for device in &DEVICES {
        let name = format!("firmware of {}", device.name);
        let built =
            build(device, device.scene).and_then(|demo| Ok((scene::bake(device.scene)?, demo)));
        let Some((baked, demo)) = tally.need(&name, built) else {
            continue;
        };
        let name = format!("promises of {}", device.name);
        tally.check(&name, footprint::promises(&demo.image));
        let name = format!("{} in its emulator", device.name);
        let shown = rp2040::run(device, &demo.path, FRAMES, &PRESSES);
        let Some(shown) = tally.need(&name, shown) else {
            continue;
        };
        let name = format!("the panel of {} shows what the host renders", device.name);
        tally.check(&name, all_as_rendered(device, &baked, &shown));
        let name = format!("buttons turn the object of {}", device.name);
        tally.check(&name, stands(&shown));
        let stack = shown.first().map_or(0, |shown| shown.stack);
        let name = format!("stack of {}, {stack} bytes", device.name);
        tally.check(&name, within(stack));
        let name = format!("what {} sends", device.name);
        tally.check(&name, sent(device, &shown));
    }
    let (device, scene_name) = WAITING;
    let name = format!("{} waits for its bus", device.name);
    tally.check(&name, waits(device, scene_name));
}

fn within(stack: u64) -> Result<()> {
    if (1..=STACK_LIMIT).contains(&stack) {
        return Ok(());
    }
    Err(format!("it is not within the {STACK_LIMIT} bytes promised").into())
}

fn waits(device: &Device, scene_name: &str) -> Result<()> {
    let demo = build(device, scene_name)?;
    let shown = rp2040::run(device, &demo.path, 2, &[])?;
    all_as_rendered(device, &scene::bake(scene_name)?, &shown)?;
    if shown.iter().any(|shown| shown.report.waiting < WAITED) {
        return Err("drawing was not faster than the bus: this showed nothing".into());
    }
    Ok(())
}

fn all_as_rendered(device: &Device, scene: &Baked, shown: &[Shown]) -> Result<()> {
    for frame in shown {
        let expected = rendered(device, scene, frame.report)?;
        same(device, &expected, frame)?;
    }
    Ok(())
}

/// Fails where a picture differs.
fn same(device: &Device, expected: &[u8], shown: &Shown) -> Result<()> {
    let bytes = device.picture_bytes() / usize::from(device.size.0).max(1);
    let pairs = expected.iter().zip(&shown.pixels);
    let wrong = pairs.enumerate().filter(|(_, (a, b))| a != b);
    let wrong: Vec<_> = wrong.map(|(place, _)| place / bytes).collect();
    let (Some(first), Some(last)) = (wrong.first(), wrong.last()) else {
        if expected.len() != shown.pixels.len() {
            return Err("the pictures differ in size".into());
        }
        return Ok(());
    };
    Err(format!(
        "frame {} differs in {} bytes, rows {first} to {last}",
        shown.report.frame,
        wrong.len()
    )
    .into())
}

/// The picture of a frame as the host renders it, as a panel has it.
fn rendered(device: &Device, baked: &Baked, report: Report) -> Result<Vec<u8>> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", baked.path.display());
    let bytes = fs::read(&baked.path).map_err(|error| fail(&error))?;
    let blob = fixel_bake::Baked::from_bytes(&bytes).map_err(|error| fail(&error))?;
    let scene = blob.scene().map_err(|error| fail(&error))?;
    let options = fixel_host::Options {
        width: device.size.0,
        height: device.size.1,
        frame: report.frame,
        band_rows: None,
        camera: None,
    };
    let turn = Angle::from_bits(report.turn << 16);
    let planes = fixel_host::render_turned(&scene, &options, turn);
    let (pixels, _) = fixel_host::picture(&scene, &planes);
    Ok(match device.pixels {
        Pixels::Rgb565 => pixels.into_iter().flat_map(rgb565).collect(),
        Pixels::Mono => pixels.into_iter().map(|[r, ..]| r >> 7).collect(),
    })
}

/// The bytes of a colour that has no more bits than that.
fn rgb565(colour: [u8; 3]) -> [u8; 2] {
    fixel::palette::rgb565(colour).to_be_bytes()
}

fn stands(shown: &[Shown]) -> Result<()> {
    let wanted = STANDS.map(|(frame, steps)| (frame, (steps * STEP) as u16));
    let found: Vec<_> = shown
        .iter()
        .map(|shown| (shown.report.frame, shown.report.turn as u16))
        .collect();
    if found != wanted {
        return Err(format!("frames and turns {found:?}, not {wanted:?}").into());
    }
    Ok(())
}

/// A panel that gets everything gets as much for each frame; one that gets only changes gets
/// less when nothing does.
fn sent(device: &Device, shown: &[Shown]) -> Result<()> {
    let bytes: Vec<_> = shown.iter().map(|shown| shown.bus.bytes).collect();
    let (Some(moving), Some(still)) = (bytes.get(2), bytes.get(3)) else {
        return Err("too few frames".into());
    };
    if device.sends_all && moving != still {
        return Err(format!("frames of {bytes:?} bytes").into());
    }
    if !device.sends_all && moving <= still {
        return Err(
            format!("{still} bytes for a frame that is as the last, {moving} before").into(),
        );
    }
    Ok(())
}
