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

/// x, y and θ of the right end of a rod of length 1.
pub(super) fn tip(solution: &Solution) -> [f64; 3] {
    let [.., along, y, rotation] = solution.at.values[..] else { panic!("a node has three fields") };
    [1.0 + along, y, rotation]
}

/// x and y of every node of an equilibrium, on elements of this order.
pub(crate) fn nodes(model: &RodModel, order: usize, solution: &Solution) -> Result<Vec<(f64, f64)>, String> {
    let problem = problem(model, order)?;
    let beam = problem.beam.planar().ok_or("a rod lies in the plane")?;
    let fields = solution.at.values.chunks_exact(3);
    Ok(fields.zip(beam.places(&solution.at.mesh.boundaries)).map(|(node, s)| (s + node[0], node[1])).collect())
}
