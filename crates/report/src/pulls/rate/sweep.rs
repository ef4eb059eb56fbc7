//! A sweep of pulls at a rate: its rows, sweep.csv, the same as one object, and the picture.
use crate::chart::picture::Heading;
use crate::chart::style::colour;
use crate::pulls::swept_pulls::{Quantity, draw_swept_pulls};
use crate::records::of_many::sweep::{SweepSummary, write_swept};
use crate::records::pulled::PulledAtRate;
use crate::swept::{PullRow, SweptKeys};
use crate::writing::error::ReportError;
use crate::writing::number::S_PER_NS;
use crate::writing::record::{Fields, Record};
use peelkit_scene::Scene;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The numbers of a pull at a rate. Forces in nN, displacements in nm, energies in aJ, times in s.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RateResult {
    /// The largest force of the pull: of a beam by a parabola through the three steps next to it
    pub largest_force: f64,
    /// Of what moves the grip, there
    pub displacement: f64,
    /// Since the pull began, there
    pub time: f64,
    /// Kinetic energy at the step next to it
    pub kinetic: f64,
    /// Dissipated by the material up to that step
    pub dissipated: f64,
    /// When nothing adhered any more for the first time
    pub contact_lost: Option<f64>,
    /// Mean force from half to nine tenths of the way
    pub mean_force: Option<f64>,
    /// Of the grip, or of the machine behind its spring, to the end
    pub work: f64,
    /// Largest defect of the balance over the largest work
    pub imbalance: f64,
    /// Steps in time
    pub steps: usize,
    /// Newton iterations
    pub newton_iterations: usize,
    /// Elements of the mesh
    pub elements: usize,
    /// Why it stopped short, if it did
    pub failed: Option<String>,
}

impl RateResult {
    /// Of a pull, and why it stopped short, if it did.
    pub fn new(pulled: &PulledAtRate, failed: Option<String>) -> Self {
        let next = pulled.next_to_peak().map(|next| next.balance).unwrap_or_default();
        let (time, displacement, largest_force) =
            pulled.peak.map_or((0.0, 0.0, 0.0), |at| (at.time, at.displacement, at.force));
        Self {
            largest_force,
            displacement,
            time: S_PER_NS * time,
            kinetic: next.kinetic,
            dissipated: next.dissipated,
            contact_lost: pulled.contact_lost.map(|time| S_PER_NS * time),
            mean_force: pulled.mean_force(),
            work: pulled.change().work,
            imbalance: pulled.imbalance,
            steps: pulled.steps(),
            newton_iterations: pulled.iterations,
            elements: pulled.elements,
            failed,
        }
    }
}

/// One value of a sweep of pulls at a rate.
pub type RateRow = PullRow<RateResult>;

impl RateRow {
    /// The name of its end in outputs.
    pub fn end(&self) -> &'static str {
        match &self.found {
            Err(_) | Ok(RateResult { failed: Some(_), .. }) => "failed",
            Ok(found) if found.contact_lost.is_some() => "detached",
            Ok(_) => "still-attached",
        }
    }

    /// What was found of a pull that was followed to its end.
    pub(super) fn finished(&self) -> Option<&RateResult> {
        self.found.as_ref().ok().filter(|found| found.failed.is_none())
    }
}

// -- The table of a sweep of pulls at a rate, sweep.csv, and the same as one object --

impl Record for RateRow {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "the value of the key that was varied", |row| row.value);
        of.sometimes("value_2", "of the second key, where two are varied", |row| row.second);
        of.field("largest_force_nN", "the largest force of the pull, as in summary.json", |row| row.of(|found| Some(found.largest_force)));
        of.field("displacement_nm", "of what moves the grip, or the root, there", |row| row.of(|found| Some(found.displacement)));
        of.field("time_s", "since the pull began, there", |row| row.of(|found| Some(found.time)));
        of.field("kinetic_aJ", "kinetic energy at the step next to it", |row| row.of(|found| Some(found.kinetic)));
        of.field("dissipated_aJ", "dissipated up to that step", |row| row.of(|found| Some(found.dissipated)));
        of.field("contact_lost_s", "when nothing adheres any more for the first time; empty where that does not happen", |row| row.of(|found| found.contact_lost));
        of.field("mean_force_nN", "mean force from half to nine tenths of the way, as in summary.json", |row| row.of(|found| found.mean_force));
        of.field("work_aJ", "work of the grip, or of the machine behind its spring, to the end", |row| row.of(|found| Some(found.work)));
        of.field("imbalance", "largest defect of the balance of energies at any step, over the largest work", |row| row.of(|found| Some(found.imbalance)));
        of.field("end", "as in summary.json of a pull at a rate", |row| row.end());
        of.field("solve_s", "wall clock", |row| row.solve_s);
        of.field("steps", "steps in time", |row| row.of(|found| Some(found.steps)));
        of.field("newton_iterations", "Newton iterations", |row| row.of(|found| Some(found.newton_iterations)));
        of.field("elements", "elements of the mesh, which stays", |row| row.of(|found| Some(found.elements)));
    }
}

/// Writes sweep.csv of a sweep of pulls at a rate: one row a value, or a pair of values. Behind `value` the same number stands once more in a column
/// that names its key and unit.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_rates(dir: &Path, keys: SweptKeys, rows: &[RateRow]) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys, rows.iter())
}

impl<'a> SweepSummary<'a, &'a RateRow> {
    /// The summary of rows of pulls at a rate.
    pub fn of_rates(scene: &'a Scene, keys: SweptKeys<'a>, rows: &'a [RateRow], remarks: &[String]) -> Self {
        Self::of_rows(scene, keys, rows.iter(), remarks)
    }
}

// -- The picture of a sweep of pulls at a rate: the largest force and what is dissipated up to it, against the varied value; or maps over two --

const QUANTITIES: [Quantity<RateResult>; 2] = [
    Quantity {
        label: "largest force P (nN)",
        of: |row| row.finished().map(|found| found.largest_force),
        colour: colour::BLUE,
        height: 280.0,
        has_map: true,
    },
    Quantity {
        label: "dissipated up to it (aJ)",
        of: |row| row.finished().map(|found| found.dissipated),
        colour: colour::VERMILLION,
        height: 180.0,
        has_map: true,
    },
];

/// Draws `sweep.svg` and `sweep.png` into `dir`: of one key the largest force and what is dissipated up to it against its values, of two keys maps of
/// both, on logarithmic axes where `log` is set.
///
/// Fails where no pull was followed to its end, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_rates<'h>(
    dir: &Path,
    keys: SweptKeys,
    rows: &[RateRow],
    heading: impl Into<Heading<'h>>,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    draw_swept_pulls(dir, keys, rows, (&QUANTITIES, "was pulled to its end"), heading.into(), log)
}
