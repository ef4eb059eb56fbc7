//! `peel sweep` of whole peels: each value peeled from rest to its end.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::failed::{failed_rows, stopped_short};
use super::kept::{Found, compute};
use super::{files, no_effect};
use crate::command_line::command_line;
use crate::output::{list_files, say};
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit::study::{self, PeelResult};
use peelkit_report::{OutputFolder, PartHeader, ReportError, SweepRow, SweepSummary};
use peelkit_scene::Scene;
use std::path::PathBuf;

/// Peels every value; of a divided sweep those of the part.
pub fn peel_each(
    args: &Sweep,
    scene: &Scene,
    cases: &Cases,
    part: Option<&PartHeader>,
    wanted: WantedUnits,
) -> Result<(), Stop> {
    let keys = cases.keys;
    let command = command_line();
    let computed = compute(args, scene, cases, &peel)?;
    let rows: Vec<SweepRow> = computed.all.iter().map(row).collect();
    let write = |output: &OutputFolder| write(output, scene, &command, cases, &rows, part);
    let files = computed.output.as_ref().map_or(Ok(Vec::new()), write);
    if files.is_ok() && rows.len() == cases.all.len() {
        computed.discard()?;
    }
    let mut remarks = computed.remarks;
    remarks.extend(no_effect::seen(keys, &rows));
    if args.json {
        let summary = SweepSummary::new(scene, keys, &rows, &remarks).with_command(&command);
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::sweep(scene, keys, &rows, &remarks, wanted), list_files(&files)))?;
    }
    files?;
    stopped_short([rows.len(), cases.all.len()], failed_rows(keys, &rows))
}

fn peel(Case { scene, .. }: &Case) -> PeelResult {
    PeelResult::from(&study::peel(&scene.model, &scene.accuracy, &scene.bounds.from_now()))
}

fn row(Found { case, found, solve_s }: &Found<PeelResult>) -> SweepRow {
    let Case { value, second, scene } = case;
    SweepRow { value: *value, second: *second, model: scene.model.clone(), found: found.clone(), solve_s: *solve_s }
}

/// Nothing is written where nothing was reached.
fn write(
    output: &OutputFolder,
    scene: &Scene,
    command: &str,
    cases: &Cases,
    rows: &[SweepRow],
    part: Option<&PartHeader>,
) -> Result<Vec<PathBuf>, ReportError> {
    if rows.is_empty() {
        return Ok(Vec::new());
    }
    output.write(|dir| match part {
        None => files::write_all(dir, scene, command, cases, rows),
        Some(header) => files::write_part(dir, scene, command, cases, rows, header),
    })
}
