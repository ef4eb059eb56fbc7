//! One value of a sweep of pulls at a rate.

use super::pulled::PulledAtRate;
use crate::number::S_PER_NS;
use crate::pull_row::PullRow;
use serde::{Deserialize, Serialize};

/// The numbers of a pull at a rate. Forces in nN, displacements in nm, energies in aJ, times in s.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RateResult {
    /// The largest force of the pull: of a beam by a parabola through the three steps next to it
    pub largest_force: f64,
    /// Of what moves the grip, there
    pub displacement: f64,
    /// Since the pull began, there
    pub time: f64,
    /// Kinetic energy at the step next to it
    pub kinetic: f64,
    /// Dissipated by the material up to that step
    pub dissipated: f64,
    /// When nothing adhered any more for the first time
    pub contact_lost: Option<f64>,
    /// Of the grip, or of the machine behind its spring, to the end
    pub work: f64,
    /// Largest defect of the balance over the largest work
    pub imbalance: f64,
    /// Steps in time
    pub steps: usize,
    /// Newton iterations
    pub newton_iterations: usize,
    /// Elements of the mesh
    pub elements: usize,
    /// Why it stopped short, if it did
    pub failed: Option<String>,
}

impl RateResult {
    /// Of a pull, and why it stopped short, if it did.
    pub fn new(pulled: &PulledAtRate, failed: Option<String>) -> Self {
        let next = pulled.next_to_peak().map(|next| next.balance).unwrap_or_default();
        let (time, displacement, largest_force) =
            pulled.peak.map_or((0.0, 0.0, 0.0), |at| (at.time, at.displacement, at.force));
        Self {
            largest_force,
            displacement,
            time: S_PER_NS * time,
            kinetic: next.kinetic,
            dissipated: next.dissipated,
            contact_lost: pulled.contact_lost.map(|time| S_PER_NS * time),
            work: pulled.change().work,
            imbalance: pulled.imbalance,
            steps: pulled.steps(),
            newton_iterations: pulled.iterations,
            elements: pulled.elements,
            failed,
        }
    }
}

/// One value of a sweep of pulls at a rate.
pub type RateRow = PullRow<RateResult>;

impl RateRow {
    /// The name of its end in outputs.
    pub fn end(&self) -> &'static str {
        match &self.found {
            Err(_) | Ok(RateResult { failed: Some(_), .. }) => "failed",
            Ok(found) if found.contact_lost.is_some() => "detached",
            Ok(_) => "still-attached",
        }
    }

    /// What was found of a pull that was followed to its end.
    pub(super) fn finished(&self) -> Option<&RateResult> {
        self.found.as_ref().ok().filter(|found| found.failed.is_none())
    }
}
