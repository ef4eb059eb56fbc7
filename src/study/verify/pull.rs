//! The strip pulled at an angle against collocation, and its steady force against a closed form.

use super::reference::{Row, read};
use super::{Check, Measure, Topic};
use crate::adhesion::LineLoad;
use crate::analytic::sliding_force;
use crate::model::{Hold, PeelModel, Pull, StripModel};
use crate::study::{Accuracy, Bounds, End, Peel, Turn, peel};
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

/// The strip of a row, and its name.
fn strip_of(row: &Row) -> (StripModel, String) {
    let number = |column: &str| row.number(column).unwrap_or(f64::NAN);
    let hold = |column: &str| if row.text(column) == Some("fixed") { Hold::Fixed } else { Hold::Free };
    let (length, factor, angle) = (number("length_nm"), number("bending_stiffness_factor"), number("pull_angle_deg"));
    let mut model = StripModel::of_the_paper(length, factor);
    model.grip.rotation = hold("grip_rotation");
    model.grip.horizontal = hold("grip_across");
    model.pull = Pull { angle: angle.to_radians() };
    if row.text("line_load") == Some("axis-gap") {
        model.adhesion.line_load = LineLoad::AxisGap;
    }
    let word = |column: &str| row.text(column).unwrap_or_default().to_owned();
    let name = format!(
        "{angle} degrees, across {}, rotation {}, {}, EI × {factor}, L = {length} nm",
        word("grip_across"),
        word("grip_rotation"),
        word("line_load")
    );
    (model, name)
}

/// Peak and first two turning points of the displacement, each with its error over its bound.
fn of_row(row: &Row, relative: f64) -> Vec<Check> {
    let (model, name) = strip_of(row);
    let peel = peel(&model, &Accuracy::to(relative), &BOUNDS);
    let peak = peel.initiation_peak.map(|p| [(p.displacement, p.displacement_error), (p.force, p.force_error)]);
    let turns = peel.limit_points.iter().filter(|point| point.kind == Turn::Displacement);
    let mut turns = turns.map(|p| [(p.displacement, p.displacement_error), (p.force, p.force_error)]);
    let found = [("peak", peak), ("lp1", turns.next()), ("lp2", turns.next())];
    let mut checks = Vec::new();
    for (kind, point) in found {
        for (place, quantity) in ["displacement_nm", "force_nN"].into_iter().enumerate() {
            let Some(expected) = row.number(&format!("{kind}_{quantity}")) else { continue };
            let value = point.map(|point| point[place]).ok_or_else(|| missing(&peel));
            let bound = value.clone().map(|(value, bound)| ((value - expected).abs() - rounding(expected)) / bound);
            let about = format!("{kind} {quantity} at {relative:e}, {name}");
            checks.push(Check::new(
                TOPIC.name,
                about.clone(),
                SOURCE,
                value.map(|(value, _)| value),
                expected,
                Measure::Relative,
                relative,
            ));
            checks.push(Check::new(
                TOPIC.name,
                format!("error over its bound: {about}"),
                SOURCE,
                bound,
                1.0,
                Measure::AtMost,
                0.0,
            ));
        }
    }
    checks
}

fn missing(peel: &Peel) -> String {
    match &peel.end {
        End::Failed(why) => why.clone(),
        end => format!("not found before the path ended ({end:?})"),
    }
}

/// Half of the twelfth digit, to which the table is printed.
fn rounding(expected: f64) -> f64 {
    5e-12 * expected.abs()
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
