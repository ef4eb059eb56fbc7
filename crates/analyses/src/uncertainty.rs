//! Keys of a scene that have distributions, sampled and propagated.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::numbers::{Pulls, SampledPull, WithKnown};
use crate::session::{Parts, Progress, Session};
use peelkit::study::StopCriteria;
use peelkit::study::uncertainty::{
    self, ALONE_AT, Analysis as Found, DerivativesBy, Design, SamplePlace, Sampled, SampledPeel, one_at_a_time,
    taylor_by_differences, taylor_polynomials,
};
use peelkit_report::{self as report, Journal, JournalKind, ReportError, UncertaintySummary, timed};
use peelkit_scene::{Scene, UncertaintyTable};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// What the distributions of a scene make of its results, whatever it describes.
pub struct Uncertainty<'s> {
    scene: &'s Scene,
    table: &'s UncertaintyTable,
    design: Design,
}

impl<'s> Uncertainty<'s> {
    /// Of a scene.
    ///
    /// Fails where it does not say what is uncertain, and where that cannot be sampled.
    pub fn of(scene: &'s Scene) -> Result<Self, Refusal> {
        let table = scene.uncertainty.as_ref().ok_or_else(|| {
            Refusal::scene(
                "nothing is uncertain in this scene: it lacks the table [uncertainty]",
                "Add a line [uncertainty] and below it for example inputs = [{ key = \"strip.height\", distribution = \"normal\", deviation = \"0.5 nm\" }]",
            )
        })?;
        let design =
            Design::new(table.plan(scene)).map_err(|error| Refusal::asked(error, "See peel keys uncertainty."))?;
        Ok(Self { scene, table, design })
    }
}

/// What was found of a sample.
pub struct UncertaintyOutcome {
    /// The sample, and beside it what derivatives give
    pub analysis: Found,
    /// That it took
    pub seconds: f64,
    /// Samples of an earlier run
    pub taken: usize,
    journal: Journal,
}

impl Analysis for Uncertainty<'_> {
    type Found = UncertaintyOutcome;

    fn journal(&self) -> Option<JournalKind> {
        Some(JournalKind::SAMPLE)
    }

    fn run(&self, session: &Session) -> Result<UncertaintyOutcome, Refusal> {
        let Self { scene, table, .. } = *self;
        // a sample depends on the seed and its place, not on how many there are
        let mut one_of_many = scene.clone();
        one_of_many.uncertainty.iter_mut().for_each(|table| table.samples = 0);
        let journal = session.open(JournalKind::SAMPLE, &one_of_many, &[])?;
        session.watcher.see(Progress::Begin(self.design.samples()));
        let taken = AtomicUsize::new(0);
        let samples = Samples { design: &self.design, journal: &journal, taken: &taken, session };
        // a sample that is kept is computed to its end; what is beside the samples is not kept
        let one: &(dyn Fn() -> StopCriteria + Sync) = &|| session.stop_of_one(scene);
        let beside: &(dyn Fn() -> StopCriteria + Sync) = &|| session.stop(scene);
        let (analysis, seconds) = timed(|| match Pulls::like(scene) {
            None => {
                let model = |values: &[f64]| {
                    table.model(scene, values).map_err(|error| format!("{}. {}", error.found, error.remedy))
                };
                let with = |stop| SampledPeel { model: &model, of: &table.quantities, accuracy: &scene.accuracy, stop };
                let taylors = taylor_polynomials(self.design.plan(), &with(beside));
                self.analysis(taylors, &with(beside), &with(one), &samples)
            }
            Some(pulls) => {
                pulls.prepare(scene, &beside());
                let meter = pulls.meter(session, Parts::AtMost(self.pulls()));
                let with = |stop| SampledPull { scene, table, pulls: &pulls, meter: &meter, stop };
                let means: Vec<f64> = self.design.plan().inputs.iter().map(|input| input.distribution.mean()).collect();
                // alone, so that its time is that of one
                let known = with(beside).outcome(&means);
                let beside = WithKnown { sampled: &with(beside), at: means, known };
                let taylors = taylor_by_differences(self.design.plan(), &beside);
                self.analysis((taylors, DerivativesBy::Differences), &beside, &with(one), &samples)
            }
        });
        Ok(UncertaintyOutcome { analysis: analysis?, seconds, taken: taken.into_inner(), journal })
    }
}

impl Uncertainty<'_> {
    /// How many pulls there are: the samples; for the derivatives the means, two to a side of each input and two to a pair; two of each input alone.
    fn pulls(&self) -> usize {
        let inputs = self.design.plan().inputs.len();
        self.design.samples() + 1 + 2 * inputs + inputs * inputs.saturating_sub(1) + 2 * inputs
    }

    /// The sample, with these polynomials, and each input alone.
    fn analysis(
        &self,
        taylors: (Vec<Option<uncertainty::Taylor>>, DerivativesBy),
        beside: &dyn Sampled,
        one: &dyn Sampled,
        samples: &Samples,
    ) -> Result<Found, ReportError> {
        let alone = one_at_a_time(self.design.plan(), ALONE_AT, beside);
        let outcomes = samples.of(one)?;
        Ok(Found::new(self.design.clone(), &self.table.quantities, outcomes, taylors, alone))
    }
}

/// The samples of one run.
struct Samples<'s> {
    design: &'s Design,
    journal: &'s Journal,
    /// Samples of an earlier run
    taken: &'s AtomicUsize,
    session: &'s Session<'s>,
}

impl Samples<'_> {
    /// The outcomes in the order of the samples, those of an earlier run among them; some are missing where it was asked to stop.
    ///
    /// Fails where one cannot be kept.
    fn of(&self, one: &dyn Sampled) -> Result<Vec<Option<uncertainty::Outcome>>, ReportError> {
        let Self { design, journal, taken, session } = *self;
        let run = |at: SamplePlace| {
            let key = [at.replicate, at.point, at.row];
            if let Some(found) = journal.known(&key) {
                taken.fetch_add(1, Ordering::Relaxed);
                session.watcher.see(Progress::Known);
                return found;
            }
            let outcome = one.outcome(&design.inputs(at));
            journal.keep(&key, &outcome);
            session.watcher.see(Progress::Done);
            outcome
        };
        let outcomes = uncertainty::sample(design, &|| !session.watcher.asked() && journal.works(), &run);
        journal.check().map(|()| outcomes)
    }
}

impl UncertaintyOutcome {
    fn summary<'a>(&'a self, scene: &'a Scene) -> UncertaintySummary<'a> {
        UncertaintySummary::new(scene, &self.analysis, self.seconds)
    }

    /// Samples that were computed, of so many.
    fn done(&self) -> [usize; 2] {
        [self.analysis.computed(), self.analysis.design.samples()]
    }
}

impl Outcome for UncertaintyOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(self.summary(scene), command, UncertaintySummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let mut files = vec![self.summary(scene).with_command(command).write(dir)?];
        files.extend(report::write_uncertainty(dir, &self.analysis)?);
        files.push(report::write_samples(dir, &self.analysis)?);
        files.push(report::write_parameters(dir, scene, command)?);
        files.extend(report::draw_uncertainty(&self.analysis, scene, dir)?);
        Ok(files)
    }

    fn end(&self) -> End {
        let [computed, _] = self.done();
        let reasons = self.analysis.cut_short();
        let count: usize = reasons.iter().map(|of| of.count).sum();
        let short = (count > 0).then(|| {
            let lines =
                reasons.iter().map(|of| format!("\n{} times, first at sample {}: {}", of.count, of.first, of.reason));
            format!("{count} of {computed} samples{}", lines.collect::<String>())
        });
        End::of_many(self.done(), "samples", short)
    }

    fn is_written(&self) -> bool {
        self.analysis.computed() > 0
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        let [computed, samples] = self.done();
        Some((&self.journal, computed == samples))
    }
}
