//! Draws the examples into files: `cargo run --release -- globe globe.gif`.

use std::path::Path;
use std::process::ExitCode;

use fixel_examples::desktop::{EXAMPLES, Example};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let known = |name: &String| EXAMPLES.iter().find(|example| example.name == name);
    let [name, output] = arguments.as_slice() else {
        return usage();
    };
    let Some(example) = known(name) else {
        return usage();
    };
    match write(example, Path::new(output)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{output}: {error}");
            ExitCode::FAILURE
        }
    }
}

fn usage() -> ExitCode {
    let names: Vec<_> = EXAMPLES.iter().map(|example| example.name).collect();
    eprintln!(
        "usage: example NAME OUT.png|OUT.gif; NAME is one of {}",
        names.join(", ")
    );
    ExitCode::from(2)
}

/// One frame, or all of them.
fn write(example: &Example, output: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let (size, pixels) = (example.draw)(example.shown())?;
    if output
        .extension()
        .is_none_or(|extension| extension != "gif")
    {
        let png = fixel_output::png_rgb(size.width, size.height, &pixels)?;
        return Ok(fixel_output::write(output, &png)?);
    }
    let (width, height) = (size.width as u16, size.height as u16);
    let mut bytes = Vec::new();
    let mut encoder = gif::Encoder::new(&mut bytes, width, height, &[])?;
    encoder.set_repeat(gif::Repeat::Infinite)?;
    for frame in 0..example.frames {
        let (_, pixels) = (example.draw)(frame)?;
        let mut frame = gif::Frame::from_rgb_speed(width, height, pixels.as_flattened(), 10);
        // Hundredths of a second.
        frame.delay = 4;
        encoder.write_frame(&frame)?;
    }
    drop(encoder);
    Ok(fixel_output::write(output, &bytes)?)
}
