//! `peel sweep` of whole peels: each value peeled from rest to its end, kept as soon as it is done, and taken up again
//! by the same command after it was interrupted.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::failed::failed_rows;
use super::{files, no_effect};
use crate::command_line::command_line;
use crate::interrupt::Interrupt;
use crate::output::{list_files, progress_bar, say};
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use indicatif::ProgressBar;
use peelkit::study;
use peelkit_report::{
    Existing, OutputFolder, PartHeader, PartialSweep, ReportError, SweepRow, SweepSummary, SweptKeys,
};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Peels every value; of a divided sweep those of the part.
pub fn peel_each(
    args: &Sweep,
    scene: &Scene,
    cases: &Cases,
    part: Option<&PartHeader>,
    wanted: WantedUnits,
) -> Result<(), Stop> {
    let (keys, all) = (cases.keys, cases.all.as_slice());
    let command = command_line();
    let (rows, mut remarks, files) = match args.folder() {
        Some(folder) => {
            let bar = progress_bar(all.len());
            // before anything is written
            let above = bar.clone();
            let answer = "stopping when the values being computed are done; Ctrl-C again stops at once";
            let interrupt = Interrupt::listen(move || above.println(answer));
            let (partial, output) = open(args, &folder, scene, keys)?;
            let kept = Kept { partial, bar, interrupt };
            let (rows, remarks) = kept.peel(all)?;
            let files = write(&output, scene, &command, cases, &rows, part);
            if files.is_ok() && rows.len() == all.len() {
                PartialSweep::discard(&folder)?;
            }
            (rows, remarks, files)
        }
        None => (peel_unkept(all), Vec::new(), Ok(Vec::new())),
    };
    remarks.extend(no_effect::seen(keys, &rows));
    if args.json {
        let summary = SweepSummary::new(scene, keys, &rows, &remarks).with_command(&command);
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::sweep(scene, keys, &rows, &remarks, wanted), list_files(&files)))?;
    }
    files?;
    stopped_short(keys, &rows, all.len())
}

/// Peels one value.
fn row(Case { value, second, scene }: &Case) -> SweepRow {
    let peel = |model: &_| study::peel(model, &scene.accuracy, &scene.bounds.from_now());
    SweepRow { second: *second, ..SweepRow::of(*value, scene.model.clone(), peel) }
}

/// Nothing is written, so nothing is kept.
fn peel_unkept(cases: &[Case]) -> Vec<SweepRow> {
    let bar = progress_bar(cases.len());
    let run = |case: &Case| {
        let row = row(case);
        bar.inc(1);
        row
    };
    let rows = study::sweep(cases, &|| true, &run);
    bar.finish_and_clear();
    rows
}

/// A sweep whose finished values are kept while it runs.
struct Kept {
    partial: PartialSweep,
    bar: ProgressBar,
    interrupt: Interrupt,
}

/// A folder that keeps the values of an unfinished sweep is one to go on with; any other that holds something is refused.
fn open(
    args: &Sweep,
    folder: &Path,
    scene: &Scene,
    keys: SweptKeys,
) -> Result<(PartialSweep, OutputFolder), ReportError> {
    if !PartialSweep::is_in(folder) {
        args.out.claim(folder)?;
    } else if args.fresh {
        PartialSweep::discard(folder)?;
    }
    let partial = PartialSweep::open(folder, scene, keys, args.part)?;
    Ok((partial, OutputFolder::claim(folder, Existing::Replace)?))
}

impl Kept {
    /// The rows in the order of the cases, those of an earlier run among them, and where they come from. After Ctrl-C
    /// some are missing.
    fn peel(&self, cases: &[Case]) -> Result<(Vec<SweepRow>, Vec<String>), ReportError> {
        let known = |case: &Case| self.partial.found(case.value, case.second);
        let missing: Vec<Case> = cases.iter().filter(|case| known(case).is_none()).cloned().collect();
        let taken = cases.len() - missing.len();
        let computed = self.peel_missing(&missing, taken)?;
        let mut computed = computed.into_iter().peekable();
        let row = |case: &Case| match known(case) {
            Some((found, solve_s)) => {
                let (model, found) = (case.scene.model.clone(), found.clone());
                Some(SweepRow { value: case.value, second: case.second, model, found, solve_s })
            }
            None => computed.next_if(|row| (row.value, row.second) == (case.value, case.second)),
        };
        Ok((cases.iter().filter_map(row).collect(), self.remarks(taken, cases.len())))
    }

    /// Stops on Ctrl-C, and with an error where a row cannot be kept.
    fn peel_missing(&self, missing: &[Case], taken: usize) -> Result<Vec<SweepRow>, ReportError> {
        self.bar.set_position(taken as u64);
        // what was taken says nothing about the time to go
        self.bar.reset_eta();
        let trouble = OnceLock::new();
        let run = |case: &Case| {
            let row = row(case);
            if let Err(error) = self.partial.keep(&row) {
                // only the first one is reported
                let _ = trouble.set(error);
            }
            self.bar.inc(1);
            row
        };
        let rows = study::sweep(missing, &|| !self.interrupt.asked() && trouble.get().is_none(), &run);
        self.bar.finish_and_clear();
        trouble.into_inner().map_or(Ok(rows), Err)
    }

    fn remarks(&self, taken: usize, values: usize) -> Vec<String> {
        let resumed = (taken > 0).then(|| format!("{taken} of {values} values taken from an earlier, interrupted run"));
        resumed.into_iter().collect()
    }
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

/// Whether values are missing, and those whose computation stopped short.
fn stopped_short(keys: SweptKeys, rows: &[SweepRow], values: usize) -> Result<(), Stop> {
    let interrupted = (rows.len() < values).then(|| {
        let done = rows.len();
        format!(
            "interrupted, {done} of {values} values are done; the same command resumes from there, --fresh starts anew"
        )
    });
    let parts: Vec<String> = interrupted.into_iter().chain(failed_rows(keys, rows)).collect();
    if parts.is_empty() { Ok(()) } else { Err(Stop::cut_short(parts.join("\nand "))) }
}
