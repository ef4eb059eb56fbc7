//! The tables of a pull-off: curve.csv, tips.csv, tip.csv. Units stand in the names of the columns.

use super::names::tip_branch_word;
use super::route::travels;
use crate::error::ReportError;
use crate::number::Finite;
use crate::tables::write_table;
use peelkit::model::{CurvePoint, PullCurve, Seta};
use peelkit::study::{SetaPoint, SetaPullOff, SetaState};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Writes curve.csv: one row a stable equilibrium, in order; those at both sides of an event are among them.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_seta_curve(dir: &Path, pull_off: &SetaPullOff) -> Result<PathBuf, ReportError> {
    write_points(dir, "curve.csv", pull_off)
}

/// Writes equilibria.csv beside a pull at a rate: with the rows and columns of curve.csv.
///
/// Fails as [`write_seta_curve`] does.
pub fn write_seta_equilibria(dir: &Path, pull_off: &SetaPullOff) -> Result<PathBuf, ReportError> {
    write_points(dir, "equilibria.csv", pull_off)
}

fn write_points(dir: &Path, name: &str, pull_off: &SetaPullOff) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        step: usize,
        displacement_nm: Finite,
        travel_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        tips_attached: usize,
        root_x_nm: Finite,
        root_y_nm: Finite,
        root_z_nm: Finite,
        #[serde(rename = "force_x_nN")]
        force_x: Finite,
        #[serde(rename = "force_y_nN")]
        force_y: Finite,
        #[serde(rename = "force_z_nN")]
        force_z: Finite,
        #[serde(rename = "moment_x_nN_nm")]
        moment_x: Finite,
        #[serde(rename = "moment_y_nN_nm")]
        moment_y: Finite,
        #[serde(rename = "moment_z_nN_nm")]
        moment_z: Finite,
        #[serde(rename = "energy_aJ")]
        energy: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        #[serde(rename = "released_aJ")]
        released: Finite,
    }
    let line = |(point, travel): (&SetaPoint, f64)| {
        let [[root_x_nm, root_y_nm, root_z_nm], [force_x, force_y, force_z], [moment_x, moment_y, moment_z]] =
            [point.root, point.force, point.moment].map(|vector| vector.map(Finite));
        Line {
            step: point.step + 1,
            displacement_nm: Finite(point.displacement),
            travel_nm: Finite(travel),
            force: Finite(point.force_along),
            tips_attached: point.attached,
            root_x_nm,
            root_y_nm,
            root_z_nm,
            force_x,
            force_y,
            force_z,
            moment_x,
            moment_y,
            moment_z,
            energy: Finite(point.energy),
            work: Finite(point.work),
            released: Finite(point.released),
        }
    };
    write_table(dir, name, pull_off.points.iter().zip(travels(&pull_off.points)).map(line))
}

/// Writes tip.csv: the curve that each tip follows, from where it is pressed to where it snaps off.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_tip_curve(dir: &Path, curve: &PullCurve) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        #[serde(rename = "slope_nN_per_nm")]
        slope: Finite,
        #[serde(rename = "energy_aJ")]
        energy: Finite,
    }
    let line = |at: &CurvePoint| Line {
        displacement_nm: Finite(at.displacement),
        force: Finite(at.force),
        slope: Finite(at.slope),
        energy: Finite(curve.energy(at.displacement)),
    };
    write_table(dir, "tip.csv", curve.points().iter().map(line))
}

/// Writes tips.csv: one row a tip at each of these moments, which have names.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_tips(dir: &Path, seta: &Seta, moments: &[(&'static str, &SetaState)]) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        moment: &'static str,
        tip: usize,
        tip_x_nm: Finite,
        tip_z_nm: Finite,
        state: &'static str,
        height_nm: Finite,
        #[serde(rename = "load_x_nN")]
        load_x: Finite,
        #[serde(rename = "load_y_nN")]
        load_y: Finite,
        #[serde(rename = "load_z_nN")]
        load_z: Finite,
    }
    let lines = |&(moment, state): &(&'static str, &SetaState)| {
        let line = |(tip, at): (usize, &peelkit::study::TipState)| {
            let joint = seta.tip_joint(tip);
            let [x, _, z] = seta.joint_place(joint);
            // what the tip exerts on the ground: upwards where it is pulled
            let [load_x, load_y, load_z] = at.load.map(|load| Finite(0.0 - load));
            Line {
                moment,
                tip,
                tip_x_nm: Finite(x),
                tip_z_nm: Finite(z),
                state: tip_branch_word(at.on),
                height_nm: Finite(state.joints[joint].place[1] - at.foot[1]),
                load_x,
                load_y,
                load_z,
            }
        };
        state.tips.iter().enumerate().map(line).collect::<Vec<_>>()
    };
    write_table(dir, "tips.csv", moments.iter().flat_map(lines))
}
