//! What a pull-off found, without its points and its states: what a row of a sweep has, and a sample.

use super::converged_peak::ConvergedPeak;
use super::result::{SetaEffort, SetaEnd, SetaMoment, SetaPullOff, SetaState};
use serde::{Deserialize, Serialize};

/// The numbers of a pull-off.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaResult {
    /// On the finest mesh, or as of [`SetaPullOff`] where that was not found
    pub peak: Option<SetaMoment>,
    /// By how much the force of the peak differs from that on the mesh before, nN; none where no finer mesh came to the peak
    pub mesh_error: Option<f64>,
    /// As of [`SetaPullOff`]
    pub first_detachment: Option<SetaMoment>,
    /// As of [`SetaPullOff`]
    pub last_detachment: Option<SetaMoment>,
    /// How many events there are
    pub events: usize,
    /// Changes of tips in the largest event
    pub most_at_once: usize,
    /// Of the root over all steps, aJ
    pub work: f64,
    /// At events, aJ
    pub released: f64,
    /// As of [`SetaPullOff::imbalance`]
    pub imbalance: f64,
    /// Tips that adhere at the end
    pub attached: usize,
    /// As of [`SetaPullOff`]
    pub end: SetaEnd,
    /// Equilibria
    pub points: usize,
    /// As of [`SetaPullOff`]
    pub effort: SetaEffort,
}

impl SetaResult {
    /// Of a pull-off, and of its peak on finer meshes.
    pub fn new(pull_off: &SetaPullOff, converged: Option<&ConvergedPeak>) -> Self {
        let moment = |state: &Option<SetaState>| state.as_ref().map(SetaMoment::from);
        let last = pull_off.points.last().copied().unwrap_or_default();
        Self {
            peak: converged.map(|found| found.peak).or_else(|| moment(&pull_off.peak)),
            mesh_error: converged.map(|found| found.mesh.force),
            first_detachment: moment(&pull_off.first_detachment),
            last_detachment: moment(&pull_off.last_detachment),
            events: pull_off.events.len(),
            most_at_once: pull_off.events.iter().map(|event| event.tips.len()).max().unwrap_or(0),
            work: last.work,
            released: last.released,
            imbalance: pull_off.imbalance(),
            attached: last.attached,
            end: pull_off.end.clone(),
            points: pull_off.points.len(),
            effort: pull_off.effort,
        }
    }
}
