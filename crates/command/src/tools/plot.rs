//! `peel plot`: several results in one picture, with measured points over them.

use crate::terminal::help;
use crate::terminal::output::{OutArgs, list_files, say};
use crate::terminal::stop::Stop;
use crate::text_summary::units::UnitsArgs;
use clap::Args;
use peelkit_report::chart::Heading;
use peelkit_report::overlay::{Kind, Measured, OverlayError, ResultFile, draw_overlay};
use std::path::{Path, PathBuf};

/// Draws several results in one picture, with measured points over them
#[derive(Args)]
#[command(after_help = help::PLOT, mut_arg("out", |out| out.help("Folder for the picture [default: out/plot]")))]
pub struct Plot {
    /// Folders of peel run or peel sweep, or their tables curve.csv or sweep.csv
    #[arg(value_name = "FOLDER", required = true)]
    results: Vec<PathBuf>,

    /// Measured points: a CSV of two columns with units; may be repeated
    #[arg(long, value_name = "CSV")]
    data: Vec<PathBuf>,

    /// Heading of the picture
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,

    /// Logarithmic x axis
    #[arg(long)]
    log_x: bool,

    /// Logarithmic y axis
    #[arg(long)]
    log_y: bool,

    #[command(flatten)]
    units: UnitsArgs,

    #[command(flatten)]
    out: OutArgs,
}

/// Most results in one picture: a legend has room for them.
const MOST: usize = 14;

impl From<OverlayError> for Stop {
    fn from(error: OverlayError) -> Self {
        Self::bad_input(&error, &error.remedy)
    }
}

pub fn plot(args: &Plot) -> Result<(), Stop> {
    if args.results.len() > MOST {
        return Err(Stop::bad_input(
            format!("{} results are more than one picture shows", args.results.len()),
            format!("Give at most {MOST}."),
        ));
    }
    let mut results = args.results.iter().map(|path| ResultFile::read(path)).collect::<Result<Vec<_>, _>>()?;
    let (kind, key) = (results[0].kind, results[0].key);
    if let Some(other) = results.iter().find(|result| result.kind != kind) {
        return Err(Stop::bad_input(
            format!("{} holds a {}, and {} a {}", results[0].name, kind.file(), other.name, other.kind.file()),
            "Draw curves and sweeps in pictures of their own.",
        ));
    }
    let path = |result: &ResultFile| result.key.map(|key| key.path());
    if let Some(other) = results.iter().find(|result| path(result) != path(&results[0])) {
        let named = |result: &ResultFile| path(result).unwrap_or_else(|| "a key that its table does not name".into());
        return Err(Stop::bad_input(
            format!("{} varies {}, and {} {}", results[0].name, named(&results[0]), other.name, named(other)),
            "Draw sweeps of one key in one picture.",
        ));
    }
    ResultFile::shorten(&mut results);
    let measured =
        args.data.iter().map(|path| Measured::read(path, kind, key)).collect::<Result<Vec<_>, OverlayError>>()?;
    let title = args.title.clone().unwrap_or_else(|| match kind {
        Kind::Curve => "Force against displacement".into(),
        Kind::Sweep => "Peak force".into(),
    });
    let units = args.units.given()?.unwrap_or_default();
    if let Some(unit) = units.force_per_width {
        return Err(Stop::bad_input(
            format!("--units has {}, a force over a width, and the results do not say their width", unit.name),
            "Give a unit of forces, such as N.",
        ));
    }
    let heading = Heading { title: &title, units };
    let folder = args.out.claim(args.out.out.as_deref().unwrap_or(Path::new("out/plot")), None)?;
    let files = folder.write(|dir| draw_overlay(&results, &measured, heading, [args.log_x, args.log_y], dir));
    say(&list_files(&files))?;
    files?;
    Ok(())
}
