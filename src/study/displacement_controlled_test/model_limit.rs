//! Where a test leaves its model: what is bonded has lost its stability, or its end has collapsed onto the substrate.

use super::balance::LoadingDirection;
use super::stable_branch::Machine;
use crate::beam::planar::model_end::CollapsedSection;
use crate::beam::planar::model_limits::BondedLoss;
use crate::solve::newton::Solution;
use crate::study::peel::adhering::Adhering;
use serde::{Deserialize, Serialize};
use std::fmt;

/// What of the model has come to its end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum ModelLimit {
    /// What is bonded is unstable.
    Bonded(BondedLoss),
    /// The beam has collapsed onto the substrate.
    Collapsed(CollapsedSection),
}

/// Where a test has come to the end of its model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftModel {
    /// Which way the machine moves
    pub way: LoadingDirection,
    /// U, nm
    pub machine: f64,
    /// P of the last equilibrium within the model, nN
    pub force: f64,
    /// What has come to its end
    pub limit: ModelLimit,
}

impl fmt::Display for LeftModel {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { way, machine, force, limit } = self;
        write!(f, "on the {} at U = {machine:.6} nm, P = {force:.6} nN ", way.word())?;
        match limit {
            ModelLimit::Bonded(loss) => loss.fmt(f),
            ModelLimit::Collapsed(section) => section.fmt(f),
        }
    }
}

impl Machine<'_> {
    /// The limit of the model at which an equilibrium is, where the test cannot go on from it.
    pub fn model_limit(&self, at: &Solution) -> Option<ModelLimit> {
        self.collapsed(at).or_else(|| self.bonded(at))
    }

    /// Whether a beam has collapsed in an equilibrium.
    pub fn collapsed(&self, at: &Solution) -> Option<ModelLimit> {
        self.problem.beam.planar()?.collapsed_section(&at.at).map(ModelLimit::Collapsed)
    }

    /// Whether what is bonded is unstable at an equilibrium, or nearly so.
    pub fn bonded(&self, at: &Solution) -> Option<ModelLimit> {
        let beam = self.problem.beam.planar()?;
        if self.adhering(at) != Adhering::Pad {
            return None;
        }
        beam.limits.near_bonded_loss(beam.grip_forces(&at.at).horizontal).map(ModelLimit::Bonded)
    }
}
