//! A limit point of the path followed in a parameter of the model.
//!
//! The limit point is the solution of an augmented system (see `solve::LimitPointSearch`). Its state and
//! its force are extrapolated in the parameter by Lagrange polynomials through the values behind it, at equal mesh
//! coordinates, as many as have been best so far; the mesh follows the front and the process zone of each model. Values between those that are asked for are taken where the extrapolation would be too far off.

use super::result::PointKind;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::error::SolveError;
use crate::solve::path::predictor::{lagrange_weights, longest_step};
use crate::solve::points::search::{BendRule, FoundLimitPoint, LimitPointSearch};
use crate::solve::problem::Problem;
use crate::solve::state::{Mesh, Observables, State, weighted_sum};
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::ORDER;
use crate::study::peel::along_path::work::power;
use std::collections::VecDeque;

/// Most values that an extrapolation uses.
const MOST_POINTS: usize = 9;
/// Error wanted of an extrapolation, relative.
const TOLERANCE: f64 = 1e-3;
/// A value is refused when Newton moves from its extrapolation by more than this, relative as in
/// [`Problem::relative_size`].
const REFUSE: f64 = 0.1;
/// Most growth of a step between values that were not asked for.
const MOST_GROWTH: f64 = 3.0;
/// Values follow closely where displacement, force and front change by less than this from one to the next.
const CLOSELY: f64 = 0.01;
/// Most values for which dg/dσ is taken over from the one before.
const OLDEST_BEND: usize = 4;
/// A step below this share of the distance asked for is given up.
const LEAST_STEP: f64 = 1e-6;
/// Most steps that are refused on the way to one value, and a tenth of the most that are taken.
const MOST_TRIES: usize = 100;
/// A limit point is about to meet another where dg/dσ has fallen to this share since the last value asked for.
const MEETS: f64 = 0.1;
/// The width of a limit point, as a share of its displacement or force.
const WIDTH: f64 = 0.3;

/// A limit point at one value of the parameter, as the extrapolation needs it.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// The parameter.
    pub at: f64,
    /// The limit point on the mesh whose focus is at `center`; `ends` are those of a mesh near it.
    pub equilibrium: State,
    /// The constraint's target.
    pub target: f64,
    /// dg/dσ of the limit point.
    pub bend: f64,
    /// How many values ago that was measured.
    pub bend_age: usize,
    /// Of the limit point.
    pub observables: Observables,
    /// Size of what was neglected in displacement and force.
    pub neglected: Observables,
    /// Energy of the strip and the substrate, with that of a held grip, nN·nm.
    pub energy: f64,
}

/// Why a limit point could not be followed further.
#[derive(Clone, Debug)]
pub(super) struct Lost {
    /// The last value of the parameter at which it was there, and the nearest at which it was not found.
    pub last: f64,
    pub next: f64,
    /// Whether it was about to meet another limit point: dg/dσ was going to zero.
    pub meets: bool,
    pub cause: SolveError,
}

/// The model's problem with the mesh that the point needs.
pub(super) fn problem(model: &PeelModel, kind: PointKind) -> BeamProblem {
    let how = Discretisation::moving(Form::TwoField, ORDER);
    let problem = model.discretised(how, |beam| {
        if kind == PointKind::InitiationPeak {
            // the free end of a long strip is still at rest, and that of no strip stands on its edge
            let weight = 0.375 / (1.0 + (model.length() / (25.0 * model.bending_length())).powi(6));
            for focus in beam.mesh.fixed_foci.iter_mut().filter(|focus| focus.center == 0.0) {
                focus.weight *= weight;
                focus.length = 0.36 * beam.process_length;
            }
        }
    });
    problem.expect("the order is one that there is")
}

/// A search for the point on a problem, with the displacement or the force as the place along the path.
pub(super) fn search(problem: &Problem, kind: PointKind, target: f64) -> LimitPointSearch<'_> {
    let weights = match kind {
        PointKind::InitiationPeak => Observables::DISPLACEMENT,
        PointKind::SnapOff => Observables::FORCE,
    };
    LimitPointSearch { problem, weights, kind: kind.turn(), width: WIDTH * target.abs() }
}

impl Known {
    /// A located limit point, on a mesh whose focus is exactly at the front of the solution next to it: on the mesh of
    /// the search it is where the front was predicted, and that prediction's error would be noise to the next one.
    pub(crate) fn new(problem: &BeamProblem, kind: PointKind, at: f64, fold: &FoundLimitPoint) -> Self {
        let FoundLimitPoint { solution, ahead, .. } = fold;
        let own = solution.aligned(problem);
        let mut equilibrium = State {
            mesh: Mesh { boundaries: solution.at.mesh.boundaries.clone(), ..own.mesh.clone() },
            values: own.values.clone(),
            force: 0.0,
            history: solution.at.history.clone(),
        };
        problem.system.retract(&mut equilibrium, &solution.tangent.direction, *ahead);
        equilibrium.force = fold.observables.force;
        let rise = fold.observables.displacement - solution.observables.displacement;
        Self {
            at,
            equilibrium,
            target: fold.target + ahead,
            bend: fold.bends.of(kind.turn()),
            bend_age: 0,
            observables: fold.observables,
            neglected: fold.neglected,
            energy: problem.energy(&solution.at, solution.energy) + power(problem, solution) * rise,
        }
    }

    /// The same limit point on `elements` elements, and how it was found.
    pub(crate) fn on_elements(
        &self,
        problem: &BeamProblem,
        kind: PointKind,
        elements: usize,
        ws: &mut Workspace,
    ) -> Result<FoundLimitPoint, SolveError> {
        let from = &self.equilibrium;
        let (beam, mesh) = (&problem.beam, problem.beam.mesh_near(from.mesh.focus, &from.mesh.follows, &from.mesh));
        let at = beam.system().on_elements(&State { mesh, ..from.clone() }, elements);
        search(problem, kind, self.target).run(at, self.target, BendRule::Difference { neighbour: None }, ws)
    }

    /// Numbers that tell how good an extrapolation is; a rotation that the grip holds is no such number.
    fn measures(&self) -> [f64; 3] {
        [self.observables.displacement, self.observables.force, self.observables.monitors[FRONT]]
    }
}

/// Follows one limit point from value to value of a parameter.
pub(super) struct Continuation<'m> {
    kind: PointKind,
    model: &'m dyn Fn(f64) -> PeelModel,
    /// Newest last.
    history: VecDeque<Known>,
    /// Errors at the newest value of extrapolations through 1, 2, … values behind it, relative.
    errors: Vec<f64>,
    /// Longest step that is tried, after one was refused.
    limit: f64,
    ws: Workspace,
    iterations: usize,
}

impl<'m> Continuation<'m> {
    /// Begins at a limit point that is known.
    pub(crate) fn new(kind: PointKind, model: &'m dyn Fn(f64) -> PeelModel, first: Known) -> Self {
        Self {
            kind,
            model,
            history: VecDeque::from([first]),
            errors: Vec::new(),
            limit: f64::INFINITY,
            ws: Workspace::default(),
            iterations: 0,
        }
    }

    /// Newton iterations so far.
    pub(crate) fn iterations(&self) -> usize {
        self.iterations
    }

    /// The limit point at the value `to` of the parameter.
    pub(crate) fn advance_to(&mut self, to: f64) -> Result<&Known, Lost> {
        let (asked, bend) = (to - self.newest().at, self.newest().bend);
        let mut tries = 0;
        while self.newest().at != to {
            tries += 1;
            let from = self.newest().at;
            let (count, step) = self.choose(to - from);
            let at = if step == to - from { to } else { from + step };
            match self.attempt(at, count) {
                Ok(_) if tries > 10 * MOST_TRIES => {
                    let cause = SolveError::NotConverged { update: step / asked, iterations: self.iterations };
                    return Err(Lost { last: from, next: at, meets: false, cause });
                }
                Ok(known) => self.accept(known, step),
                Err(cause) => {
                    self.limit = 0.35 * step.abs();
                    if self.limit < LEAST_STEP * asked.abs() || at == from || tries > MOST_TRIES {
                        let meets = self.newest().bend.abs() < MEETS * bend.abs();
                        return Err(Lost { last: from, next: at, meets, cause });
                    }
                }
            }
        }
        Ok(self.newest())
    }

    fn newest(&self) -> &Known {
        &self.history[self.history.len() - 1]
    }

    /// How many values to extrapolate from, and how far; the whole `gap` where that is near enough.
    fn choose(&self, gap: f64) -> (usize, f64) {
        let most = gap.abs().min(self.limit);
        let labels: Vec<f64> =
            self.history.iter().rev().map(|known| (known.at - self.newest().at) * gap.signum()).collect();
        let mut best = (1, if self.errors.is_empty() { most } else { 0.0 }, f64::INFINITY);
        for (count, &error) in (1..labels.len()).zip(&self.errors) {
            let step = longest_step(&labels, count, error, TOLERANCE, most);
            // the error grows like the product of the distances
            let product = |at: f64, from: usize| labels[from..from + count].iter().map(|l| at - l).product::<f64>();
            let left = error * product(step, 0) / product(labels[0], 1);
            if step > 1.001 * best.1 || (step > 0.999 * best.1 && left < best.2) {
                best = (count, step, left);
            }
        }
        let step = best.1.max(0.2 * most.min(self.last_step()));
        // two even steps rather than a long one and a stub
        let step = match gap.abs() {
            whole if step >= whole => whole,
            whole if 2.0 * step > whole => 0.5 * whole,
            _ => step,
        };
        (best.0, step * gap.signum())
    }

    fn last_step(&self) -> f64 {
        let n = self.history.len();
        if n < 2 { f64::INFINITY } else { (self.history[n - 1].at - self.history[n - 2].at).abs() }
    }

    /// The limit point at a value, from an extrapolation through `count` values.
    fn attempt(&mut self, at: f64, count: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(at), self.kind);
        let (start, target) = self.extrapolated(&problem, at, count);
        let neighbour = self.bend_near_by();
        let found =
            search(&problem, self.kind, target).run(start, target, BendRule::Difference { neighbour }, &mut self.ws);
        let fold = found.inspect_err(|_| self.iterations += 3)?;
        self.iterations += fold.iterations;
        let moved = fold.correction.max((fold.target + fold.ahead - target).abs() / target.abs());
        // a maximum that has become a minimum is another limit point
        let turned = fold.bends.of(self.kind.turn()) * self.newest().bend <= 0.0;
        if moved > REFUSE || turned || fold.observables.force <= 0.0 {
            return Err(SolveError::NotConverged { update: moved, iterations: fold.iterations });
        }
        let bend_age = if fold.measured { 0 } else { self.newest().bend_age + 1 };
        Ok(Known { bend_age, ..Known::new(&problem, self.kind, at, &fold) })
    }

    /// dg/dσ of the newest value, where it was measured not long ago and values follow closely.
    fn bend_near_by(&self) -> Option<f64> {
        let newest = self.newest();
        let closely = self.errors.first().is_some_and(|&change| change < CLOSELY);
        (closely && newest.bend_age < OLDEST_BEND).then_some(newest.bend)
    }

    /// A start for Newton's method at a value, and the constraint's target there.
    fn extrapolated(&self, problem: &BeamProblem, at: f64, count: usize) -> (State, f64) {
        let newest = self.newest();
        let used: Vec<&Known> = self.history.iter().rev().take(count).collect();
        let labels: Vec<f64> = used.iter().map(|known| known.at - newest.at).collect();
        let weights = lagrange_weights(&labels, at - newest.at);
        let (mut focus, mut force, mut target) = (0.0, 0.0, 0.0);
        for (known, weight) in used.iter().zip(&weights) {
            let mesh = &known.equilibrium.mesh;
            focus += weight * mesh.focus;
            force += weight * known.equilibrium.force;
            target += weight * known.target;
        }
        let follows: Vec<&[f64]> = used.iter().map(|known| &*known.equilibrium.mesh.follows).collect();
        let follows = weighted_sum(&follows, &weights);
        // along the way a pull can become vertical: there the beam has no axial force among its unknowns
        let values: Vec<_> = used.iter().map(|known| problem.beam.adopted(&known.equilibrium)).collect();
        let states: Vec<&[f64]> = values.iter().map(|values| &**values).collect();
        let mesh = problem.beam.mesh_near(focus, &follows, &newest.equilibrium.mesh);
        let sum = State { mesh, values: problem.system.combine(&states, &weights), force, history: None };
        (sum, target)
    }

    fn accept(&mut self, known: Known, step: f64) {
        let labels: Vec<f64> = self.history.iter().rev().map(|k| k.at - known.at).collect();
        let new = known.measures();
        let values: Vec<[f64; 3]> = self.history.iter().rev().map(Known::measures).collect();
        let error = |count: usize| {
            let weights = lagrange_weights(&labels[..count], 0.0);
            let miss = |m: usize| new[m] - weights.iter().zip(&values).map(|(w, v)| w * v[m]).sum::<f64>();
            (0..new.len()).map(|m| (miss(m) / new[m]).abs()).fold(0.0, f64::max)
        };
        let errors = (1..=labels.len()).map(error);
        // a lucky hit of one value is no measure of the next
        self.errors = errors
            .enumerate()
            .map(|(i, new)| new.max(0.1 * self.errors.get(i).copied().unwrap_or(0.0)).max(f64::EPSILON))
            .collect();
        self.limit = if self.limit.is_finite() { self.limit.max(step.abs()) * MOST_GROWTH } else { self.limit };
        self.history.push_back(known);
        if self.history.len() > MOST_POINTS {
            self.history.pop_front();
        }
    }
}
