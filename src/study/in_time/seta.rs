//! The run behind [`pull_seta_in_time`]: from event to event, each stretch with its tips on branches of their law.
//!
//! A tip that comes to the end of its branch leaves it: its force is gone at once, and the energy that it had there is released. Where a dashpot
//! stands beside every spring the seta stays in its place and moves on from there. Where none does it jumps, with what dashpots remember as it is, to
//! rest in the equilibrium of fast loading. A jump as well is what a tip comes to that softens faster than the seta holds it: then no step is short
//! enough. A seta with mass never jumps: its joints go on with the velocities that they have, and are accelerated by the force that is gone.

use super::pull::InTimeFailureKind;
use super::tip_losses::{event_within, softest};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::model::problem::motion::{KG_PER_CUBIC_METRE, MovingMaterial, NotInTime};
use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::TipBranch;
use crate::number::root;
use crate::solve::error::{Quantity, SolveError};
use crate::solve::state::State;
use crate::solve::system::System;
use crate::solve::time::drive::{Drive, Ramp};
use crate::solve::time::dynamic_system::{DynamicProblem, DynamicSystem, EnergyBalance};
use crate::solve::time::integrator::{Inside, StepControl, TimeError, TimeIntegrator, TimeOptions};
use crate::solve::time::rule::Motion;
use crate::solve::workspace::{ShouldStop, Workspace};
use crate::study::asked::events::{EventAction, EventAt, StationQuantity};
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::seta::rest::{Rested, come_to_rest};
use crate::study::seta::result::TipChange;
use crate::study::seta::standing::{RootDrive, Standing, TipTangent};
use std::sync::Arc;

/// The first step over the time of acceleration; behind an event over the last one.
const FIRST: f64 = 1e-2;
const BEHIND_EVENT: f64 = 1e-3;
/// Newton's tolerance over that of a step; that of an equilibrium.
const NEWTON: f64 = 1e-5;
const AT_REST: f64 = 1e-8;

/// Pulls a seta whose tips adhere at a rate, from equilibrium until no tip adheres.
///
/// # Errors
/// What of the seta cannot be followed, no equilibrium at the start, a step in time that failed.
pub fn pull_seta_in_time(
    model: &SetaModel,
    material: &MovingMaterial,
    pull: &SetaPullRate,
    accuracy: &SetaTimeAccuracy,
    should_stop: Option<ShouldStop>,
) -> Result<SetaInTime, SetaInTimeFailure> {
    followed(Run::new(model, material, pull, accuracy, should_stop))
}

/// The same with stations and events of the user, which are located to round-off inside of steps, or at the jump that passes them; one that stops
/// ends the pull where it lies. Of the stop criteria these are heeded, and what the caller says.
///
/// # Errors
/// As of [`pull_seta_in_time`]; an event whose quantity is no number.
pub fn pull_seta_in_time_with(
    model: &SetaModel,
    material: &MovingMaterial,
    pull: &SetaPullRate,
    accuracy: &SetaTimeAccuracy,
    stop: &StopCriteria,
) -> Result<SetaInTime, SetaInTimeFailure> {
    let run = Run::new(model, material, pull, accuracy, stop.while_followed());
    followed(run.map(|run| Run { events: &stop.events, ..run }))
}

fn followed(run: Result<Run, SetaInTimeFailureKind>) -> Result<SetaInTime, SetaInTimeFailure> {
    let mut run = run.map_err(|why| SetaInTimeFailure { why, reached: None })?;
    match run.go() {
        Ok(()) => Ok(run.result),
        Err(why) => Err(SetaInTimeFailure { why, reached: Some(Box::new(run.result)) }),
    }
}

struct Run<'a> {
    events: &'a [EventAt],
    standing: Standing,
    drive: RootDrive,
    ramp: Ramp,
    accuracy: &'a SetaTimeAccuracy,
    should_stop: Option<ShouldStop>,
    motion: Motion,
    has_mass: bool,
    /// The state before the last step
    before: State,
    /// Length of the next step, ns
    step: f64,
    /// Work, and energies dissipated, of the stretches before
    so_far: EnergyBalance,
    released: f64,
    result: SetaInTime,
}

impl<'a> Run<'a> {
    fn new(
        model: &SetaModel,
        material: &MovingMaterial,
        pull: &SetaPullRate,
        accuracy: &'a SetaTimeAccuracy,
        should_stop: Option<ShouldStop>,
    ) -> Result<Self, SetaInTimeFailureKind> {
        material.check()?;
        if material.opening.is_some() {
            return Err(NotInTime::NotCovered { what: "a rate of opening of the tips of a seta" }.into());
        }
        check(pull, accuracy)?;
        let mut standing = Standing::new(model, TipBranch::Attached)?;
        let drive = RootDrive::new(pull.direction, model.seta.joint_place(0));
        let start = (standing.tree.stress_free(0), 0.0);
        let mut ws = Workspace::until(should_stop.clone());
        let rested = come_to_rest(&mut standing, &drive, start, &[], AT_REST, &mut ws);
        let rest = rested.map_err(|(cause, _)| InTimeFailureKind::NoStart { displacement: 0.0, cause })?;
        standing.tree = standing.tree.with_viscosity(material.viscosity);
        let density = KG_PER_CUBIC_METRE * material.density;
        if density > 0.0 {
            standing.tree = standing.tree.with_inertia(|branch| model.seta.section_inertia(branch, density));
        }
        let at = rest.solution.at;
        let still = vec![0.0; standing.tree.unknowns(&at)];
        let memory = standing.tree.relaxed_memory(&at);
        let (ramp, before, elements) = (pull.ramp(), at.clone(), standing.tree.elements());
        let mut run = Self {
            events: &[],
            standing,
            drive,
            ramp,
            accuracy,
            should_stop,
            motion: Motion::new(0.0, at, still.clone(), still, memory),
            has_mass: density > 0.0,
            before,
            step: FIRST * ramp.smooth,
            so_far: EnergyBalance::default(),
            released: 0.0,
            result: SetaInTime { elements, iterations: rest.iterations, ..SetaInTime::default() },
        };
        let balance = run.energies();
        let first = run.point(&run.motion, balance);
        run.result.points.push(first);
        Ok(run)
    }

    fn go(&mut self) -> Result<(), SetaInTimeFailureKind> {
        while self.result.stopped.is_none() && self.standing.attached() > 0 && self.motion.time < self.ramp.end() {
            match self.stretch() {
                Ok(tips) if tips.is_empty() => {}
                Ok(tips) => self.event(TipLoss::EndOfBranch, &tips)?,
                Err(SetaInTimeFailureKind::InTime(InTimeFailureKind::Step(why))) => {
                    let jumps = self.jumping().is_some();
                    let tips = softest(&self.standing, &self.before, &self.motion.at);
                    if matches!(why, TimeError::Stopped { .. }) || !jumps || tips.is_empty() {
                        return Err(why.into());
                    }
                    self.event(TipLoss::Unstable, &tips)?;
                }
                Err(why) => return Err(why),
            }
        }
        Ok(())
    }

    /// Goes on to where tips come to the end of their branch, or to the end of the way. What was reached stays where a step fails.
    fn stretch(&mut self) -> Result<Vec<usize>, SetaInTimeFailureKind> {
        let end = self.ramp.end();
        let tree = Arc::new(self.standing.adhering_tree(&self.drive, None, TipTangent::Own));
        let problem = DynamicProblem::new(self.standing.problem_of(tree.clone(), &self.drive), tree);
        let options = TimeOptions {
            newton: NEWTON * self.accuracy.tolerance,
            ..TimeOptions::new(StepControl::Adaptive {
                tolerance: self.accuracy.tolerance,
                first: self.step,
                longest: self.accuracy.longest * end,
            })
        };
        let ws = Workspace::until(self.should_stop.clone());
        let mut integrator = TimeIntegrator::new(&problem, Drive::ramp(self.ramp), self.motion.clone(), options, ws);
        let (known, located) = (self.so_far, self.accuracy.located);
        let effort = (self.result.iterations, self.result.tried);
        loop {
            if self.result.points.len() > self.accuracy.most_steps {
                let (steps, time) = (self.accuracy.most_steps, self.motion.time);
                return Err(InTimeFailureKind::TooManySteps { steps, time, end }.into());
            }
            let event = |from: &State, to: &State| event_within(&self.standing, from, to, located);
            let took = integrator.advance_to_event(end, &event);
            let (iterations, tried) = integrator.effort();
            (self.result.iterations, self.result.tried) = (effort.0 + iterations, effort.1 + tried);
            took?;
            self.step = integrator.motion().time - self.motion.time;
            let motion = integrator.motion().clone();
            self.before = std::mem::replace(&mut self.motion, motion).at;
            let own = *integrator.balance();
            self.so_far =
                EnergyBalance { work: known.work + own.work, dissipated: known.dissipated + own.dissipated, ..own };
            let point = self.point(&self.motion, self.so_far);
            self.result.points.push(point);
            self.look(&mut integrator, known)?;
            if self.result.stopped.is_some() {
                return Ok(Vec::new());
            }
            let tips = self.standing.changing(&self.motion.at);
            if !tips.is_empty() || self.motion.time >= end {
                return Ok(tips);
            }
        }
    }

    /// Tips leave the branch that they are on.
    fn event(&mut self, loss: TipLoss, tips: &[usize]) -> Result<(), SetaInTimeFailureKind> {
        let displacement = self.ramp.at(self.motion.time).value;
        let standing = self.standing.clone();
        let (changes, released) = match self.jumping() {
            None => self.let_go(tips),
            Some(tree) => self.jump(tree, tips, displacement)?,
        };
        let before = self.result.last();
        self.released += released;
        let kinetic = self.so_far.kinetic;
        self.motion = if self.has_mass { self.accelerated(&standing, tips) } else { self.at_rest() };
        self.step *= BEHIND_EVENT;
        self.so_far.dissipated += released;
        let (EnergyBalance { work, dissipated, .. }, known) = (self.so_far, self.energies());
        // what springs in series with dashpots store has not changed where the seta has not moved, and has where it jumped
        self.so_far = EnergyBalance { work, dissipated, kinetic, ..known };
        let after = self.point(&self.motion, self.so_far);
        self.result.points.push(after);
        self.result.events.push(SetaInTimeEvent { before, after, loss, tips: changes, released });
        self.look_at_jump(&before, &after);
        Ok(())
    }

    /// Looks for stations and events on the newest step; one that stops the pull takes the place of its end.
    fn look(&mut self, integrator: &mut TimeIntegrator, known: EnergyBalance) -> Result<(), SetaInTimeFailureKind> {
        let [.., from, to] = self.result.points[..] else { return Ok(()) };
        let failed = |cause| TimeError::Failed { time: from.time, step: to.time - from.time, cause };
        let mut found: Vec<(f64, SetaInTimeStation)> = Vec::new();
        for (event, at) in self.events.iter().enumerate() {
            let ends = [value(at, &from), value(at, &to)];
            if ends.iter().any(|end| !end.is_finite()) {
                return Err(failed(SolveError::NotFiniteUpdate { quantity: Quantity::EventQuantity }).into());
            }
            if !at.passes(ends[0], ends[1]) {
                continue;
            }
            let after = self.result.points.len() - 2;
            let solve = |share: f64| {
                let Inside { motion, balance: own, .. } = integrator.inside(share)?;
                let balance =
                    EnergyBalance { work: known.work + own.work, dissipated: known.dissipated + own.dissipated, ..own };
                let point = self.point(&motion, balance);
                let above = value(at, &point) - at.value;
                Ok::<_, SolveError>((SetaInTimeStation { event, point, jumped: false, after }, above))
            };
            let scale = MET * at.value.abs().max(ends[0].abs()).max(ends[1].abs());
            let is_met = |above: f64, _, left: f64| above.abs() <= scale || left <= MET;
            let [low, high] = [(0.0, ends[0] - at.value), (1.0, ends[1] - at.value)];
            let (station, passing) = root::passed(low, high, solve, is_met).map_err(failed)?;
            found.push((passing.place, station));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, station) in found {
            self.result.stations.push(station);
            let at = &self.events[station.event];
            if at.action == EventAction::Stop {
                self.result.points.pop();
                self.result.points.push(station.point);
                self.result.stopped = Some(Bound::Event { name: at.name.clone() });
                break;
            }
        }
        Ok(())
    }

    /// The same where tips leave the branch of their law, at one time.
    fn look_at_jump(&mut self, before: &SetaInTimePoint, point: &SetaInTimePoint) {
        let after = self.result.points.len() - 2;
        for (event, at) in self.events.iter().enumerate() {
            if at.passes(value(at, before), value(at, point)) {
                self.result.stations.push(SetaInTimeStation { event, point: *point, jumped: true, after });
                if at.action == EventAction::Stop {
                    self.result.stopped = Some(Bound::Event { name: at.name.clone() });
                    break;
                }
            }
        }
    }

    /// The tree as it answers a jump; none where it does not jump, but stays in its place.
    fn jumping(&self) -> Option<BeamTree> {
        if self.has_mass { None } else { self.standing.tree.in_jump(&self.motion.memory) }
    }

    /// Behind an event, without mass: in equilibrium.
    fn at_rest(&self) -> Motion {
        let Motion { time, at, memory, .. } = self.motion.clone();
        let at = State { force: self.held_by_tips(&at), ..at };
        let still = vec![0.0; self.standing.tree.unknowns(&at)];
        Motion::new(time, at, still.clone(), still, memory)
    }

    /// Behind an event, with mass: as fast as before, with the forces of these tips as they are now in place of what they were.
    fn accelerated(&self, before: &Standing, tips: &[usize]) -> Motion {
        let Motion { time, at, velocity, mut acceleration, memory, .. } = self.motion.clone();
        for &tip in tips {
            let [was, is] = [before, &self.standing].map(|standing| standing.response(&at, tip).gradient);
            let joint = self.standing.model.seta.tip_joint(tip);
            let more = self.standing.tree.accelerated(&at, joint, &std::array::from_fn(|k| was[k] - is[k]));
            (0..SPATIAL_UNKNOWNS).for_each(|k| acceleration[joint * SPATIAL_UNKNOWNS + k] += more[k]);
        }
        Motion::new(time, at, velocity, acceleration, memory)
    }

    /// The seta stays where it is.
    fn let_go(&mut self, tips: &[usize]) -> (Vec<TipChange>, f64) {
        let at = &self.motion.at;
        let energy = |standing: &Standing| tips.iter().map(|&tip| standing.response(at, tip).energy).sum::<f64>();
        let (before, mut after) = (energy(&self.standing), self.standing.clone());
        let change = |&tip: &usize| {
            let load = self.standing.load(at, tip);
            TipChange { tip, to: after.change(at, tip), load }
        };
        let changes = tips.iter().map(change).collect();
        let released = before - energy(&after);
        self.standing = after;
        (changes, released)
    }

    /// It comes to rest, with the stiffness of fast loading.
    fn jump(
        &mut self,
        tree: BeamTree,
        tips: &[usize],
        displacement: f64,
    ) -> Result<(Vec<TipChange>, f64), SetaInTimeFailureKind> {
        let viscous = std::mem::replace(&mut self.standing.tree, tree);
        let before = self.standing.adhering_tree(&self.drive, None, TipTangent::Own).energy(&self.motion.at);
        let mut ws = Workspace::until(self.should_stop.clone());
        let start = (self.motion.at.clone(), displacement);
        let rested = come_to_rest(&mut self.standing, &self.drive, start, tips, AT_REST, &mut ws);
        self.standing.tree = viscous;
        let time = self.motion.time;
        let Rested { solution, changes, iterations } = rested
            .map_err(|(cause, changes)| SetaInTimeFailureKind::Restless { time, displacement, changes, cause })?;
        self.result.iterations += iterations;
        self.motion.at = solution.at;
        Ok((changes, before - solution.energy))
    }

    /// Energies where it is.
    fn energies(&self) -> EnergyBalance {
        let at = &self.motion.at;
        let tree = self.standing.adhering_tree(&self.drive, None, TipTangent::Own);
        let (stored, total) = (tree.stored_energy(at), tree.energy(at));
        let fast = tree.in_jump(&self.motion.memory).map_or(total, |fast| fast.energy(at));
        EnergyBalance { stored: stored + fast - total, adhesion: total - stored, ..EnergyBalance::default() }
    }

    /// Sum of the forces with which the ground holds the tips, along the pull, nN.
    fn held_by_tips(&self, at: &State) -> f64 {
        let direction = self.drive.direction();
        let along = |tip: usize| {
            let load = self.standing.load(at, tip);
            -(0..3).map(|i| load[i] * direction[i]).sum::<f64>()
        };
        (0..self.standing.tips.len()).map(along).sum()
    }

    fn point(&self, motion: &Motion, balance: EnergyBalance) -> SetaInTimePoint {
        SetaInTimePoint {
            time: motion.time,
            displacement: self.ramp.at(motion.time).value,
            force: motion.at.force,
            tip_force: self.held_by_tips(&motion.at),
            attached: self.standing.attached(),
            balance,
            released: self.released,
        }
    }
}

/// By how much an event is missed at most, over the largest value of its quantity on the step.
const MET: f64 = 1e-10;

/// What passes a value in an event, of a seta at one time; no number where it is none of its quantities.
fn value(at: &EventAt, point: &SetaInTimePoint) -> f64 {
    match at.quantity.named() {
        Some(StationQuantity::Time) => point.time,
        Some(StationQuantity::Displacement) => point.displacement,
        Some(StationQuantity::Force) => point.force,
        Some(StationQuantity::Attached) => point.attached as f64,
        _ => f64::NAN,
    }
}

// -- What a pull of a seta in time gives --

/// The seta at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetaInTimePoint {
    /// t since the pull began, ns
    pub time: f64,
    /// Of the root, nm
    pub displacement: f64,
    /// Force of what moves the root, along the pull, nN
    pub force: f64,
    /// Sum of the forces with which the ground holds the tips, along the pull, nN: the same as `force` where mass does not count
    pub tip_force: f64,
    /// Tips that adhere
    pub attached: usize,
    /// Energies, aJ: what is released at events is dissipated.
    pub balance: EnergyBalance,
    /// The part of the energy dissipated that was released at events, aJ
    pub released: f64,
}

/// How tips came to leave the branch of their law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TipLoss {
    /// They came to the end of it.
    EndOfBranch,
    /// They softened faster than the seta holds them, with the stiffness of fast loading: they jump.
    Unstable,
}

/// Tips that leave the branch of their law.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaInTimeEvent {
    /// The seta just before
    pub before: SetaInTimePoint,
    /// Just behind, at the same time
    pub after: SetaInTimePoint,
    /// Why
    pub loss: TipLoss,
    /// In their order
    pub tips: Vec<TipChange>,
    /// Energy released, aJ
    pub released: f64,
}

/// A station of a pull of a seta in time, or where an event of the user lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaInTimeStation {
    /// Which one of [`StopCriteria::events`]
    pub event: usize,
    /// The seta there: by a step of its own from the step before, or behind the jump that passes the value
    pub point: SetaInTimePoint,
    /// Whether the quantity jumps past the value
    pub jumped: bool,
    /// It lies behind this one of the points
    pub after: usize,
}

/// A pull of a seta in time.
#[derive(Clone, Debug, Default)]
pub struct SetaInTime {
    /// Every step, from rest on; an event is followed by another point at the same time where it changes the energies.
    pub points: Vec<SetaInTimePoint>,
    /// Stations and events of the user, in time
    pub stations: Vec<SetaInTimeStation>,
    /// The event that stopped it, if one has
    pub stopped: Option<Bound>,
    /// In their order
    pub events: Vec<SetaInTimeEvent>,
    /// Elements of the tree
    pub elements: usize,
    /// Newton iterations
    pub iterations: usize,
    /// Steps that were tried, those that were refused among them
    pub tried: usize,
}

impl SetaInTime {
    /// The last point.
    pub fn last(&self) -> SetaInTimePoint {
        self.points.last().copied().unwrap_or_default()
    }

    /// The point with the largest force.
    pub fn peak(&self) -> SetaInTimePoint {
        self.points.iter().copied().max_by(|a, b| a.force.total_cmp(&b.force)).unwrap_or_default()
    }

    /// The largest defect of the balance, over the largest work: work = stored + adhesion + dissipated.
    pub fn balance_error(&self) -> f64 {
        let Some(start) = self.points.first() else { return 0.0 };
        let largest = |of: &dyn Fn(&SetaInTimePoint) -> f64| self.points.iter().map(of).fold(0.0, f64::max);
        let defect = |point: &SetaInTimePoint| point.balance.defect(&start.balance).abs();
        largest(&defect) / largest(&|point| point.balance.work.abs()).max(f64::MIN_POSITIVE)
    }
}

/// Why a pull of a seta was not followed to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaInTimeFailureKind {
    #[error(transparent)]
    InTime(#[from] InTimeFailureKind),
    #[error(transparent)]
    Seta(#[from] SetaError),
    #[error(
        "at t = {time:.6e} ns, u = {displacement:.6} nm, the seta does not come to rest behind an event, after {changes} changes of tips: {cause}; try more elements"
    )]
    Restless { time: f64, displacement: f64, changes: usize, cause: SolveError },
}

impl From<NotInTime> for SetaInTimeFailureKind {
    fn from(why: NotInTime) -> Self {
        Self::InTime(why.into())
    }
}

impl From<TimeError> for SetaInTimeFailureKind {
    fn from(why: TimeError) -> Self {
        Self::InTime(why.into())
    }
}

/// A failure with what was reached.
#[derive(Clone, Debug)]
pub struct SetaInTimeFailure {
    /// Why
    pub why: SetaInTimeFailureKind,
    /// Up to there
    pub reached: Option<Box<SetaInTime>>,
}

// -- How the root of a seta is pulled in time, and how accurately that is followed --

/// How the root of a seta that adheres moves: from rest along a direction, at a constant rate, until no tip adheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaPullRate {
    /// Along x, y and z: y is the normal, away from the ground. Its length does not matter.
    pub direction: [f64; 3],
    /// How far at most, nm
    pub most: f64,
    /// nm/ns = m/s
    pub rate: f64,
    /// On how much of the way the root accelerates, nm. A jump in velocity makes a force of its own.
    pub accelerates: f64,
}

impl SetaPullRate {
    /// Along the normal, accelerating on 20 nm.
    pub const fn normal(most: f64, rate: f64) -> Self {
        Self { direction: [0.0, 1.0, 0.0], most, rate, accelerates: 20.0 }
    }

    /// Displacement in time.
    pub(in crate::study) fn ramp(&self) -> Ramp {
        Ramp::new(0.0, self.most, self.rate, 2.0 * self.accelerates / self.most)
    }
}

/// How accurately a seta is followed in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaTimeAccuracy {
    /// Error of a step in time, in units of 10 nm and 0.01 rad
    pub tolerance: f64,
    /// How near to the end of its branch a tip leaves that, nm
    pub located: f64,
    /// The longest step over the time of the whole way
    pub longest: f64,
    /// Most steps
    pub most_steps: usize,
}

impl Default for SetaTimeAccuracy {
    fn default() -> Self {
        Self { tolerance: 1e-5, located: 1e-3, longest: 0.002, most_steps: 200_000 }
    }
}

pub(in crate::study) fn check(pull: &SetaPullRate, accuracy: &SetaTimeAccuracy) -> Result<(), InTimeFailureKind> {
    let length = pull.direction.iter().map(|x| x * x).sum::<f64>();
    let positive = [
        ("the length of the direction of the pull", length),
        ("the end of the pull in nm", pull.most),
        ("the rate of the pull in nm/ns", pull.rate),
        ("the way on which the root accelerates in nm", pull.accelerates),
        ("the tolerance of a step in time", accuracy.tolerance),
        ("the distance in nm within which the end of a branch is found", accuracy.located),
        ("the longest step over the time of the whole way", accuracy.longest),
    ];
    match positive.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
        Some((what, value)) => Err(InTimeFailureKind::OutOfRange { what, value, wanted: "positive" }),
        None => Ok(()),
    }
}
