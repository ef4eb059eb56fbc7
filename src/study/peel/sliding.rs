//! How a beam that friction holds has slid.

use super::result::Peel;
use super::solution_history::SolutionHistory;
use crate::adhesion::friction::dahl::FrictionState;
use crate::beam::planar::friction_history::FrictionHistory;
use crate::solve::newton::Solution;

/// The friction on a beam at one equilibrium of its path.
#[derive(Clone, Debug, PartialEq)]
pub struct Sliding {
    /// Displacement of the face at the free end along the substrate, nm
    pub free_end: f64,
    /// ∫ b t dS, what friction carries along the substrate, nN
    pub force: f64,
    /// ∫ b τ dS, what it could carry, nN
    pub capacity: f64,
    /// Length in contact: where the limit is more than half the shear strength, nm
    pub contact: f64,
    /// Length of that on which the face slides: where it carries more than nine tenths of its limit, nm
    pub sliding: f64,
    /// Energy dissipated since the path began, aJ
    pub dissipated: f64,
    /// S (nm), traction over shear strength s, and shear strength τ (GPa), along the beam
    pub along: Vec<(f64, f64, f64)>,
}

/// Traction over shear strength from which a face counts as sliding, and fraction of the strength from which it counts as in contact.
const SLIDES: f64 = 0.9;
const TOUCHES: f64 = 0.5;

impl Peel {
    /// How the beam has slid at its initiation peak; none without friction or without a peak.
    pub fn sliding_at_peak(&self) -> Option<Sliding> {
        let trace = self.trace.as_ref()?;
        self.sliding(trace, trace.peak.as_ref()?)
    }

    /// The same at `points[index]`.
    pub fn sliding_at(&self, index: usize) -> Option<Sliding> {
        let trace = self.trace.as_ref()?;
        self.sliding(trace, trace.points.get(index)?)
    }

    fn sliding(&self, trace: &SolutionHistory, solution: &Solution) -> Option<Sliding> {
        let strength = self.model.friction.strength?;
        let began = FrictionHistory(trace.problem.beam.planar()?.history.as_ref()?).iter().next()?.1.place;
        let history = trace.problem.system.commit(&solution.at)?;
        let along: Vec<(f64, FrictionState)> = FrictionHistory(&history).iter().collect();
        // by the trapezoidal rule
        let sum = |of: &dyn Fn(&(f64, FrictionState)) -> f64| -> f64 {
            along.windows(2).map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (of(&pair[0]) + of(&pair[1]))).sum()
        };
        let width = |s: f64| self.model.section_at(s).1;
        let touches = |slip: &FrictionState| slip.limit > TOUCHES * strength;
        Some(Sliding {
            free_end: along[0].1.place - began,
            force: sum(&|(s, slip)| width(*s) * slip.mobilisation * slip.limit),
            capacity: sum(&|(s, slip)| width(*s) * slip.limit),
            contact: sum(&|(_, slip)| f64::from(touches(slip))),
            sliding: sum(&|(_, slip)| f64::from(touches(slip) && slip.mobilisation.abs() > SLIDES)),
            dissipated: history.dissipated,
            along: along.iter().map(|(s, slip)| (*s, slip.mobilisation, slip.limit)).collect(),
        })
    }
}
