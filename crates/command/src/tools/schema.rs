//! `peel schema`: what an editor needs to help with a scene.

use crate::terminal::help;
use crate::terminal::output::say;
use crate::terminal::stop::Stop;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes a JSON schema of scenes, for editors
#[derive(Args)]
#[command(after_help = help::SCHEMA_EXAMPLES)]
pub struct Schema {
    /// File to write, replaced if it exists; - for standard output
    #[arg(value_name = "FILE", default_value = NAME)]
    file: PathBuf,
}

/// What a scene of `peel new` calls it.
pub const NAME: &str = "peel.schema.json";

/// The schema as a text.
pub fn text() -> String {
    format!("{:#}\n", peelkit_scene::schema())
}

pub fn schema(args: &Schema) -> Result<(), Stop> {
    if args.file == Path::new("-") {
        return say(&text());
    }
    let shown = args.file.display();
    fs::write(&args.file, text()).map_err(|error| Stop::other(format!("cannot write {shown}: {error}")))?;
    say(&format!(
        "wrote {shown}\nAn editor with support for TOML reads it where the first line of a scene is #:schema {shown}\n"
    ))
}
