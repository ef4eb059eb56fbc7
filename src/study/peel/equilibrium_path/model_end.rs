//! Whether a path has come to where the model itself ends.

use crate::beam::planar::model_limits::BondedLoss;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::study::peel::failure::PathFailure;
use crate::study::peel::result::PathEnd;
use std::sync::Arc;

/// A force below this share of the work of adhesion over the width is none, where a path cannot be continued.
const NO_FORCE: f64 = 1e-6;

/// The end at the newest point, if its model says so: a section is where the energy has a pole, or what is bonded has lost its stability
/// since the point before. Then a negative eigenvalue comes without a limit point; where the sections tilt to one side from the front on
/// instead, none does, and the path goes on in a stable state.
pub(super) fn model_end(problem: &BeamProblem, points: &[Arc<Solution>], relative: f64) -> Option<PathEnd> {
    let [.., before, newest] = points else { return None };
    let beam = problem.beam.planar()?;
    if let Some(upright) = beam.upright_section(&newest.at, relative) {
        return Some(PathEnd::Upright(upright));
    }
    let turned = newest.slope.displacement * before.slope.displacement <= 0.0;
    if turned || newest.negative <= before.negative || loss(problem, before).is_some() {
        return None;
    }
    loss(problem, newest).map(PathEnd::BondedPartUnstable)
}

fn loss(problem: &BeamProblem, at: &Solution) -> Option<BondedLoss> {
    let beam = problem.beam.planar()?;
    beam.limits.bonded.as_ref()?;
    beam.limits.bonded_loss(beam.grip_forces(&at.at).horizontal)
}

/// The end of a path that cannot be continued where its model says why.
pub(super) fn stopped_by_model(
    problem: &BeamProblem,
    points: &[Arc<Solution>],
    trouble: &PathFailure,
) -> Option<PathEnd> {
    if let PathFailure::NearUpright(upright) = trouble {
        return Some(PathEnd::Upright(*upright));
    }
    let [_, _, .., newest] = points else { return None };
    let beam = problem.beam.planar()?;
    if let Some(section) = beam.held_upright(&newest.at) {
        return Some(PathEnd::Upright(section));
    }
    if newest.observables.force < NO_FORCE * problem.measure.force && newest.slope.force < 0.0 {
        return Some(PathEnd::Pivoting);
    }
    beam.limits.bonded.as_ref()?;
    beam.limits.near_bonded_loss(beam.grip_forces(&newest.at).horizontal).map(PathEnd::BondedPartUnstable)
}
