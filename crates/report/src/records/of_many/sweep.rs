//! A sweep: sweep.csv, and the same as one object.

use crate::records::summary::{Found, Summary};
use crate::swept::{SweepRow, SweptKeys, as_given};
use crate::writing::error::ReportError;
use crate::writing::names::end_word;
use crate::writing::record::write_text;
use crate::writing::record::{Bounded, Cell, Fields, Object, Record, columns, csv};
use crate::writing::reference::Output;
use peelkit::study::{self, FollowedPoint, FollowedRow, FollowedSweep, LimitPoint, PeelResult, PointKind};
use peelkit_scene::{Key, Scene};
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// One value of a sweep in short.
#[derive(Clone, Copy, Debug)]
pub struct SweepLine<'a> {
    value: f64,
    second: Option<f64>,
    found: FoundAt<'a>,
    solve_s: f64,
}

/// What was computed at a value.
#[derive(Clone, Copy, Debug)]
enum FoundAt<'a> {
    Peel(&'a PeelResult),
    Followed(PointKind, &'a FollowedRow),
}

impl Record for SweepLine<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "of the key that is varied, in nm, GPa, aJ, J/m2, N/m, nN, rad, rad/nm or s, or a plain number", |line| line.value);
        of.sometimes("value_2", "of the second key, where two are varied", |line| line.second);
        of.bounded(["peak_force_nN", "peak_error_nN"], "force of `peak`, the largest up to the first jump", |line| line.of(|found| found.peak).map(|at| Bounded::new(at.force, at.force_error)));
        of.bounded(["peak_displacement_nm", "peak_error_nm"], "u at the peak", |line| line.of(|found| found.peak).map(|at| Bounded::new(at.displacement, at.displacement_error)));
        of.bounded(["initiation_peak_nN", "initiation_peak_error_nN"], "the first local maximum of the force", |line| line.point(PointKind::InitiationPeak).map(force));
        of.bounded(["initiation_peak_displacement_nm", "initiation_peak_error_nm"], "u there", |line| line.point(PointKind::InitiationPeak).map(displacement));
        of.bounded(["plateau_force_nN", "plateau_error_nN"], "force of the plateau", |line| line.of(|found| found.plateau).map(|at| Bounded { value: at.force, error: at.force_error }));
        of.field("plateau_displacement_nm", "u there", |line| line.of(|found| found.plateau).map(|at| at.displacement));
        of.field("plateau_error_nm", "how far from there the force changes as little", |line| line.of(|found| found.plateau).and_then(|at| at.displacement_error));
        of.bounded(["snap_off_displacement_nm", "snap_off_error_nm"], "u at the first jump", |line| line.point(PointKind::SnapOff).map(displacement));
        of.bounded(["snap_off_force_nN", "snap_off_error_nN"], "P at the first jump", |line| line.point(PointKind::SnapOff).map(force));
        of.bounded(["work_aJ", "work_error_aJ"], "work to the first jump, or to the end of a path without one, which is not the work of peeling: see `work_to`", |line| line.work());
        of.field("work_to", "where `work_aJ` goes to: `first jump` or `end of path`", |line| line.work_to());
        of.bounded(["pad_detachment_displacement_nm", "pad_detachment_error_nm"], "u where the pad comes off", |line| line.of(|found| found.pad_detachment).map(|at| displacement(at.into())));
        of.bounded(["pad_detachment_force_nN", "pad_detachment_error_nN"], "P there", |line| line.of(|found| found.pad_detachment).map(|at| force(at.into())));
        of.bounded(["pad_detachment_work_aJ", "pad_detachment_work_error_aJ"], "work to there", |line| line.of(|found| found.pad_detachment).map(work));
        of.bounded(["detachment_displacement_nm", "detachment_error_nm"], "u where all comes off", |line| line.of(|found| found.detachment).map(|at| displacement(at.into())));
        of.bounded(["detachment_force_nN", "detachment_error_nN"], "P there", |line| line.of(|found| found.detachment).map(|at| force(at.into())));
        of.bounded(["detachment_work_aJ", "detachment_work_error_aJ"], "work to there", |line| line.of(|found| found.detachment).map(work));
        of.field("largest_computed_force_nN", "where there is no peak; without a bound", |line| line.of(|found| found.largest_computed_force).map(|at| at.force));
        of.field("end", "how its path ended", |line| line.of(|found| Some(end_word(&found.end))));
        of.field("accuracy_reached", "largest relative bound of this value", |line| line.of(|found| found.reached));
        of.field("solve_s", "time of this value", |line| line.solve_s);
        of.field("points", "points of its path", |line| line.of(|found| Some(found.effort.points)));
        of.field("newton_iterations", "on all meshes", |line| line.newton_iterations());
        of.field("elements", "of the final mesh", |line| line.mesh().map(|[elements, _]| elements));
        of.field("order", "of the elements", |line| line.mesh().map(|[_, order]| order));
    }
}

fn force(at: FollowedPoint) -> Bounded {
    Bounded::new(at.force, at.force_error)
}

fn displacement(at: FollowedPoint) -> Bounded {
    Bounded::new(at.displacement, at.displacement_error)
}

fn work(at: LimitPoint) -> Bounded {
    Bounded { value: at.work, error: at.work_error }
}

impl<'a> SweepLine<'a> {
    /// What a peel found at a value, or a pair of them, in so many seconds.
    pub fn new(value: f64, second: Option<f64>, found: &'a PeelResult, solve_s: f64) -> Self {
        Self { value, second, found: FoundAt::Peel(found), solve_s }
    }

    /// The values of a sweep that followed one point, each in so many seconds.
    pub fn followed(sweep: &'a FollowedSweep, solve_s: &[f64]) -> Vec<Self> {
        let line = |(row, &solve_s): (&'a FollowedRow, &f64)| {
            let found = FoundAt::Followed(sweep.kind, row);
            Self { value: row.value, second: None, found, solve_s }
        };
        sweep.rows.iter().zip(solve_s).map(line).collect()
    }

    /// Of a whole peel.
    fn of<T>(&self, of: impl FnOnce(&'a PeelResult) -> Option<T>) -> Option<T> {
        match self.found {
            FoundAt::Peel(found) => of(found),
            FoundAt::Followed(..) => None,
        }
    }

    /// A point that can be followed.
    fn point(&self, kind: PointKind) -> Option<FollowedPoint> {
        match (self.found, kind) {
            (FoundAt::Peel(found), PointKind::InitiationPeak) => found.initiation_peak.map(FollowedPoint::from),
            (FoundAt::Peel(found), PointKind::SnapOff) => found.snap_off.map(FollowedPoint::from),
            (FoundAt::Followed(followed, row), _) => row.point.filter(|_| followed == kind),
        }
    }

    fn work(&self) -> Option<Bounded> {
        let (value, error) = match self.found {
            FoundAt::Peel(found) => (found.work, found.snap_off.and_then(|at| at.work_error)),
            FoundAt::Followed(..) => (self.point(PointKind::SnapOff).and_then(|at| at.work), None),
        };
        value.map(|value| Bounded { value, error })
    }

    fn work_to(&self) -> Option<&'static str> {
        match self.found {
            FoundAt::Peel(found) => work_to(found),
            FoundAt::Followed(..) => self.work().map(|_| "first jump"),
        }
    }

    fn newton_iterations(&self) -> usize {
        match self.found {
            FoundAt::Peel(found) => found.effort.newton_iterations,
            FoundAt::Followed(_, row) => row.newton_iterations,
        }
    }

    /// Elements and their order.
    fn mesh(&self) -> Option<[usize; 2]> {
        match self.found {
            FoundAt::Peel(found) => Some([found.effort.elements, found.effort.order]),
            FoundAt::Followed(_, row) => row.point.map(|_| [row.elements, study::FOLLOWED_ORDER]),
        }
    }
}

/// Up to where the work of a row goes: where there is no first jump, that is not the work of peeling.
pub fn work_to(found: &PeelResult) -> Option<&'static str> {
    let end = || found.work.map(|_| "end of path");
    found.snap_off.map(|_| "first jump").or_else(end)
}

impl<'a> From<&'a SweepRow> for SweepLine<'a> {
    fn from(row: &'a SweepRow) -> Self {
        Self::new(row.value, row.second, &row.found, row.solve_s)
    }
}

/// The table and the object.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::table("sweep.csv", SweepLine::keys()),
        Output::object("peel sweep --json", SweepSummary::<SweepLine>::keys()),
    ]
}

/// Writes sweep.csv: one row a value, or a pair of values. Behind `value` the same number stands once more in a column that names its key
/// and the unit in which a user gives it: an angle in degrees.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_sweep<'k>(dir: &Path, keys: impl Into<SweptKeys<'k>>, rows: &[SweepRow]) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys.into(), rows.iter().map(SweepLine::from))
}

/// Writes sweep.csv of a sweep that followed one point, each value in so many seconds: the same columns, empty where nothing was
/// computed.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_followed<'k>(
    dir: &Path,
    keys: impl Into<SweptKeys<'k>>,
    sweep: &FollowedSweep,
    solve_s: &[f64],
) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys.into(), SweepLine::followed(sweep, solve_s).into_iter())
}

/// Writes sweep.csv of records that begin with `value`, and with `value_2` where two keys are varied.
pub(crate) fn write_swept<R: Record>(
    dir: &Path,
    keys: SweptKeys,
    rows: impl Iterator<Item = R>,
) -> Result<PathBuf, ReportError> {
    let mut header = columns::<R>();
    header.retain(|name| name != "value_2" || keys.second.is_some());
    let (names, count) = (keys.columns(), keys.keys().count());
    header.splice(count..count, names.iter().cloned());
    let rows = rows.map(|row| {
        let Object(mut cells) = row.object();
        let given = |((name, key), (_, value)): ((&String, &Key), &(_, Cell))| {
            (Cow::from(name.clone()), cell_as_given(key, value))
        };
        let named: Vec<_> = names.iter().zip(keys.keys()).zip(&cells).map(given).collect();
        cells.splice(count..count, named);
        Object(cells)
    });
    write_text(dir, "sweep.csv", csv(&header, rows))
}

/// A value in the unit in which a user gives the key.
fn cell_as_given(key: &Key, value: &Cell) -> Cell {
    match value {
        Cell::Number(number) if key.per_usual_unit() != 1.0 => Cell::Text(as_given(key, *number).to_string()),
        value => value.clone(),
    }
}

/// The rows of a sweep and the keys that were varied.
#[derive(Clone, Debug)]
pub struct Sweep<'a, L> {
    keys: SweptKeys<'a>,
    /// The point that was followed from value to value, where the values were not peeled one by one
    followed: Option<PointKind>,
    /// What happened to that point on the way, or where the rows come from
    remarks: Vec<String>,
    rows: Vec<L>,
}

/// A sweep as one object: the key that was varied, its unit, and a row a value.
pub type SweepSummary<'a, L = SweepLine<'a>> = Summary<'a, Sweep<'a, L>>;

impl<L: Record> Record for Sweep<'_, L> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("vary", "the key that was varied", |sweep| sweep.keys.first.path());
        of.field("unit", "of `value` in the rows; null where the key is a plain number", |sweep| unit(sweep.keys.first));
        of.sometimes("vary_2", "the second key, where two are varied", |sweep| sweep.keys.second.map(Key::path));
        of.sometimes("unit_2", "of `value_2`; null likewise", |sweep| sweep.keys.second.and_then(unit));
        of.sometimes("followed", "with `--follow`: the point that was followed", |sweep| sweep.followed.map(PointKind::word));
        of.sometimes("remarks", "what happened to that point on the way, or where the rows come from", |sweep| Some(sweep.remarks.clone()).filter(|remarks| !remarks.is_empty()));
        of.field("rows", "a row for each value: the columns of sweep.csv", |sweep| sweep.rows.iter().map(Record::object).collect::<Vec<_>>());
    }
}

fn unit(key: &Key) -> Option<&'static str> {
    Some(key.unit()).filter(|unit| !unit.is_empty())
}

impl<L: Record> Found for Sweep<'_, L> {
    const PARAMETERS: &'static str = "the scene before the sweep";
}

impl<'a> SweepSummary<'a> {
    /// The summary of these rows, in which keys of the scene were varied, and what is to be said of them besides.
    pub fn new(
        scene: &'a Scene,
        keys: impl Into<SweptKeys<'a>>,
        rows: impl IntoIterator<Item = &'a SweepRow>,
        remarks: &[String],
    ) -> Self {
        Self::of_rows(scene, keys.into(), rows.into_iter().map(SweepLine::from), remarks)
    }

    /// The same for a point that was followed while `key` was varied, each value in so many seconds.
    pub fn followed(scene: &'a Scene, key: &'a Key, sweep: &'a FollowedSweep, solve_s: &[f64]) -> Self {
        let remarks: Vec<_> = sweep.remarks.iter().map(ToString::to_string).collect();
        let rows = SweepLine::followed(sweep, solve_s);
        let found = Sweep { keys: key.into(), followed: Some(sweep.kind), remarks, rows };
        Summary::of(scene, found)
    }
}

impl<'a, L: Record> SweepSummary<'a, L> {
    /// The summary of these records.
    pub(crate) fn of_rows(
        scene: &'a Scene,
        keys: SweptKeys<'a>,
        rows: impl Iterator<Item = L>,
        remarks: &[String],
    ) -> Self {
        Summary::of(scene, Sweep { keys, followed: None, remarks: remarks.to_vec(), rows: rows.collect() })
    }
}
