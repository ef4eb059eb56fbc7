//! The values of a sweep computed on all cores, each kept as soon as it is done, and taken up again by the same command after it was interrupted.

use super::args::Sweep;
use super::cases::{Case, Cases};
use crate::interrupt::Interrupt;
use crate::output::progress_bar;
use indicatif::ProgressBar;
use peelkit::study;
use peelkit_report::{OutputFolder, PartialFile, PartialSweep, ReportError, Storable, timed};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// What was found of a case, in so many seconds.
pub struct Found<'c, F> {
    pub case: &'c Case,
    pub found: F,
    pub solve_s: f64,
}

/// What was found of all cases, in their order; after Ctrl-C some are missing.
pub struct Computed<'c, F> {
    pub all: Vec<Found<'c, F>>,
    /// Where it comes from, if there is something to say of that.
    pub remarks: Vec<String>,
    /// Where files go, if they are written.
    pub output: Option<OutputFolder>,
    folder: Option<PathBuf>,
}

/// What is found of a case.
type Of<'o, F> = &'o (dyn Fn(&Case) -> F + Sync);

/// Computes every case; nothing is kept where no files are written.
pub fn compute<'c, F>(args: &Sweep, scene: &Scene, cases: &'c Cases, of: Of<F>) -> Result<Computed<'c, F>, ReportError>
where
    F: Storable + Send + Sync,
{
    let bar = progress_bar(cases.all.len());
    let Some(folder) = args.folder() else {
        return Ok(Computed { all: unkept(&cases.all, &bar, of), remarks: Vec::new(), output: None, folder: None });
    };
    // before anything is written
    let above = bar.clone();
    let answer = "stopping when the values being computed are done; Ctrl-C again stops at once";
    let interrupt = Interrupt::listen(move || above.println(answer));
    let open = |dir: &Path| PartialSweep::<F>::open(dir, scene, cases.keys, args.part);
    let (partial, output) = args.out.claim_unfinished(&folder, args.fresh, open)?;
    let kept = Kept { partial, bar, interrupt };
    let (all, taken) = kept.compute(&cases.all, of)?;
    let remark = format!("{taken} of {} values taken from an earlier, interrupted run", cases.all.len());
    let remarks = Some(remark).filter(|_| taken > 0).into_iter().collect();
    Ok(Computed { all, remarks, output: Some(output), folder: Some(folder) })
}

impl<F: Storable> Computed<'_, F> {
    /// Removes what was kept: all is computed and written.
    pub fn discard(&self) -> Result<(), ReportError> {
        self.folder.as_ref().map_or(Ok(()), |folder| PartialSweep::<F>::discard(folder))
    }
}

fn one<'c, F>(case: &'c Case, of: Of<F>) -> Found<'c, F> {
    let (found, solve_s) = timed(|| of(case));
    Found { case, found, solve_s }
}

fn unkept<'c, F: Send>(cases: &'c [Case], bar: &ProgressBar, of: Of<F>) -> Vec<Found<'c, F>> {
    let all: Vec<&Case> = cases.iter().collect();
    let run = |&case: &&'c Case| {
        let found = one(case, of);
        bar.inc(1);
        found
    };
    let all = study::sweep(&all, &|| true, &run);
    bar.finish_and_clear();
    all
}

/// A sweep whose finished values are kept while it runs.
struct Kept<F> {
    partial: PartialSweep<F>,
    bar: ProgressBar,
    interrupt: Interrupt,
}

impl<F: Storable + Send + Sync> Kept<F> {
    /// What is found of the cases, in their order, what an earlier run found among it, and how many that are.
    fn compute<'c>(&self, cases: &'c [Case], of: Of<F>) -> Result<(Vec<Found<'c, F>>, usize), ReportError> {
        let known = |case: &Case| self.partial.found(case.value, case.second);
        let missing: Vec<&Case> = cases.iter().filter(|case| known(case).is_none()).collect();
        let taken = cases.len() - missing.len();
        let mut computed = self.compute_missing(&missing, taken, of)?.into_iter().peekable();
        let found = |case: &'c Case| match known(case) {
            Some((found, solve_s)) => Some(Found { case, found: found.clone(), solve_s }),
            None => computed.next_if(|next| (next.case.value, next.case.second) == (case.value, case.second)),
        };
        Ok((cases.iter().filter_map(found).collect(), taken))
    }

    /// Stops on Ctrl-C, and with an error where something cannot be kept.
    fn compute_missing<'c>(
        &self,
        missing: &[&'c Case],
        taken: usize,
        of: Of<F>,
    ) -> Result<Vec<Found<'c, F>>, ReportError> {
        self.bar.set_position(taken as u64);
        // what was taken says nothing about the time to go
        self.bar.reset_eta();
        let trouble = OnceLock::new();
        let run = |&case: &&'c Case| {
            let found = one(case, of);
            let place = (case.value, case.second);
            if let Err(error) = self.partial.keep_found(place, &found.found, found.solve_s) {
                // only the first one is reported
                let _ = trouble.set(error);
            }
            self.bar.inc(1);
            found
        };
        let all = study::sweep(missing, &|| !self.interrupt.asked() && trouble.get().is_none(), &run);
        self.bar.finish_and_clear();
        trouble.into_inner().map_or(Ok(all), Err)
    }
}
