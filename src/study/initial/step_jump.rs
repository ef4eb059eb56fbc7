//! The jump of a beam whose equilibria lose their stability in a step before the pull.
//!
//! The grip stays where it is and the energy falls, by gradient flow, to a stable equilibrium: as in the displacement-controlled test. It does so
//! a little beyond the loss, where the equilibrium that was left is none any more.

use super::error::{LoadingError, LoadingProgress};
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::newton::Solution;
use crate::solve::relax::{Held, RelaxError, RelaxOptions, Relaxation, disturbed, disturbed_anyhow, relax_until};
use crate::solve::state::State;
use crate::solve::workspace::{ShouldStop, Workspace};
use std::sync::Arc;

/// Most jumps of a step.
pub(super) const MOST_JUMPS: usize = 20;
/// How far beyond the loss the beam is let go, over how far the grip has come in the step and over the scale of its displacement.
const BEYOND: f64 = 1e-6;
/// The accuracy to which a start, and what a jump leads through, must be free of upright sections.
pub(super) const UPRIGHT: f64 = 1e-6;
/// Elements on which a beam comes to rest once more, over those before: on few an equilibrium may be one that is none on more.
pub(super) const FINER: usize = 2;

/// Where the equilibria of a step lose their stability.
pub(super) struct StabilityLoss {
    /// How far the step has come
    pub at: LoadingProgress,
    /// Whether what moves turns back there; else the path branches.
    pub turns: bool,
    /// Where it is lost, seen from where the path began, nm or rad
    pub displacement: f64,
    /// The solution next to it; the unstable one where the path branches
    pub solution: Arc<Solution>,
}

/// Where the beam has come to rest.
pub(super) struct Landed {
    pub solution: Solution,
    /// Energy that it released, aJ
    pub released: f64,
}

impl StabilityLoss {
    fn error(&self) -> LoadingError {
        let at = self.at;
        if self.turns { LoadingError::Turns { at } } else { LoadingError::Unstable { at } }
    }
}

/// The stable equilibrium to which a beam jumps whose grip goes on in the direction of `onward`.
///
/// Fails with the loss itself where the beam has no energy that falls, or remembers how it has come.
pub(super) fn jumped(
    problem: &BeamProblem,
    loss: &StabilityLoss,
    onward: f64,
    should_stop: Option<ShouldStop>,
) -> Result<Landed, LoadingError> {
    let limit = &*loss.solution;
    let border = problem.beam.planar().is_some_and(|beam| beam.chain.has_border());
    if border || limit.at.history.is_some() || !problem.system.is_conservative() {
        return Err(loss.error());
    }
    let start = if loss.turns { disturbed(problem, limit) } else { disturbed_anyhow(problem, &limit.at) };
    let beyond = BEYOND * (loss.displacement.abs() + problem.grip.displacement_scale());
    let held = loss.displacement + beyond.copysign(onward);
    let mut ws = Workspace::until(should_stop);
    let mut at_rest = |from| {
        let mut end = None;
        let watch = |at: &State| {
            end = model_end(problem, loss.at, at);
            end.is_some()
        };
        let options = RelaxOptions::default();
        let rest = relax_until(problem, from, Held::Displacement(held), &options, &mut ws, watch);
        let no_rest = |cause| LoadingError::NoRest { at: loss.at, cause };
        match (end, rest.map_err(no_rest)?) {
            (None, Relaxation::Rest(rest)) => Ok(rest.solution),
            (Some(end), _) => Err(end),
            (None, Relaxation::Left { steps, energy, .. }) => Err(no_rest(RelaxError::Endless { steps, energy })),
        }
    };
    let coarse = at_rest(start)?;
    let finer = problem.system.on_elements(&coarse.at, FINER * coarse.at.mesh.elements());
    let energy = |s: &Solution| problem.energy(&s.at, s.energy);
    // with the work of the grip from one to the other
    let work = limit.observables.force * (held - limit.observables.displacement);
    let released = energy(limit) + work - energy(&coarse);
    let solution = at_rest(finer)?;
    Ok(Landed { solution, released })
}

/// Why a state on the way of a jump is beyond what the model is for.
fn model_end(problem: &BeamProblem, at: LoadingProgress, state: &State) -> Option<LoadingError> {
    let beam = problem.beam.planar()?;
    if let Some(section) = beam.upright_section(state, UPRIGHT) {
        return Some(LoadingError::Upright { at, section });
    }
    if let Some(section) = beam.collapsed_section(state) {
        return Some(LoadingError::Collapses { at, section });
    }
    let free_end = beam.nodes(&state.values).get(beam.rotation)?.cos();
    (free_end.abs() < UPRIGHT).then_some(LoadingError::OnEnd { at })
}

/// The problem with x at every node, where the horizontal force is a multiplier: that one's energy is no minimum, and does not fall.
pub(super) fn with_x(model: &PeelModel, how: Discretisation, problem: &BeamProblem) -> Option<BeamProblem> {
    let three_field = Discretisation { form: Form::ThreeField, ..how };
    let has_multiplier = problem.beam.planar().is_some_and(|beam| beam.chain.has_border());
    has_multiplier.then(|| model.discretised(three_field, |_| {}).ok()).flatten()
}

/// An equilibrium of the problem with x at every node, as one of the problem that it was made of.
pub(super) fn without_x(problem: &BeamProblem, at: State, with_x: &BeamProblem) -> State {
    match (problem.beam.planar(), with_x.beam.planar()) {
        (Some(own), Some(with_x)) => own.without_x(&at, with_x),
        _ => at,
    }
}
