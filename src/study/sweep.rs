//! One parameter varied, each value peeled from rest to its end.

use super::{Accuracy, Bounds, Effort, End, LimitPoint, Peak, Peel, Plateau, peel};
use crate::model::PeelModel;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// One value of a sweep, before it is peeled.
#[derive(Clone, Debug)]
pub struct SweepCase {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    pub model: PeelModel,
    pub accuracy: Accuracy,
    pub bounds: Bounds,
}

/// One value of a sweep and what its peel found.
#[derive(Clone, Debug)]
pub struct SweepRow {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    pub model: PeelModel,
    pub found: Found,
}

/// What a peel found, without its path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Found {
    pub initiation_peak: Option<Peak>,
    pub peak: Option<Peak>,
    pub plateau: Option<Plateau>,
    /// S of the peeling front at the path point nearest to the plateau, nm.
    pub plateau_front: Option<f64>,
    pub snap_off: Option<LimitPoint>,
    /// ∫ P du from rest to the snap-off, or to the end of the path where there is none, aJ
    pub work: Option<f64>,
    pub end: End,
    pub effort: Effort,
    pub solve_s: f64,
}

impl From<&Peel> for Found {
    fn from(peel: &Peel) -> Self {
        Self {
            initiation_peak: peel.initiation_peak,
            peak: peel.peak,
            plateau: peel.plateau,
            plateau_front: peel.plateau.and_then(|plateau| front_at(peel, plateau)),
            snap_off: peel.snap_off,
            work: peel.snap_off.map(|at| at.work).or_else(|| peel.points.last().map(|point| point.work)),
            end: peel.end.clone(),
            effort: peel.effort,
            solve_s: peel.solve_s,
        }
    }
}

/// The front at the path point nearest to a plateau.
fn front_at(peel: &Peel, plateau: Plateau) -> Option<f64> {
    let away =
        |displacement: f64, force: f64| (displacement / plateau.displacement - 1.0).hypot(force / plateau.force - 1.0);
    let nearest =
        peel.points.iter().min_by(|a, b| away(a.displacement, a.force).total_cmp(&away(b.displacement, b.force)));
    nearest.map(|point| point.front)
}

/// Peels the cases, on all cores; the rows come back in the order of the cases and do not depend on the number of
/// threads. `go_on` is asked before each case: once it says no, no other is begun, and the cases that were not begun
/// have no row. `done` is given each row as soon as it is finished. Both are called from any thread.
pub fn sweep(
    cases: &[SweepCase],
    go_on: &(dyn Fn() -> bool + Sync),
    done: &(dyn Fn(&SweepRow) + Sync),
) -> Vec<SweepRow> {
    let row = |case: &SweepCase| {
        let SweepCase { value, model, accuracy, bounds } = case;
        let found = Found::from(&peel(model, accuracy, bounds));
        let row = SweepRow { value: *value, model: model.clone(), found };
        done(&row);
        row
    };
    cases.par_iter().filter(|_| go_on()).map(row).collect()
}
