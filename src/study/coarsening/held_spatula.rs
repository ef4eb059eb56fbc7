//! A spatula whose end is held at a height, at a place along the substrate and at a rotation.
//!
//! Equilibrium minimises Π over all unknowns but these three; then E(u, v, θ) = min Π, ∂E/∂(u, v, θ) is the residual of the equations of the end,
//! and ∂²E/∂(u, v, θ)² what is left of the tangent when all else is eliminated.

use super::options::{HeldError, PadEnd, TipPlace, TipResponse};
use crate::model::peel::{Form, Grip, Hold, PeelModel, Pull};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::PathOptions;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::system::{Coefficients, INTERFACE};
use crate::solve::workspace::{ShouldStop, Workspace};
use crate::study::asked::accuracy::{Accuracy, Resolution};
use crate::study::initial::prepared::{Prepared, prepared};

/// Error of a solution, relative as in [`crate::solve::System::size`].
const OPTIONS: NewtonOptions =
    NewtonOptions { tolerance: 1e-11, largest_update: 0.5, most_iterations: 12, exact_slope: false };
/// Error of the mesh, over the tolerance of the table.
const MESH: f64 = 1e-3;
const FINEST: f64 = 1e-7;
/// Shortest step from place to place, as a share of the way.
const SHORTEST: f64 = 1e-4;
/// Most growth of a step that was taken, and what is left of one that was not.
const GROWTH: f64 = 2.0;
const SHORTER: f64 = 0.4;

/// A spatula in a grip that holds all of its end.
#[derive(Clone)]
pub(super) struct HeldSpatula {
    problem: BeamProblem,
    pub options: PathOptions,
    pad_end: PadEnd,
    should_stop: Option<ShouldStop>,
}

/// An equilibrium with its end held at a place.
#[derive(Clone)]
pub(super) struct HeldState {
    pub place: TipPlace,
    pub solution: Solution,
}

impl HeldSpatula {
    /// Of a model, on a mesh whose error is far below a relative `tolerance`; once `should_stop` says so, nothing more is solved.
    pub(crate) fn new(
        model: &PeelModel,
        pad_end: PadEnd,
        tolerance: f64,
        should_stop: Option<ShouldStop>,
    ) -> Result<Self, HeldError> {
        let horizontal = if pad_end == PadEnd::Held { Hold::Fixed } else { Hold::Free };
        let grip = Grip { rotation: Hold::Fixed, horizontal, ..Grip::FREE };
        let model = PeelModel { grip, pull: Pull::UP, steps: Vec::new(), ..model.clone() };
        let accuracy = Accuracy::to((MESH * tolerance).max(FINEST));
        let resolution = Resolution::first(&model, &accuracy);
        let how = Discretisation::moving(Form::TwoField, resolution.order);
        let Prepared { problem, .. } = prepared(&model, how, None).map_err(|why| HeldError::NoStart(why.why))?;
        let options = resolution.path_options(&model, accuracy.relative);
        Ok(Self { problem, options, pad_end, should_stop })
    }

    /// Room for solves of it.
    pub(crate) fn workspace(&self) -> Workspace {
        Workspace::until(self.should_stop.clone())
    }

    /// That nothing more is to be solved.
    pub(crate) fn check_stop(&self) -> Result<(), HeldError> {
        if self.should_stop.as_ref().is_some_and(|should_stop| should_stop()) {
            Err(HeldError::Stopped)
        } else {
            Ok(())
        }
    }

    /// Its equilibria as a path from one of them on.
    pub(crate) fn path<'p>(&self, problem: &'p BeamProblem, options: PathOptions, start: State) -> Path<'p> {
        Path::from(problem, options, start).until(self.should_stop.clone())
    }

    /// The problem of a drive straight up with the end held at a place along the substrate and at a rotation.
    pub(crate) fn problem_at(&self, place: TipPlace) -> BeamProblem {
        let mut grip = self.problem.grip;
        grip.origin[self.problem.beam.slot_of_rotation()] += place.rotation;
        if let Some(across) = grip.across.filter(|_| self.pad_end == PadEnd::Held) {
            grip.origin[across] += place.lateral;
        }
        self.problem.with_grip(grip)
    }

    /// The equilibrium next to the stress-free configuration.
    pub(crate) fn rest(&self) -> Result<HeldState, HeldError> {
        let first = Path::new(&self.problem, self.options).advance().map_err(HeldError::NoRest)?;
        let rest = HeldState { place: TipPlace::default(), solution: Solution::clone(&first) };
        self.moved(&rest, TipPlace::default(), &mut self.workspace())
    }

    /// The equilibrium next to the stress-free configuration so far away from the substrate, nm.
    pub(crate) fn lifted(&self, normal: f64) -> Result<HeldState, HeldError> {
        let place = TipPlace { normal, ..TipPlace::default() };
        let mut at = self.problem.system.stress_free(self.options.elements);
        if let Some(beam) = self.problem.beam.planar() {
            let nodes = beam.nodes(&at.values).len();
            let heights = at.values[..nodes].iter_mut().skip(beam.slot_of_height()).step_by(beam.fields());
            heights.for_each(|height| *height += normal);
        }
        let solution = solved(&self.problem, at, normal, &mut Workspace::default())
            .map_err(|cause| HeldError::NotReached { from: place, to: place, reached: place, cause })?;
        Ok(HeldState { place, solution })
    }

    /// The stable equilibrium at this v and θ in which the end is held by a normal force, nN, by equilibria between on a straight line.
    pub(crate) fn under_force(
        &self,
        from: &HeldState,
        force: f64,
        to: TipPlace,
        ws: &mut Workspace,
    ) -> Result<HeldState, HeldError> {
        let first = from.solution.at.force;
        self.on_the_way(from, to, |here, place, share| {
            let constraint = PathConstraint { weights: Observables::FORCE, target: first + share * (force - first) };
            let problem = self.problem_at(place);
            let solution = with_own_mesh(&problem, here.solution.at.clone(), &constraint, &OPTIONS, ws)?;
            stable(HeldState { place: TipPlace { normal: solution.observables.displacement, ..place }, solution })
        })
    }

    /// The stable equilibrium at another place, by equilibria between on a straight line.
    pub(crate) fn moved(&self, from: &HeldState, to: TipPlace, ws: &mut Workspace) -> Result<HeldState, HeldError> {
        self.on_the_way(from, to, |here, place, _| {
            let solution = solved(&self.problem_at(place), here.solution.at.clone(), place.normal, ws)?;
            stable(HeldState { place, solution })
        })
    }

    /// From state to state on a straight line, in steps as long as `next` bears them: it gets a state, a place near by and its share of the way.
    fn on_the_way(
        &self,
        from: &HeldState,
        to: TipPlace,
        mut next: impl FnMut(&HeldState, TipPlace, f64) -> Result<HeldState, SolveError>,
    ) -> Result<HeldState, HeldError> {
        let (mut here, mut share, mut step) = (from.clone(), 0.0, 1.0f64);
        loop {
            let ahead = if share + step >= 1.0 { 1.0 } else { share + step };
            match next(&here, from.place.toward(to, ahead), ahead) {
                Ok(state) if ahead == 1.0 => return Ok(state),
                Ok(state) => (here, share, step) = (state, ahead, GROWTH * step),
                Err(SolveError::Stopped) => return Err(HeldError::Stopped),
                Err(cause) if step < SHORTEST => {
                    return Err(HeldError::NotReached { from: from.place, to, reached: here.place, cause });
                }
                Err(_) => step *= SHORTER,
            }
        }
    }

    /// Energy, forces and stiffness of an equilibrium.
    pub(crate) fn response(&self, at: &State, ws: &mut Workspace) -> Result<TipResponse, SolveError> {
        let system = &*self.problem.system;
        let root = system.factorise(at, Coefficients::STATIC, [0.0; 2], ws)?;
        let residual = system.residual(at);
        let slots = self.slots();
        let force = slots.map(|slot| slot.map_or(0.0, |slot| residual[system.place_of(slot, at)]));
        let condensed = condensed(&root.matrix, system.interface().len(), &slots);
        let entry = |i: usize, j: usize| match (slots[i], slots[j]) {
            (Some(a), Some(b)) => condensed[a][b],
            _ => 0.0,
        };
        let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (entry(i, j) + entry(j, i))));
        Ok(TipResponse { energy: root.evaluation.energy, force, stiffness })
    }

    /// Slots of the interface for u, v and θ; none for v where the pad slides.
    fn slots(&self) -> [Option<usize>; 3] {
        let (beam, grip) = (&self.problem.beam, &self.problem.grip);
        let lateral = grip.across.filter(|_| self.pad_end == PadEnd::Held);
        [Some(grip.driven), lateral, Some(beam.slot_of_rotation())]
    }
}

/// An equilibrium at a displacement, from near by.
fn solved(problem: &BeamProblem, at: State, normal: f64, ws: &mut Workspace) -> Result<Solution, SolveError> {
    let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: normal };
    with_own_mesh(problem, at, &constraint, &OPTIONS, ws)
}

/// The equilibrium under a constraint, from near by, on the mesh that it asks for.
pub(super) fn with_own_mesh(
    problem: &BeamProblem,
    at: State,
    constraint: &PathConstraint,
    options: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let solution = solve(problem, at, constraint, options, ws)?;
    match problem.system.remeshed(&solution.at) {
        Some(at) => solve(problem, at, constraint, options, ws),
        None => Ok(solution),
    }
}

/// A state, if it is stable.
fn stable(state: HeldState) -> Result<HeldState, SolveError> {
    let Solution { negative, correction, iterations, .. } = state.solution;
    if negative > 0 { Err(SolveError::NotConverged { update: correction, iterations }) } else { Ok(state) }
}

/// What is left of a block on the slots that are kept, with the others eliminated.
fn condensed(
    matrix: &[[f64; INTERFACE]; INTERFACE],
    interface: usize,
    kept: &[Option<usize>],
) -> [[f64; INTERFACE]; INTERFACE] {
    let mut block = *matrix;
    for pivot in (0..interface).filter(|slot| !kept.contains(&Some(*slot))) {
        for i in (0..interface).filter(|&i| i != pivot) {
            let factor = block[i][pivot] / block[pivot][pivot];
            for j in 0..interface {
                block[i][j] -= factor * block[pivot][j];
            }
        }
    }
    block
}
