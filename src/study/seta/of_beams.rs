//! The pull-off of a seta whose spatulae are beams that adhere: every equilibrium is one of the whole tree.
//!
//! Step after step of the loading the root is moved along stable equilibria, up to where they lose their stability. There the seta comes to rest with
//! its root held, by gradient flow, and goes on. A spatula whose free end has turned up by more than 45 degrees stands on the face of its end: what
//! that face would hold is not what a pad holds by, so it lets go there and does not adhere until it is clear of the ground.

use super::loading::{SetaLoading, SetaStart, SetaStep, StepEnd};
use super::loss::critical_direction;
use super::result::{EventCause, SetaEnd, SetaEvent, SetaFailure, SetaPullOff, TipChange};
use super::standing::{RootDrive, grip_of};
use crate::beam::spatial::rotation::matrix;
use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::beam::spatial::tree::branching_beam::TreeMonitor;
use crate::model::seta::check::SetaError;
use crate::model::seta::spatulae::SetaOfBeams;
use crate::model::seta::tip_law::TipBranch;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::PathOptions;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::Located;
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceOptions};
use crate::solve::problem::Problem;
use crate::solve::relax::{Held, RelaxError, RelaxOptions, Relaxation, relax_until};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::stop_criteria::{Bound, Stage, StopCriteria};
use crate::study::peel::step_dependence::StepCurve;
use crate::study::states::seta_state::{JointPlace, LocationError, SetaPoint, SetaState, TipState};
use std::sync::Arc;

/// Sine of the angle by which the free end of a spatula has turned up where it stands on its face.
const UPRIGHT: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// A spatula that let go adheres again once it is so far from the ground, over the distance within which its law acts.
const CLEAR: f64 = 10.0;
/// Longest step of a relaxation, and the share of an energy that is round-off: stored energy and adhesion are much larger than their sum.
const RELAXING: RelaxOptions = RelaxOptions { round_off: 1e-12, ..RelaxOptions::by(0.3) };
/// Points behind a limit point that its interpolation may use.
const BEHIND: usize = 2;
/// A solution at the end of a step.
const AT_END: NewtonOptions =
    NewtonOptions { tolerance: 1e-9, largest_update: 0.5, most_iterations: 12, exact_slope: true };
/// Limit points are located to this share.
const LOCATED: f64 = 1e-8;
/// Most losses of stability in one step of the loading.
const MOST_EVENTS: usize = 1000;
/// Force of a tip that measures a path, nN.
const FORCE: f64 = 0.3;
/// How far pads go aside that measures a path, nm: where a seta leans to one side nothing else moves to first order.
const ASIDE: f64 = 10.0;
/// Sizes by which a state is moved along its critical direction, of which that with the least energy is taken.
const DISTURBED: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];
/// How far the root is moved on where no further point of a path is found, nm: at first, over the time before, and at most.
const NUDGE: f64 = 0.01;
const MORE: f64 = 4.0;
const LONGEST_NUDGE: f64 = 20.0;
/// An energy that is released, aJ, below which nothing has happened.
const NOTHING: f64 = 1e-3;
/// A jump may take so much of the energy: that is the error of its work. More of it says that the mesh is too coarse.
const BALANCED: f64 = 1e-4;

/// Pulls a seta of beams off as the loading says.
///
/// # Errors
/// What of the seta or of the loading cannot be computed: it has to adhere at the start. Where the computation stops short, the result says so and
/// has what was reached.
pub fn pull_off_of_beams(
    model: &SetaOfBeams,
    loading: &SetaLoading,
    options: &PathOptions,
    stop: &StopCriteria,
) -> Result<SetaPullOff, SetaError> {
    loading.check()?;
    if let SetaStart::Above(height) = loading.start {
        return Err(SetaError::NotAdhering { height });
    }
    let tree = model.tree()?;
    let mut run = Run {
        result: SetaPullOff::empty(tree.elements()),
        off: vec![false; model.seta.tips()],
        ws: Workspace::until(stop.for_solves(Stage::Results)),
        from: model.seta.joint_place(0),
        step: 0,
        is_last: false,
        model,
        tree,
        options,
        stop,
    };
    let end = run.go(loading);
    let point = run.last();
    if let Ok(at) = &end {
        run.result.last = Some(run.state(&at.at, point, None));
    }
    // what is found on the way stays, whatever ends it
    run.result.end = end.err().unwrap_or(SetaEnd::Completed);
    Ok(run.result)
}

struct Run<'a> {
    model: &'a SetaOfBeams,
    tree: BeamTree,
    options: &'a PathOptions,
    stop: &'a StopCriteria,
    ws: Workspace,
    result: SetaPullOff,
    /// The spatulae that have let go
    off: Vec<bool>,
    /// Where the root was at the beginning of the step, nm
    from: [f64; 3],
    /// Number of the step, and whether it is the last one
    step: usize,
    is_last: bool,
}

/// What a stable piece ends with.
enum PieceEnd {
    /// The step is done.
    Done(Arc<Solution>),
    /// Stability is lost, or a spatula stands on its end: where that is, and where relaxing begins.
    Lost(Arc<Solution>, State),
    /// No further point was found behind this one, and why.
    Stuck(Arc<Solution>, SolveError),
}

impl Run<'_> {
    fn go(&mut self, loading: &SetaLoading) -> Result<Arc<Solution>, SetaEnd> {
        let lying = self.model.lying(&self.tree);
        let drive = RootDrive::new(loading.steps[0].direction, self.from);
        let rest = self.at_rest(&drive, lying, 0.0);
        let mut here = rest.map_err(|cause| SetaEnd::Failed(SetaFailure::NoStart { cause }))?;
        for (number, step) in loading.steps.iter().enumerate() {
            (self.step, self.is_last) = (number, number + 1 == loading.steps.len());
            let drive = RootDrive::new(step.direction, self.from);
            here = self.go_step(step, &drive, here)?;
            self.from = drive.root(here.observables.displacement);
            // the next step counts from here
            Arc::make_mut(&mut here).observables.displacement = 0.0;
        }
        Ok(here)
    }

    /// The tree with its spatulae as they are, in the grip that moves its root.
    fn problem(&self, drive: &RootDrive) -> Problem {
        let first = self.model.spatula_of(0);
        let adheres = |branch: usize| !branch.checked_sub(first).is_some_and(|tip| self.off[tip]);
        let tree = self.tree.with_adhesion(adheres).with_root_axes(drive.axes);
        let [x, y, z] = drive.from;
        let drive = RootDrive { from: [x, y + self.model.foot(), z], ..*drive };
        let tree = tree.with_monitors([Some(TreeMonitor::AdheringLength), Some(TreeMonitor::PadsAside)]);
        let mut problem = grip_of(Arc::new(tree), &drive, FORCE * self.off.len() as f64);
        // the fronts of several spatulae may go to and fro, and the force goes on then
        problem.measure.monitors = [self.model.spatula.sections.lying.process_length, ASIDE];
        problem
    }

    /// A step of the loading from an equilibrium at its beginning, to that at its end.
    fn go_step(&mut self, step: &SetaStep, drive: &RootDrive, here: Arc<Solution>) -> Result<Arc<Solution>, SetaEnd> {
        let (mut here, mut ahead) = (here, NUDGE);
        for number in 0..MOST_EVENTS {
            let problem = self.problem(drive);
            let points = self.result.points.len();
            let (at, start, nudge) = match self.follow(&problem, step, drive, &here, number == 0)? {
                PieceEnd::Done(last) => return Ok(last),
                PieceEnd::Lost(at, start) => (at, start, 0.0),
                PieceEnd::Stuck(_, cause) if ahead > LONGEST_NUDGE => return Err(self.lost(cause)),
                PieceEnd::Stuck(at, _) => {
                    let start = at.at.clone();
                    (at, start, ahead)
                }
            };
            // where the path has gone on, the next time it is stuck is another one
            ahead = if self.result.points.len() > points + 2 { NUDGE } else { MORE * ahead };
            here = self.lose(drive, &at, start, nudge)?;
            if self.is_off(&here.at) && matches!(step.until, StepEnd::Detached(_)) {
                return Ok(here);
            }
        }
        Err(self.lost(SolveError::LimitPointNotConfirmed))
    }

    /// From where stability is lost to where the seta comes to rest; where it is not known to be lost there, with the root a little farther on, nm.
    fn lose(&mut self, drive: &RootDrive, at: &Solution, start: State, ahead: f64) -> Result<Arc<Solution>, SetaEnd> {
        let (before, displacement, step) = (self.last(), at.observables.displacement + ahead, self.step);
        let left = self.state(&at.at, before, Some(location(at, ahead)));
        let rest = self.at_rest(drive, start, displacement);
        let rest = rest.map_err(|cause| match self.is_cut_short(&cause) {
            true => self.lost(cause),
            false => SetaEnd::Failed(SetaFailure::Restless { step, displacement, changes: 0, cause }),
        })?;
        let change = |(tip, own): (usize, &TipState)| {
            let to = self.branch(&rest.at, tip);
            (own.on != to).then_some(TipChange { tip, to, load: own.load })
        };
        let tips: Vec<TipChange> = left.tips.iter().enumerate().filter_map(change).collect();
        let mut after = self.point(drive, &rest, before);
        // a tip that lets go does so at the beginning; where none does the seta may have gone on as it was
        let force = if tips.is_empty() { 0.5 * (before.force_along + after.force_along) } else { before.force_along };
        let work = ahead * force;
        let released = before.energy + work - rest.energy;
        after.work += work;
        if ahead > 0.0 && tips.is_empty() && released.abs() < NOTHING {
            // it has gone on as it was
            self.result.points.push(after);
            self.keep_peak(&rest, after, None);
            return Ok(rest);
        }
        after.released += released;
        self.result.points.push(after);
        if self.is_last && tips.iter().any(|tip| !tip.to.adheres()) {
            self.result.first_detachment.get_or_insert_with(|| left.clone());
            self.result.last_detachment = Some(left);
        }
        self.keep_peak(&rest, after, None);
        let imbalance = -released / before.energy.abs().max(rest.energy.abs());
        if imbalance > BALANCED {
            return Err(SetaEnd::Failed(SetaFailure::Unbalanced { step, displacement, imbalance }));
        }
        let cause = if tips.is_empty() { EventCause::Buckling } else { EventCause::Tips };
        self.result.events.push(SetaEvent { before, after, cause, tips, released });
        Ok(rest)
    }

    /// The stable equilibrium to which the energy falls with the root held; spatulae that come to stand on their end let go on the way.
    fn at_rest(&mut self, drive: &RootDrive, mut at: State, displacement: f64) -> Result<Arc<Solution>, SolveError> {
        loop {
            let (problem, held) = (self.problem(drive), Held::Displacement(displacement));
            let mut ws = std::mem::take(&mut self.ws);
            let ended = relax_until(&problem, at, held, &RELAXING, &mut ws, |at| self.upright(at).next().is_some());
            self.ws = ws;
            match ended.map_err(RelaxError::cause)? {
                Relaxation::Left { at: left, eliminations, .. } => {
                    self.result.effort.newton_iterations += eliminations;
                    let standing: Vec<usize> = self.upright(&left).collect();
                    standing.into_iter().for_each(|tip| self.off[tip] = true);
                    at = left;
                }
                Relaxation::Rest(relaxed) => {
                    self.result.effort.newton_iterations += relaxed.eliminations;
                    return self.clear(drive, relaxed.solution).map(Arc::new);
                }
            }
        }
    }

    /// An equilibrium in which the spatulae that let go and are clear of the ground may adhere again.
    fn clear(&mut self, drive: &RootDrive, rest: Solution) -> Result<Solution, SolveError> {
        let far = CLEAR * self.model.spatula.sections.lying.gap_scale;
        let is_clear = |tip: &usize| self.off[*tip] && self.tree.nearest(&rest.at, self.model.spatula_of(*tip)) > far;
        let clear: Vec<usize> = (0..self.off.len()).filter(is_clear).collect();
        if clear.is_empty() {
            return Ok(rest);
        }
        clear.into_iter().for_each(|tip| self.off[tip] = false);
        let target = rest.observables.displacement;
        let held = PathConstraint { weights: Observables::DISPLACEMENT, target };
        solve(&self.problem(drive), rest.at, &held, &AT_END, &mut self.ws)
    }

    /// The spatulae that stand on the face of their end.
    fn upright<'s>(&'s self, at: &'s State) -> impl Iterator<Item = usize> + 's {
        let ends = self.model.seta.joints();
        let rises = move |tip: usize| matrix(self.tree.joint(at, ends + tip).1)[1][0] > UPRIGHT;
        (0..self.off.len()).filter(move |&tip| rises(tip) && self.branch(at, tip).adheres())
    }

    /// Whether a spatula adheres.
    fn branch(&self, at: &State, tip: usize) -> TipBranch {
        let adheres = !self.off[tip] && self.tree.nearest(at, self.model.spatula_of(tip)) < self.model.reach();
        if adheres { TipBranch::Attached } else { TipBranch::Detached }
    }

    fn attached(&self, at: &State) -> usize {
        (0..self.off.len()).filter(|&tip| self.branch(at, tip).adheres()).count()
    }

    fn is_off(&self, at: &State) -> bool {
        self.attached(at) == 0
    }
}

// -- One stable piece --

impl Run<'_> {
    /// The stable equilibria from one on, to the end of the step or to where stability is lost.
    fn follow(
        &mut self,
        problem: &Problem,
        step: &SetaStep,
        drive: &RootDrive,
        here: &Arc<Solution>,
        is_first: bool,
    ) -> Result<PieceEnd, SetaEnd> {
        let path = Path::from(problem, *self.options, here.at.clone()).until(self.stop.while_followed());
        let trace = TraceOptions {
            kinds: &[LimitPointKind::Displacement, LimitPointKind::Load],
            branches: true,
            relative: LOCATED,
            behind: BEHIND,
        };
        let mut tracer = PathTracer::new(problem, path, trace);
        let mut looked = 0;
        let ended = loop {
            if let Some(bound) = self.bound() {
                break Err(SetaEnd::Bound(bound));
            }
            let event = match tracer.advance() {
                Ok(event) => event,
                Err(why) => {
                    let cause = why.cause();
                    let last = tracer.path().points()[..looked].last().unwrap_or(here);
                    break match self.is_cut_short(&cause) {
                        true => Err(self.lost(cause)),
                        false => Ok(PieceEnd::Stuck(last.clone(), cause)),
                    };
                }
            };
            let points = tracer.path().points();
            let target = self.target(step);
            match event {
                PathEvent::InertiaChange { .. } => {}
                PathEvent::LimitPoint { kind: LimitPointKind::Load, after, located } => {
                    self.note_maximum(problem, drive, (points, after), &located);
                }
                PathEvent::LimitPoint { after, located, .. } | PathEvent::BranchPoint { after, located } => {
                    if !self.is_before(target, &located.observables) {
                        break self.arrive(problem, drive, (points, after), target).map(PieceEnd::Done);
                    }
                    break self.take_lost(problem, drive, (points, after), &located);
                }
                PathEvent::Point(point) => {
                    let before = looked;
                    looked += 1;
                    if before == 0 {
                        if is_first {
                            self.begin_step(drive, &point);
                        }
                    } else if !self.is_before(target, &point.observables) {
                        break self.arrive(problem, drive, (points, before - 1), target).map(PieceEnd::Done);
                    } else {
                        let segment = PathSegment::around(problem, points, before - 1);
                        self.take(drive, &segment, segment.end(), &point);
                    }
                    if matches!(step.until, StepEnd::Detached(_)) && self.is_off(&point.at) {
                        break Ok(PieceEnd::Done(point));
                    }
                    if self.upright(&point.at).next().is_some() {
                        let start = point.at.clone();
                        break Ok(PieceEnd::Lost(point, start));
                    }
                }
            }
        };
        self.result.effort.newton_iterations += tracer.iterations();
        ended
    }

    /// Which observable ends a step, and at what.
    fn target(&self, step: &SetaStep) -> PathConstraint {
        match step.until {
            StepEnd::Travel(target) | StepEnd::Detached(target) => {
                PathConstraint { weights: Observables::DISPLACEMENT, target }
            }
            StepEnd::Preload(target) => PathConstraint { weights: Observables::FORCE, target },
        }
    }

    fn is_before(&self, PathConstraint { weights, target }: PathConstraint, at: &Observables) -> bool {
        weights.dot(at) < target
    }

    /// The equilibrium at the end of a step, which lies between two points.
    fn arrive(
        &mut self,
        problem: &Problem,
        drive: &RootDrive,
        (points, after): (&[Arc<Solution>], usize),
        target: PathConstraint,
    ) -> Result<Arc<Solution>, SetaEnd> {
        let mut segment = PathSegment::around(problem, points, after);
        let [from, to] = [after, after + 1].map(|k| target.weights.dot(&points[k].observables));
        let start = segment.start(problem, (target.target - from) / (to - from) * segment.end(), 4);
        let solution = solve(problem, start, &target, &AT_END, &mut self.ws).map_err(|cause| self.lost(cause))?;
        let solution = Arc::new(solution);
        let label = segment.insert(Arc::clone(&solution));
        self.take(drive, &segment, label, &solution);
        Ok(solution)
    }

    /// Goes on to where stability is lost.
    fn take_lost(
        &mut self,
        problem: &Problem,
        drive: &RootDrive,
        (points, after): (&[Arc<Solution>], usize),
        located: &Located,
    ) -> Result<PieceEnd, SetaEnd> {
        let mut segment = PathSegment::around(problem, points, after);
        let lost = &located.solution;
        let label = segment.insert(lost.clone());
        self.take(drive, &segment, label, lost);
        let direction = critical_direction(problem, lost, &mut self.ws).map_err(|cause| self.lost(cause))?;
        // the way along which the path goes on, where it turns
        let along: f64 = direction.iter().zip(&lost.tangent.direction).map(|(a, b)| a * b).sum();
        let onward: Vec<f64> = direction.iter().map(|x| x.copysign(x * along)).collect();
        // far along the straight line sections would be in the ground
        let unit = problem.system.size(&onward, &lost.at);
        let moved = |size: f64| {
            let mut at = lost.at.clone();
            problem.system.retract(&mut at, &onward, size / unit);
            at
        };
        let energy = |at: &State| problem.system.evaluate(at, &vec![0.0; onward.len()]).0.energy;
        let tried = DISTURBED.map(moved).into_iter().filter(|at| problem.system.is_admissible(at));
        let start = tried.min_by(|a, b| energy(a).total_cmp(&energy(b)));
        Ok(PieceEnd::Lost(lost.clone(), start.unwrap_or_else(|| lost.at.clone())))
    }

    /// The force has a maximum on the way to the next point.
    fn note_maximum(
        &mut self,
        problem: &Problem,
        drive: &RootDrive,
        (points, after): (&[Arc<Solution>], usize),
        located: &Located,
    ) {
        let mut segment = PathSegment::around(problem, points, after);
        let label = segment.insert(located.solution.clone());
        let mut point = self.point(drive, &located.solution, self.last());
        point.work += StepCurve::interpolated(&segment, label, &located.solution).work();
        self.keep_peak(&located.solution, point, Some(location(&located.solution, 0.0)));
    }

    /// Goes on to an equilibrium of the same piece, at this label of the step to it.
    fn take(&mut self, drive: &RootDrive, segment: &PathSegment, label: f64, to: &Solution) {
        let mut point = self.point(drive, to, self.last());
        point.work += StepCurve::interpolated(segment, label, to).work();
        self.result.points.push(point);
        self.keep_peak(to, point, None);
    }

    /// The first point of a step.
    fn begin_step(&mut self, drive: &RootDrive, at: &Solution) {
        let point = self.point(drive, at, self.last());
        self.result.points.push(point);
        if self.is_last {
            self.result.initial_stiffness = Some(at.slope.force / at.slope.displacement);
            self.keep_peak(at, point, None);
        }
    }

    /// The criterion that is met.
    fn bound(&self) -> Option<Bound> {
        let (points, last) = (self.result.points.len(), self.last());
        if points >= self.stop.points {
            return Some(Bound::Points(self.stop.points));
        }
        let beyond = || self.stop.displacement.filter(|&most| self.is_last && last.displacement > most);
        self.stop.reached_bound(Stage::Path).or_else(|| beyond().map(Bound::Displacement))
    }

    /// Whether a solve was stopped from outside.
    fn is_cut_short(&self, cause: &SolveError) -> bool {
        *cause == SolveError::Stopped && self.stop.reached_bound(Stage::Results).is_some()
    }

    /// Where the run stands when it cannot go on.
    fn lost(&self, cause: SolveError) -> SetaEnd {
        if let (SolveError::Stopped, Some(bound)) = (&cause, self.stop.reached_bound(Stage::Results)) {
            return SetaEnd::Bound(bound);
        }
        let SetaPoint { displacement, attached, .. } = self.last();
        SetaEnd::Failed(SetaFailure::Lost { step: self.step, displacement, attached, cause })
    }
}

// -- What is read off an equilibrium --

impl Run<'_> {
    fn last(&self) -> SetaPoint {
        self.result.points.last().copied().unwrap_or_default()
    }

    /// The numbers of an equilibrium, with work and energy released as before.
    fn point(&self, drive: &RootDrive, solution: &Solution, before: SetaPoint) -> SetaPoint {
        let displacement = solution.observables.displacement;
        let (root, rest) = (drive.root(displacement), self.model.seta.joint_place(0));
        let section = self.tree.section(&solution.at, 0, 0);
        SetaPoint {
            step: self.step,
            displacement,
            root: std::array::from_fn(|i| root[i] - rest[i]),
            force: section.force.map(|force| -force),
            force_along: solution.observables.force,
            moment: section.moment.map(|moment| -moment),
            attached: self.attached(&solution.at),
            outside: 0,
            energy: solution.energy,
            ..before
        }
    }

    /// Joints, branches and tips in a state, over the height at which tips stand at rest.
    fn state(&self, at: &State, point: SetaPoint, location: Option<LocationError>) -> SetaState {
        let (seta, foot) = (&self.model.seta, self.model.foot());
        let place = |(place, directors): ([f64; 3], _)| {
            let [x, y, z] = place;
            JointPlace::from(([x, y - foot, z], directors))
        };
        let tip = |tip: usize| {
            let [x, _, z] = seta.joint_place(seta.tip_joint(tip));
            let spatula = self.model.spatula_of(tip);
            // what the shaft holds it with is what the ground pulls with
            let held = self.tree.section(at, spatula, self.model.elements).force;
            TipState { on: self.branch(at, tip), foot: [x, 0.0, z], load: held.map(|force| -force) }
        };
        SetaState {
            point,
            location,
            joints: (0..seta.joints()).map(|joint| place(self.tree.joint(at, joint))).collect(),
            between: (1..seta.joints())
                .map(|joint| self.tree.between_joints(at, joint - 1).into_iter().map(place).collect())
                .collect(),
            tips: (0..seta.tips()).map(tip).collect(),
        }
    }

    /// Keeps an equilibrium of the last step whose force is the largest so far, and the newest.
    fn keep_peak(&mut self, solution: &Solution, point: SetaPoint, location: Option<LocationError>) {
        let known = self.result.peak.as_ref().map(|peak| peak.point);
        if self.is_last && known.is_none_or(|known| point.force_along > known.force_along) {
            self.result.peak = Some(self.state(&solution.at, point, location));
        }
    }
}

/// By how much a limit point misses what was looked for, which lies no farther ahead than so far, nm.
fn location(at: &Solution, ahead: f64) -> LocationError {
    let (Observables { displacement, force, .. }, slope) = (at.observables, at.slope);
    let along = if ahead > 0.0 { (slope.force / slope.displacement * ahead).abs() } else { 0.0 };
    LocationError { force: LOCATED * force.abs() + along, displacement: LOCATED * displacement.abs() + ahead }
}
