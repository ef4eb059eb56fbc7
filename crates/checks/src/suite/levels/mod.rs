//! From atoms to the line load: every level of coarse-graining against quadrature and exact lattice sums.

mod curved;
mod half_space;
mod lattice;
mod section;

use super::check::{Check, Measure, Topic};
use super::reference::{Row, read};
use peelkit::adhesion::{HalfSpace, Rule};
use std::num::NonZeroUsize;

pub(super) const TOPIC: Topic =
    Topic { name: "levels", about: "atoms, volumes, body force, surface traction and line load", run };

/// A_H = 1e-19 J, r0 = 0.4 nm.
const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

fn run() -> Vec<Check> {
    [half_space::checks(), lattice::checks(), section::checks(), curved::checks()].concat()
}

/// A check against a cell of a table; a cell that is not there fails.
fn against(
    name: String,
    source: &str,
    row: &Row,
    column: &str,
    computed: f64,
    measure: Measure,
    tolerance: f64,
) -> Check {
    let expected = row.number(column);
    let computed = if expected.is_some() { Ok(computed) } else { Err(format!("the table has no {column} here")) };
    Check::new(TOPIC.name, name, source, computed, expected.unwrap_or(f64::NAN), measure, tolerance)
}

/// The number in a cell, or NaN, which no check lets pass.
fn cell(row: &Row, column: &str) -> f64 {
    row.number(column).unwrap_or(f64::NAN)
}

fn rule(points: usize) -> Rule {
    Rule::new(NonZeroUsize::new(points).unwrap_or(NonZeroUsize::MIN))
}
