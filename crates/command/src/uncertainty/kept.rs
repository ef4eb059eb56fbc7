//! A sample whose results are kept as they come, and taken up again by the same command after it was interrupted.

use super::Uncertainty;
use crate::interrupt::Interrupt;
use crate::output::progress_bar;
use indicatif::ProgressBar;
use peelkit::study::StopCriteria;
use peelkit::study::uncertainty::{Design, Outcome, SamplePlace, Sampled, sample};
use peelkit_report::{OutputFolder, PartialFile, PartialUncertainty, ReportError};
use peelkit_scene::Scene;
use std::path::PathBuf;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Runs the samples of one command.
pub struct Sampler {
    /// Where files go, if they are written
    pub output: Option<OutputFolder>,
    kept: Option<(PathBuf, PartialUncertainty)>,
    bar: ProgressBar,
    interrupt: Interrupt,
    /// Samples of an earlier command
    taken: AtomicUsize,
}

impl Sampler {
    /// A folder that keeps the samples of an unfinished command is one to go on with; any other that holds something is refused.
    pub fn open(args: &Uncertainty, scene: &Scene, samples: usize) -> Result<Self, ReportError> {
        let folder = match &args.out.out {
            None if args.json => None,
            None => Some(args.scene.default_folder(&["uncertainty".to_owned()])),
            given => given.clone(),
        };
        let open = |folder: PathBuf| {
            let both = args.out.claim_unfinished(&folder, args.fresh, |dir| PartialUncertainty::open(dir, scene));
            both.map(|both| (folder, both))
        };
        let opened = folder.map(open).transpose()?;
        let (output, kept) = match opened {
            Some((folder, (partial, output))) => (Some(output), Some((folder, partial))),
            None => (None, None),
        };
        let bar = progress_bar(samples);
        let above = bar.clone();
        let answer = "stopping when the samples being computed are done; Ctrl-C again stops at once";
        let interrupt = Interrupt::listen(move || above.println(answer));
        Ok(Self { output, kept, bar, interrupt, taken: AtomicUsize::new(0) })
    }

    /// Criteria that also end a path where the user has asked to stop.
    pub fn ends(&self, stop: StopCriteria) -> StopCriteria {
        self.interrupt.ends(stop)
    }

    /// The outcomes in the order of the samples, those of an earlier run among them. After Ctrl-C some are missing.
    ///
    /// Fails where one cannot be kept.
    pub fn sample(&self, design: &Design, of: &dyn Sampled) -> Result<Vec<Option<Outcome>>, ReportError> {
        let trouble = OnceLock::new();
        let partial = self.kept.as_ref().map(|(_, partial)| partial);
        let run = |at: SamplePlace| {
            if let Some(found) = partial.and_then(|partial| partial.found(at)) {
                self.taken.fetch_add(1, Ordering::Relaxed);
                self.bar.inc(1);
                // what was taken says nothing about the time to go
                self.bar.reset_eta();
                return found.clone();
            }
            let outcome = of.outcome(&design.inputs(at));
            if let Some(Err(error)) = partial.map(|partial| partial.keep(at, &outcome)) {
                // only the first one is reported
                let _ = trouble.set(error);
            }
            self.bar.inc(1);
            outcome
        };
        let outcomes = sample(design, &|| !self.interrupt.asked() && trouble.get().is_none(), &run);
        self.bar.finish_and_clear();
        trouble.into_inner().map_or(Ok(outcomes), Err)
    }

    /// Where samples come from that were not computed now.
    pub fn remark(&self) -> Option<String> {
        let taken = self.taken.load(Ordering::Relaxed);
        let samples = self.bar.length().unwrap_or_default();
        (taken > 0).then(|| format!("{taken} of {samples} samples taken from an earlier, interrupted run"))
    }

    /// Removes what was kept: all is computed and written.
    pub fn discard(&self) -> Result<(), ReportError> {
        self.kept.as_ref().map_or(Ok(()), |(folder, _)| PartialUncertainty::discard(folder))
    }
}
