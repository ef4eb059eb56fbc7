//! The work of the grip along a path, of its force, and of its moment where it turns: the energy it changed, or, where the load has no
//! potential, ∫ P du.

use crate::adhesion::friction::dahl::FrictionState;
use crate::beam::planar::planar_beam::FrictionHistory;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::newton::on_more_elements;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::Located;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::Observables;
use crate::solve::workspace::{ShouldStop, Workspace};
use crate::study::asked::error_bounds::{DIFFERENCE_BOUND_FACTOR, ROUND_OFF, bound_floor};
use crate::study::peel::result::{PathFailure, Peel};
use crate::study::peel::solution_history::SolutionHistory;
use crate::study::peel::step_dependence::StepCurve;
use std::sync::Arc;

/// Work from rest to a point, aJ; 0 where the load has no potential, until [`Peel::integrate_works`].
pub(in crate::study) fn work_at(problem: &BeamProblem, first: &Solution, s: &Solution) -> f64 {
    if problem.system.is_conservative() { energy(problem, s) - energy(problem, first) } else { 0.0 }
}

/// The same at a located point.
pub(in crate::study::peel) fn work_near(problem: &BeamProblem, first: &Solution, located: &Located) -> f64 {
    if !problem.system.is_conservative() {
        return 0.0;
    }
    let s = &located.solution;
    let ahead = power(problem, s) * (located.observables.displacement - s.observables.displacement);
    work_at(problem, first, s) + ahead
}

/// What more elements change of the works of a path.
pub(in crate::study::peel) struct WorkErrors<'p> {
    problem: &'p BeamProblem,
    /// Change of the energy where the path begins, aJ; none where there is none to be had.
    start: Option<f64>,
    /// Energy there, aJ
    first: f64,
    relative: f64,
}

impl<'p> WorkErrors<'p> {
    /// Of a path that begins at a point.
    pub(crate) fn new(problem: &'p BeamProblem, first: &Solution, relative: f64, ws: &mut Workspace) -> Self {
        let known = problem.system.is_conservative() && !problem.system.step_dependence().exists();
        let start = known.then(|| change_of_energy(problem, first, Observables::DISPLACEMENT, ws)).flatten();
        Self { problem, start, first: energy(problem, first), relative }
    }

    /// Bound on the error of the work at a limit point whose displacement has the bound `displacement_error`, aJ.
    ///
    /// On half as many elements again the limit point lies Δu further, and its energy is that of the solution with the same force (at a limit
    /// point of the displacement; with the same displacement at one of the force), and P du from there: with E' and u' of that solution it
    /// changes by E' - E - P (u' - u) + P Δu. The last is bounded as the displacement is.
    pub(crate) fn at(
        &self,
        located: &Located,
        kind: LimitPointKind,
        displacement_error: f64,
        ws: &mut Workspace,
    ) -> Option<f64> {
        let s = &located.solution;
        let held = match kind {
            LimitPointKind::Displacement => Observables::FORCE,
            LimitPointKind::Load => Observables::DISPLACEMENT,
        };
        let change = change_of_energy(self.problem, s, held, ws)? - self.start?;
        let energy = energy(self.problem, s);
        let floor = ROUND_OFF * energy.abs().max(self.first.abs())
            + bound_floor(located, self.relative) * (energy - self.first).abs();
        let bound = DIFFERENCE_BOUND_FACTOR * change.abs() + power(self.problem, s).abs() * displacement_error + floor;
        bound.is_finite().then_some(bound)
    }
}

/// E' - E - P (u' - u), aJ: a solution on half as many elements again, with one number held, against a solution.
fn change_of_energy(problem: &BeamProblem, s: &Solution, held: Observables, ws: &mut Workspace) -> Option<f64> {
    let finer = on_more_elements(problem, s, held, ws).ok()?;
    let moved = finer.observables.displacement - s.observables.displacement;
    Some(energy(problem, &finer) - energy(problem, s) - power(problem, s) * moved)
}

/// ∫ P du from rest to each point, aJ, whatever the load.
pub(in crate::study::peel) fn works_of_force(
    problem: &BeamProblem,
    points: &[Arc<Solution>],
    ws: &mut Workspace,
) -> Vec<f64> {
    let mut works = vec![0.0];
    for i in 0..points.len().saturating_sub(1) {
        works.push(works[i] + StepCurve::behind(problem, points, i, ws).work());
    }
    works
}

/// dΠ/du of an equilibrium, nN: the force along the pull, and of a grip that turns as it goes the work of the moment besides.
pub(in crate::study) fn power(problem: &BeamProblem, s: &Solution) -> f64 {
    let (force, gear) = (s.at.force, problem.grip.gear);
    if gear == 0.0 { force } else { force + gear * problem.beam.grip_forces(&s.at).moment }
}

/// Stored and adhesion energy, aJ.
pub(in crate::study::peel) fn energy(problem: &BeamProblem, s: &Solution) -> f64 {
    problem.energy(&s.at, s.energy)
}

impl Peel {
    /// Where the load has no potential: ∫ P du of every point and limit point. It takes solutions inside every step, longer than the path,
    /// and so is done once, of the path that is reported. What came out too late may be of interpolants.
    pub(in crate::study::peel) fn integrate_works(&mut self, should_stop: Option<ShouldStop>) -> Option<PathFailure> {
        let SolutionHistory { problem, points, limit_points: located, .. } = self.trace.as_ref()?;
        if problem.system.is_conservative() {
            return None;
        }
        let ws = &mut Workspace::until(should_stop);
        let works = works_of_force(problem, points, ws);
        for (point, work) in self.points.iter_mut().zip(&works) {
            point.work = *work;
        }
        for (turn, solution) in self.limit_points.iter_mut().zip(located) {
            let mut segment = PathSegment::around(problem, points, turn.after);
            let label = segment.insert(solution.clone());
            turn.work = works[turn.after] + StepCurve::until(problem, &segment, label, solution, ws).work();
        }
        self.tell_bounds();
        ws.is_stopped().then_some(PathFailure::OutOfTime)
    }

    /// ∫ P du from rest to `points[index]`, by quadrature, which knows nothing of energies, and the change of stored and adhesion
    /// energy on that way, both aJ; nothing where the path was not kept. They are equal where the load has a potential and the
    /// grip does not turn.
    pub fn work_and_energy(&self, index: usize) -> Option<(f64, f64)> {
        let trace = self.trace.as_ref()?;
        let points = trace.points.get(..=index)?;
        let work = *works_of_force(&trace.problem, points, &mut Workspace::default()).last()?;
        Some((work, energy(&trace.problem, points.last()?) - energy(&trace.problem, points.first()?)))
    }
}

// -- Where what has let go closes, and how a beam that friction holds has slid --

impl Peel {
    /// The displacement (nm) from which the beam goes by what its face remembers, where what has let go does not heal: there it first closes again.
    /// Zero where that was before the pull; none where nothing has closed by more than 1e-11 of the work of adhesion of a process zone.
    pub fn closing(&self) -> Option<f64> {
        let trace = self.trace.as_ref().filter(|_| !self.model.adhesion.healing)?;
        let goes_by_it =
            |at: &Solution| at.at.history.as_ref().is_some_and(|known| known.points().any(|(_, _, row)| row[0] > 0.0));
        let first = trace.points.iter().position(|at| goes_by_it(at))?;
        Some(trace.points[first.saturating_sub(1)].observables.displacement)
    }
}

/// The friction on a beam at one equilibrium of its path.
#[derive(Clone, Debug, PartialEq)]
pub struct Sliding {
    /// Displacement of the face at the free end along the substrate, nm
    pub free_end: f64,
    /// ∫ b t dS, what friction carries along the substrate, nN
    pub force: f64,
    /// ∫ b τ dS, what it could carry, nN
    pub capacity: f64,
    /// Length in contact: where the limit is more than half the shear strength, nm
    pub contact: f64,
    /// Length of that on which the face slides: where it carries more than nine tenths of its limit, nm
    pub sliding: f64,
    /// Energy dissipated since the path began, aJ
    pub dissipated: f64,
    /// S (nm), traction over shear strength s, and shear strength τ (GPa), along the beam
    pub along: Vec<(f64, f64, f64)>,
}

/// Traction over shear strength from which a face counts as sliding, and fraction of the strength from which it counts as in contact.
const SLIDES: f64 = 0.9;
const TOUCHES: f64 = 0.5;

impl Peel {
    /// How the beam has slid at its initiation peak; none without friction or without a peak.
    pub fn sliding_at_peak(&self) -> Option<Sliding> {
        let trace = self.trace.as_ref()?;
        self.sliding(trace, trace.peak.as_ref()?)
    }

    /// The same at `points[index]`.
    pub fn sliding_at(&self, index: usize) -> Option<Sliding> {
        let trace = self.trace.as_ref()?;
        self.sliding(trace, trace.points.get(index)?)
    }

    fn sliding(&self, trace: &SolutionHistory, solution: &Solution) -> Option<Sliding> {
        let strength = self.model.friction.strength?;
        let began = FrictionHistory(trace.problem.beam.planar()?.memory.slip_at_rest()?).iter().next()?.1.place;
        let history = trace.problem.system.commit(&solution.at)?;
        let along: Vec<(f64, FrictionState)> = FrictionHistory(&history).iter().collect();
        // by the trapezoidal rule
        let sum = |of: &dyn Fn(&(f64, FrictionState)) -> f64| -> f64 {
            along.windows(2).map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (of(&pair[0]) + of(&pair[1]))).sum()
        };
        let width = |s: f64| self.model.section_at(s).1;
        let touches = |slip: &FrictionState| slip.limit > TOUCHES * strength;
        Some(Sliding {
            free_end: along[0].1.place - began,
            force: sum(&|(s, slip)| width(*s) * slip.mobilisation * slip.limit),
            capacity: sum(&|(s, slip)| width(*s) * slip.limit),
            contact: sum(&|(_, slip)| f64::from(touches(slip))),
            sliding: sum(&|(_, slip)| f64::from(touches(slip) && slip.mobilisation.abs() > SLIDES)),
            dissipated: history.dissipated,
            along: along.iter().map(|(s, slip)| (*s, slip.mobilisation, slip.limit)).collect(),
        })
    }
}
