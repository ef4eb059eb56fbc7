//! The tables of a path: curve.csv, branch.csv, equilibria.csv and limit_points.csv. Units stand in the names of the columns.

use crate::writing::error::ReportError;
use crate::writing::names::limit_point_kind_word;
use crate::writing::record::{Fields, Record};
use crate::writing::record::{table, write_text};
use crate::writing::reference::Output;
use peelkit::model::SpatialGrip;
use peelkit::study::{EventAt, Events, LimitPoint, OutOfPlane, OutOfPlaneBranch, PathPoint, Peel, Station, Stations};
use std::io;
use std::path::{Path, PathBuf};

impl Record for PathPoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u of the grip along the pull", |at| at.displacement);
        of.field("force_nN", "P of the grip along the pull", |at| at.force);
        of.field("end_rotation_rad", "rotation of the grip", |at| at.end_rotation);
        of.field("work_aJ", "∫ P du from the beginning of the path; with the moment of a grip that rotates as it goes", |at| at.work);
        of.field("negative_eigenvalues", "number of unstable directions under displacement control; 0: stable. For `force-only`, which has no energy, the number of negative pivots, of which only the parity is meaningful", |at| at.negative_eigenvalues);
        of.field("negative_eigenvalues_load", "the same under force control; for a grip that rotates as it pulls, under control of P + `turn` · M", |at| at.negative_eigenvalues_load);
        of.field("front_nm", "length that still adheres, by its energy", |at| at.front);
        of.field("newton_iterations", "that the point took", |at| at.iterations);
    }
}

/// What a point of the planar path has besides, where its stability out of the plane is known.
struct OutOfPlaneColumn(Option<usize>);

impl Record for OutOfPlaneColumn {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("negative_eigenvalues_out_of_plane", "with `--out-of-plane`: number of unstable directions out of the plane, grip free to roll, whether displacement or force is held; else empty", |at| at.0);
    }
}

/// The grip at a point of a path in space: columns of curve.csv behind those of the point.
#[derive(Clone, Copy, Debug)]
pub struct GripOfPoint(pub SpatialGrip);

impl Record for GripOfPoint {
    fn fields(of: &mut Fields<Self>) {
        let about = [
            "in space, like the next four: moment of the grip on its roll; 0 where that is free",
            "roll of the grip, about its axis",
            "yaw of the grip, about the normal of the substrate",
            "force of the grip normal to the pull, in its vertical plane; 0 where it is free",
            "force of the grip normal to that plane; 0 where it is free",
        ];
        grip(of, about, |at| at.0);
    }
}

/// A limit point as a row.
struct LimitPointRow<'a>(&'a LimitPoint);

impl Record for LimitPointRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("kind", "`displacement` (du = 0) or `load` (dP = 0)", |at| limit_point_kind_word(at.0.kind));
        of.field("displacement_nm", "u there", |at| at.0.displacement);
        of.field("force_nN", "P there", |at| at.0.force);
        of.field("end_rotation_rad", "rotation of the grip there", |at| at.0.end_rotation);
        of.field("work_aJ", "work of the grip from the beginning of the path to there", |at| at.0.work);
        of.field("error_nm", "bound of the error of the displacement", |at| at.0.displacement_error);
        of.field("error_nN", "bound of the error of the force", |at| at.0.force_error);
        of.field("flat", "whether the force is so level there that the displacement cannot be determined and does not matter", |at| at.0.flat);
        of.field("after_point", "it lies behind this row of curve.csv, counted from 0", |at| at.0.after);
        of.field("error_aJ", "bound of the error of the work; empty with friction and for a load without a potential", |at| at.0.work_error);
    }
}

/// A station, or where an event lies, as a row.
struct StationRow {
    at: EventAt,
    station: Station,
}

impl StationRow {
    fn of(at: EventAt, station: Station) -> Self {
        Self { at, station }
    }
}

impl Record for StationRow {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("quantity", "`displacement`, `force`, `front`, `end_rotation` or `free_end_gap`", |row| row.at.quantity.name());
        of.field("value", "its value that was asked for: nm, of a force nN, of a rotation rad", |row| row.at.value);
        of.part(|row| row.station);
        of.field("event", "the name of an event of the user; empty of a station", |row| row.at.name.clone());
    }
}

/// The grip at a limit point in space.
struct GripOfLimitPoint(SpatialGrip);

impl Record for GripOfLimitPoint {
    fn fields(of: &mut Fields<Self>) {
        let about = [
            "in space, like the next four: moment of the grip on its roll there; 0 where that is free",
            "roll of the grip there",
            "yaw of the grip there",
            "force of the grip there normal to the pull, in its vertical plane; 0 where it is free",
            "force of the grip there normal to that plane; 0 where it is free",
        ];
        grip(of, about, |at| at.0);
    }
}

/// What a point of a path in space has besides one in the plane.
pub(super) fn grip<R>(of: &mut Fields<R>, about: [&'static str; 5], grip: fn(&R) -> SpatialGrip) {
    let [torque, roll, yaw, across, lateral] = about;
    of.field("torque_nN_nm", torque, |at| grip(at).torque);
    of.field("roll_deg", roll, |at| grip(at).roll.to_degrees());
    of.field("yaw_deg", yaw, |at| grip(at).yaw.to_degrees());
    of.field("reaction_across_nN", across, |at| grip(at).across);
    of.field("reaction_lateral_nN", lateral, |at| grip(at).lateral);
}

/// The tables with all columns that they can have.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::table("curve.csv", <((&PathPoint, OutOfPlaneColumn), GripOfPoint)>::keys()),
        Output::table("limit_points.csv", <(LimitPointRow, GripOfLimitPoint)>::keys()),
        Output::table("stations.csv", <(StationRow, GripOfLimitPoint)>::keys()),
    ]
}

/// Writes curve.csv: one row a path point, with its stability out of the plane where that is known; in space with the columns of the grip.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_curve<'p>(dir: &Path, peel: &'p Peel, out_of_plane: Option<&OutOfPlane>) -> Result<PathBuf, ReportError> {
    let negative = |index: usize| out_of_plane.and_then(|at| at.negative_eigenvalues.get(index).copied());
    let row = |(index, point): (usize, &'p PathPoint)| ((point, OutOfPlaneColumn(negative(index))), point.in_space);
    let rows = peel.points.iter().enumerate().map(row);
    write_text(dir, "curve.csv", with_grip(rows, GripOfPoint))
}

/// The text of curve.csv without a stability out of the plane.
///
/// Fails where a number is not finite.
pub fn curve_csv(peel: &Peel) -> io::Result<Vec<u8>> {
    with_grip(peel.points.iter().map(|point| (point, point.in_space)), GripOfPoint)
}

/// Writes branch.csv: one row a point of the branch that leaves the plane, with the columns of curve.csv in space.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_branch(dir: &Path, branch: &OutOfPlaneBranch) -> Result<PathBuf, ReportError> {
    write_text(dir, "branch.csv", curve_csv(&branch.peel))
}

/// Writes equilibria.csv: the equilibria beside a pull at a rate, with the columns of curve.csv.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_equilibria(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    write_text(dir, "equilibria.csv", curve_csv(peel))
}

/// Writes limit_points.csv: one row a limit point, in path order; in space with the columns of the grip.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_limit_points(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    let rows = peel.limit_points.iter().map(|at| (LimitPointRow(at), at.in_space));
    write_text(dir, "limit_points.csv", with_grip(rows, GripOfLimitPoint))
}

/// Writes stations.csv: one row an equilibrium at a value that was asked for, those of one value in path order, and behind them those of the events of
/// the user; in space with the columns of the grip.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_stations(dir: &Path, stations: &[Stations], events: &[Events]) -> Result<PathBuf, ReportError> {
    let of_station =
        |of: &Stations| of.found.iter().map(|&found| StationRow::of(of.at.into(), found)).collect::<Vec<_>>();
    let of_event = |of: &Events| of.found.iter().map(|&found| StationRow::of(of.at.clone(), found)).collect::<Vec<_>>();
    let rows = stations.iter().flat_map(of_station).chain(events.iter().flat_map(of_event));
    write_text(
        dir,
        "stations.csv",
        with_grip(
            rows.map(|row| {
                let grip = row.station.in_space;
                (row, grip)
            }),
            GripOfLimitPoint,
        ),
    )
}

/// The text of a table, in space with the columns of the grip behind those of the row: in the plane no row has them.
fn with_grip<R: Record, G: Record>(
    rows: impl Iterator<Item = (R, Option<SpatialGrip>)>,
    of_grip: fn(SpatialGrip) -> G,
) -> io::Result<Vec<u8>> {
    let rows: Vec<_> = rows.collect();
    match rows.iter().any(|(_, grip)| grip.is_some()) {
        true => table(rows.into_iter().map(|(row, grip)| (row, of_grip(grip.unwrap_or_default())))),
        false => table(rows.into_iter().map(|(row, _)| row)),
    }
}
