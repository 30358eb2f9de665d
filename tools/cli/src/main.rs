//! The `fixel` command.
fn main() {}
