//! Where planar strips lose their stability out of the plane, against shooting.

use crate::check::{Check, Measure, Topic};
use crate::suite::reference::{Row, read};
use peelkit::model::{PeelModel, StripModel};
use peelkit::study::{Accuracy, OutOfPlaneLoss, Peel, StopCriteria, peel};
use rayon::prelude::*;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "out-of-plane",
    about: "where planar strips leave their plane: shooting of the spatial equations",
    checks,
};

const LOSSES: &str = include_str!("../../../verification/out_of_plane.csv");
const SHOOTING: &str = "verification/out_of_plane.py: shooting";
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);
/// Asked for, and allowed.
const ACCURACIES: [f64; 2] = [1e-6, 1e-9];

fn checks() -> Vec<Check> {
    read(LOSSES).into_par_iter().flat_map(|row| losses(&row)).collect()
}

fn name(row: &Row) -> String {
    let columns = [
        ("law", "", ""),
        ("line_load", "", ""),
        ("far_face", "far face ", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("youngs_modulus_GPa", "E = ", " GPa"),
        ("poissons_ratio", "ν = ", ""),
        ("length_nm", "L = ", " nm"),
        ("height_nm", "h = ", " nm"),
        ("width_nm", "b = ", " nm"),
    ];
    let told = columns.iter().filter_map(|(column, before, unit)| Some(format!("{before}{}{unit}", row.text(column)?)));
    told.collect::<Vec<_>>().join(", ")
}

/// A number against the table, and its error over its bound, which is at most one and half of the last digit that is
/// printed.
fn held(what: &str, row: &Row, column: &str, found: Option<(f64, f64)>, asked: f64) -> Option<[Check; 2]> {
    let expected = row.number(column)?;
    let name = format!("{what}, {}, at {asked:e}", name(row));
    let computed = found.map(|found| found.0).ok_or_else(|| "stable on the whole path".to_owned());
    let printed = 0.5 * 10f64.powi(-(row.text(column)?.split_once('.').map_or(0, |(_, digits)| digits.len()) as i32));
    let over = found.map(|(value, bound)| (value - expected).abs() / (bound + printed)).ok_or_else(String::new);
    let bound = format!("error over bound of {name}");
    Some([
        Check::new(name, SHOOTING, computed, expected, Measure::Relative, asked.max(printed / expected)),
        Check::new(bound, SHOOTING, over, 1.0, Measure::AtMost, 0.0),
    ])
}

fn peeled(row: &Row, asked: f64) -> Option<Peel> {
    let model: StripModel = row.strip()?;
    Some(peel(&PeelModel::from(model), &Accuracy::to(asked), &BOUNDS))
}

/// Displacement and force of a row, at every accuracy.
fn losses(row: &Row) -> Vec<Check> {
    let at = |asked: f64| {
        let peel = peeled(row, asked)?;
        let found = match peel.out_of_plane() {
            Ok(stability) => stability.first_loss,
            Err(why) => {
                let name = format!("loss, {}, at {asked:e}", name(row));
                return Some(vec![Check::new(name, SHOOTING, Err(why.to_string()), 0.0, Measure::AtMost, 0.0)]);
            }
        };
        let number = |of: fn(OutOfPlaneLoss) -> (f64, f64)| found.map(of);
        let place = number(|loss| (loss.displacement, loss.displacement_error));
        let force = number(|loss| (loss.force, loss.force_error));
        let place = held("u of the loss, nm", row, "loss_displacement_nm", place, asked)?;
        Some(place.into_iter().chain(held("P of the loss, nN", row, "loss_force_nN", force, asked)?).collect())
    };
    ACCURACIES.into_iter().filter_map(at).flatten().collect()
}
