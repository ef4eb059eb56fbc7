//! The tables of one peel: curve.csv, limit_points.csv, branch.csv, observed.csv. Units stand in the names of the columns.

use super::table::{table_with_grip, write_table, write_table_with_grip};
use crate::error::ReportError;
use crate::names::limit_point_kind_word;
use crate::number::Finite;
use peelkit::study::{LimitPoint, Observed, OutOfPlane, OutOfPlaneBranch, PathPoint, Peel};
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};

/// A point of a path, in the plane or in space.
#[derive(Default, Serialize)]
struct PointColumns {
    displacement_nm: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    end_rotation_rad: Finite,
    #[serde(rename = "work_aJ")]
    work: Finite,
    negative_eigenvalues: usize,
    negative_eigenvalues_load: usize,
    front_nm: Finite,
    newton_iterations: usize,
}

impl From<&PathPoint> for PointColumns {
    fn from(point: &PathPoint) -> Self {
        Self {
            displacement_nm: Finite(point.displacement),
            force: Finite(point.force),
            end_rotation_rad: Finite(point.end_rotation),
            work: Finite(point.work),
            negative_eigenvalues: point.negative_eigenvalues,
            negative_eigenvalues_load: point.negative_eigenvalues_load,
            front_nm: Finite(point.front),
            newton_iterations: point.iterations,
        }
    }
}

/// Writes curve.csv: one row a path point, with its stability out of the plane where that is known; in space with the columns of the grip.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_curve(dir: &Path, peel: &Peel, out_of_plane: Option<&OutOfPlane>) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct OutOfPlaneColumn {
        negative_eigenvalues_out_of_plane: Option<usize>,
    }
    let line = |(index, point): (usize, &PathPoint)| {
        let negative_eigenvalues_out_of_plane = out_of_plane.and_then(|at| at.negative_eigenvalues.get(index).copied());
        (PointColumns::from(point), OutOfPlaneColumn { negative_eigenvalues_out_of_plane })
    };
    let lines = peel.points.iter().enumerate().map(|at| (line(at), at.1.in_space));
    write_table_with_grip(dir, "curve.csv", lines)
}

/// The text of curve.csv without a stability out of the plane.
///
/// Fails where a number is not finite.
pub fn curve_csv(peel: &Peel) -> io::Result<Vec<u8>> {
    table_with_grip(peel.points.iter().map(|point| (PointColumns::from(point), point.in_space)))
}

/// Writes branch.csv: one row a point of the branch that leaves the plane, with the columns of curve.csv in space.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_branch(dir: &Path, branch: &OutOfPlaneBranch) -> Result<PathBuf, ReportError> {
    write_path(dir, "branch.csv", &branch.peel)
}

/// Writes equilibria.csv: the equilibria beside a pull at a rate, with the columns of curve.csv.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_equilibria(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    write_path(dir, "equilibria.csv", peel)
}

fn write_path(dir: &Path, name: &str, peel: &Peel) -> Result<PathBuf, ReportError> {
    write_table_with_grip(dir, name, peel.points.iter().map(|point| (PointColumns::from(point), point.in_space)))
}

/// Writes limit_points.csv: one row a limit point, in path order; in space with the columns of the grip.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_limit_points(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        kind: &'static str,
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        end_rotation_rad: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        error_nm: Finite,
        #[serde(rename = "error_nN")]
        force_error: Finite,
        flat: bool,
        after_point: usize,
        #[serde(rename = "error_aJ")]
        work_error: Option<Finite>,
    }
    let line = |at: &LimitPoint| Line {
        kind: limit_point_kind_word(at.kind),
        displacement_nm: Finite(at.displacement),
        force: Finite(at.force),
        end_rotation_rad: Finite(at.end_rotation),
        work: Finite(at.work),
        error_nm: Finite(at.displacement_error),
        force_error: Finite(at.force_error),
        flat: at.flat,
        after_point: at.after,
        work_error: at.work_error.map(Finite),
    };
    write_table_with_grip(dir, "limit_points.csv", peel.limit_points.iter().map(|at| (line(at), at.in_space)))
}

/// Writes observed.csv: one row a point of the test, in its order.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_observed(dir: &Path, test: &Observed) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        branch: &'static str,
        machine_displacement_nm: Finite,
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        front_nm: Finite,
        jump: bool,
        adheres: &'static str,
    }
    let lines = test.points.iter().map(|point| Line {
        branch: point.way.word(),
        machine_displacement_nm: Finite(point.machine),
        displacement_nm: Finite(point.displacement),
        force: Finite(point.force),
        work: Finite(point.work),
        front_nm: Finite(point.front),
        jump: point.jumped,
        adheres: point.adheres.word(),
    });
    write_table(dir, "observed.csv", lines)
}
