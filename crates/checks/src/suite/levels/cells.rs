//! A level against the cells of a table.

use crate::check::{Check, Measure};
use crate::suite::reference::Row;
use peelkit::adhesion::{HalfSpace, Rule};
use std::num::NonZeroUsize;

/// A_H = 1e-19 J, r0 = 0.4 nm.
pub(super) const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

/// A check against a cell of a table; a cell that is not there fails.
pub(super) fn against(
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
    Check::new(name, source, computed, expected.unwrap_or(f64::NAN), measure, tolerance)
}

/// The number in a cell, or NaN, which no check lets pass.
pub(super) fn cell(row: &Row, column: &str) -> f64 {
    row.number(column).unwrap_or(f64::NAN)
}

pub(super) fn rule(points: usize) -> Rule {
    Rule::new(NonZeroUsize::new(points).unwrap_or(NonZeroUsize::MIN))
}
