//! `peel sweep` of a scene with a table `[time]`: each value pulled at its rate.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::failed::{failed, place, stopped_short};
use super::kept::{Found, compute};
use super::no_effect;
use crate::command_line::command_line;
use crate::output::{list_files, say};
use crate::run::rate::should_stop;
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit::study::pull_in_time;
use peelkit_report::{self as report, OutputFolder, RateResult, RateRow, ReportError, SweepSummary, SweptKeys};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// What of `peel sweep` has no meaning for a pull at a rate.
pub fn refuse(args: &Sweep) -> Result<(), Stop> {
    if args.followed().is_some() {
        return Err(Stop::bad_input(
            "--follow and --peak-only have no meaning for a pull at a rate: they follow a limit point of equilibria",
            "Omit them: each value is pulled as a whole.",
        ));
    }
    if args.part.is_some() {
        return Err(Stop::bad_input(
            "--part divides sweeps of equilibria, and this is one of pulls at a rate",
            "Omit it, and give each machine values of its own with --from and --to, or --values.",
        ));
    }
    Ok(())
}

/// Pulls at the rate of every value.
pub fn pull_each(args: &Sweep, scene: &Scene, cases: &Cases, wanted: WantedUnits) -> Result<(), Stop> {
    let keys = cases.keys;
    let command = command_line();
    let computed = compute(args, scene, cases, &|case: &Case| pull(&case.scene))?;
    let rows: Vec<RateRow> = computed.all.iter().map(row).collect();
    let write = |output: &OutputFolder| write(output, scene, &command, cases, &rows);
    let files = computed.output.as_ref().map_or(Ok(Vec::new()), write);
    if files.is_ok() && rows.len() == cases.all.len() {
        computed.discard()?;
    }
    let mut remarks = computed.remarks;
    remarks.extend(no_effect::of_alike(keys, rows.len(), alike(&rows)));
    if args.json {
        let summary = SweepSummary::of_rates(scene, keys, &rows, &remarks).with_command(&command);
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::swept_rates(scene, keys, &rows, &remarks, wanted), list_files(&files)))?;
    }
    files?;
    stopped_short([rows.len(), cases.all.len()], failed_rows(keys, &rows))
}

/// The pull of a scene, or why there is none.
fn pull(scene: &Scene) -> Result<RateResult, String> {
    let Some(table) = &scene.time else { return Err("the scene has no [time]".to_owned()) };
    let (pull, accuracy) = (scene.pull_rate(table), scene.time_accuracy(table));
    let stop = should_stop(&scene.bounds.from_now());
    match pull_in_time(&scene.model, &table.moving_material(), &pull, &accuracy, stop) {
        Ok(pulled) => Ok(RateResult::new(&pulled, None)),
        Err(failure) => match failure.reached {
            Some(reached) => Ok(RateResult::new(&reached, Some(failure.why.to_string()))),
            None => Err(failure.why.to_string()),
        },
    }
}

fn row(Found { case, found, solve_s }: &Found<Result<RateResult, String>>) -> RateRow {
    RateRow { value: case.value, second: case.second, found: found.clone(), solve_s: *solve_s }
}

/// Whether all values gave the same.
fn alike(rows: &[RateRow]) -> bool {
    rows.len() > 1 && rows.iter().all(|row| row.found.is_ok() && row.found == rows[0].found)
}

/// The values that were not pulled to their end, each with its reason.
fn failed_rows(keys: SweptKeys, rows: &[RateRow]) -> Option<String> {
    let reason = |row: &RateRow| {
        let why = match &row.found {
            Ok(found) => found.failed.clone()?,
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
    rows: &[RateRow],
) -> Result<Vec<PathBuf>, ReportError> {
    if rows.is_empty() {
        return Ok(Vec::new());
    }
    output.write(|dir: &Path| {
        let mut files =
            vec![report::write_swept_rates(dir, cases.keys, rows)?, report::write_parameters(dir, scene, command)?];
        if rows.iter().any(|row| row.found.as_ref().is_ok_and(|found| found.failed.is_none())) {
            files.extend(report::draw_swept_rates(dir, cases.keys, rows, &scene.title, cases.log)?);
        }
        Ok(files)
    })
}
