//! The tables of the peel of a solid, curve.csv and limit_points.csv. Units stand in the names of the columns.

use crate::writing::error::ReportError;
use crate::writing::names::limit_point_kind_word;
use crate::writing::record::{Cell, Fields, Record, columns_of, write_table};
use crate::writing::reference::Output;
use peelkit::study::{SolidLimitPoint, SolidPeel, SolidPoint};
use std::path::{Path, PathBuf};

impl Record for SolidPoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u of the grip", |at| at.displacement);
        of.field("force_nN", "P of the grip", |at| at.force);
        of.field("end_rotation_rad", "rotation of the chord of the end face", |at| at.end_rotation);
        of.field("work_aJ", "work of the grip from the beginning of the path, a difference of energies; empty for a load without a potential", |at| at.work);
        of.field("negative_eigenvalues", "number of unstable directions under displacement control; 0: stable; empty for a load without a potential", |at| at.negative);
        of.field("negative_eigenvalues_load", "the same under force control", |at| at.negative_load);
        of.field("detached_nm", "length that has come off, by the logarithm of the gap", |at| at.front);
    }
}

impl Record for SolidLimitPoint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("kind", "`displacement` (du = 0) or `load` (dP = 0)", |at| limit_point_kind_word(at.kind));
        of.field("displacement_nm", "u there", |at| at.displacement);
        of.field("force_nN", "P there", |at| at.force);
        of.field("error_nm", "bound of the error of the displacement, by a finer mesh; empty of those that were not solved there", |at| at.errors.map(|errors| errors.displacement));
        of.field("error_nN", "bound of the error of the force, likewise", |at| at.errors.map(|errors| errors.force));
        of.field("confirmed", "whether the finer mesh has this limit point as well; else it is one of the mesh: an element comes off by itself", |at| at.errors.map(|errors| errors.confirmed));
        of.field("after_point", "it lies behind this row of curve.csv, counted from 0", |at| at.after);
    }
}

/// Writes curve.csv and limit_points.csv.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_solid_tables(dir: &Path, peel: &SolidPeel) -> Result<Vec<PathBuf>, ReportError> {
    Ok(vec![
        write_table(dir, "curve.csv", peel.points.iter())?,
        write_table(dir, "limit_points.csv", peel.limit_points.iter())?,
    ])
}

/// The columns of curve.csv by their names.
pub fn solid_columns(points: &[SolidPoint]) -> Vec<(String, Vec<Cell>)> {
    columns_of(points.iter())
}

pub(super) fn outputs() -> Vec<Output> {
    vec![
        Output::table("curve.csv of a solid", SolidPoint::keys()),
        Output::table("limit_points.csv of a solid", SolidLimitPoint::keys()),
    ]
}
