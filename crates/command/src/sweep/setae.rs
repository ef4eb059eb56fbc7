//! `peel sweep` of a scene with a seta: each value pulled off.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::failed::{failed, place, stopped_short};
use super::kept::{Found, compute};
use super::no_effect;
use crate::command_line::command_line;
use crate::output::{list_files, say};
use crate::seta::Setae;
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit::study::SetaResult;
use peelkit_report::{self as report, OutputFolder, ReportError, SetaRow, SweepSummary, SweptKeys, seta_end_reason};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// What of `peel sweep` has no meaning for a seta.
pub fn refuse(args: &Sweep) -> Result<(), Stop> {
    if args.followed().is_some() {
        return Err(Stop::bad_input(
            "--follow and --peak-only have no meaning for a seta: they follow a limit point of one beam",
            "Omit them: each value is pulled off as a whole.",
        ));
    }
    if args.part.is_some() {
        return Err(Stop::bad_input(
            "--part divides sweeps of single beams, and this is one of setae",
            "Omit it, and give each machine values of its own with --from and --to, or --values.",
        ));
    }
    Ok(())
}

/// Pulls the seta of every value off.
pub fn pull_off_each(args: &Sweep, scene: &Scene, cases: &Cases, wanted: WantedUnits) -> Result<(), Stop> {
    let keys = cases.keys;
    let command = command_line();
    let setae = Setae::like(scene);
    let pull_off = |case: &Case| setae.pull_off(&case.scene, &case.scene.bounds.from_now());
    let computed = compute(args, scene, cases, &pull_off)?;
    let rows: Vec<SetaRow> = computed.all.iter().map(row).collect();
    let write = |output: &OutputFolder| write(output, scene, &command, cases, &rows);
    let files = computed.output.as_ref().map_or(Ok(Vec::new()), write);
    if files.is_ok() && rows.len() == cases.all.len() {
        computed.discard()?;
    }
    let mut remarks = computed.remarks;
    remarks.extend(no_effect::of_alike(keys, rows.len(), alike(&rows)));
    if args.json {
        let summary = SweepSummary::of_setae(scene, keys, &rows, &remarks).with_command(&command);
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::swept_setae(scene, keys, &rows, &remarks, wanted), list_files(&files)))?;
    }
    files?;
    stopped_short([rows.len(), cases.all.len()], failed_rows(keys, &rows))
}

fn row(Found { case, found, solve_s }: &Found<Result<SetaResult, String>>) -> SetaRow {
    SetaRow { value: case.value, second: case.second, found: found.clone(), solve_s: *solve_s }
}

/// Whether all values gave the same.
fn alike(rows: &[SetaRow]) -> bool {
    rows.len() > 1 && rows.iter().all(|row| row.found.is_ok() && row.found == rows[0].found)
}

/// The values that were not pulled off to their end, each with its reason.
fn failed_rows(keys: SweptKeys, rows: &[SetaRow]) -> Option<String> {
    let reason = |row: &SetaRow| {
        let why = match &row.found {
            Ok(found) if found.end.is_failure() => seta_end_reason(&found.end)?,
            Ok(_) => return None,
            Err(why) => why.clone(),
        };
        Some(format!("at {}: {why}", place(keys, row.value, row.second)))
    };
    failed(&rows.iter().filter_map(reason).collect::<Vec<_>>(), rows.len())
}

/// Nothing is written where nothing was reached.
fn write(
    output: &OutputFolder,
    scene: &Scene,
    command: &str,
    cases: &Cases,
    rows: &[SetaRow],
) -> Result<Vec<PathBuf>, ReportError> {
    if rows.is_empty() {
        return Ok(Vec::new());
    }
    output.write(|dir: &Path| {
        let mut files =
            vec![report::write_swept_setae(dir, cases.keys, rows)?, report::write_parameters(dir, scene, command)?];
        if rows.iter().any(|row| row.peak().is_some()) {
            files.extend(report::draw_swept_setae(dir, cases.keys, rows, &scene.title, cases.log)?);
        }
        Ok(files)
    })
}
