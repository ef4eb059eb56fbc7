//! One value of a sweep of whole peels.

use super::timing::timed;
use peelkit::model::PeelModel;
use peelkit::study::{Peel, PeelResult};

/// One value of a sweep and what its peel found.
#[derive(Clone, Debug)]
pub struct SweepRow {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    /// The value of the second one, where two are varied.
    pub second: Option<f64>,
    /// What was peeled.
    pub model: PeelModel,
    /// Peak, plateau, snap-off and end: forces in nN, displacements in nm, work in aJ.
    pub found: PeelResult,
    /// Wall clock that the peel took, s.
    pub solve_s: f64,
}

impl SweepRow {
    /// What `peel` finds of a model, of a sweep over one parameter.
    pub fn of(value: f64, model: PeelModel, peel: impl FnOnce(&PeelModel) -> Peel) -> Self {
        let (found, solve_s) = timed(|| PeelResult::from(&peel(&model)));
        Self { value, second: None, model, found, solve_s }
    }
}
