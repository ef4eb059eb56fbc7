//! Runs the peels of the figures.

use peelkit::model::{PeelModel, StripModel};
use peelkit::study::{Accuracy, Observed, Peel, StopCriteria, observed_retreat, peel, sweep};
use peelkit_report::SweepRow;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Runs peels and counts them.
pub(crate) struct Runner<'a> {
    done: AtomicUsize,
    total: usize,
    progress: &'a (dyn Fn(usize, usize) + Sync),
}

pub(crate) const ACCURACY: Accuracy = Accuracy::to(1e-6);
pub(crate) const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);

impl<'a> Runner<'a> {
    /// `progress` is called with the number of finished peels and `total`, from any thread.
    pub fn new(total: usize, progress: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        Self { done: AtomicUsize::new(0), total, progress }
    }

    /// Reports that nothing is left to do, where fewer peels were run than planned.
    pub fn finish(&self) {
        if self.done.load(Ordering::Relaxed) < self.total {
            (self.progress)(self.total, self.total);
        }
    }

    pub fn peel<'m, M>(&self, model: &'m M) -> Peel
    where
        PeelModel: From<&'m M>,
    {
        let peel = peel(model, &ACCURACY, &BOUNDS);
        self.count();
        peel
    }

    /// The same of several, on all cores, each as far as `bounds` say and as well as `accuracy` says.
    pub fn peel_all(
        &self,
        models: &[PeelModel],
        accuracy: &Accuracy,
        bounds: impl Fn(&PeelModel) -> StopCriteria + Sync,
    ) -> Vec<Peel> {
        let peel = |model: &PeelModel| {
            let peel = peel(model, accuracy, &bounds(model));
            self.count();
            peel
        };
        models.par_iter().map(peel).collect()
    }

    /// Pull-offs under displacement control; all models must have such a test.
    pub fn pull_off_all(&self, models: &[PeelModel], accuracy: &Accuracy, bounds: &StopCriteria) -> Vec<Observed> {
        let test = |model: &PeelModel| {
            let test = observed_retreat(model, accuracy, bounds).expect("a model of a figure has a test");
            self.count();
            test
        };
        models.par_iter().map(test).collect()
    }

    pub fn sweep<M: Clone + Into<PeelModel>>(&self, cases: &[(f64, M)]) -> Vec<SweepRow> {
        self.sweep_to(ACCURACY, cases)
    }

    pub fn sweep_to<M: Clone + Into<PeelModel>>(&self, accuracy: Accuracy, cases: &[(f64, M)]) -> Vec<SweepRow> {
        let cases: Vec<(f64, PeelModel)> = cases.iter().map(|(value, model)| (*value, model.clone().into())).collect();
        let row = |(value, model): &(f64, PeelModel)| {
            let row = SweepRow::of(*value, model.clone(), |model| peel(model, &accuracy, &BOUNDS));
            self.count();
            row
        };
        sweep(&cases, &|| true, &row)
    }

    pub fn count(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        (self.progress)(done, self.total);
    }
}

/// The strip of Section 6 of the paper, of the given length in nm.
pub(crate) fn paper_strip(length: f64) -> StripModel {
    StripModel::of_the_paper(length, 1.0)
}
