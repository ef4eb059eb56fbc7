//! Where a path loses its stability out of the plane, by equilibria solved on the step that holds it.

use super::result::OutOfPlaneLoss;
use super::roll_elements::RollReader;
use crate::solve::error::SolveError;
use crate::solve::newton::on_more_elements;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::step_to;
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{COMPANION_FRACTION, DIFFERENCE_BOUND_FACTOR, ROUND_OFF_PLACE, least};
use crate::study::peel::solution_history::SolutionHistory;
use std::sync::Arc;

/// Error of a solution, relative as in [`crate::solve::System::size`].
const FINE: f64 = 1e-12;
/// Most solves until the loss is located, and on each finer mesh.
const MOST_SOLVES: usize = 60;
/// What is left to find over the step when it is found: the rest is extrapolated with the tangent.
const FOUND: f64 = 1e-7;
/// Most finer meshes until the bound is what was asked.
const MOST_MESHES: usize = 4;

/// A place on a step with what is known there: its label on the segment, and the margin of
/// [`super::roll_elements::RollStability`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub label: f64,
    pub margin: f64,
}

/// The roll of a path on the step behind one of its points.
pub(super) struct StepSearch<'s> {
    pub reader: &'s RollReader<'s>,
    pub history: &'s SolutionHistory,
    pub step: usize,
    pub segment: PathSegment,
}

/// A loss that was located, with what is known of the path beside it.
pub(super) struct LocatedLoss {
    pub loss: OutOfPlaneLoss,
    /// Nothing where the path is unstable from its beginning on
    pub beside: Option<Beside>,
}

/// An equilibrium next to a loss.
pub(super) struct Beside {
    pub solution: Arc<Solution>,
    /// Of the constraint along the path
    pub weights: Observables,
    /// From there to the loss, in the constraint's target
    pub ahead: f64,
    /// Change of the margin per unit of the constraint's target
    pub margin_slope: f64,
}

/// A loss on one mesh.
struct Lost {
    solution: Arc<Solution>,
    /// Of the constraint, at the solution
    target: f64,
    /// From there to the loss, in the constraint's target
    ahead: f64,
    /// Of the margin, per unit of the constraint's target
    slope: f64,
}

impl Lost {
    fn observables(&self) -> Observables {
        self.solution.observables.plus(&self.solution.slope.times(self.ahead))
    }
}

impl<'s> StepSearch<'s> {
    pub(crate) fn new(reader: &'s RollReader<'s>, history: &'s SolutionHistory, step: usize) -> Self {
        let segment = PathSegment::around(&history.problem, &history.points, step);
        Self { reader, history, step, segment }
    }

    /// The equilibrium at the label `at`, by way of the nearer end of the step.
    pub(crate) fn solution_at(&mut self, at: f64, ws: &mut Workspace) -> Result<Arc<Solution>, SolveError> {
        let nearer = if at < 0.5 * self.segment.end() { 0.0 } else { self.segment.end() };
        step_to(&self.history.problem, &mut self.segment, nearer, at, FINE, ws)
    }

    /// The same with its margin.
    pub(crate) fn margin_at(&mut self, at: f64, ws: &mut Workspace) -> Result<(Arc<Solution>, Known), SolveError> {
        let solution = self.solution_at(at, ws)?;
        let margin = self.margin_of(&solution)?;
        Ok((solution, Known { label: at, margin }))
    }

    fn margin_of(&self, solution: &Solution) -> Result<f64, SolveError> {
        let found = self.reader.stability(&solution.at);
        found.map(|found| found.margin()).ok_or(SolveError::SingularGrip)
    }

    /// The loss between a stable place and one that is not, with bounds on the errors of its numbers.
    pub(crate) fn located(
        mut self,
        (stable, lost): (Known, Known),
        relative: f64,
        ws: &mut Workspace,
    ) -> Result<LocatedLoss, SolveError> {
        let mut coarse = self.on_path_mesh(stable, lost, ws)?;
        let Lost { solution, ahead, slope, .. } = &coarse;
        let (weights, ahead, margin_slope) = (self.segment.weights, *ahead, *slope);
        let beside = Some(Beside { solution: solution.clone(), weights, ahead, margin_slope });
        let mut found = None;
        for _ in 0..MOST_MESHES {
            let Ok(fine) = self.on_finer_mesh(&coarse, ws) else { break };
            let loss = self.bounded(&coarse, &fine, relative);
            let is_enough = loss.displacement_error <= relative * loss.displacement.abs();
            let is_better = found.is_none_or(|best: OutOfPlaneLoss| loss.displacement_error < best.displacement_error);
            found = if is_better { Some(loss) } else { found };
            if is_enough || !is_better {
                break;
            }
            coarse = fine;
        }
        // where finer meshes have no loss beside this one, the step is what is known
        Ok(LocatedLoss { loss: found.unwrap_or_else(|| self.unconfirmed(&coarse)), beside })
    }

    /// By chords of the margin, every third look in the middle of what is left.
    fn on_path_mesh(&mut self, mut stable: Known, mut lost: Known, ws: &mut Workspace) -> Result<Lost, SolveError> {
        let end = self.segment.end();
        for look in 1..=MOST_SOLVES {
            let width = lost.label - stable.label;
            let chord = stable.label + width * stable.margin / (stable.margin - lost.margin);
            let middle = 0.5 * (stable.label + lost.label);
            let is_chord = look % 3 != 0 && lost.margin.is_finite();
            let at = if is_chord { chord } else { middle };
            let (solution, known) = self.margin_at(at, ws)?;
            let (before, behind) = (stable, lost);
            if known.margin > 0.0 {
                stable = known
            } else {
                lost = known
            }
            // the chord to the end that stays, from the two nearest places
            let other =
                if (known.label - before.label).abs() < (behind.label - known.label).abs() { before } else { behind };
            let slope = (known.margin - other.margin) / (known.label - other.label);
            let ahead = -known.margin / slope;
            let is_near = ahead.abs() <= FOUND * end || (lost.label - stable.label).abs() <= FOUND * end;
            if slope.is_finite() && ahead.is_finite() && is_near {
                let target = self.segment.target(known.label);
                return Ok(Lost { solution, target, ahead, slope });
            }
        }
        Err(SolveError::NotConverged { update: (lost.label - stable.label) / end, iterations: MOST_SOLVES })
    }

    /// The same loss on half as many elements again, by the secant rule.
    fn on_finer_mesh(&self, coarse: &Lost, ws: &mut Workspace) -> Result<Lost, SolveError> {
        let problem = &*self.history.problem;
        let weights = self.segment.weights;
        let end = self.segment.end().abs();
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 10, exact_slope: true };
        let mut solution = on_more_elements(problem, &coarse.solution, weights, ws)?;
        let (mut target, mut slope) = (coarse.target, coarse.slope);
        let mut margin = self.margin_of(&solution)?;
        for _ in 0..MOST_SOLVES {
            let ahead = -margin / slope;
            if !ahead.is_finite() || (target + ahead - coarse.target).abs() > end {
                break;
            }
            if ahead.abs() <= FOUND * end {
                return Ok(Lost { solution: Arc::new(solution), target, ahead, slope });
            }
            target += ahead;
            let constraint = PathConstraint { weights, target };
            solution = solve(problem, solution.moved(problem, ahead), &constraint, &options, ws)?;
            let next = self.margin_of(&solution)?;
            (slope, margin) = ((next - margin) / ahead, next);
        }
        Err(SolveError::LimitPointNotConfirmed)
    }

    /// The loss with its bounds, from the same on a finer mesh.
    fn bounded(&self, coarse: &Lost, fine: &Lost, relative: f64) -> OutOfPlaneLoss {
        let (found, difference) = (coarse.observables(), fine.observables().since(&coarse.observables()));
        let share = (difference.displacement / found.displacement).abs().max((difference.force / found.force).abs());
        let floor = COMPANION_FRACTION * share.min(1.0) + least(relative);
        let bound = |difference: f64, value: f64, round_off: f64| {
            DIFFERENCE_BOUND_FACTOR * difference.abs() + (floor + round_off) * value.abs()
        };
        OutOfPlaneLoss {
            displacement: found.displacement,
            force: found.force,
            displacement_error: bound(difference.displacement, found.displacement, ROUND_OFF_PLACE),
            force_error: bound(difference.force, found.force, ROUND_OFF_PLACE),
            after: Some(self.step),
        }
    }

    /// A loss of which no more is known than its step.
    fn unconfirmed(&self, coarse: &Lost) -> OutOfPlaneLoss {
        let (found, change) = (coarse.observables(), self.segment.change());
        OutOfPlaneLoss {
            displacement: found.displacement,
            force: found.force,
            displacement_error: change.displacement.abs(),
            force_error: change.force.abs(),
            after: Some(self.step),
        }
    }
}
