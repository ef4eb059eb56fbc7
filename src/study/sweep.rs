//! One parameter varied, each value peeled from rest to its end.

use super::{Accuracy, Bounds, Peel, peel};
use crate::model::StripModel;
use rayon::prelude::*;

/// One value of a sweep and the peel computed for it.
#[derive(Clone, Debug)]
pub struct SweepRow {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    pub peel: Peel,
}

/// Peels every case, on all cores; the rows come back in the order of the cases and do not depend on the number of
/// threads. `done` is called once a finished case, from any thread.
pub fn sweep(
    cases: &[(f64, StripModel)],
    accuracy: &Accuracy,
    bounds: &Bounds,
    done: &(dyn Fn() + Sync),
) -> Vec<SweepRow> {
    cases
        .par_iter()
        .map(|&(value, model)| {
            let row = SweepRow { value, peel: Peel { trace: None, ..peel(&model, accuracy, bounds) } };
            done();
            row
        })
        .collect()
}
