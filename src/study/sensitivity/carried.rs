//! A state of one model as a state of another that differs from it a little.

use super::error::NoSensitivities;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::problem::InitialState;
use crate::solve::state::{Mesh, State};
use crate::study::initial::prepared::prepared;

/// A model beside the one that was peeled, made into what the solver is given.
pub(super) struct Beside {
    problem: BeamProblem,
    /// Where elements have to end, with both ends of the beam, nm
    breaks: Vec<f64>,
}

impl Beside {
    /// Of the model that was peeled.
    pub fn base(problem: &BeamProblem, model: &PeelModel) -> Self {
        Self { problem: problem.clone(), breaks: with_ends(model) }
    }

    /// Of a model that differs from that by `change` in the parameter `key`. A start that had to be found is found again: displacements count
    /// from there.
    pub fn varied(
        key: &str,
        change: f64,
        model: &PeelModel,
        base: &BeamProblem,
        how: Discretisation,
    ) -> Result<Self, NoSensitivities> {
        model.check().map_err(|cause| NoSensitivities::AtTheEdge { key: key.to_owned(), change, cause })?;
        let problem = match base.start {
            InitialState::Known { .. } => prepared(model, how, None)
                .map(|prepared| prepared.problem)
                .map_err(|failed| NoSensitivities::NoStart { key: key.to_owned(), change, cause: failed.why })?,
            InitialState::StressFree | InitialState::Settling => model.discretised(how, |_| {})?,
        };
        Ok(Self { problem, breaks: with_ends(model) })
    }

    pub fn problem(&self) -> &BeamProblem {
        &self.problem
    }

    /// A state of `base` as one of this: with every number but those of the grip, which stays where it was along the drive. Elements end at the same
    /// shares of what lies between breaks.
    pub fn carried(&self, base: &Self, at: &State) -> Option<State> {
        let (own, other) = (&self.problem, &base.problem);
        let place = |s: f64| {
            let k = base.breaks.partition_point(|&end| end < s).clamp(1, base.breaks.len() - 1);
            let share = (s - base.breaks[k - 1]) / (base.breaks[k] - base.breaks[k - 1]);
            self.breaks[k - 1] + share * (self.breaks[k] - self.breaks[k - 1])
        };
        if self.breaks.len() != base.breaks.len() {
            return None;
        }
        let boundaries: Vec<f64> = at.mesh.boundaries.iter().map(|&s| place(s)).collect();
        let moved = State { mesh: Mesh { boundaries, ..at.mesh.clone() }, ..at.clone() };
        if own.system.interface().len() != other.system.interface().len()
            || own.system.unknowns(&moved) != other.system.unknowns(at)
        {
            return None;
        }
        Some(own.grip.carried(&other.grip, &*other.system, &*own.system, moved))
    }
}

/// Where the elements of a model have to end, with both ends, ascending.
fn with_ends(model: &PeelModel) -> Vec<f64> {
    let length = model.length();
    let mut breaks = vec![0.0];
    breaks.extend(model.breaks().into_iter().filter(|&s| s > 0.0 && s < length));
    breaks.push(length);
    breaks
}
