//! `fixel bake`.

use crate::{args, input, output};
use anyhow::{Result, bail};

/// Bakes a scene into one file.
pub fn run(args: &args::Bake) -> Result<()> {
    let mut input = input::load_on(&args.scene, args.screen.get())?;
    if let Some(colours) = args.colours {
        if input.baked.is_some() {
            bail!(
                "{}: --colours needs a scene, this is baked already",
                args.scene.display()
            );
        }
        if !input.scene.palette.fixed.is_empty() {
            bail!(
                "{}: --colours does not go with palette.file, which has all entries",
                args.scene.display()
            );
        }
        input.scene.palette.colours = colours;
    }
    if !(args.ray || args.raster)
        && input.baked.is_none()
        && let Some(why) = input.scene.asks_for_rays()
    {
        bail!(
            "{}: {why} asks for rays, which firmware casts only if --ray bakes what they need; \
             expected --ray, or --raster for triangles alone",
            args.scene.display()
        );
    }
    if let Some(most) = args.max_triangles {
        input.reduce(most)?;
    }
    let baked = if args.ray {
        input.bake_for_rays()?
    } else {
        input.bake()?
    };
    let bytes = baked.bytes();
    output::write(&args.output, bytes)?;
    eprintln!("wrote {} ({} bytes)", args.output.display(), bytes.len());
    Ok(())
}
