//! `peel sweep` of pulls of which each is found as a whole, or not at all: of setae, or at a rate.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::conclusion::Conclusion;
use super::failed::{failed, place};
use super::kept::{Found, compute};
use super::no_effect;
use crate::command_line::command_line;
use crate::stop::Stop;
use crate::text_summary::WantedUnits;
use peelkit_report::{self as report, PullRow, ReportError, Storable, SweptKeys};
use peelkit_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// Rows of a scene in which keys are varied.
pub struct Swept<'s, F> {
    pub scene: &'s Scene,
    pub keys: SweptKeys<'s>,
    pub rows: &'s [PullRow<F>],
    /// Whether the axes of the keys are logarithmic.
    pub log: [bool; 2],
}

/// What a sweep of pulls is of.
pub trait Pulled: Storable + Send + Sync {
    /// Why the pull stopped short, if it did.
    fn failure(&self) -> Option<String>;
    /// Whether the pull of a row has a place in the picture.
    fn is_drawn(&self) -> bool;
    /// Writes the table of all rows.
    fn write(swept: &Swept<Self>, dir: &Path) -> Result<PathBuf, ReportError>;
    /// Draws them.
    fn draw(swept: &Swept<Self>, dir: &Path) -> Result<Vec<PathBuf>, ReportError>;
    /// Them as one object, with remarks and the command line.
    fn json(swept: &Swept<Self>, remarks: &[String], command: &str) -> io::Result<String>;
    /// Them as a table in units that are wanted.
    fn text(swept: &Swept<Self>, remarks: &[String], wanted: WantedUnits) -> String;
}

/// Refuses what has no meaning for such pulls: why limit points are not followed, what is done with each value instead, and why it is not divided.
pub fn refuse(args: &Sweep, [followed, whole, divided]: [&str; 3]) -> Result<(), Stop> {
    if args.followed().is_some() {
        return Err(Stop::bad_input(followed, whole));
    }
    if args.part.is_some() {
        return Err(Stop::bad_input(
            divided,
            "Omit it, and give each machine values of its own with --from and --to, or --values.",
        ));
    }
    Ok(())
}

/// The pull of every value.
pub fn pull_each<F: Pulled>(
    args: &Sweep,
    scene: &Scene,
    cases: &Cases,
    wanted: WantedUnits,
    pull: &(dyn Fn(&Case) -> Result<F, String> + Sync),
) -> Result<(), Stop> {
    let keys = cases.keys;
    let command = command_line();
    let computed = compute(args, scene, cases, pull)?;
    let rows: Vec<PullRow<F>> = computed.all.iter().map(row).collect();
    let swept = Swept { scene, keys, rows: &rows, log: cases.log };
    computed.conclude(
        args,
        Conclusion {
            done: [rows.len(), cases.all.len()],
            write: &|dir| write(&swept, dir, &command),
            remark: no_effect::of_alike(keys, rows.len(), alike(&rows)),
            json: &|remarks| F::json(&swept, remarks, &command),
            text: &|remarks| F::text(&swept, remarks, wanted),
            failed: failed_rows(keys, &rows),
        },
    )
}

fn row<F: Clone>(Found { case, found, solve_s }: &Found<Result<F, String>>) -> PullRow<F> {
    PullRow { value: case.value, second: case.second, found: found.clone(), solve_s: *solve_s }
}

/// Whether all values gave the same.
fn alike<F: PartialEq>(rows: &[PullRow<F>]) -> bool {
    rows.len() > 1 && rows.iter().all(|row| row.found.is_ok() && row.found == rows[0].found)
}

/// The values that were not pulled to their end, each with its reason.
fn failed_rows<F: Pulled>(keys: SweptKeys, rows: &[PullRow<F>]) -> Option<String> {
    let reason = |row: &PullRow<F>| {
        let why = match &row.found {
            Ok(found) => found.failure()?,
            Err(why) => why.clone(),
        };
        Some(format!("at {}: {why}", place(keys, row.value, row.second)))
    };
    failed(&rows.iter().filter_map(reason).collect::<Vec<_>>(), rows.len())
}

fn write<F: Pulled>(swept: &Swept<F>, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![F::write(swept, dir)?, report::write_parameters(dir, swept.scene, command)?];
    if swept.rows.iter().any(|row| row.found.as_ref().is_ok_and(F::is_drawn)) {
        files.extend(F::draw(swept, dir)?);
    }
    Ok(files)
}
