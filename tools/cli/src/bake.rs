//! `fixel bake`.

use crate::{args, input, output};
use anyhow::Result;
use fixel_bake::Options;

/// Bakes a scene into one file.
pub fn run(args: &args::Bake) -> Result<()> {
    output::refuse_stdout(&args.output)?;
    let options = Options {
        rays: (args.ray || args.raster).then_some(args.ray),
        max_triangles: args.max_triangles,
        colours: args.colours,
    };
    let outputs = [Some(args.output.as_path())];
    let input = input::load_on(&args.input, args.screen.get(), &outputs)?;
    let (baked, reduced) = input.bake_with(&options)?;
    for mesh in reduced {
        eprintln!("{mesh}");
    }
    let bytes = baked.bytes();
    output::write(&args.output, bytes)?;
    eprintln!("wrote {} ({} bytes)", args.output.display(), bytes.len());
    Ok(())
}
