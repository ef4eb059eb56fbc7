//! The pull-off of a seta as a function of uncertain keys.

use crate::seta::Setae;
use peelkit::study::uncertainty::{Outcome, Sampled};
use peelkit::study::{PeelQuantity, SetaResult, StopCriteria};
use peelkit_report::seta_end_reason;
use peelkit_scene::{Scene, UncertaintyTable};

/// The pull-off of the seta of a scene with any values of its uncertain keys.
#[derive(Clone, Copy)]
pub struct SampledSeta<'s> {
    pub scene: &'s Scene,
    pub table: &'s UncertaintyTable,
    pub setae: &'s Setae,
    /// The stop criteria of one pull-off, anew for each
    pub stop: &'s (dyn Fn() -> StopCriteria + Sync),
}

impl Sampled for SampledSeta<'_> {
    fn numbers(&self) -> usize {
        self.table.quantities.len()
    }

    fn outcome(&self, inputs: &[f64]) -> Outcome {
        let scene = self.table.scene(self.scene, inputs).map_err(|error| format!("{}. {}", error.found, error.remedy));
        match scene.and_then(|scene| self.setae.pull_off(&scene, &(self.stop)())) {
            Ok(found) => Outcome {
                values: self.table.quantities.iter().map(|&of| value(of, &found)).collect(),
                cut_short: seta_end_reason(&found.end),
            },
            Err(why) => Outcome::refused(self.numbers(), why),
        }
    }
}

/// A number of a pull-off: none that it does not have, and none of one that stopped short, whose largest force may lie ahead.
fn value(of: PeelQuantity, found: &SetaResult) -> Option<f64> {
    let peak = found.peak.filter(|_| !found.end.is_cut_short())?;
    match of {
        PeelQuantity::PeakForce => Some(peak.force),
        PeelQuantity::PeakDisplacement => Some(peak.displacement),
        _ => None,
    }
}
