//! The run behind [`pull_off`]: step after step of the loading, branch after branch, event after event.

use super::advance::{Advance, advance};
use super::knot::{Knot, Reached, passed};
use super::loading::{SetaLoading, SetaOptions, SetaStart, SetaStep, StepEnd};
use super::loss::{Critical, Loss};
use super::rest::{Rested, come_to_rest};
use super::result::{EventCause, Mark, Named, SetaEnd, SetaEvent, SetaFailure, SetaProgress, SetaPullOff, SetaStation};
use super::standing::{RootDrive, Standing, TipTangent};
use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::TipBranch;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::events::{EventAction, EventQuantity, StationQuantity};
use crate::study::asked::stop_criteria::{Bound, Stage, StopCriteria};
use crate::study::seta::advance::Refusal;
use crate::study::states::seta_state::{JointPlace, LocationError, SetaPoint, SetaState};

/// Shortest step of the root, nm: below the error with which contacts are located.
const SHORTEST: f64 = 1e-7;
/// A preload is met to this share.
const PRELOADED: f64 = 1e-9;

/// Pulls a seta off as the loading says, from its start.
///
/// # Errors
/// What of the seta cannot be computed. Where the computation stops short, the result says so and has what was reached.
pub fn pull_off(
    model: &SetaModel,
    loading: &SetaLoading,
    options: &SetaOptions,
    stop: &StopCriteria,
) -> Result<SetaPullOff, SetaError> {
    Ok(pull_off_from(model, loading, options, stop, None)?.0)
}

/// The same from what an earlier run of the same model, loading and options has reached, to where this one ends. What it has reached is none
/// where it found no start.
///
/// # Errors
/// As of [`pull_off`].
pub fn pull_off_from(
    model: &SetaModel,
    loading: &SetaLoading,
    options: &SetaOptions,
    stop: &StopCriteria,
    reached: Option<SetaProgress>,
) -> Result<(SetaPullOff, Option<SetaProgress>), SetaError> {
    loading.check()?;
    let mut run = match Run::new(model, loading, options, stop, reached)? {
        Ok(run) => run,
        Err(failed) => return Ok((*failed, None)),
    };
    let end = run.go();
    let mut result = run.progress.result.clone();
    result.end = end;
    result.last = Some(run.state(&run.progress.here, None));
    run.progress.tips = run.standing.tips.iter().map(|tip| (tip.on, tip.foot)).collect();
    Ok((result, Some(run.progress)))
}

pub(super) struct Run<'a> {
    standing: Standing,
    pub loading: &'a SetaLoading,
    pub options: &'a SetaOptions,
    stop: &'a StopCriteria,
    ws: Workspace,
    /// The root at rest, nm
    rest: [f64; 3],
    pub progress: SetaProgress,
    /// What the step under way has replaced of the states that have names, the oldest first
    replaced: Vec<(Named, Option<SetaState>)>,
}

impl<'a> Run<'a> {
    /// Where it starts, or what there is of a run that has no start.
    pub(crate) fn new(
        model: &SetaModel,
        loading: &'a SetaLoading,
        options: &'a SetaOptions,
        stop: &'a StopCriteria,
        reached: Option<SetaProgress>,
    ) -> Result<Result<Self, Box<SetaPullOff>>, SetaError> {
        let on = if loading.start == SetaStart::Adhering { TipBranch::Attached } else { TipBranch::Detached };
        let mut standing = Standing::new(model, on)?;
        let mut ws = Workspace::until(stop.for_solves(Stage::Results));
        let rest = model.seta.joint_place(0);
        let with = |standing, ws, progress| Self {
            standing,
            loading,
            options,
            stop,
            ws,
            rest,
            progress,
            replaced: Vec::new(),
        };
        if let Some(progress) = reached {
            for (tip, (on, foot)) in standing.tips.iter_mut().zip(&progress.tips) {
                (tip.on, tip.foot) = (*on, *foot);
            }
            return Ok(Ok(with(standing, ws, progress)));
        }
        let mut result = SetaPullOff::empty(standing.tree.elements());
        let mut from = rest;
        let above = loading.above();
        from[1] += above;
        let at = standing.tree.stress_free_above(above);
        let drive = RootDrive::new(loading.steps[0].direction, from);
        match come_to_rest(&mut standing, &drive, (at, 0.0), &[], options.tolerance, &mut ws) {
            Ok(Rested { solution, iterations, .. }) => {
                result.effort.newton_iterations = iterations;
                let (step, ahead) = (0, options.first_step);
                let progress =
                    SetaProgress { result, here: solution, tips: Vec::new(), step, from, ahead, softest: None };
                let mut run = with(standing, ws, progress);
                run.begin_step(&drive, SetaPoint::default());
                Ok(Ok(run))
            }
            Err((cause, _)) => {
                result.end = SetaEnd::Failed(SetaFailure::NoStart { cause });
                Ok(Err(Box::new(result)))
            }
        }
    }

    fn go(&mut self) -> SetaEnd {
        while let Some(step) = self.loading.steps.get(self.progress.step) {
            let drive = RootDrive::new(step.direction, self.progress.from);
            if let Err(end) = self.go_step(step, &drive) {
                return end;
            }
            let before = self.progress.from;
            self.progress.from = drive.root(self.progress.here.observables.displacement);
            self.progress.step += 1;
            if let Some(next) = self.loading.steps.get(self.progress.step)
                && let Err(end) = self.turn_to(next)
            {
                // what is resumed begins with the turn
                self.progress.from = before;
                self.progress.step -= 1;
                return end;
            }
        }
        self.finished()
    }

    /// The same equilibrium, with displacements that count along the direction of the next step.
    fn turn_to(&mut self, next: &SetaStep) -> Result<(), SetaEnd> {
        let drive = RootDrive::new(next.direction, self.progress.from);
        let problem = self.standing.problem(&drive, None, TipTangent::Own);
        let held = PathConstraint { weights: Observables::DISPLACEMENT, target: 0.0 };
        let newton = self.options.newton();
        let solved = solve(&problem, self.progress.here.at.clone(), &held, &newton, &mut self.ws);
        self.progress.here = solved.map_err(|cause| self.lost(cause))?;
        self.progress.ahead = self.options.first_step;
        self.begin_step(&drive, self.last());
        Ok(())
    }

    /// The first point of a step.
    fn begin_step(&mut self, drive: &RootDrive, before: SetaPoint) {
        let point = self.point(drive, &self.progress.here, before);
        self.progress.result.points.push(point);
        if point.step + 1 == self.loading.steps.len() {
            let slope = self.progress.here.slope;
            self.progress.result.initial_stiffness = Some(slope.force / slope.displacement);
        }
    }

    fn go_step(&mut self, step: &SetaStep, drive: &RootDrive) -> Result<(), SetaEnd> {
        loop {
            let here = self.progress.here.observables;
            let left = match step.until {
                StepEnd::Travel(length) => length - here.displacement,
                StepEnd::Detached(_) if self.standing.attached() == 0 => return Ok(()),
                StepEnd::Detached(most) => most - here.displacement,
                StepEnd::Preload(preload) if here.force >= preload * (1.0 - PRELOADED) => return Ok(()),
                StepEnd::Preload(preload) => {
                    let displacement = self.loading.deepest(self.standing.model.seta.brush_height);
                    if here.displacement >= displacement {
                        let step = self.progress.step;
                        return Err(SetaEnd::Failed(SetaFailure::NoPreload { step, preload, displacement }));
                    }
                    displacement - here.displacement
                }
            };
            // displacements are met to rounding
            if left < SHORTEST {
                return Ok(());
            }
            if let Some(bound) = self.bound() {
                return Err(SetaEnd::Bound(bound));
            }
            self.advance(step, drive, left.min(self.bounded() - here.displacement))?;
        }
    }

    /// One step of the root and the event that it leads to, or what keeps it from going on.
    pub(crate) fn advance(&mut self, step: &SetaStep, drive: &RootDrive, left: f64) -> Result<(), SetaEnd> {
        self.whole(|run| match run.take_step(step, drive, left)? {
            Some(event) => run.happen(drive, event),
            None => Ok(()),
        })
    }

    /// One step of the root, and whether it leads to an event, which does not happen.
    pub(crate) fn advance_to_event(&mut self, step: &SetaStep, drive: &RootDrive, left: f64) -> Result<bool, SetaEnd> {
        self.whole(|run| Ok(run.take_step(step, drive, left)?.is_some()))
    }

    /// What is stopped on its way is as if it had not been begun.
    fn whole<T>(&mut self, go: impl FnOnce(&mut Self) -> Result<T, SetaEnd>) -> Result<T, SetaEnd> {
        let before = Mark::of(&self.progress, &self.standing);
        self.replaced.clear();
        let took = go(self);
        if self.ws.is_stopped() {
            before.restore(&mut self.progress, &mut self.standing);
            for (name, state) in self.replaced.drain(..).rev() {
                *self.progress.result.named(name) = state;
            }
            return Err(self.lost(SolveError::Stopped));
        }
        took
    }

    fn take_step(&mut self, step: &SetaStep, drive: &RootDrive, left: f64) -> Result<Option<Due>, SetaEnd> {
        let ahead = self.progress.ahead.min(self.options.longest_step).min(left);
        let preload = if let StepEnd::Preload(preload) = step.until { Some(preload) } else { None };
        let SetaProgress { here, softest, .. } = &self.progress;
        let (took, iterations) =
            advance(&self.standing, drive, (here, ahead), (*softest, preload), self.options, &mut self.ws);
        self.progress.result.effort.newton_iterations += iterations;
        match took {
            Advance::Shorter { ahead, why } => {
                if ahead < SHORTEST {
                    return Err(self.refused(why));
                }
                self.progress.ahead = ahead;
                Ok(None)
            }
            Advance::Taken { taken, start, next } => {
                self.progress.ahead = next;
                self.locate_here(start);
                taken.into_iter().try_for_each(|reached| self.take(drive, reached))?;
                Ok(None)
            }
            Advance::Contact { taken, tips } => {
                let location = taken.location;
                self.take(drive, *taken)?;
                // the step to the contact says nothing of how long the next one may be
                self.progress.ahead = self.progress.ahead.max(self.options.first_step);
                let start = self.progress.here.at.clone();
                Ok(Some(Due { start, tips, location }))
            }
            Advance::Lost(Loss { taken, start, critical, slope, .. }) => {
                self.locate_here(start);
                self.progress.softest = slope.or(self.progress.softest);
                let end = self.progress.here.observables.displacement + left;
                let location = taken.last().and_then(|last| last.location);
                for taken in taken {
                    let Observables { displacement, force, .. } = taken.solution.observables;
                    if displacement > end || preload.is_some_and(|preload| force > preload * (1.0 + PRELOADED)) {
                        let before = displacement.min(end) - self.progress.here.observables.displacement;
                        self.progress.ahead = 0.5 * self.progress.ahead.min(before);
                        return Ok(None);
                    }
                    self.take(drive, taken)?;
                }
                Ok(match critical {
                    Critical::Tips(tips) => Some(Due { start: self.progress.here.at.clone(), tips, location }),
                    Critical::Shape(start) => Some(Due { start: *start, tips: Vec::new(), location }),
                    Critical::Passed => None,
                })
            }
        }
    }

    /// Goes on to an equilibrium of the same branch, or to where an event of the user on the way there stops it.
    fn take(&mut self, drive: &RootDrive, reached: Reached) -> Result<(), SetaEnd> {
        let stopped = self.look(drive, &reached.solution)?;
        let (Reached { solution, work, location }, end) = match stopped {
            Some((stopped, bound)) => (stopped, Err(SetaEnd::Bound(bound))),
            None => (reached, Ok(())),
        };
        let mut point = self.point(drive, &solution, self.last());
        point.work += work;
        self.standing.note(&solution.at);
        self.progress.here = solution;
        self.progress.result.points.push(point);
        self.keep_peak(point, location);
        end
    }

    /// Looks for stations and events on the way to an equilibrium of the same branch; where the first one lies that stops the run.
    fn look(&mut self, drive: &RootDrive, to: &Solution) -> Result<Option<(Reached, Bound)>, SetaEnd> {
        let (stop, before) = (self.stop, self.last());
        let from = Knot::new(
            self.progress.here.observables.displacement,
            self.progress.here.clone(),
            self.progress.here.slope.displacement,
        );
        let to = Knot::new(to.observables.displacement, to.clone(), to.slope.displacement);
        if stop.events.is_empty() || to.parameter <= from.parameter {
            return Ok(None);
        }
        let problem = self.standing.problem(drive, None, TipTangent::Own);
        let newton = NewtonOptions { most_iterations: 20, ..self.options.newton() };
        let (mut found, mut ws) = (Vec::new(), std::mem::take(&mut self.ws));
        for (event, at) in stop.events.iter().enumerate() {
            let value = |knot: &Knot| {
                let solution = &knot.solution;
                match &at.quantity {
                    EventQuantity::Named(StationQuantity::Displacement) => solution.observables.displacement,
                    EventQuantity::Named(StationQuantity::Force) => solution.observables.force,
                    EventQuantity::OfSeta(of) => {
                        let mut point = self.point(drive, solution, before);
                        point.work += from.work_to(knot);
                        of(&self.state_at(solution, point, None))
                    }
                    EventQuantity::Named(_) | EventQuantity::OfBeam(_) => 0.0,
                }
            };
            let passed = passed(&problem, [&from, &to], (at, &value), &newton, &mut ws);
            found.push(passed.map(|passed| passed.map(|(knot, location)| (event, knot, location))));
        }
        self.ws = ws;
        let found: Result<Vec<_>, SolveError> = found.into_iter().filter_map(Result::transpose).collect();
        let mut found = found.map_err(|cause| self.lost(cause))?;
        found.sort_by(|a, b| a.1.parameter.total_cmp(&b.1.parameter));
        for (event, knot, location) in found {
            let work = from.work_to(&knot);
            let mut point = self.point(drive, &knot.solution, before);
            point.work += work;
            let after = self.progress.result.points.len() - 1;
            self.progress.result.stations.push(SetaStation {
                event,
                point,
                location: Some(location),
                jumped: false,
                after,
            });
            if stop.events[event].action == EventAction::Stop {
                let name = stop.events[event].name.clone();
                return Ok(Some((Reached { solution: knot.solution, work, location: None }, Bound::Event { name })));
            }
        }
        Ok(None)
    }

    /// The same where the seta has jumped from one equilibrium to another, with its root held.
    fn look_at_jump(&mut self, from: &SetaState) -> Result<(), SetaEnd> {
        let behind = self.state(&self.progress.here, None);
        self.progress.result.take_jump(&self.stop.events, from, &behind)
    }

    /// The force has a maximum where the run stands, as the step behind it says.
    fn locate_here(&mut self, location: Option<LocationError>) {
        let here = self.last();
        let known = self.progress.result.peak.as_ref().filter(|peak| peak.point == here && peak.location.is_none());
        if let (Some(_), Some(peak)) = (location, known) {
            let peak = SetaState { location, ..peak.clone() };
            self.keep(Named::Peak, peak);
        }
    }

    fn keep_peak(&mut self, point: SetaPoint, location: Option<LocationError>) {
        let is_last = point.step + 1 == self.loading.steps.len();
        let known = self.progress.result.peak.as_ref().map(|peak| peak.point);
        if is_last && known.is_none_or(|known| point.force_along > known.force_along) {
            let state = self.state(&self.progress.here, location);
            self.keep(Named::Peak, state);
        }
    }

    fn keep(&mut self, name: Named, state: SetaState) {
        let before = self.progress.result.named(name).replace(state);
        self.replaced.push((name, before));
    }

    /// The numbers of an equilibrium, with work and energy released as before.
    fn point(&self, drive: &RootDrive, solution: &Solution, before: SetaPoint) -> SetaPoint {
        let displacement = solution.observables.displacement;
        let (root, section) = (drive.root(displacement), self.standing.tree.section(&solution.at, 0, 0));
        SetaPoint {
            step: self.progress.step,
            displacement,
            root: std::array::from_fn(|i| root[i] - self.rest[i]),
            force: section.force.map(|force| -force),
            force_along: solution.observables.force,
            moment: section.moment.map(|moment| -moment),
            attached: self.standing.attached(),
            outside: self.standing.outside(&solution.at),
            energy: solution.energy,
            ..before
        }
    }

    fn state(&self, solution: &Solution, location: Option<LocationError>) -> SetaState {
        self.state_at(solution, self.last(), location)
    }

    fn state_at(&self, solution: &Solution, point: SetaPoint, location: Option<LocationError>) -> SetaState {
        let tree = &self.standing.tree;
        let at = &solution.at;
        SetaState {
            point,
            location,
            joints: (0..tree.joints()).map(|joint| tree.joint(at, joint).into()).collect(),
            between: (1..tree.joints())
                .map(|joint| tree.between_joints(at, joint - 1).into_iter().map(JointPlace::from).collect())
                .collect(),
            tips: self.standing.tip_states(&solution.at),
            spatulae: Vec::new(),
            raised: 0.0,
        }
    }

    fn last(&self) -> SetaPoint {
        self.progress.result.points.last().copied().unwrap_or_default()
    }
}

/// What a step leads to, and has not happened yet.
pub(super) struct Due {
    /// Where it begins
    pub start: State,
    /// The tips that change first; none where beams buckle
    pub tips: Vec<usize>,
    /// By how much its place is missed
    pub location: Option<LocationError>,
}

impl Run<'_> {
    /// Tips change, or the seta leaves its shape, and comes to rest with its root held.
    pub(super) fn happen(&mut self, drive: &RootDrive, event: Due) -> Result<(), SetaEnd> {
        let Due { start, tips, location } = event;
        let cause = if tips.is_empty() { EventCause::Buckling } else { EventCause::Tips };
        if cause == EventCause::Buckling && self.has_buckled_here() {
            return Err(self.lost(SolveError::LimitPointNotConfirmed));
        }
        let (before, here) = (self.last(), self.progress.here.clone());
        let state = self.state(&here, location);
        let displacement = here.observables.displacement;
        let tolerance = self.options.tolerance;
        let standing = self.standing.tips.clone();
        let rested = come_to_rest(&mut self.standing, drive, (start, displacement), &tips, tolerance, &mut self.ws);
        let Rested { solution, changes, iterations } = rested.map_err(|(cause, changes)| {
            let step = self.progress.step;
            self.standing.tips = standing;
            let outside = self.standing.outside(&here.at);
            match cause {
                SolveError::NotConverged { .. } if outside > 0 => {
                    SetaEnd::Failed(SetaFailure::Extrapolated { step, displacement, outside })
                }
                cause => SetaEnd::Failed(SetaFailure::Restless { step, displacement, changes, cause }),
            }
        })?;
        self.progress.result.effort.newton_iterations += iterations;
        let released = before.energy - solution.energy;
        let mut after = self.point(drive, &solution, before);
        after.released += released;
        let stiffness = solution.slope.force / solution.slope.displacement;
        let late = location.map_or(0.0, |location| location.displacement);
        let location = LocationError { force: (stiffness * late).abs(), displacement: late };
        self.progress.here = solution;
        let detaches = changes.iter().any(|change| !change.to.adheres());
        let left = state.clone();
        if detaches && before.step + 1 == self.loading.steps.len() {
            if self.progress.result.first_detachment.is_none() {
                self.keep(Named::FirstDetachment, state.clone());
            }
            self.keep(Named::LastDetachment, state);
        }
        self.progress.result.points.push(after);
        self.progress.result.events.push(SetaEvent { before, after, cause, tips: changes, released });
        self.keep_peak(after, Some(location));
        self.look_at_jump(&left)
    }

    /// Whether the last event was one here in which beams buckled and no tip followed: it led back to where it began.
    fn has_buckled_here(&self) -> bool {
        self.progress.result.events.last().is_some_and(|event| {
            let SetaPoint { step, displacement, .. } = event.before;
            let there = self.progress.here.observables.displacement;
            let is_here = step == self.progress.step && (displacement - there).abs() < SHORTEST;
            is_here && event.cause == EventCause::Buckling && event.tips.is_empty()
        })
    }
}

// -- Where a run ends, and why --

/// What of all work may be missing at the end, over the tolerance of each step; at least and at most.
const MISSING: f64 = 10.0;
const LEAST_MISSING: f64 = 1e-6;
const MOST_MISSING: f64 = 0.05;
/// Error of the largest energy of a run, over it, that adds up from round-off.
const ROUND_OFF: f64 = 1e-10;

impl Run<'_> {
    /// The end of a run whose steps are all taken: completed, if its work is where it ought to be.
    fn finished(&self) -> SetaEnd {
        let result = &self.progress.result;
        let balance = self.options.balance;
        let (missing, turnover) = (result.unaccounted(), result.turnover());
        let round_off = ROUND_OFF * result.points.iter().fold(0.0f64, |most, point| most.max(point.energy.abs()));
        // what is no number is missing as well
        if missing.abs() <= (MISSING * balance).clamp(LEAST_MISSING, MOST_MISSING) * turnover + round_off {
            return SetaEnd::Completed;
        }
        let work = result.points.last().map_or(0.0, |last| last.work);
        let share = missing.abs() / turnover;
        SetaEnd::Failed(SetaFailure::Unaccounted { missing, work, share, balance })
    }

    fn bound(&self) -> Option<Bound> {
        let most = self.stop.points;
        let points = self.progress.result.points.len() >= most;
        let bounded = self.bounded();
        let displacement = bounded - self.progress.here.observables.displacement < SHORTEST;
        points
            .then_some(Bound::Points(most))
            .or(displacement.then_some(Bound::Displacement(bounded)))
            .or_else(|| self.stop.reached_bound(Stage::Path))
    }

    /// The displacement at which the last step is left, nm.
    fn bounded(&self) -> f64 {
        let is_last = self.progress.step + 1 == self.loading.steps.len();
        self.stop.displacement.filter(|_| is_last).unwrap_or(f64::INFINITY)
    }

    /// Why no step is short enough.
    fn refused(&self, why: Refusal) -> SetaEnd {
        match why {
            Refusal::Unsolved(cause) => self.lost(cause),
            Refusal::TooFar | Refusal::Unstable => self.lost(SolveError::LimitPointNotConfirmed),
            Refusal::Unbalanced(times) => {
                let SetaProgress { step, here, .. } = &self.progress;
                let (displacement, imbalance) = (here.observables.displacement, times * self.options.balance);
                SetaEnd::Failed(SetaFailure::Unbalanced { step: *step, displacement, imbalance })
            }
        }
    }

    fn lost(&self, cause: SolveError) -> SetaEnd {
        if cause == SolveError::Stopped {
            return SetaEnd::Bound(self.stop.reached_bound(Stage::Results).unwrap_or(Bound::Interrupted));
        }
        let SetaProgress { step, here, .. } = &self.progress;
        let displacement = here.observables.displacement;
        SetaEnd::Failed(SetaFailure::Lost { step: *step, displacement, attached: self.standing.attached(), cause })
    }
}
