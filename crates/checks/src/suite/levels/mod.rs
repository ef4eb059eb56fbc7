//! From atoms to the line load: every level of coarse-graining against quadrature and exact lattice sums.

mod cells;
mod curved;
mod half_space;
mod lattice;
mod section;

use crate::check::{Check, Topic};

pub(super) const TOPIC: Topic =
    Topic { name: "levels", about: "atoms, volumes, body force, surface traction and line load", checks };

fn checks() -> Vec<Check> {
    [half_space::checks(), lattice::checks(), section::checks(), curved::checks()].concat()
}
