//! The strip pulled at an angle against collocation, and its steady force against a closed form.

use super::reference::{Row, read};
use super::{Check, Measure, Topic, bounds};
use crate::analytic::sliding_force;
use crate::model::{PeelModel, Pull, StripModel};
use crate::study::{Accuracy, Bounds, End, Peel, peel};
use rayon::prelude::*;

pub(super) const TOPIC: Topic =
    Topic { name: "pull", about: "strips pulled at an angle: collocation, steady force, both forms", run };

const TABLE: &str = include_str!("../../../verification/pull_angle.csv");
const SOURCE: &str = "verification/pull_angle.py: collocation";
const BOUNDS: Bounds = Bounds { points: 20_000, time_s: None, displacement: None };
/// Relative errors asked for: the default, and a fine one.
const ACCURACIES: [f64; 2] = [1e-6, 1e-9];
/// Angles (degrees) of long strips, of this length in nm, whose front is looked at half-way.
const STEADY: [f64; 7] = [20.0, 45.0, 60.0, 90.0, 120.0, 150.0, 170.0];
const LONG: f64 = 2000.0;

fn run() -> Vec<Check> {
    let rows = read(TABLE);
    let tasks: Vec<(&Row, f64)> = rows.iter().flat_map(|row| ACCURACIES.map(|relative| (row, relative))).collect();
    let mut checks: Vec<Check> = tasks.par_iter().flat_map(|&(row, relative)| of_row(row, relative)).collect();
    checks.extend(STEADY.par_iter().map(|&angle| steady(angle)).collect::<Vec<_>>());
    checks
}

/// Peak and first two turning points of the displacement, each with its error over its bound.
fn of_row(row: &Row, relative: f64) -> Vec<Check> {
    let word = |column: &str| row.text(column).unwrap_or_default();
    let name = format!(
        "{} degrees, across {}, rotation {}, {}, EI × {}, L = {} nm",
        word("pull_angle_deg"),
        word("grip_across"),
        word("grip_rotation"),
        word("line_load"),
        word("bending_stiffness_factor"),
        word("length_nm")
    );
    let check = |name, computed, expected, measure, tolerance| {
        Check::new(TOPIC.name, name, SOURCE, computed, expected, measure, tolerance)
    };
    let Some(model) = row.strip() else {
        return vec![check(name, Err("a word of the row is not known".into()), f64::NAN, Measure::Relative, relative)];
    };
    let peel = peel(&model, &Accuracy::to(relative), &BOUNDS);
    let mut checks = Vec::new();
    for (quantity, found) in bounds::reported(&peel) {
        let (Some(text), Some(expected)) = (row.text(quantity), row.number(quantity)) else { continue };
        let found = found.ok_or_else(|| missing(&peel));
        let unknown = 0.5 * bounds::last_digit(text);
        let over = found.clone().map(|(value, bound)| ((value - expected).abs() - unknown).max(0.0) / bound);
        let about = format!("{quantity} at {relative:e}, {name}");
        let over_bound = format!("error over its bound: {about}");
        checks.push(check(about, found.map(|(value, _)| value), expected, Measure::Relative, relative));
        checks.push(check(over_bound, over, 1.0, Measure::AtMost, 0.0));
    }
    checks
}

fn missing(peel: &Peel) -> String {
    match &peel.end {
        End::Failed(why) => why.clone(),
        end => format!("not found before the path ended ({end:?})"),
    }
}

/// The force where the front of a long strip is half-way.
fn steady(degrees: f64) -> Check {
    let mut model = StripModel::of_the_paper(LONG, 1.0);
    model.pull = Pull { angle: degrees.to_radians() };
    let peel = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    let away = |front: f64| (front - 0.5 * LONG).abs();
    let half_way = peel.points.iter().min_by(|a, b| away(a.front).total_cmp(&away(b.front)));
    let model = PeelModel::from(model);
    let rest = model.free_end().0 * model.line_law().rest_energy();
    Check::new(
        TOPIC.name,
        format!("force with the front half-way, nN, {degrees} degrees, L = {LONG} nm"),
        "P (1 - cos α) + P² sin² α/(2EA) = -bΨ(y_eq, 0), from the first integral",
        half_way.map(|point| point.force).ok_or_else(|| missing(&peel)),
        sliding_force(rest, model.section().axial, degrees.to_radians()),
        Measure::Relative,
        1e-6,
    )
}
