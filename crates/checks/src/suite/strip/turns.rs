//! Initiation peak and first two displacement limit points of the strips of a table, each with its error over its bound.

use crate::check::{Check, Measure, Topic, missing};
use crate::suite::accuracy::bounds;
use crate::suite::reference::{Row, read};
use peelkit::adhesion::Attraction;
use peelkit::study::{Accuracy, PathEnd, StopCriteria, peel};
use rayon::prelude::*;

/// Relative errors asked for: the default, and a fine one, of which a law with corners is not capable, nor a path that remembers
/// how it has slid.
const ACCURACIES: [f64; 2] = [1e-6, 1e-9];
/// Round-off of a force, over the largest one of its path, as the program's own bounds count it: the force of a limit point that is a thousandth of the
/// largest one scatters by so much from mesh to mesh, and no accuracy beyond it can be asked for.
const ROUND_OFF: f64 = 5e-12;
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);

/// A table of limit points.
pub(super) struct Turns {
    pub table: &'static str,
    /// Who computed it.
    pub source: &'static str,
    /// What distinguishes its strips: a column, and what stands around its cell in the name of a check.
    pub named: &'static [(&'static str, &'static str, &'static str)],
}

impl Turns {
    /// Every number of every row, at two accuracies.
    pub fn checks(&self) -> Vec<Check> {
        let rows = read(self.table);
        let accuracies = |row: &Row| match row.text("law") {
            Some(law) if Attraction::named(law).is_some_and(|law| law.corners() > 1.0) => &ACCURACIES[..1],
            _ if row.text("tau0_GPa").is_some() => &ACCURACIES[..1],
            _ => &ACCURACIES[..],
        };
        let tasks: Vec<(&Row, f64)> =
            rows.iter().flat_map(|row| accuracies(row).iter().map(move |&relative| (row, relative))).collect();
        tasks.par_iter().flat_map(|&(row, relative)| self.of_row(row, relative)).collect()
    }

    fn of_row(&self, row: &Row, relative: f64) -> Vec<Check> {
        let parts = self
            .named
            .iter()
            .filter_map(|(column, before, behind)| row.text(column).map(|cell| format!("{before}{cell}{behind}")));
        let name = parts.collect::<Vec<_>>().join(", ");
        let check = |name, computed, expected, measure, tolerance| {
            Check::new(name, self.source, computed, expected, measure, tolerance)
        };
        let Some(model) = row.model() else {
            return vec![check(
                name,
                Err("a word of the row is not known".into()),
                f64::NAN,
                Measure::Relative,
                relative,
            )];
        };
        let peel = peel(&model, &Accuracy::to(relative), &BOUNDS);
        let largest = peel.points.iter().map(|point| point.force.abs()).fold(0.0, f64::max);
        let mut checks = Vec::new();
        for (quantity, found) in bounds::reported(&peel) {
            let (Some(text), Some(expected)) = (row.text(quantity), row.number(quantity)) else { continue };
            // where all slides before it peels, the force at which it does
            let sliding = || {
                let slides = quantity == "peak_force_nN" && peel.end == PathEnd::Sliding;
                peel.largest_computed_force.filter(|_| slides)
            };
            // it is no limit point and has no bound: the accuracy asked for is expected of it
            let found = found.or_else(|| sliding().map(|at| (at.force, relative * at.force)));
            let found = found.ok_or_else(|| missing(&peel.end));
            let unknown = 0.5 * bounds::last_digit(text);
            let over = found.clone().map(|(value, bound)| ((value - expected).abs() - unknown).max(0.0) / bound);
            let about = format!("{quantity} at {relative:e}, {name}");
            let over_bound = format!("error over its bound: {about}");
            // beyond its peak a path with a friction history, or with a law of joined parts, may be known less well than was asked, and says so, and so
            // may a row
            let bound = found.as_ref().map_or(0.0, |(value, bound)| (bound / value).abs());
            let known = bound + (unknown / expected).abs();
            let round_off = if quantity.ends_with("_nN") { ROUND_OFF * largest / expected.abs() } else { 0.0 };
            let says_so = ["tau0_GPa", "shear_strength_GPa"].into_iter().any(|column| row.text(column).is_some());
            let tolerance = if says_so { relative.max(known) } else { relative.max(round_off) };
            checks.push(check(about, found.map(|(value, _)| value), expected, Measure::Relative, tolerance));
            checks.push(check(over_bound, over, 1.0, Measure::AtMost, 0.0));
        }
        checks
    }
}

// -- Strips that friction holds against collocation --

pub(in crate::suite) const FRICTION: Topic =
    Topic { name: "friction", about: "strips with friction along the substrate: collocation", checks: of_friction };

const OF_FRICTION: Turns = Turns {
    table: include_str!("../../../verification/friction.csv"),
    source: "verification/friction.py: collocation",
    named: &[
        ("tau0_GPa", "τ0 = ", " GPa"),
        ("friction_coefficient", "μ = ", ""),
        ("pull_angle_deg", "", " degrees"),
        ("grip_across", "normal to the pull ", ""),
        ("grip_rotation", "rotation ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};

fn of_friction() -> Vec<Check> {
    OF_FRICTION.checks()
}
