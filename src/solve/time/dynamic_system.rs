//! What time integration asks of a system besides what equilibrium does: mass, what its material remembers, and one factorisation of both; and
//! where the work goes that is done on a structure in motion.

use crate::solve::error::SolveError;
use crate::solve::problem::Problem;
use crate::solve::state::State;
use crate::solve::system::{CondensedSystem, NodalTerms, System};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// The rule that replaces the time derivative of what a material remembers: dm/dt = `per_time` (m - `known`) at the end of a step.
#[derive(Clone, Debug, Default)]
pub struct MaterialRate {
    /// A rate, 1/time
    pub per_time: f64,
    /// From the memories of the steps before, as the system lays them out; empty of a material that remembers nothing.
    pub known: Arc<[f64]>,
}

/// What a step in time adds to residual and tangent.
#[derive(Clone, Copy, Debug)]
pub struct StepTerms<'a> {
    /// Forces of inertia, and the masses over β' h²
    pub nodal: NodalTerms<'a>,
    /// Of its material
    pub rate: &'a MaterialRate,
}

/// What a viscous material stores besides its elastic energy, and what it dissipates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViscousPower {
    /// Energy of the springs that are in series with dashpots, aJ
    pub stored: f64,
    /// Power of the dashpots, aJ per unit of time
    pub dissipated: f64,
}

/// A structure that moves: M(q) dv/dt + gyroscopic forces + viscous forces + R(q) = forces of the grip.
///
/// The mass matrix is a diagonal, one number an unknown: the mass of an element is lumped in its nodes by the Gauss-Lobatto rule of these
/// nodes, which is as accurate as the element (A. T. Patera, J. Comput. Phys. 54 (1984)). Velocities and accelerations are directions.
///
/// Units: whatever the masses are in; with masses in nN·ns²/nm = 1e-18 kg times are in ns and velocities in nm/ns = m/s.
pub trait DynamicSystem: System {
    /// M, a number an unknown. Zeros of a structure whose inertia does not count.
    fn masses(&self, at: &State) -> Vec<f64>;

    /// M a, with what turning masses add to that.
    fn inertia_forces(&self, at: &State, masses: &[f64], velocity: &[f64], acceleration: &[f64]) -> Vec<f64> {
        let _ = (at, velocity);
        masses.iter().zip(acceleration).map(|(mass, a)| mass * a).collect()
    }

    /// ½ v · M v, aJ
    fn kinetic_energy(&self, at: &State, masses: &[f64], velocity: &[f64]) -> f64 {
        let _ = at;
        0.5 * masses.iter().zip(velocity).map(|(mass, v)| mass * v * v).sum::<f64>()
    }

    /// Elastic energy alone, without that of adhesion, aJ.
    fn stored_energy(&self, at: &State) -> f64;

    /// Factorises the tangent of a step, its diagonal and viscous parts included, in place of [`System::factorise`]; the residual is that of the
    /// step.
    ///
    /// # Errors
    /// As of [`System::factorise`].
    fn factorise_step(&self, at: &State, terms: &StepTerms, ws: &mut Workspace) -> Result<CondensedSystem, SolveError>;

    /// What the material remembers of a state in which it has been for ever; empty of a material that remembers nothing.
    fn relaxed_memory(&self, _at: &State) -> Vec<f64> {
        Vec::new()
    }

    /// What the material remembers behind a step that ended in a state.
    fn memory(&self, _at: &State, _rate: &MaterialRate) -> Vec<f64> {
        Vec::new()
    }

    /// Energy and power of its dashpots at the end of a step.
    fn viscous_power(&self, _at: &State, _rate: &MaterialRate) -> ViscousPower {
        ViscousPower::default()
    }
}

/// A system that moves in a grip.
#[derive(Clone)]
pub struct DynamicProblem {
    /// Of which the system is the same
    pub problem: Problem,
    /// What moves
    pub system: Arc<dyn DynamicSystem>,
}

impl DynamicProblem {
    /// A problem whose system is this one.
    pub fn new(problem: Problem, system: Arc<dyn DynamicSystem>) -> Self {
        Self { problem: Problem { system: system.clone(), ..problem }, system }
    }
}

/// Energies at one time, and what went in and out since the beginning, aJ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyBalance {
    /// Work of the grip since the beginning
    pub work: f64,
    /// Elastic energy, with that of springs in series with dashpots
    pub stored: f64,
    /// Energy of adhesion, negative
    pub adhesion: f64,
    /// Of the machine's spring
    pub spring: f64,
    /// Kinetic energy
    pub kinetic: f64,
    /// Dissipated by the material since the beginning
    pub dissipated: f64,
}

impl EnergyBalance {
    /// What is in the structure: stored, of adhesion, of the spring and kinetic.
    pub fn total(&self) -> f64 {
        self.stored + self.adhesion + self.spring + self.kinetic
    }

    /// Work less what the structure has more than at the `start`, less what it dissipated: zero, but for the errors of the steps.
    pub fn defect(&self, start: &Self) -> f64 {
        self.work - (self.total() - start.total()) - self.dissipated
    }
}
