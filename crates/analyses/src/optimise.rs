//! The best design of a scene that says what is free.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::numbers::{Meter, Pulls};
use crate::session::{Parts, Progress, Session};
use peelkit::study::optimisation::{
    DesignNumber, DesignProblem, Evaluation, NoOptimum, NumberBy, Objective, OptimisationOptions, Optimum, optimise,
};
use peelkit::study::{PeelQuantity, StopCriteria};
use peelkit_report::{self as report, Journal, JournalKind, OptimisationSummary, ReportError, timed};
use peelkit_scene::{OptimisationTable, Scene};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The search for the best design of a scene.
pub struct Optimisation<'s> {
    scene: &'s Scene,
    table: &'s OptimisationTable,
    problem: Arc<DesignProblem<'static>>,
}

impl<'s> Optimisation<'s> {
    /// Of a scene.
    ///
    /// Fails where it does not say what is free.
    pub fn of(scene: &'s Scene) -> Result<Self, Refusal> {
        let both = scene.optimisation.as_ref().zip(scene.design_problem());
        let (table, problem) = both.ok_or_else(|| {
            Refusal::scene(
                "nothing is free in this scene: it lacks the table [optimise]",
                "Add a line [optimise] and below it for example objective = \"initiation_peak.force_nN\" and width = { from = \"5 nm\", to = \"20 nm\" }; \
                 `peel keys optimise` lists its keys.",
            )
        })?;
        Ok(Self { scene, table, problem: Arc::new(problem) })
    }
}

/// The number of the pull of a design.
fn number(
    pulls: &Pulls,
    meter: &Meter,
    design: &Scene,
    of: PeelQuantity,
    stop: &StopCriteria,
) -> Result<DesignNumber, String> {
    let found = meter.over(|| pulls.pulled(design, stop))?;
    let none = || found.curve.short.clone().unwrap_or_else(|| "its pull has none".to_owned());
    let (value, error) = found.value(of).ok_or_else(none)?;
    Ok(DesignNumber { value, error, curve: found.curve.points() })
}

impl Optimisation<'_> {
    /// How many pulls there are at most: the designs of every search, the neighbours, and the design at the start and the best one.
    fn pulls(&self) -> usize {
        let each = if matches!(self.problem.objective, Objective::Ratio { .. }) { 2 } else { 1 };
        each * (self.table.starts * self.table.evaluations + self.table.neighbours + 2)
    }
}

/// The best design that was found.
pub struct OptimisationOutcome {
    /// What was optimised
    pub problem: Arc<DesignProblem<'static>>,
    /// The best design
    pub optimum: Optimum,
    /// That it took
    pub seconds: f64,
    /// Designs of an earlier run
    pub taken: usize,
    journal: Journal,
}

impl Analysis for Optimisation<'_> {
    type Found = OptimisationOutcome;

    fn journal(&self) -> Option<JournalKind> {
        Some(JournalKind::OPTIMISATION)
    }

    fn run(&self, session: &Session) -> Result<OptimisationOutcome, Refusal> {
        let Self { scene, table, problem } = self;
        let journal = session.open(JournalKind::OPTIMISATION, scene, &[])?;
        session.watcher.see(Progress::Begin(table.starts * table.evaluations));
        let keep = |design: &Evaluation| {
            session.watcher.see(Progress::Done);
            journal.keep(&(&design.coordinates, design.with_gradient), design);
        };
        let options = OptimisationOptions {
            stop: &|| session.stop_of_one(scene),
            go_on: &|| !session.watcher.asked() && journal.works(),
            known: &|coordinates, with_gradient| journal.known(&(coordinates, with_gradient)),
            keep: &|_, design| keep(design),
            ..table.options(scene.accuracy)
        };
        let (found, seconds) = timed(|| match Pulls::like(scene).zip(scene.design_problem()) {
            None => optimise(problem, &options),
            Some((pulls, problem)) => {
                pulls.prepare(scene, &session.stop(scene));
                let meter = pulls.meter(session, Parts::AtMost(self.pulls()));
                let of = problem.objective.quantity();
                let number = |values: &[f64], angle: Option<f64>, stop: &StopCriteria| {
                    let mut design = scene.of_design(values).ok_or("there is no such model")?;
                    design.model.pull.angle = angle.unwrap_or(design.model.pull.angle);
                    number(&pulls, &meter, &design, of, stop)
                };
                optimise(&DesignProblem { number: NumberBy::Values(Box::new(number)), ..problem }, &options)
            }
        });
        let taken = journal.entries();
        journal.check()?;
        let optimum = found.map_err(|error| match error {
            NoOptimum::AllBad { .. } => Refusal::cut_short(error),
            error => Refusal::scene(
                format!("there is no optimum: {error}"),
                "Change the table [optimise]; `peel run` of the same scene shows what its peel has.",
            ),
        })?;
        Ok(OptimisationOutcome { problem: Arc::clone(problem), optimum, seconds, taken, journal })
    }
}

impl OptimisationOutcome {
    fn summary<'a>(&'a self, scene: &'a Scene) -> OptimisationSummary<'a> {
        OptimisationSummary::new(scene, &self.problem, &self.optimum, self.seconds)
    }

    /// The best design as a scene of its own.
    pub fn best(&self, scene: &Scene) -> Option<Scene> {
        scene.of_design(&self.optimum.after.values)
    }
}

impl Outcome for OptimisationOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(self.summary(scene), command, OptimisationSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let Self { problem, optimum, .. } = self;
        let summary = self.summary(scene).with_command(command);
        let mut files = vec![summary.write(dir)?, report::write_history(dir, problem, optimum)?];
        if let Some(best) = self.best(scene) {
            let path = dir.join("optimum.toml");
            report::write_whole(&path, best.to_toml().as_bytes())?;
            files.push(path);
        }
        files.push(report::write_parameters(dir, scene, command)?);
        files.extend(report::draw_optimum(problem, optimum, scene, dir)?);
        Ok(files)
    }

    fn end(&self) -> End {
        if !self.optimum.unfinished {
            return End::Done;
        }
        let designs: usize = self.optimum.searches.iter().map(|search| search.evaluations.len()).sum();
        End::Interrupted { done: Some(format!("{designs} designs are evaluated")), short: None }
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        Some((&self.journal, !self.optimum.unfinished))
    }
}
