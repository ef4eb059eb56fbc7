//! `peel collect`: the parts of a divided sweep put together into what the undivided sweep writes.

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
use peelkit_scene::{Key, Scene};
use std::path::{Path, PathBuf};

/// Puts together the parts that peel sweep --part has computed
#[derive(Args)]
#[command(after_help = SHORT_HELP, after_long_help = LONG_HELP)]
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
    let parts = Parts::read(&args.folders)?;
    let header = parts.header();
    let mut scene = Scene::parse(&header.name, &header.sweep.scene, &[])?;
    args.units.put(&mut scene)?;
    let cases = Cases::along(&scene, &parts.axes()?, None).map_err(|why| Stop::refused(&scene, why))?;
    args.units.check(&scene, cases.keys.keys().map(Key::path))?;
    let merged = Merged::of(&parts, &cases)?;
    let (missing, missing_text) = (merged.missing_parts(), merged.missing_text());
    let found = SweepOutcome::of(&cases, Rows::Peels(merged.rows), merged.remarks);
    let command = command(args, header);
    let files = match args.out.folder(args.json, || header.folder.clone()) {
        Some(folder) => write(args, &folder, header, missing, |dir| found.write_all(&scene, dir, &command))?,
        None => Vec::new(),
    };
    if args.json {
        say(&found.json(&scene, Some(&command)).map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", table(&scene, &found, scene.written_units()), list_files(&Ok(files))))?;
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

// -- The help --

/// Of `peel collect -h`.
const SHORT_HELP: &str = "\
Example: peel collect out/strip-sweep-strip.length-part-*
More: peel collect --help, on files, missing parts, parts that were computed twice";

/// Of `peel collect --help`.
const LONG_HELP: &str = "\
Examples:
  peel sweep strip.toml --vary strip.length --from \"60 nm\" --to \"120 nm\" --points 40 --part 1/8
  peel collect out/strip-sweep-strip.length-part-*
  peel collect p1 p2 p3 p4 p5 p6 p7 p8 --out whole

Files: sweep.csv, sweep.svg, sweep.png and parameters.toml, the same bit for bit as the undivided sweep writes, but for
the times. The command in parameters.toml is that of the undivided sweep. Without --out the folder is that of the
undivided sweep as well.

Missing parts: what is there is written, the message names what is missing, and the exit status is 3. The folder then
holds collect.partial.json besides. Give the command again with the late parts: it needs no --force, and removes that
file when nothing is missing. A folder in which a part is still being computed may be given; its part counts as missing.

A part that was computed twice: the results have to be equal, bit for bit but for the times, and a remark says so. Of
each value the first folder counts. Different results are refused, with the first difference.

Parts of different sweeps are refused, with the first difference: another scene, key, value, number of parts or version.

Exit status:
  0  done
  1  another error, such as a folder that cannot be written
  2  bad input: no part, parts of different sweeps, or the output folder is not empty and --force is not given
  3  parts are missing, or the computation of values stopped short: what is there is written all the same";
