//! `peel completions` and `peel man`: what a shell and the manual need to know of the command.

use crate::terminal::help;
use crate::terminal::output::say;
use crate::terminal::stop::Stop;
use clap::{Args, Command};
use clap_complete::Shell;
use std::fs;
use std::path::PathBuf;

/// Prints what a shell needs to complete the words of the command
#[derive(Args)]
#[command(after_help = help::COMPLETIONS_EXAMPLES)]
pub struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Writes the pages of the manual, one for each command
#[derive(Args)]
#[command(after_help = help::MAN_EXAMPLES)]
pub struct Man {
    /// Folder to write them into, made if missing
    #[arg(value_name = "DIR", default_value = "man")]
    folder: PathBuf,
}

pub fn completions(args: &Completions, mut command: Command) -> Result<(), Stop> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, "peel", &mut script);
    say(&String::from_utf8_lossy(&script))
}

pub fn man(args: &Man, command: Command) -> Result<(), Stop> {
    let shown = args.folder.display();
    let written = fs::create_dir_all(&args.folder).and_then(|()| clap_mangen::generate_to(command, &args.folder));
    written.map_err(|error| Stop::other(format!("cannot write {shown}: {error}")))?;
    say(&format!("wrote the pages of the manual into {shown}\nNext: man {shown}/peel.1\n"))
}
