//! `peel collect`: the parts of a divided sweep put together into what the undivided sweep writes.

mod differences;
mod help;
mod merge;
mod parts;

use crate::studies::sweep::table;
use crate::terminal::command_line::joined;
use crate::terminal::output::{OutArgs, list_files, say};
use crate::terminal::stop::Stop;
use crate::text_summary::units::UnitsArgs;
use clap::Args;
use merge::Merged;
use parts::Parts;
use peelkit_analyses::{Cases, Outcome, Rows, SweepOutcome};
use peelkit_report::{Existing, OutputFolder, PartHeader, PartialCollection, ReportError};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// Puts together the parts that peel sweep --part has computed
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::LONG)]
pub struct Collect {
    /// Folders of the parts, in any order
    #[arg(value_name = "FOLDER", required = true)]
    folders: Vec<PathBuf>,

    #[command(flatten)]
    out: OutArgs,

    #[command(flatten)]
    units: UnitsArgs,

    /// Prints one JSON object only; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

pub fn collect(args: &Collect) -> Result<(), Stop> {
    let wanted = args.units.wanted()?;
    let parts = Parts::read(&args.folders)?;
    let header = parts.header();
    let scene = Scene::parse(&header.name, &header.sweep.scene, &[])?;
    let cases = Cases::along(&scene, &parts.axes()?, None).map_err(|why| Stop::refused(&scene, why))?;
    let merged = Merged::of(&parts, &cases)?;
    let (missing, missing_text) = (merged.missing_parts(), merged.missing_text());
    let found = SweepOutcome::of(&cases, Rows::Peels(merged.rows), merged.remarks);
    let command = command(args, header);
    let files = match args.out.folder(args.json, || header.folder.clone()) {
        Some(folder) => write(args, &folder, header, missing, |dir| found.write(&scene, dir, &command))?,
        None => Vec::new(),
    };
    if args.json {
        say(&found.json(&scene, Some(&command)).map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", table(&scene, &found, wanted), list_files(&Ok(files))))?;
    }
    let short: Vec<String> = missing_text.into_iter().chain(found.failed()).collect();
    if short.is_empty() { Ok(()) } else { Err(Stop::cut_short(short.join("\nand "))) }
}

/// The command line of the undivided sweep that would write the same.
fn command(args: &Collect, header: &PartHeader) -> String {
    let mut words = header.command.clone();
    if let Some(out) = &args.out.out {
        words.extend(["--out".to_owned(), out.display().to_string()]);
    }
    joined(&words)
}

/// A folder of the same sweep in which parts were missing is one to go on with; any other that holds something is refused.
fn write(
    args: &Collect,
    folder: &Path,
    header: &PartHeader,
    missing: Vec<usize>,
    write: impl FnOnce(&Path) -> Result<Vec<PathBuf>, ReportError>,
) -> Result<Vec<PathBuf>, ReportError> {
    let output = if PartialCollection::is_in(folder, &header.sweep) {
        OutputFolder::claim(folder, Existing::Replace, None)?
    } else {
        args.out.claim(folder, None)?
    };
    let is_whole = missing.is_empty();
    let files = output.write(|dir| {
        let mut files = write(dir)?;
        if !is_whole {
            files.push(PartialCollection { sweep: header.sweep.clone(), missing }.write(dir)?);
        }
        Ok(files)
    })?;
    if is_whole {
        PartialCollection::discard(folder)?;
    }
    Ok(files)
}
