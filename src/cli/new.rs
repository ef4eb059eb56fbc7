//! `peel new`: a commented scene to start from.

use super::output::say;
use super::stop::Stop;
use clap::Args;
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

const SCENE: &str = include_str!("../../scenes/strip.toml");

/// Writes a commented scene to start from
#[derive(Args)]
pub struct New {
    /// Name of the scene; .toml is added where it is missing
    #[arg(default_value = "strip", value_name = "NAME")]
    name: PathBuf,
}

pub fn new(args: &New) -> Result<(), Stop> {
    let mut path = args.name.clone();
    if path.extension().is_none_or(|extension| extension != "toml") {
        path.as_mut_os_string().push(".toml");
    }
    let shown = path.display();
    let cannot = |error| Stop::other(format!("cannot write {shown}: {error}"));
    let mut file = match OpenOptions::new().write(true).create_new(true).open(&path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            return Err(Stop::bad_input(
                format!("{shown} exists and is left as it is"),
                "Give another name: peel new NAME",
            ));
        }
        opened => opened.map_err(cannot)?,
    };
    if let Err(error) = file.write_all(SCENE.as_bytes()) {
        // Half a scene is worse than none; the error is told in either case.
        let _ = fs::remove_file(&path);
        return Err(cannot(error));
    }
    say(&format!("wrote {shown}\nNext: peel run {shown}\n"))
}
