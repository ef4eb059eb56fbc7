//! What the grip does before it pulls: a list of steps, each from the equilibrium to which the one before has led.
//!
//! A step moves one thing of the grip, its height, its place along the substrate or its rotation. Held meanwhile are the height,
//! and place and rotation as far as the scene's grip holds them; a place that a step has moved in a grip that is free there is let go
//! before the next step, and before the pull: the force on what is free falls to zero first. The equilibria are followed as a path in
//! what is moved; there is no time in it. Where they lose their stability the beam jumps, by gradient flow of its energy, and the step goes on
//! from where it comes to rest: [`super::step_jump`]. A beam without an energy that falls does not: its step ends there.

use super::error::{LoadingError, LoadingPhase, LoadingProgress, LoadingUnit, NoEquilibrium};
use super::grip_control::{GripControl, LettingGo, NONE};
use super::step_jump::{MOST_JUMPS, StabilityLoss, jumped, with_x, without_x};
use crate::beam::grip_state::{GripState, StepJump, StepsTaken};
use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::model::step::{Moved, Step};
use crate::solve::frontal::nodes::BUNDLE;
use crate::solve::newton::{NewtonOptions, Solution, settle, solve};
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::{PathOptions, controlled};
use crate::solve::path::predictor::MOST_POINTS;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::locate;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::{Pace, ShouldStop, Workspace};
use std::sync::Arc;

/// Elements on which steps are followed, over those of a short strip, and more for each break of an outline; their ends are found on
/// twice as many.
const SHORT: f64 = 10.0;
const A_BREAK: usize = 4;
/// How many times as many a strip in space takes, where a rolled section comes near the ground within a short way.
const IN_SPACE: f64 = 2.0;
/// How many times as many a law with corners takes, and how many more where elements are cut there.
const CORNERED: f64 = 5.0;
const AT_CORNERS: f64 = 32.0;
/// Most more that friction takes.
const MOST_SLIDING: f64 = 400.0;
/// Error of a prediction, over the gap, and of a solution on the way and at the end.
const STEP_TOLERANCE: f64 = 1e-2;
const ROUGH: f64 = 1e-9;
const FINE: f64 = 1e-11;
/// First step, over the scale of what moves and over the whole way.
const FIRST: f64 = 0.02;
const OF_WAY: f64 = 0.1;
/// Most equilibria of a step.
const MOST_EQUILIBRIA: usize = 500;
/// Parts of a segment of the path in which its end is looked for.
const PARTS: usize = 64;

/// Takes the steps of a model: its problem then starts where they have led, unless one of them has no end.
///
/// A beam whose horizontal force is a multiplier has no energy that falls: where it would jump the steps are taken once more with x at every node.
pub(super) fn take(
    model: &PeelModel,
    how: Discretisation,
    problem: &mut BeamProblem,
    should_stop: Option<ShouldStop>,
) -> (StepsTaken, Result<(), NoEquilibrium>) {
    let from_rest = problem.start.known().is_none();
    let (steps, taken) = take_with(model, problem, should_stop.clone());
    let jumps = taken.as_ref().err().is_some_and(NoEquilibrium::is_loss_of_stability);
    let Some(mut with_x) = (jumps && from_rest).then(|| with_x(model, how, problem)).flatten() else {
        return (steps, taken);
    };
    let (steps, taken) = take_with(model, &mut with_x, should_stop);
    if let Some(at) = with_x.start.known().filter(|_| taken.is_ok()) {
        let at = without_x(problem, State::clone(at), &with_x);
        problem.start_at(Arc::new(at));
        problem.settles();
    }
    (steps, taken)
}

fn take_with(
    model: &PeelModel,
    problem: &mut BeamProblem,
    should_stop: Option<ShouldStop>,
) -> (StepsTaken, Result<(), NoEquilibrium>) {
    if model.steps.is_empty() {
        return (StepsTaken::default(), Ok(()));
    }
    let pull = GripControl::of(problem);
    let mut sequence = LoadingSequence {
        elements: elements(model, problem),
        far: model.line_law().cutoff_distance(),
        azimuth: model.space.map(|space| space.azimuth),
        pull,
        first: None,
        should_stop,
        number: 1,
        last_jump: None,
        taken: StepsTaken::default(),
    };
    let taken = sequence.all(&model.steps, problem);
    pull.set(problem);
    (sequence.taken, taken)
}

/// Elements on which steps are followed.
pub(super) fn elements(model: &PeelModel, problem: &BeamProblem) -> usize {
    if let Some(at) = problem.start.known() {
        return at.mesh.elements() / 2;
    }
    let span = (model.length() / model.process_length()).asinh();
    let corners = if model.adhesion.attraction.corners() > 1.0 && !model.cuts_elements() { CORNERED } else { 1.0 };
    let in_space = if model.space.is_some() { IN_SPACE } else { 1.0 };
    let cut = if model.cuts_elements() { AT_CORNERS } else { 0.0 };
    let slides = model.sticking_length().map_or(0.0, |_| (model.length() / model.feature_length()).min(MOST_SLIDING));
    let elements = in_space * corners * (SHORT + span * span) + cut + slides;
    (elements.ceil() as usize + A_BREAK * model.breaks().len()).next_multiple_of(BUNDLE)
}

/// What the path of a step ends at.
#[derive(Clone, Copy)]
struct Goal {
    what: LimitPointKind,
    value: f64,
    /// Displacement that jumps on the way have left behind.
    done: f64,
    /// First displacement on the way there.
    first: f64,
    unit: LoadingUnit,
}

/// What a path leads to: its goal, or a loss of stability before it.
enum WayEnd {
    Goal(Arc<Solution>),
    Loss(StabilityLoss),
}

/// Steps under way.
struct LoadingSequence {
    elements: usize,
    /// Where the adhesion is neglected, nm
    far: f64,
    /// Of the pull in space, rad
    azimuth: Option<f64>,
    /// What the grip does in the pull behind them.
    pull: GripControl,
    /// Where they began.
    first: Option<Arc<State>>,
    should_stop: Option<ShouldStop>,
    /// Of the step that is taken
    number: usize,
    /// The step in which the beam has jumped last, and where
    last_jump: Option<(usize, LoadingProgress)>,
    /// The grip in the steps so far.
    taken: StepsTaken,
}

impl LoadingSequence {
    fn all(&mut self, steps: &[Step], problem: &mut BeamProblem) -> Result<(), NoEquilibrium> {
        let failed = |phase: LoadingPhase| move |cause| NoEquilibrium::Loading { phase, cause: Box::new(cause) };
        self.begin(problem).map_err(failed(LoadingPhase::Start))?;
        for (number, &step) in (1..).zip(steps) {
            self.number = number;
            let moved = step.motion().map_or(Moved::Height, |(moved, _)| moved);
            if step != Step::Hold {
                self.take_hold(problem, moved).map_err(failed(LoadingPhase::LettingGo { number, step }))?;
            }
            let mut way: Vec<GripState> = self.grip(problem).into_iter().collect();
            let taken = match (step, step.motion()) {
                (_, Some((_, amount))) => self.follow(problem, Goal::moved(problem, moved, amount), &mut way),
                (Step::Release, None) => self.release(problem, &mut way),
                _ => Ok(()),
            };
            let end = self.grip(problem).filter(|_| taken.is_ok());
            way.extend(end);
            self.taken.ways.push(way);
            taken.map_err(failed(LoadingPhase::Step { number, step }))?;
            self.taken.ends.extend(end);
        }
        self.pull.set(problem);
        self.let_go(problem).map_err(failed(LoadingPhase::LettingGoToPull))?;
        let off = problem.start.known().is_some_and(|at| problem.beam.is_clear(at, self.far));
        match self.last_jump.filter(|_| off) {
            Some((number, at)) => {
                Err(failed(LoadingPhase::Step { number, step: steps[number - 1] })(LoadingError::Off { at }))
            }
            None => Ok(()),
        }
    }

    /// The grip where the problem begins.
    fn grip(&self, problem: &BeamProblem) -> Option<GripState> {
        self.grip_in(problem, problem.start.known()?)
    }

    fn grip_in(&self, problem: &BeamProblem, at: &State) -> Option<GripState> {
        Some(problem.beam.grip_state(at, self.first.as_ref()?))
    }

    /// The equilibrium from which the first step goes.
    fn begin(&mut self, problem: &mut BeamProblem) -> Result<(), LoadingError> {
        let options = self.options(problem.grip.displacement_scale());
        let start =
            Path::new(problem, options).until(self.should_stop.clone()).advance().map_err(LoadingError::Start)?;
        let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: start.observables.displacement };
        let forces = problem.beam.grip_forces(&start.at);
        let at = LoadingUnit::Nanometre.reached(forces, start.observables.displacement);
        self.lead(problem, (&start, at), &constraint)?;
        self.first = problem.start.known().cloned();
        Ok(())
    }

    /// Makes the grip move this and hold the rest, from the equilibrium where it is.
    fn take_hold(&mut self, problem: &mut BeamProblem, moved: Moved) -> Result<(), LoadingError> {
        self.pull.moving(problem, self.azimuth, moved).set(problem);
        self.let_go(problem)
    }

    /// Lets the force on what the grip does not hold fall to zero, with all else held.
    fn let_go(&mut self, problem: &mut BeamProblem) -> Result<(), LoadingError> {
        let control = GripControl::of(problem);
        let Some(at) = problem.start.known().cloned() else { return Ok(()) };
        let Some(LettingGo { control: meanwhile, force }) = control.letting_go(problem, self.pull.driven, &at) else {
            return Ok(());
        };
        meanwhile.set(problem);
        let done = self.follow(problem, Goal::without(problem, force), &mut Vec::new());
        control.set(problem);
        done
    }

    /// Lets the vertical force fall to zero, with the height as what moves.
    fn release(&mut self, problem: &mut BeamProblem, way: &mut Vec<GripState>) -> Result<(), LoadingError> {
        let Some(at) = problem.start.known() else { return Ok(()) };
        let force = problem.beam.grip_forces(at).vertical;
        if force.abs() < NONE * problem.measure.force {
            return Ok(());
        }
        self.follow(problem, Goal::without(problem, force), way)
    }

    fn options(&self, first: f64) -> PathOptions {
        PathOptions {
            elements: self.elements,
            step_tolerance: STEP_TOLERANCE,
            stride: 1.0,
            longest: None,
            tolerance: ROUGH,
            prediction: MOST_POINTS,
            first_displacement: first,
            pace: Pace::Quick,
        }
    }

    /// Follows the equilibria from where the problem begins to the goal, where it then begins; the grip at those between goes to the `way`.
    fn follow(&mut self, problem: &mut BeamProblem, goal: Goal, way: &mut Vec<GripState>) -> Result<(), LoadingError> {
        let (mut goal, mut jumps) = (goal, 0);
        loop {
            let loss = match self.path(problem, goal, way)? {
                WayEnd::Goal(end) => {
                    let constraint = PathConstraint { weights: goal.weights(), target: goal.value };
                    return self.lead(problem, (&end, goal.reached(problem, &end)), &constraint);
                }
                WayEnd::Loss(loss) if jumps == MOST_JUMPS => return Err(LoadingError::Jumps { at: loss.at, jumps }),
                WayEnd::Loss(loss) => loss,
            };
            jumps += 1;
            goal = self.jump(problem, goal, &loss, way)?;
        }
    }

    /// Lets the beam jump from where it has lost its stability: the problem then begins where it comes to rest. The goal, seen from there.
    fn jump(
        &mut self,
        problem: &mut BeamProblem,
        goal: Goal,
        loss: &StabilityLoss,
        way: &mut Vec<GripState>,
    ) -> Result<Goal, LoadingError> {
        let before = self.grip_in(problem, &loss.solution.at);
        let landed = jumped(problem, loss, goal.first.signum(), self.should_stop.clone())?;
        let after = self.grip_in(problem, &landed.solution.at);
        let goal = goal.behind(problem, &landed.solution);
        problem.start_at(Arc::new(landed.solution.at));
        if let Some((before, after)) = before.zip(after) {
            way.extend([before, after]);
            self.taken.jumps.push(StepJump { step: self.number, before, after, released: landed.released });
        }
        self.last_jump = Some((self.number, loss.at));
        Ok(goal)
    }

    /// The solution at the goal, on the elements of the path there, unless that loses its stability before.
    fn path(&self, problem: &BeamProblem, goal: Goal, way: &mut Vec<GripState>) -> Result<WayEnd, LoadingError> {
        let mut path = Path::new(problem, self.options(goal.first)).until(self.should_stop.clone());
        let start = path.advance().map_err(LoadingError::Start)?;
        let value = goal.what.pick();
        let onward = goal.first.signum();
        let is_there = |o: &Observables| (value(o) - goal.value) * onward >= 0.0;
        // a force that was round-off
        if is_there(&start.observables) {
            return Ok(WayEnd::Goal(start));
        }
        let mut before = start.clone();
        while path.points().len() < MOST_EQUILIBRIA {
            let here = path
                .advance()
                .map_err(|why| LoadingError::Path { at: goal.reached(problem, &before), why: Box::new(why) })?;
            if problem.beam.clearance(&here.at) <= 0.0 {
                return Err(LoadingError::Inside { at: goal.reached(problem, &before) });
            }
            let turned = here.slope.displacement * goal.first < 0.0;
            let is_lost = |s: &Solution| problem.system.is_conservative() && s.negative > start.negative;
            if turned || is_there(&here.observables) || is_lost(&here) {
                let last = path.points().len() - 1;
                let segment = PathSegment::around(problem, path.points(), last - 1);
                let label = |part: usize| segment.end() * part as f64 / PARTS as f64;
                let at = |label: f64| segment.observable(value, 0.5 * segment.end()).at(label).0;
                let part = (1..=PARTS).find(|&part| (at(label(part)) - goal.value) * onward >= 0.0);
                let lost = |unstable| lost(problem, &segment, goal, (&before, unstable), turned).map(WayEnd::Loss);
                let Some(part) = part.or(is_there(&here.observables).then_some(PARTS)) else {
                    return lost(here);
                };
                let constraint = PathConstraint { weights: goal.weights(), target: goal.value };
                let guess = segment.start(problem, label(part) - 0.5 * label(1), 4);
                let end = solve(problem, guess, &constraint, &newton(ROUGH), &mut Workspace::default());
                // in shorter steps, on the way to a goal that is not behind a turn
                let end = match end {
                    Err(_) if !turned => {
                        let found = controlled(problem, before.at.clone(), constraint.weights, &[goal.value], ROUGH);
                        found.map(|mut found| found.remove(0))
                    }
                    end => end,
                };
                return match end {
                    Ok(end) if is_lost(&end) => lost(Arc::new(end)),
                    Ok(end) => Ok(WayEnd::Goal(Arc::new(end))),
                    Err(_) if turned => lost(here),
                    Err(why) => Err(LoadingError::End { at: goal.reached(problem, &before), why }),
                };
            }
            way.extend(self.grip_in(problem, &here.at));
            before = here;
        }
        Err(LoadingError::Long { at: goal.reached(problem, &before), points: MOST_EQUILIBRIA })
    }

    /// Lets the problem begin in a solution, and where it is, on twice as many elements and a mesh that is fine at
    /// its front.
    fn lead(
        &self,
        problem: &mut BeamProblem,
        (end, at): (&Solution, LoadingProgress),
        constraint: &PathConstraint,
    ) -> Result<(), LoadingError> {
        let beam = &problem.beam;
        let mesh = beam.mesh_at(end.observables.monitors[FRONT], &end.aligned(problem).mesh.follows, 2 * self.elements);
        let finer = beam.resampled(&end.at, mesh);
        let settled = settle(problem, finer, constraint, &newton(FINE), &mut Workspace::default());
        problem.start_at(Arc::new(settled.map_err(|why| LoadingError::End { at, why })?.at));
        Ok(())
    }
}

impl Goal {
    /// That what moves has come so far, nm or rad.
    fn moved(problem: &BeamProblem, moved: Moved, amount: f64) -> Self {
        let first = (FIRST * problem.grip.displacement_scale()).min(OF_WAY * amount.abs()).copysign(amount);
        let unit = LoadingUnit::of(moved, amount);
        Self { what: LimitPointKind::Displacement, value: amount, done: 0.0, first, unit }
    }

    /// That this force on what moves has fallen to zero.
    fn without(problem: &BeamProblem, force: f64) -> Self {
        let first = -(FIRST * problem.grip.displacement_scale()).copysign(force);
        Self { what: LimitPointKind::Load, value: 0.0, done: 0.0, first, unit: LoadingUnit::Nanometre }
    }

    /// The same goal, seen from where the beam has jumped to.
    fn behind(self, problem: &BeamProblem, landed: &Solution) -> Self {
        let Observables { displacement, force, .. } = landed.observables;
        let done = self.done + displacement;
        match self.what {
            LimitPointKind::Displacement => Self { value: self.value - displacement, done, ..self },
            LimitPointKind::Load => Self { done, ..Self::without(problem, force) },
        }
    }

    fn weights(self) -> Observables {
        match self.what {
            LimitPointKind::Displacement => Observables::DISPLACEMENT,
            LimitPointKind::Load => Observables::FORCE,
        }
    }

    fn reached(self, problem: &BeamProblem, solution: &Solution) -> LoadingProgress {
        let moved = self.done + solution.observables.displacement;
        self.unit.reached(problem.beam.grip_forces(&solution.at), moved)
    }
}

/// Where a segment loses its stability: at a limit point of the displacement, or, where that does not turn, between a solution and one that is
/// unstable, where the path branches.
fn lost(
    problem: &BeamProblem,
    segment: &PathSegment,
    goal: Goal,
    (before, unstable): (&Solution, Arc<Solution>),
    turned: bool,
) -> Result<StabilityLoss, LoadingError> {
    let at = goal.reached(problem, before);
    if !turned {
        let displacement = unstable.observables.displacement;
        return Ok(StabilityLoss { at, turns: false, displacement, solution: unstable });
    }
    let whole = (0.0, segment.end());
    let located = locate(problem, segment, LimitPointKind::Displacement, whole, None, &mut Workspace::default());
    let limit = located.map_err(|_| LoadingError::Unstable { at })?;
    let (forces, displacement) = (problem.beam.grip_forces(&limit.solution.at), limit.observables.displacement);
    let at = goal.unit.reached(forces, goal.done + displacement);
    Ok(StabilityLoss { at, turns: true, displacement, solution: limit.solution })
}

fn newton(tolerance: f64) -> NewtonOptions {
    NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 20, exact_slope: false }
}
