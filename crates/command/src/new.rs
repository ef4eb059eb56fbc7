//! `peel new`: a commented scene to start from.

use crate::output::say;
use crate::stop::Stop;
use clap::{Args, ValueEnum};
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

/// Writes a commented scene as a template
#[derive(Args)]
pub struct New {
    /// Name of the scene file [default: the name of the body]; .toml is added if missing
    #[arg(value_name = "NAME")]
    name: Option<PathBuf>,

    /// The beam that is peeled
    #[arg(long, value_name = "BODY", default_value = "strip")]
    body: Body,
}

/// The bodies for which there is a commented scene.
#[derive(Clone, Copy, ValueEnum)]
enum Body {
    /// A uniform strip
    Strip,
    /// A gecko's spatula
    Spatula,
    /// A beam given piece by piece
    Profile,
}

impl Body {
    fn scene(self) -> (&'static str, &'static str) {
        match self {
            Self::Strip => ("strip", include_str!("../../../scenes/strip.toml")),
            Self::Spatula => ("spatula", include_str!("../../../scenes/spatula.toml")),
            Self::Profile => ("profile", include_str!("../../../scenes/profile.toml")),
        }
    }
}

pub fn new(args: &New) -> Result<(), Stop> {
    let (body, scene) = args.body.scene();
    let mut path = args.name.clone().unwrap_or_else(|| body.into());
    if path.extension().is_none_or(|extension| extension != "toml") {
        path.as_mut_os_string().push(".toml");
    }
    let shown = path.display();
    let cannot = |error| Stop::other(format!("cannot write {shown}: {error}"));
    let mut file = match OpenOptions::new().write(true).create_new(true).open(&path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            return Err(Stop::bad_input(
                format!("{shown} exists and is not replaced"),
                "Give another name: peel new NAME",
            ));
        }
        opened => opened.map_err(cannot)?,
    };
    if let Err(error) = file.write_all(scene.as_bytes()) {
        // Half a scene is worse than none; the error is reported in either case.
        let _ = fs::remove_file(&path);
        return Err(cannot(error));
    }
    say(&format!("wrote {shown}\nNext: peel run {shown}\n"))
}
