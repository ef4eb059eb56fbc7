//! The designs of an optimisation, kept as they are evaluated and taken up again by the same command after it was interrupted.

use super::Optimise;
use crate::interrupt::Interrupt;
use crate::output::progress_bar;
use indicatif::ProgressBar;
use peelkit::study::optimisation::Evaluation;
use peelkit_report::{OutputFolder, PartialFile, PartialOptimisation, ReportError};
use peelkit_scene::Scene;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// What is kept of one command.
pub struct Keeper {
    /// Where files go, if they are written
    pub output: Option<OutputFolder>,
    kept: Option<(PathBuf, PartialOptimisation)>,
    bar: ProgressBar,
    interrupt: Interrupt,
    /// The first design that could not be kept
    trouble: Mutex<Option<ReportError>>,
    failed: AtomicBool,
}

impl Keeper {
    /// A folder that keeps the designs of an unfinished command is one to go on with; any other that holds something is refused. At most so many
    /// designs are evaluated.
    pub fn open(args: &Optimise, scene: &Scene, designs: usize) -> Result<Self, ReportError> {
        let folder = match &args.out.out {
            None if args.json => None,
            None => Some(args.scene.default_folder(&["optimise".to_owned()])),
            given => given.clone(),
        };
        let open = |folder: PathBuf| {
            let both = args.out.claim_unfinished(&folder, args.fresh, |dir| PartialOptimisation::open(dir, scene));
            both.map(|both| (folder, both))
        };
        let opened = folder.map(open).transpose()?;
        let (output, kept) = match opened {
            Some((folder, (partial, output))) => (Some(output), Some((folder, partial))),
            None => (None, None),
        };
        let bar = progress_bar(designs);
        let above = bar.clone();
        let answer = "stopping when the designs being evaluated are done; Ctrl-C again stops at once";
        let interrupt = Interrupt::listen(move || above.println(answer));
        Ok(Self { output, kept, bar, interrupt, trouble: Mutex::new(None), failed: AtomicBool::new(false) })
    }

    /// Whether another design may be evaluated.
    pub fn goes_on(&self) -> bool {
        !self.interrupt.asked() && !self.failed.load(Ordering::Relaxed)
    }

    /// What an earlier run found of a design.
    pub fn known(&self, coordinates: &[f64]) -> Option<Evaluation> {
        self.kept.as_ref()?.1.found(coordinates).cloned()
    }

    /// Keeps a design.
    pub fn keep(&self, design: &Evaluation) {
        self.bar.inc(1);
        if let Some(Err(error)) = self.kept.as_ref().map(|(_, partial)| partial.keep(design)) {
            self.failed.store(true, Ordering::Relaxed);
            let mut trouble = self.trouble.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
            trouble.get_or_insert(error);
        }
    }

    /// Ends the bar.
    ///
    /// Fails where a design could not be kept.
    pub fn finish(&self) -> Result<(), ReportError> {
        self.bar.finish_and_clear();
        let mut trouble = self.trouble.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        trouble.take().map_or(Ok(()), Err)
    }

    /// How many designs come from an earlier run, in words.
    pub fn taken_text(&self) -> String {
        let taken = self.kept.as_ref().map_or(0, |(_, partial)| partial.taken());
        if taken == 0 { String::new() } else { format!("\n{taken} designs taken from an earlier, interrupted run\n") }
    }

    /// Removes what was kept: all is computed and written.
    pub fn discard(&self) -> Result<(), ReportError> {
        self.kept.as_ref().map_or(Ok(()), |(folder, _)| PartialOptimisation::discard(folder))
    }
}
