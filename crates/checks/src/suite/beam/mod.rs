//! The beam on its own, without adhesion: against closed forms, elliptic integrals and shooting.
//!
//! All rods have L = 1 and EI = 1, so that lengths are in L, forces in EI/L² and moments in EI/L.

pub(crate) mod arch;
mod circle;
mod column;
mod end_force;
mod locking;
mod motion;

use super::check::{Check, Measure, Topic};
use peelkit::beam::{RestCurve, Section, TIP_ROTATION};
use peelkit::model::{Drive, PlanarProblem, RodModel, Support};
use peelkit::solve::{Observables, Solution, controlled};

pub(super) const TOPIC: Topic =
    Topic { name: "beam", about: "the beam without adhesion: bending, buckling, snap-through", run };

fn run() -> Vec<Check> {
    let parts = [circle::checks, end_force::checks, column::checks, locking::checks, motion::checks, arch::checks];
    parts.iter().flat_map(|part| part()).collect()
}

pub(crate) const DISPLACEMENT: Observables = Observables::DISPLACEMENT;
const FORCE: Observables = Observables::FORCE;
const LEFT_ROTATION: Observables = Observables::monitor(TIP_ROTATION);

/// A rod whose left end is clamped and whose right end is free.
pub(crate) fn cantilever(axial: f64, shear: f64, drive: Drive) -> RodModel {
    RodModel {
        length: 1.0,
        section: Section { axial, shear, bending: 1.0 },
        rest: RestCurve::default(),
        left: Support::CLAMPED,
        right: Support::FREE,
        drive,
    }
}

fn problem(model: &RodModel, order: usize) -> Result<PlanarProblem, String> {
    model.problem(order).map_err(|error| error.to_string())
}

/// Equilibria of a model from rest on, at the values `targets` of a constraint.
pub(crate) fn under_control(
    model: &RodModel,
    order: usize,
    elements: usize,
    weights: Observables,
    targets: &[f64],
) -> Result<Vec<Solution>, String> {
    let problem = problem(model, order)?;
    controlled(&problem, problem.initial(elements), weights, targets, TOLERANCE).map_err(|error| error.to_string())
}

/// Error wanted of every solution.
const TOLERANCE: f64 = 1e-13;

/// x, y and θ of the right end.
fn tip(solution: &Solution) -> [f64; 3] {
    let state = &solution.at.values;
    std::array::from_fn(|f| state[state.len() - 3 + f])
}

fn check(
    name: String,
    source: &str,
    computed: Result<f64, String>,
    expected: f64,
    measure: Measure,
    tolerance: f64,
) -> Check {
    Check::new(TOPIC.name, name, source, computed, expected, measure, tolerance)
}
