//! Materials whose stress depends on how their strain went in time.
//!
//! With the section's elastic stiffness C, its strains ε, section forces are C ε and besides
//!
//! - Kelvin and Voigt: τ C dε/dt, with the retardation time τ;
//! - standard linear solid: g C (ε - e), de/dt = (ε - e)/τ, with the relaxation time τ and g = E₀/E∞ - 1: C is the relaxed stiffness, that of
//!   slow loading, and (1 + g) C that of fast loading.
//!
//! One rule dm/dt = c (m - m_k) for what is remembered, m = ε or m = e, makes of both f C (ε - m_k): f = τ c, or f = g c/(c + 1/τ).

use crate::solve::time::dynamic_system::{MaterialRate, ViscousPower};
use serde::{Deserialize, Serialize};

/// How a material flows. Times are in ns where masses are in nN·ns²/nm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Viscosity {
    /// Not at all
    #[default]
    Elastic,
    /// A dashpot beside the spring
    KelvinVoigt {
        /// τ
        retardation_time: f64,
    },
    /// A spring and a dashpot in series, beside the spring
    StandardLinearSolid {
        /// τ of the dashpot's branch
        relaxation_time: f64,
        /// E₀/E∞, more than 1
        stiffness_ratio: f64,
    },
}

impl Viscosity {
    /// Whether it remembers anything.
    pub fn is_viscous(self) -> bool {
        self != Self::Elastic
    }

    /// f for a rule of the rate c.
    pub fn factor(self, per_time: f64) -> f64 {
        match self {
            Self::Elastic => 0.0,
            Self::KelvinVoigt { retardation_time } => retardation_time * per_time,
            Self::StandardLinearSolid { relaxation_time, stiffness_ratio } => {
                (stiffness_ratio - 1.0) * per_time / (per_time + 1.0 / relaxation_time)
            }
        }
    }

    /// What is remembered behind a step: m for a strain ε and the known m_k.
    pub(crate) fn remembered(self, strain: f64, known: f64, per_time: f64) -> f64 {
        match self {
            Self::Elastic | Self::KelvinVoigt { .. } => strain,
            Self::StandardLinearSolid { relaxation_time, .. } => {
                (strain / relaxation_time + per_time * known) / (per_time + 1.0 / relaxation_time)
            }
        }
    }

    /// The same of a body, strain by strain.
    pub(crate) fn remembered_by(self, strains: &[f64], rate: &MaterialRate) -> Vec<f64> {
        let remembered = |(strain, known): (&f64, &f64)| self.remembered(*strain, *known, rate.per_time);
        strains.iter().zip(rate.known.iter()).map(remembered).collect()
    }

    /// Energy and power of a body with these energies in the step and at rest, aJ; they are not asked for where nothing flows.
    pub(crate) fn power_in(self, rate: &MaterialRate, energies: impl FnOnce() -> [f64; 2]) -> ViscousPower {
        if !self.is_viscous() {
            return ViscousPower::default();
        }
        let [in_step, at_rest] = energies();
        self.power(in_step - at_rest, rate.per_time)
    }

    /// Energy and power, from ½ f (ε - m_k)·C (ε - m_k) of the whole body, aJ.
    pub(crate) fn power(self, energy: f64, per_time: f64) -> ViscousPower {
        match self {
            Self::Elastic => ViscousPower::default(),
            Self::KelvinVoigt { .. } => ViscousPower { stored: 0.0, dissipated: 2.0 * energy * per_time },
            Self::StandardLinearSolid { relaxation_time, .. } => {
                let stored = energy * per_time / (per_time + 1.0 / relaxation_time);
                ViscousPower { stored, dissipated: 2.0 * stored / relaxation_time }
            }
        }
    }
}
