//! `fixel info`.

use crate::{args, baked, output};
use anyhow::{Context, Result};

/// Prints what is in a baked scene, one `name: value` a line.
pub fn run(args: &args::Info) -> Result<()> {
    let name = || args.file.display().to_string();
    let bytes = std::fs::read(&args.file).with_context(name)?;
    let mut text = String::new();
    for (field, value) in baked::describe(&bytes).with_context(name)? {
        text += &format!("{field}: {value}\n");
    }
    output::stdout(&text)
}
