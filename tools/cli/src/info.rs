//! `fixel info`.

use crate::{args, baked, output};
use anyhow::Result;

/// Prints what is in a baked scene, one `name: value` a line.
pub fn run(args: &args::Info) -> Result<()> {
    let baked = baked::read(&args.file)?;
    let mut text = String::new();
    for (field, value) in baked::describe(&baked)? {
        text += &format!("{field}: {value}\n");
    }
    output::stdout(&text)
}
