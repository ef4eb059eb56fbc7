//! Rods without adhesion, and their equilibria.

use peelkit::beam::{ReferenceCurve, Section, TIP_ROTATION};
use peelkit::model::{BeamProblem, Drive, RodModel, Support};
use peelkit::solve::{Observables, Solution, controlled};

pub(crate) const DISPLACEMENT: Observables = Observables::DISPLACEMENT;
pub(super) const FORCE: Observables = Observables::FORCE;
pub(super) const LEFT_ROTATION: Observables = Observables::monitor(TIP_ROTATION);

/// A rod whose left end is clamped and whose right end is free.
pub(crate) fn cantilever(axial: f64, shear: f64, drive: Drive) -> RodModel {
    RodModel {
        length: 1.0,
        section: Section { axial, shear, bending: 1.0 },
        rest: ReferenceCurve::default(),
        left: Support::CLAMPED,
        right: Support::FREE,
        drive,
    }
}

pub(super) fn problem(model: &RodModel, order: usize) -> Result<BeamProblem, String> {
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

/// Tolerance of every solution.
pub(super) const TOLERANCE: f64 = 1e-13;

/// x, y and θ of the right end.
pub(super) fn tip(solution: &Solution) -> [f64; 3] {
    let state = &solution.at.values;
    std::array::from_fn(|f| state[state.len() - 3 + f])
}
