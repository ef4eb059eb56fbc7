//! The generalised-α rule of J. Chung and G. M. Hulbert, J. Appl. Mech. 60 (1993), in the form for rotation groups of O. Brüls, A. Cardona
//! and M. Arnold, Mech. Mach. Theory 48 (2012).
//!
//! With accelerations dv/dt that satisfy the equation of motion at the end of each step, and a sequence a that lags behind them,
//!
//!   (1 - α_m) a₁ + α_m a₀ = (1 - α_f) (dv/dt)₁ + α_f (dv/dt)₀
//!   q₁ = q₀ ∘ exp(x),   x = h v₀ + h² (½ - β) a₀ + h² β a₁,   v₁ = v₀ + h (1 - γ) a₀ + h γ a₁.
//!
//! It is of second order; what vibrates faster than steps can follow is damped by ρ∞ a step. a belongs to a time (α_m - α_f) h behind the step: a
//! step of another length has it moved there, or the order is lost.

use crate::solve::state::State;

/// The rule of one spectral radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GeneralisedAlpha {
    /// α_m
    pub alpha_m: f64,
    /// α_f
    pub alpha_f: f64,
    /// β
    pub beta: f64,
    /// γ
    pub gamma: f64,
}

/// Velocity and accelerations at the end of a step, of one unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EndRates {
    pub velocity: f64,
    pub acceleration: f64,
    pub pseudo: f64,
}

impl GeneralisedAlpha {
    /// With the spectral radius ρ∞ at infinite frequency, from 0 (these are gone after a step) to 1 (nothing is damped).
    pub(crate) fn new(spectral_radius: f64) -> Self {
        let rho = spectral_radius.clamp(0.0, 1.0);
        let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
        let gamma = 0.5 - alpha_m + alpha_f;
        Self { alpha_m, alpha_f, beta: 0.25 * (gamma + 0.5).powi(2), gamma }
    }

    /// β': the derivative of the acceleration by x, 1/time².
    pub(crate) fn mass_factor(&self, h: f64) -> f64 {
        (1.0 - self.alpha_m) / (self.beta * h * h * (1.0 - self.alpha_f))
    }

    /// a of the step before, moved to where a step of another length has it; `ratio` is that length over the last one.
    pub(super) fn moved(&self, before: EndRates, ratio: f64) -> f64 {
        before.acceleration + ratio * (before.pseudo - before.acceleration)
    }

    /// The rates at the end of a step of length h on which the unknown went by x; a₀ is moved already.
    pub(super) fn after(&self, before: EndRates, x: f64, h: f64) -> EndRates {
        let EndRates { velocity: v, acceleration: dv, pseudo: a } = before;
        let pseudo = ((x / h - v) / h - (0.5 - self.beta) * a) / self.beta;
        EndRates {
            velocity: v + h * ((1.0 - self.gamma) * a + self.gamma * pseudo),
            acceleration: ((1.0 - self.alpha_m) * pseudo + self.alpha_m * a - self.alpha_f * dv) / (1.0 - self.alpha_f),
            pseudo,
        }
    }
}

/// A state in motion, at one time.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Since the drive began
    pub time: f64,
    /// Where it is, with the force of the grip
    pub at: State,
    /// v, a direction over time
    pub velocity: Vec<f64>,
    /// dv/dt, which satisfies the equation of motion
    pub acceleration: Vec<f64>,
    /// a of the rule, which lags behind that
    pub(super) pseudo: Vec<f64>,
    /// What the material remembers
    pub memory: Vec<f64>,
}

impl Motion {
    /// At rest in an equilibrium, or let go from any state with this velocity and acceleration. `memory`: what the material remembers.
    pub fn new(time: f64, at: State, velocity: Vec<f64>, acceleration: Vec<f64>, memory: Vec<f64>) -> Self {
        Self { time, at, velocity, pseudo: acceleration.clone(), acceleration, memory }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Chung and Hulbert's numbers at the ends of the range: ρ∞ = 1 is the midpoint-like rule with γ = ½, β = ¼; ρ∞ = 0 has
    /// α_m = -1, α_f = 0, γ = 3/2, β = 1.
    #[test]
    fn the_ends_of_the_range() {
        let one = GeneralisedAlpha::new(1.0);
        assert_relative_eq!(one.gamma, 0.5);
        assert_relative_eq!(one.beta, 0.25);
        let zero = GeneralisedAlpha::new(0.0);
        assert_eq!((zero.alpha_m, zero.alpha_f, zero.gamma, zero.beta), (-1.0, 0.0, 1.5, 1.0));
    }

    /// A motion whose acceleration is the same for ever is exact.
    #[test]
    fn constant_acceleration() {
        let (rule, h, g) = (GeneralisedAlpha::new(0.7), 0.3, 9.81);
        let before = EndRates { velocity: 2.0, acceleration: g, pseudo: g };
        let after = rule.after(before, 2.0 * h + 0.5 * g * h * h, h);
        assert_relative_eq!(after.velocity, 2.0 + g * h, max_relative = 1e-14);
        assert_relative_eq!(after.acceleration, g, max_relative = 1e-13);
    }
}
