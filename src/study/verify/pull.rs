//! The strip pulled at an angle against collocation, and its steady force against a closed form.

use super::check::missing;
use super::turns::Turns;
use super::{Check, Measure, Topic};
use crate::analytic::sliding_force;
use crate::model::{PeelModel, Pull, StripModel};
use crate::study::{Accuracy, Bounds, peel};
use rayon::prelude::*;

pub(super) const TOPIC: Topic = Topic {
    name: "pull",
    about: "strips pulled at an angle, or laid down under tension: collocation, steady force",
    run,
};

const TABLE: Turns = Turns {
    topic: TOPIC.name,
    table: include_str!("../../../verification/pull_angle.csv"),
    source: "verification/pull_angle.py: collocation",
    named: &[
        ("pull_angle_deg", "", " degrees"),
        ("grip_across", "across ", ""),
        ("grip_rotation", "rotation ", ""),
        ("line_load", "", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};
const BOUNDS: Bounds = Bounds { points: 20_000, time_s: None, displacement: None };
const STRETCHED: Turns = Turns {
    topic: TOPIC.name,
    table: include_str!("../../../verification/pretension.csv"),
    source: "verification/pretension.py: collocation",
    named: &[
        ("pretension_nN", "pretension ", " nN"),
        ("pull_angle_deg", "", " degrees"),
        ("grip_rotation", "rotation ", ""),
        ("line_load", "", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};
/// Angles (degrees) of long strips, of this length in nm, whose front is looked at half-way.
const STEADY: [f64; 7] = [20.0, 45.0, 60.0, 90.0, 120.0, 150.0, 170.0];
const LONG: f64 = 2000.0;

fn run() -> Vec<Check> {
    let mut checks = TABLE.checks();
    checks.extend(STRETCHED.checks());
    checks.extend(STEADY.par_iter().map(|&angle| steady(angle)).collect::<Vec<_>>());
    checks
}

/// The force where the front of a long strip is half-way.
fn steady(degrees: f64) -> Check {
    let mut model = StripModel::of_the_paper(LONG, 1.0);
    model.pull = Pull { angle: degrees.to_radians() };
    let peel = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    let model = PeelModel::from(model);
    let rest = model.free_end().0 * model.line_law().rest_energy();
    Check::new(
        TOPIC.name,
        format!("force with the front half-way, nN, {degrees} degrees, L = {LONG} nm"),
        "P (1 - cos α) + P² sin² α/(2EA) = -bΨ(y_eq, 0), from the first integral",
        peel.nearest_front(0.5 * LONG).map(|point| point.force).ok_or_else(|| missing(&peel.end)),
        sliding_force(rest, model.section().axial, degrees.to_radians()),
        Measure::Relative,
        1e-6,
    )
}
