//! The run behind [`pull_seta_in_time`]: from event to event, each stretch with its tips on branches of their law.
//!
//! A tip that comes to the end of its branch leaves it: its force is gone at once, and the energy that it had there is released. Where a dashpot
//! stands beside every spring the seta stays in its place and moves on from there. Where none does it jumps, with what dashpots remember as it is, to
//! rest in the equilibrium of fast loading. A jump as well is what a tip comes to that softens faster than the seta holds it: then no step is short
//! enough. A seta with mass never jumps: its joints go on with the velocities that they have, and are accelerated by the force that is gone.

use super::events::{event_within, softest};
use super::result::{SetaInTime, SetaInTimeEvent, SetaInTimeFailure, SetaInTimeFailureKind, SetaInTimePoint, TipLoss};
use super::settings::{SetaPullRate, SetaTimeAccuracy, check};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::model::problem::motion::{KG_PER_CUBIC_METRE, MovingMaterial};
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::TipBranch;
use crate::solve::state::State;
use crate::solve::system::System;
use crate::solve::time::drive::{Drive, Ramp};
use crate::solve::time::dynamic_system::{DynamicProblem, DynamicSystem, EnergyBalance};
use crate::solve::time::integrator::{StepControl, TimeError, TimeIntegrator, TimeOptions};
use crate::solve::time::rule::Motion;
use crate::solve::workspace::{ShouldStop, Workspace};
use crate::study::pull_in_time::result::InTimeFailureKind;
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
    let mut run = Run::new(model, material, pull, accuracy, should_stop)
        .map_err(|why| SetaInTimeFailure { why, reached: None })?;
    match run.go() {
        Ok(()) => Ok(run.result),
        Err(why) => Err(SetaInTimeFailure { why, reached: Some(Box::new(run.result)) }),
    }
}

struct Run<'a> {
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
        while self.standing.attached() > 0 && self.motion.time < self.ramp.end() {
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
        Ok(())
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
        let before = self.standing.adhering_tree(&self.drive, None, TipTangent::Own).energy(&self.motion.at.values);
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
        let (stored, total) = (tree.stored_energy(at), tree.energy(&at.values));
        let fast = tree.in_jump(&self.motion.memory).map_or(total, |fast| fast.energy(&at.values));
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
