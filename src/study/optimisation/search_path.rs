//! How the peels of a search are computed: no further than the number that is asked for, on the mesh of the design at the start.

use super::options::OptimisationOptions;
use crate::model::peel::PeelModel;
use crate::solve::path::options::{PathOptions, Waypoint};
use crate::study::accuracy::{Accuracy, Choice};
use crate::study::checkpoint::Checkpoint;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::peeling::{peel, peel_on};
use crate::study::sensitivity::quantity::PeelQuantity;
use crate::study::stop_criteria::{Stage, StopCriteria, StopReason};
use crate::study::terms::decision::Terms;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How the peel of one factor of an objective is computed in a search. Every design is computed alike, whatever was computed before.
#[derive(Clone, Copy)]
pub(super) struct SearchPath {
    of: PeelQuantity,
    elements: usize,
    reach: Reach,
}

/// How far a path is followed.
#[derive(Clone, Copy)]
enum Reach {
    /// To this displacement, nm
    Displacement(f64),
    /// Until the displacement has turned back
    FirstJump,
    /// To its end
    End,
}

/// A path is followed this many times as far as the initiation peak of the start is.
const BEYOND_PEAK: f64 = 3.0;
/// Path points behind the first jump that its interpolation may use.
const BEHIND: usize = 6;
/// A mesh is as good as that of the start where its error is not this many times what was asked for.
const WORSE_MESH: f64 = 10.0;

impl SearchPath {
    /// From the peel of the design at the start.
    pub fn new(of: PeelQuantity, start: &Peel) -> Self {
        use PeelQuantity::*;
        let reach = match of {
            InitiationPeakForce | InitiationPeakDisplacement => {
                start.initiation_peak.map_or(Reach::End, |peak| Reach::Displacement(BEYOND_PEAK * peak.displacement))
            }
            PeakForce | PeakDisplacement | FirstJumpForce | FirstJumpDisplacement | FirstJumpWork
                if start.snap_off.is_some() =>
            {
                Reach::FirstJump
            }
            _ => Reach::End,
        };
        Self { of, elements: start.effort.elements, reach }
    }

    /// The peel of a design: on another mesh or to its end only where the number is not found otherwise.
    pub fn peel(&self, model: &PeelModel, options: &OptimisationOptions) -> Peel {
        let Accuracy { relative, choice, .. } = options.search;
        let accuracy = Accuracy { relative, choice, terms: Terms::All };
        let fixed = accuracy.with(Choice { elements: Some(self.elements), ..choice });
        let stop = (options.stop)();
        let found = match self.reach {
            Reach::End => peel(model, &fixed, &stop),
            Reach::Displacement(most) => peel(model, &fixed, &StopCriteria { displacement: Some(most), ..stop }),
            Reach::FirstJump => to_first_jump(model, &fixed, stop),
        };
        let good = found.reached_accuracy().is_some_and(|reached| reached <= WORSE_MESH * relative);
        if good && self.of.value(&found).is_some() && !matches!(found.end, PathEnd::Failed(_)) {
            return found;
        }
        peel(model, &accuracy, &(options.stop)())
    }
}

/// The peel as far as a few points behind where the displacement turns back.
fn to_first_jump(model: &PeelModel, accuracy: &Accuracy, stop: StopCriteria) -> Peel {
    let behind = Arc::new(AtomicUsize::new(0));
    let seen = behind.clone();
    let enough = move |stage| {
        let is_over = stage == Stage::Path && seen.load(Ordering::Relaxed) >= BEHIND;
        is_over.then_some(StopReason::Interrupted)
    };
    let keep = |_: &PathOptions, waypoint: Waypoint| {
        let back = waypoint.point.slope.displacement < 0.0;
        behind.store(if back { behind.load(Ordering::Relaxed) + 1 } else { 0 }, Ordering::Relaxed);
    };
    let checkpoint = Checkpoint { taken: &|_| Vec::new(), keep: &keep };
    peel_on(model, accuracy, &stop.or_when(enough), &checkpoint)
}
