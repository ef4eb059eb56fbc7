//! From step to step in time: how long each is, where it is cut, and what becomes of the energy.

use super::drive::Drive;
use super::dynamic_system::{DynamicProblem, EnergyBalance, MaterialRate};
use super::rule::{GeneralisedAlpha, Motion};
use super::step::{Prescribed, Step, Taken, backward_differences, extrapolation, integral};
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, State};
use crate::solve::workspace::Workspace;
use std::collections::VecDeque;

/// How long steps are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepControl {
    /// All of this length
    Fixed(f64),
    /// As long as their error allows
    Adaptive {
        /// Error of a step, relative as in [`crate::solve::System::size`]
        tolerance: f64,
        /// The first step
        first: f64,
        /// The longest step
        longest: f64,
    },
}

/// A monitor of the system that passes a level: a step ends there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Which monitor
    pub monitor: usize,
    /// Where it is passed
    pub level: f64,
    /// How near to it a step ends, in the monitor's unit
    pub within: f64,
}

/// Says at which share of a step between two states an event lies; none where there is no event in it, or where it lies near enough to its end.
pub(crate) type StepEvent<'e> = &'e dyn Fn(&State, &State) -> Option<f64>;

/// How motion is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeOptions {
    /// ρ∞ of the generalised α method
    pub spectral_radius: f64,
    /// How long steps are
    pub steps: StepControl,
    /// Error wanted of Newton's method, relative as in [`crate::solve::System::size`]
    pub newton: f64,
    /// An event that steps are cut at
    pub crossing: Option<Crossing>,
}

impl TimeOptions {
    /// With ρ∞ = 0.8 and without events.
    pub const fn new(steps: StepControl) -> Self {
        Self { spectral_radius: 0.8, steps, newton: 1e-10, crossing: None }
    }
}

/// Why motion was not followed further.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TimeError {
    #[error("the time limit was reached at t = {time:.6e}")]
    Stopped { time: f64 },
    #[error("the step in time at t = {time:.6e} failed with a length of {step:.3e}: {cause}; try shorter steps")]
    Failed { time: f64, step: f64, cause: SolveError },
    #[error(
        "the step in time at t = {time:.6e} with a length of {step:.3e} has more than one solution: {negative} negative eigenvalues; \
         try shorter steps, or a material with mass or viscosity"
    )]
    NotUnique { time: f64, step: f64, negative: usize },
    #[error(
        "the step in time at t = {time:.6e} with a length of {step:.3e} has an error of {error:.3e}, wanted is {tolerance:.3e}; try a \
         larger tolerance, or a material with mass or viscosity"
    )]
    Inaccurate { time: f64, step: f64, error: f64, tolerance: f64 },
    #[error(
        "the step in time at t = {time:.6e} with a length of {step:.3e} leads into the substrate; try shorter steps"
    )]
    Inadmissible { time: f64, step: f64 },
}

/// A step shorter than this share of the time that has passed, and of the first step, is none.
const SHORTEST: f64 = 1e-13;
const SHORTEST_OF_FIRST: f64 = 1e-8;
/// What is left of a step that failed; most growth of one that was taken, and least; how much of the error is used.
const SHORTER: f64 = 0.35;
const GROWTH: f64 = 1.8;
const LEAST_GROWTH: f64 = 0.3;
const SAFETY: f64 = 0.85;
/// Error of the rule over that of an extrapolation, of three steps of one length: 1/6 of h³ d³q/dt³, at most.
const OF_EXTRAPOLATION: f64 = 1.0;
/// States that predictions go by.
const KEPT: usize = 3;
/// A step ends at most this much short of the end that is asked for without being lengthened, over its length.
const ROUNDED: f64 = 1e-6;

/// A step as it was taken.
struct Point {
    motion: Motion,
    /// Length of the step that ended here
    step: f64,
    /// Powers of the grip and of the dashpots
    power: [f64; 2],
    monitors: [f64; MONITORS],
    /// Up to there
    balance: EnergyBalance,
}

/// A motion inside a step that was taken.
#[derive(Clone, Debug)]
pub(crate) struct Inside {
    /// There
    pub motion: Motion,
    /// Numbers of the system there
    pub monitors: [f64; MONITORS],
    /// Energies there, and what went in and out
    pub balance: EnergyBalance,
}

/// Follows the motion of a problem under a drive.
pub struct TimeIntegrator<'a> {
    problem: &'a DynamicProblem,
    drive: Drive,
    options: TimeOptions,
    rule: GeneralisedAlpha,
    masses: Vec<f64>,
    /// The newest first
    points: VecDeque<Point>,
    next: f64,
    start: EnergyBalance,
    balance: EnergyBalance,
    /// Newton iterations so far, and steps that were tried
    iterations: usize,
    tried: usize,
    crossed: Option<f64>,
    ws: Workspace,
}

impl<'a> TimeIntegrator<'a> {
    /// From a motion on. Its mesh stays.
    pub fn new(problem: &'a DynamicProblem, drive: Drive, start: Motion, options: TimeOptions, ws: Workspace) -> Self {
        let (system, masses) = (&problem.system, problem.system.masses(&start.at));
        let next = match options.steps {
            StepControl::Fixed(step) | StepControl::Adaptive { first: step, .. } => step,
        };
        let energy = system.evaluate(&start.at, &vec![0.0; system.unknowns(&start.at)]).0;
        let stored = system.stored_energy(&start.at);
        let balance = EnergyBalance {
            work: 0.0,
            stored,
            adhesion: energy.energy - stored,
            spring: 0.5 * problem.problem.grip.compliance * start.at.force.powi(2),
            kinetic: system.kinetic_energy(&start.at, &masses, &start.velocity),
            dissipated: 0.0,
        };
        let mut integrator = Self {
            problem,
            drive,
            rule: GeneralisedAlpha::new(options.spectral_radius),
            options,
            masses,
            points: VecDeque::with_capacity(KEPT + 1),
            next,
            start: balance,
            balance,
            iterations: 0,
            tried: 0,
            crossed: None,
            ws,
        };
        let power = [integrator.grip_power(&start), 0.0];
        integrator.points.push_front(Point { motion: start, step: 0.0, power, monitors: energy.monitors, balance });
        integrator
    }

    /// Where the structure is and how it moves.
    pub fn motion(&self) -> &Motion {
        &self.points[0].motion
    }

    /// Energies now, and what went in and out.
    pub fn balance(&self) -> &EnergyBalance {
        &self.balance
    }

    /// Energies at the start.
    pub fn start(&self) -> &EnergyBalance {
        &self.start
    }

    /// Numbers of the system, as [`crate::solve::System::evaluate`] gives them.
    pub fn monitors(&self) -> [f64; MONITORS] {
        self.points[0].monitors
    }

    /// How far what moves the grip is along the drive.
    pub fn displacement(&self) -> f64 {
        self.displacement_of(&self.motion().at)
    }

    /// The same in a state.
    pub(crate) fn displacement_of(&self, at: &State) -> f64 {
        self.problem.problem.displacement(at)
    }

    /// Where the last step began; where no step was taken, where it is.
    pub(crate) fn before(&self) -> &State {
        &self.points[usize::from(self.points.len() > 1)].motion.at
    }

    /// When the monitor of the options passed its level for the first time.
    pub(crate) fn crossed(&self) -> Option<f64> {
        self.crossed
    }

    /// Newton iterations, and steps that were tried, those that were refused among them.
    pub(crate) fn effort(&self) -> (usize, usize) {
        (self.iterations, self.tried)
    }

    /// Takes a step, no farther than to the time `until`.
    ///
    /// # Errors
    /// No step is short enough, or, with fixed steps, one failed.
    pub fn advance(&mut self, until: f64) -> Result<(), TimeError> {
        self.advance_to_event(until, &|_, _| None)
    }

    /// Takes a step, no farther than to the time `until`, nor farther than `event` allows: that is asked about the states before and behind a
    /// step and answers at which share of the step an event lies, if it is not near enough to its end.
    ///
    /// # Errors
    /// As of [`Self::advance`].
    pub(crate) fn advance_to_event(&mut self, until: f64, event: StepEvent) -> Result<(), TimeError> {
        let time = self.motion().time;
        let left = until - time;
        let mut h = if left <= self.next * (1.0 + ROUNDED) { left } else { self.next };
        loop {
            let refused = match self.attempt(h) {
                Ok((taken, error, rate)) => match self.judge(&taken, h, error, event) {
                    Verdict::Take(growth) => {
                        self.lengthen(h, growth, left);
                        self.accept(taken, h, &rate);
                        return Ok(());
                    }
                    Verdict::Cut(share) => {
                        h *= share;
                        continue;
                    }
                    Verdict::Refuse(error) => error,
                },
                Err(SolveError::Stopped) => return Err(TimeError::Stopped { time }),
                Err(cause) => TimeError::Failed { time, step: h, cause },
            };
            let StepControl::Adaptive { first, .. } = self.options.steps else { return Err(refused) };
            let share = match refused {
                TimeError::Inaccurate { error, tolerance, .. } => {
                    (SAFETY * (tolerance / error).cbrt()).clamp(LEAST_GROWTH, SAFETY)
                }
                _ => SHORTER,
            };
            h *= share;
            if h < SHORTEST * time.abs() || h < SHORTEST_OF_FIRST * first {
                return Err(refused);
            }
        }
    }

    /// The motion at a share of the last step, by a step of its own from where that began: what is followed does not change by it.
    ///
    /// # Errors
    /// That step failed, or none was taken.
    pub(crate) fn inside(&mut self, share: f64) -> Result<Inside, SolveError> {
        let before = (self.iterations, self.tried);
        let Some(newest) = self.points.pop_front() else { return Err(SolveError::SingularGrip) };
        let tried =
            if self.points.is_empty() { Err(SolveError::SingularGrip) } else { self.attempt(share * newest.step) };
        let inside = tried.map(|(taken, _, rate)| {
            let (balance, _, monitors) = self.ended(&taken.motion, share * newest.step, &rate);
            Inside { motion: taken.motion, monitors, balance }
        });
        self.points.push_front(newest);
        (self.iterations, self.tried) = before;
        inside
    }

    /// The next step, which a step that was cut at the end asked for does not shorten.
    fn lengthen(&mut self, h: f64, growth: f64, left: f64) {
        if let StepControl::Adaptive { longest, .. } = self.options.steps {
            let cut = h == left && h < self.next;
            let grown = (h * growth).min(longest);
            self.next = if cut && growth >= 1.0 { self.next.min(longest).max(grown) } else { grown };
        }
    }

    /// A step of this length, its error, and the rule of its material.
    fn attempt(&mut self, h: f64) -> Result<(Taken, f64, MaterialRate), SolveError> {
        self.tried += 1;
        let now = &self.points[0];
        let (time, system) = (now.motion.time + h, &self.problem.system);
        let before = (now.step > 0.0).then_some(now.step);
        let (per_time, weights) = backward_differences(h, before);
        let older = self.points.get(1).map_or(&now.motion.memory, |point| &point.motion.memory);
        let known = now.motion.memory.iter().zip(older).map(|(m, o)| weights[0] * m + weights[1] * o).collect();
        let rate = MaterialRate { per_time, known };
        let prescribed = match &self.drive {
            Drive::Displacement(of) => Prescribed::Displacement(of(time)),
            Drive::Force(of) => Prescribed::Force(of(time)),
        };
        let step = Step {
            problem: self.problem,
            rule: self.rule,
            from: &now.motion,
            h,
            ratio: before.map_or(1.0, |before| h / before),
            rate: &rate,
            masses: &self.masses,
            prescribed,
            tolerance: self.options.newton,
        };
        let predicted = self.predicted(h);
        let taken = step.take(predicted.clone(), &mut self.ws)?;
        self.iterations += taken.iterations;
        let miss = system.size(&system.difference(&predicted.values, &taken.motion.at.values), &predicted);
        Ok((taken, miss * self.error_share(h), rate))
    }

    /// Where a step leads: by the parabola through the last three states; at first along the motion.
    fn predicted(&self, h: f64) -> State {
        let now = &self.points[0].motion;
        let system = &self.problem.system;
        if self.points.len() < KEPT {
            let way: Vec<f64> =
                (now.velocity.iter().zip(&now.acceleration)).map(|(v, a)| h * (v + 0.5 * h * a)).collect();
            let mut at = now.at.clone();
            system.retract(&mut at, &way, 1.0);
            return at;
        }
        let times: Vec<f64> = self.points.iter().map(|point| point.motion.time).collect();
        let states: Vec<&[f64]> = self.points.iter().map(|point| &*point.motion.at.values).collect();
        let weights = extrapolation(&times, now.time + h);
        State { values: system.combine(&states, &weights), ..now.at.clone() }
    }

    /// h³ d³q/dt³/6 over what the prediction misses.
    fn error_share(&self, h: f64) -> f64 {
        if self.points.len() < KEPT {
            return OF_EXTRAPOLATION;
        }
        let (first, second) = (self.points[0].step, self.points[1].step);
        OF_EXTRAPOLATION * h * h / ((h + first) * (h + first + second))
    }

    /// Whether a step is taken.
    fn judge(&self, taken: &Taken, h: f64, error: f64, event: StepEvent) -> Verdict {
        let time = self.motion().time;
        if taken.negative > 0 {
            return Verdict::Refuse(TimeError::NotUnique { time, step: h, negative: taken.negative });
        }
        if !self.problem.system.is_admissible(&taken.motion.at) {
            return Verdict::Refuse(TimeError::Inadmissible { time, step: h });
        }
        let StepControl::Adaptive { tolerance, .. } = self.options.steps else { return Verdict::Take(1.0) };
        if error > tolerance {
            return Verdict::Refuse(TimeError::Inaccurate { time, step: h, error, tolerance });
        }
        if let Some(share) = event(&self.motion().at, &taken.motion.at) {
            return Verdict::Cut(share.clamp(0.0, 1.0 - ROUNDED));
        }
        if let Some(Crossing { monitor, level, within }) = self.options.crossing.filter(|_| self.crossed.is_none()) {
            let (from, to) = (self.monitors()[monitor] - level, self.monitors_of(&taken.motion)[monitor] - level);
            if from * to < 0.0 && from.abs() > within && to.abs() > within {
                return Verdict::Cut((from / (from - to)).clamp(0.05, 0.95));
            }
        }
        Verdict::Take((SAFETY * (tolerance / error).cbrt()).clamp(LEAST_GROWTH, GROWTH))
    }

    fn monitors_of(&self, motion: &Motion) -> [f64; MONITORS] {
        let system = &self.problem.system;
        system.evaluate(&motion.at, &vec![0.0; system.unknowns(&motion.at)]).0.monitors
    }

    fn accept(&mut self, taken: Taken, h: f64, rate: &MaterialRate) {
        let motion = taken.motion;
        let (balance, power, monitors) = self.ended(&motion, h, rate);
        self.balance = balance;
        let now = &self.points[0];
        if let Some(Crossing { monitor, level, within }) = self.options.crossing {
            let (from, to) = (now.monitors[monitor] - level, monitors[monitor] - level);
            if self.crossed.is_none() && (from * to <= 0.0 || to.abs() <= within) {
                self.crossed = Some(motion.time);
            }
        }
        self.points.push_front(Point { motion, step: h, power, monitors, balance });
        self.points.truncate(KEPT);
    }

    /// Energies, powers and monitors at the end of a step of this length from the newest point.
    fn ended(&self, motion: &Motion, h: f64, rate: &MaterialRate) -> (EnergyBalance, [f64; 2], [f64; MONITORS]) {
        let system = &self.problem.system;
        let evaluation = system.evaluate(&motion.at, &vec![0.0; system.unknowns(&motion.at)]).0;
        let viscous = system.viscous_power(&motion.at, rate);
        let power = [self.grip_power(motion), viscous.dissipated];
        let now = &self.points[0];
        let older = self.points.get(1).map(|older| (now.step, older.power));
        let gone = |k: usize| integral(h, [power[k], now.power[k]], older.map(|(length, power)| (length, power[k])));
        let stored = system.stored_energy(&motion.at);
        let balance = EnergyBalance {
            work: now.balance.work + gone(0),
            stored: stored + viscous.stored,
            adhesion: evaluation.energy - stored,
            spring: 0.5 * self.problem.problem.grip.compliance * motion.at.force.powi(2),
            kinetic: system.kinetic_energy(&motion.at, &self.masses, &motion.velocity),
            dissipated: now.balance.dissipated + gone(1),
        };
        (balance, power, evaluation.monitors)
    }

    /// Power of what moves the grip.
    fn grip_power(&self, motion: &Motion) -> f64 {
        let rate = match &self.drive {
            Drive::Displacement(of) => of(motion.time).first,
            Drive::Force(_) => {
                let problem = &self.problem.problem;
                let gradient = problem.grip.displacement_gradient(&*self.problem.system, &motion.at);
                gradient.iter().zip(&motion.velocity).map(|(g, v)| g * v).sum()
            }
        };
        motion.at.force * rate
    }
}

/// What becomes of a step.
enum Verdict {
    /// It is taken; the next one may be longer by this factor.
    Take(f64),
    /// It passes an event, which is about this share of its length away.
    Cut(f64),
    Refuse(TimeError),
}
