//! One step in time: Newton's method for the equation of motion at its end.

use super::drive::DriveRates;
use super::dynamic_system::{DynamicProblem, MaterialRate, StepTerms};
use super::rule::{EndRates, GeneralisedAlpha, Motion};
use crate::solve::error::{Quantity, SolveError};
use crate::solve::frontal::grip_block::GripBlock;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::system::NodalTerms;
use crate::solve::workspace::Workspace;

/// Most iterations of a step.
const MOST_ITERATIONS: usize = 14;
/// A first correction above this, relative as in [`crate::solve::System::size`], is refused: the prediction was too far away.
const LARGEST: f64 = 0.5;
/// Updates that do not fall any more are round-off below this.
const ROUND_OFF: f64 = 1e-7;

/// What is prescribed of the grip at the end of a step.
#[derive(Clone, Copy, Debug)]
pub(super) enum Prescribed {
    Displacement(DriveRates),
    Force(f64),
}

impl Prescribed {
    fn constraint(self) -> PathConstraint {
        match self {
            Self::Displacement(rates) => PathConstraint { weights: Observables::DISPLACEMENT, target: rates.value },
            Self::Force(force) => PathConstraint { weights: Observables::FORCE, target: force },
        }
    }
}

/// A step to be taken.
pub(super) struct Step<'a> {
    pub problem: &'a DynamicProblem,
    pub rule: GeneralisedAlpha,
    pub from: &'a Motion,
    /// Length of it
    pub h: f64,
    /// This length over that of the last step
    pub ratio: f64,
    pub rate: &'a MaterialRate,
    pub masses: &'a [f64],
    pub prescribed: Prescribed,
    /// Error wanted of Newton's method, relative as in [`crate::solve::System::size`]
    pub tolerance: f64,
}

/// A step that was taken.
pub(super) struct Taken {
    pub motion: Motion,
    pub iterations: usize,
    /// Negative eigenvalues of the tangent of the step: more than none, and another solution is as near.
    pub negative: usize,
}

impl Step<'_> {
    /// Takes it from a prediction of where it ends.
    pub(crate) fn take(&self, predicted: State, ws: &mut Workspace) -> Result<Taken, SolveError> {
        if ws.is_stopped() {
            return Err(SolveError::Stopped);
        }
        let DynamicProblem { problem, system } = self.problem;
        let mut at = predicted;
        let factor = self.rule.mass_factor(self.h);
        let stiffness: Vec<f64> = self.masses.iter().map(|mass| mass * factor).collect();
        let mut update = vec![0.0; system.unknowns(&at)];
        let (constraint, mut previous) = (self.prescribed.constraint(), f64::INFINITY);
        for iterations in 1..=MOST_ITERATIONS {
            let [velocity, acceleration, _] = self.rates(&at);
            let force = system.inertia_forces(&at, self.masses, &velocity, &acceleration);
            let nodal = NodalTerms { stiffness: &stiffness, force: &force };
            let root = system.factorise_step(&at, &StepTerms { nodal, rate: self.rate }, ws)?;
            let observed = problem.observables(&at, &root.evaluation);
            let grip = GripBlock::new(problem, &root, &at, &constraint, &observed);
            let solved = grip.solve(-1.0)?;
            system.recover(ws, &solved.interface, -1.0, &mut update);
            let size = system.size(&update, &at);
            if !(size.is_finite() && solved.force.is_finite()) {
                return Err(SolveError::NotFiniteUpdate { quantity: Quantity::NewtonUpdate });
            }
            let stalls = iterations > 2 && size > 0.9 * previous;
            if size > LARGEST || (stalls && size > ROUND_OFF) {
                return Err(SolveError::NotConverged { update: size, iterations });
            }
            system.retract(&mut at, &update, 1.0);
            at.force += solved.force;
            // the tangent is not exact where masses turn: what is left after a step falls by as much as the last one
            let next = if previous.is_finite() { size * (size / previous).min(1.0) } else { size };
            if next <= self.tolerance || stalls {
                let (held, loose) = grip.inertia(root.negative);
                let negative = if matches!(self.prescribed, Prescribed::Force(_)) { loose } else { held };
                return Ok(Taken { motion: self.ended(at), iterations, negative });
            }
            previous = size;
        }
        Err(SolveError::NotConverged { update: previous, iterations: MOST_ITERATIONS })
    }

    fn ended(&self, at: State) -> Motion {
        let [velocity, acceleration, pseudo] = self.rates(&at);
        let memory = self.problem.system.memory(&at, self.rate);
        Motion { time: self.from.time + self.h, at, velocity, acceleration, pseudo, memory }
    }

    /// Velocities, accelerations and a at the end of the step, were it to end in this state.
    fn rates(&self, at: &State) -> [Vec<f64>; 3] {
        let (rule, from, h) = (self.rule, self.from, self.h);
        let way = self.problem.system.difference(&from.at.values, &at.values);
        let mut rates = [const { Vec::new() }; 3];
        for (k, x) in way.into_iter().enumerate() {
            let before =
                EndRates { velocity: from.velocity[k], acceleration: from.acceleration[k], pseudo: from.pseudo[k] };
            let moved = EndRates { pseudo: rule.moved(before, self.ratio), ..before };
            let EndRates { velocity, acceleration, pseudo } = rule.after(moved, x, h);
            rates[0].push(velocity);
            rates[1].push(acceleration);
            rates[2].push(pseudo);
        }
        for (k, first, second) in self.prescribed_rates(at) {
            (rates[0][k], rates[1][k], rates[2][k]) = (first, second, second);
        }
        rates
    }

    /// Place in a direction, rate and acceleration of each unknown whose motion is prescribed: the rule would find these from positions, and
    /// accelerations of what is held come out of that as noise.
    fn prescribed_rates(&self, at: &State) -> Vec<(usize, f64, f64)> {
        let (grip, system) = (&self.problem.problem.grip, &self.problem.system);
        let mut own = Vec::new();
        let drive = match self.prescribed {
            Prescribed::Displacement(rates) if grip.compliance == 0.0 => Some(rates),
            _ => None,
        };
        let mixed = grip.mixed();
        for slot in (0..system.interface().len()).filter(|&slot| grip.held[slot]) {
            let place = system.place_of(slot, at);
            let geared = slot == grip.geared && grip.gear != 0.0;
            match (mixed, drive) {
                (Some((across, direction)), Some(rates)) if across == slot => {
                    own.push((place, direction.along * rates.first, direction.along * rates.second));
                    let driven = system.place_of(grip.driven, at);
                    own.push((driven, direction.up * rates.first, direction.up * rates.second));
                }
                (Some((across, _)), None) if across == slot => {}
                (_, Some(rates)) if geared => own.push((place, grip.gear * rates.first, grip.gear * rates.second)),
                _ if geared => {}
                _ => own.push((place, 0.0, 0.0)),
            }
        }
        if let (None, Some(rates)) = (mixed, drive) {
            own.push((system.place_of(grip.driven, at), rates.first, rates.second));
        }
        own
    }
}

// -- Polynomials through the last points in time: predictions, their errors, rates and integrals --

/// Weights that extrapolate from `times`, the newest first, to `to`: Lagrange's.
pub(super) fn extrapolation(times: &[f64], to: f64) -> Vec<f64> {
    let weight = |i: usize| {
        (0..times.len()).filter(|&j| j != i).map(|j| (to - times[j]) / (times[i] - times[j])).product::<f64>()
    };
    (0..times.len()).map(weight).collect()
}

/// BDF of the second order, dm/dt = c (m₁ - w₀ m₀ - w₋ m₋) at the end of a step h behind one of the length h₋; of the first order where
/// there was none. Returns c, w₀ and w₋.
pub(super) fn backward_differences(h: f64, before: Option<f64>) -> (f64, [f64; 2]) {
    let Some(before) = before else { return (1.0 / h, [1.0, 0.0]) };
    let r = h / before;
    let scale = 1.0 + 2.0 * r;
    (scale / (h * (1.0 + r)), [(1.0 + r).powi(2) / scale, -r * r / scale])
}

/// ∫ p dt over the last step h, from p at its end, at its beginning and at the beginning of the step before, by the parabola through these.
pub(super) fn integral(h: f64, [now, last]: [f64; 2], before: Option<(f64, f64)>) -> f64 {
    let Some((length, first)) = before else { return 0.5 * h * (now + last) };
    let r = h / length;
    h * ((3.0 + 2.0 * r) / (6.0 * (1.0 + r)) * now + (3.0 + r) / 6.0 * last - r * r / (6.0 * (1.0 + r)) * first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// All three are exact of parabolas on steps of any length.
    #[test]
    fn exact_of_parabolas() {
        let (first, last, now) = (0.3, 0.7, 1.6);
        let p = |t: f64| 2.0 - 3.0 * t + 1.5 * t * t;
        let weights = extrapolation(&[now, last, first], 2.0);
        let found = weights[0] * p(now) + weights[1] * p(last) + weights[2] * p(first);
        assert_relative_eq!(found, p(2.0), max_relative = 1e-13);
        let (c, [w0, w1]) = backward_differences(now - last, Some(last - first));
        assert_relative_eq!(c * (p(now) - w0 * p(last) - w1 * p(first)), -3.0 + 3.0 * now, max_relative = 1e-13);
        let whole = |t: f64| 2.0 * t - 1.5 * t * t + 0.5 * t.powi(3);
        let found = integral(now - last, [p(now), p(last)], Some((last - first, p(first))));
        assert_relative_eq!(found, whole(now) - whole(last), max_relative = 1e-13);
    }
}
