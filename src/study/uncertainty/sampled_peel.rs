//! A peel as a function of its uncertain inputs.

use super::design::{Design, SamplePlace};
use super::outcome::{Outcome, peel_numbers};
use crate::model::peel::PeelModel;
use crate::study::accuracy::Accuracy;
use crate::study::sensitivity::quantity::PeelQuantity;
use crate::study::stop_criteria::StopCriteria;
use crate::study::sweep::sweep;

/// Numbers as a function of uncertain inputs, of a peel or of something else. Its functions are called from any thread.
pub trait Sampled: Sync {
    /// How many numbers there are
    fn numbers(&self) -> usize;

    /// The numbers with these inputs, in the order and units of the plan.
    fn outcome(&self, inputs: &[f64]) -> Outcome;
}

impl Sampled for SampledPeel<'_> {
    fn numbers(&self) -> usize {
        self.of.len()
    }

    fn outcome(&self, inputs: &[f64]) -> Outcome {
        SampledPeel::outcome(self, inputs)
    }
}

/// A peel as a function of its uncertain inputs. All of its functions are called from any thread.
#[derive(Clone, Copy)]
pub struct SampledPeel<'p> {
    /// The model with these inputs, in the order and units of the plan; or why there is none
    pub model: &'p (dyn Fn(&[f64]) -> Result<PeelModel, String> + Sync),
    /// What is asked for
    pub of: &'p [PeelQuantity],
    /// Of every peel
    pub accuracy: &'p Accuracy,
    /// The stop criteria of one path, anew for each
    pub stop: &'p (dyn Fn() -> StopCriteria + Sync),
}

impl SampledPeel<'_> {
    /// What the peel with these inputs gives.
    pub fn outcome(&self, inputs: &[f64]) -> Outcome {
        match (self.model)(inputs) {
            Ok(model) => peel_numbers(&model, self.of, self.accuracy, self.stop),
            Err(why) => Outcome::refused(self.of.len(), why),
        }
    }
}

/// Runs the samples of a design on all cores, replicate after replicate. `go_on` is asked before each: once it says no, no other is begun, and
/// the samples that were not begun have no result. The results stand in the order of the samples, however many cores there are.
pub fn sample<R: Send>(
    design: &Design,
    go_on: &(dyn Fn() -> bool + Sync),
    run: &(dyn Fn(SamplePlace) -> R + Sync),
) -> Vec<Option<R>> {
    let replicate = |number: usize| {
        let count = design.samples_of_replicate();
        let places: Vec<SamplePlace> =
            (number * count..(number + 1) * count).map(|sample| design.place(sample)).collect();
        let one = |&place: &SamplePlace| go_on().then(|| run(place));
        sweep(&places, &|| true, &one)
    };
    (0..design.replicates()).flat_map(replicate).collect()
}
