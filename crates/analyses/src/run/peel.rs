//! The whole path of equilibria of a scene, with what is asked for beside it.

use super::asked::Asked;
use super::kept_path;
use super::sensitivities::{self, Exponents};
use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::session::Session;
use peelkit::model::PeelModel;
use peelkit::study::{
    self, Events, Failure, NoEquilibrium, NoTest, NotOutOfPlane, Observed, OutOfPlane, OutOfPlaneBranch, PathEnd, Peel,
    Stations, StopCriteria, TestEnd,
};
use peelkit_report::{self as report, Journal, JournalKind, Marked, PassedAt, PeelSummary, ReportError, timed};
use peelkit_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The path of a scene that can be computed.
pub struct PeelRun<'s> {
    scene: &'s Scene,
    asked: Asked,
}

impl<'s> PeelRun<'s> {
    /// Of a scene without seta and without rate.
    ///
    /// Fails where something that is asked for has no meaning for this scene.
    pub fn of(scene: &'s Scene, asked: Asked) -> Result<Self, Refusal> {
        refuse_out_of_plane(scene, asked)?;
        refuse_branch(scene, asked)?;
        if asked.sensitivities {
            sensitivities::refuse(scene)?;
        }
        if asked.observed {
            refuse_test(scene)?;
        }
        Ok(Self { scene, asked })
    }
}

fn refuse_out_of_plane(scene: &Scene, asked: Asked) -> Result<(), Refusal> {
    let why = if asked.looks_out_of_plane() { NotOutOfPlane::of(&scene.model) } else { None };
    let Some(why) = why else { return Ok(()) };
    let (what, option) = match asked.branch {
        true => ("the branch out of the plane is not followed", "--branch"),
        false => ("the stability out of the plane is not computed", "--out-of-plane"),
    };
    Err(Refusal::asked(format!("{what}: {why}"), why.remedy().replace("--out-of-plane", option)))
}

/// Refuses a scene whose branch is none that is computed in space.
fn refuse_branch(scene: &Scene, asked: Asked) -> Result<(), Refusal> {
    let checked = if asked.branch { PeelModel::left_plane(&scene.model).check() } else { Ok(()) };
    checked.map_err(|why| {
        Refusal::asked(
            format!("the branch out of the plane is not followed: in space `{}` {}", why.key(), why.found()),
            "Omit --branch: --out-of-plane alone says where the planar path loses its stability.",
        )
    })
}

/// Refuses a scene that has no displacement-controlled test before its path is computed. A fault of its model is reported with its path.
fn refuse_test(scene: &Scene) -> Result<(), Refusal> {
    match study::no_test(&scene.model, &scene.accuracy) {
        None | Some(NoTest::Model(_)) => Ok(()),
        Some(none) => Err(without_test(&none)),
    }
}

fn without_test(none: &NoTest) -> Refusal {
    Refusal::asked(format!("there is no observed test: {none}"), none.remedy())
}

/// What a run has found.
pub struct PeelOutcome {
    /// The path
    pub peel: Arc<Peel>,
    /// That the path took
    pub seconds: f64,
    /// The stability of the path against leaving its plane
    pub stability: Option<OutOfPlane>,
    /// Where it was looked for, the branch that leaves the plane, if there is one
    pub branch: Option<Option<OutOfPlaneBranch>>,
    /// The displacement-controlled test
    pub test: Option<Observed>,
    /// The equilibria at the values that the scene asks for
    pub stations: Vec<Stations>,
    /// Where its events lie
    pub events: Vec<Events>,
    /// That the stability, the branch and the test took
    pub beside_s: [f64; 3],
    /// By which power of each parameter the results change
    pub exponents: Option<Exponents>,
    /// Path points of an earlier run
    pub taken: usize,
    /// Why something that was asked for is missing
    missing: Option<String>,
    interrupted: bool,
    asked: Asked,
    journal: Journal,
}

/// What there is of something that was asked for, and why it is missing.
fn or_why<T, E: ToString>(found: Result<Option<T>, E>) -> (Option<T>, Option<String>) {
    match found {
        Ok(found) => (found, None),
        Err(why) => (None, Some(why.to_string())),
    }
}

impl Analysis for PeelRun<'_> {
    type Found = PeelOutcome;

    fn journal(&self) -> Option<JournalKind> {
        Some(JournalKind::RUN)
    }

    fn run(&self, session: &Session) -> Result<PeelOutcome, Refusal> {
        let Self { scene, asked } = *self;
        let journal = kept_path::open(scene, session)?;
        let taken = journal.entries();
        let (peel, seconds) = timed(|| path(scene, &journal, session));
        let asked_to_stop = session.watcher.nothing_more_is_kept();
        let interrupted = asked_to_stop && peel.unfinished;
        let looked_at = asked.looks_out_of_plane() && !peel.points.is_empty();
        let (stability, stability_s) = timed(|| looked_at.then(|| peel.out_of_plane()).transpose());
        let (stability, unknown) = or_why(stability);
        let follows = asked.branch && !interrupted && stability.is_some();
        let (branch, branch_s) = timed(|| {
            let branch = || {
                session.stage("branch out of the plane");
                peel.branch(&session.stop(scene))
            };
            follows.then(branch).transpose()
        });
        let (branch, not_followed) = or_why(branch);
        let stations =
            if interrupted { Vec::new() } else { scene.stations.iter().map(|&at| peel.stations(at)).collect() };
        let events = if interrupted { Vec::new() } else { at_events(scene, &peel) };
        let of_events = events.iter().flat_map(|events: &Events| &events.missed);
        let missed = stations
            .iter()
            .flat_map(|stations: &Stations| &stations.missed)
            .chain(of_events)
            .next()
            .map(ToString::to_string);
        let differentiated = asked.sensitivities && !interrupted && peel.points.len() > 1;
        let exponents = || {
            session.stage("sensitivities");
            Exponents::of(scene, &peel)
        };
        let (exponents, no_exponents) = or_why(differentiated.then(exponents).transpose());
        let (test, test_s) = timed(|| (asked.observed && !interrupted).then(|| observed(scene, session)));
        let test = test.transpose()?;
        Ok(PeelOutcome {
            stability,
            branch,
            test,
            beside_s: [stability_s, branch_s, test_s],
            exponents,
            stations,
            events,
            taken,
            missing: missed.or(no_exponents).or(unknown).or(not_followed),
            interrupted,
            asked,
            journal,
            ..PeelOutcome::of(Arc::new(peel), seconds)
        })
    }
}

/// The path, from what an earlier run has kept of it.
fn path(scene: &Scene, journal: &Journal, session: &Session) -> Peel {
    let stop = StopCriteria { events: scene.events.clone(), ..session.stop(scene) };
    kept_path::on(journal, session, |checkpoint| study::peel_on(&scene.model, &scene.accuracy, &stop, checkpoint))
}

/// The equilibria of a path at the values that a scene asks for.
fn at_stations(scene: &Scene, peel: &Peel) -> Vec<Stations> {
    scene.stations.iter().map(|&at| peel.stations(at)).collect()
}

/// Where its events lie.
fn at_events(scene: &Scene, peel: &Peel) -> Vec<Events> {
    scene.events.iter().map(|at| peel.events(at)).collect()
}

/// The displacement-controlled test of a scene.
fn observed(scene: &Scene, session: &Session) -> Result<Observed, Refusal> {
    session.stage("displacement-controlled test");
    study::observed(&scene.model, &scene.accuracy, &StopCriteria { events: scene.looked_for(), ..session.stop(scene) })
        .map_err(|none| without_test(&none))
}

impl PeelOutcome {
    /// Of a path that took so many seconds, with nothing beside it.
    pub fn of(peel: Arc<Peel>, seconds: f64) -> Self {
        Self {
            peel,
            seconds,
            stability: None,
            branch: None,
            test: None,
            beside_s: [0.0; 3],
            stations: Vec::new(),
            events: Vec::new(),
            exponents: None,
            taken: 0,
            missing: None,
            interrupted: false,
            asked: Asked::default(),
            journal: Journal::nowhere(),
        }
    }

    /// The same with the equilibria at the values that its scene asks for.
    pub fn with_stations(self, scene: &Scene) -> Self {
        Self { stations: at_stations(scene, &self.peel), events: at_events(scene, &self.peel), ..self }
    }

    fn summary<'a>(&'a self, scene: &'a Scene) -> PeelSummary<'a> {
        let [stability_s, branch_s, test_s] = self.beside_s;
        let mut summary = PeelSummary::new(scene, &self.peel, self.seconds);
        if let Some(test) = &self.test {
            summary = summary.with_observed(test, test_s);
        }
        if let Some(stability) = &self.stability {
            summary = summary.with_out_of_plane(stability, stability_s);
        }
        if let Some(branch) = &self.branch {
            summary = summary.with_branch(branch.as_ref(), branch_s);
        }
        summary = summary.with_stations(&self.stations).with_events(&self.events);
        if let Some(Exponents { found, keys, .. }) = &self.exponents {
            summary = summary.with_sensitivities(found, keys);
        }
        summary
    }
}

impl Outcome for PeelOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(self.summary(scene), command, PeelSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let Self { peel, test, exponents, asked, .. } = self;
        let (stability, branch) = (self.stability.as_ref(), self.branch.iter().flatten().next());
        let mut files = vec![
            self.summary(scene).with_command(command).write(dir)?,
            report::write_curve(dir, peel, stability)?,
            report::write_limit_points(dir, peel)?,
        ];
        if !peel.step_ways.is_empty() {
            files.push(report::write_steps(dir, peel)?);
            files.extend(report::draw_steps(peel, scene, dir)?);
        }
        if !(self.stations.is_empty() && self.events.is_empty()) {
            files.push(report::write_stations(dir, &self.stations, &self.events)?);
        }
        files.push(report::write_parameters(dir, scene, command)?);
        if peel.points.len() > 1 {
            let marked = Marked::of_path(&self.stations, &self.events);
            files.extend(report::draw_peel_with_branch(peel, stability, branch, &marked, scene, dir)?);
        }
        if let Some(branch) = branch {
            files.push(report::write_branch(dir, branch)?);
        }
        if let Some(count) = asked.states {
            let states = peel.states(count as usize);
            files.push(report::write_states(dir, &states)?);
            files.extend(report::write_vtk(dir, &states)?);
        }
        if let Some(Exponents { found, keys, .. }) = exponents.as_ref().filter(|exponents| !exponents.found.is_empty())
        {
            files.extend(report::draw_sensitivities(found, keys, scene, dir)?);
        }
        if let Some(test) = test {
            files.push(report::write_observed(dir, test)?);
            if test.points.len() > 1 {
                files.extend(report::draw_observed(test, &PassedAt::of_test(test, &scene.looked_for()), scene, dir)?);
            }
        }
        if asked.animate && peel.points.len() > 1 {
            files.push(report::write_animation(dir, peel, &scene.title)?);
        }
        Ok(files)
    }

    fn end(&self) -> End {
        if self.interrupted {
            return End::Interrupted { done: None, short: None };
        }
        if let PathEnd::Failed(Failure::NoStart(NoEquilibrium::Unstable { why })) = &self.peel.end {
            let found = format!("the model is refused, there is no stable state at rest: {why}");
            return End::Refused { found, remedy: why.remedy().to_string() };
        }
        let of_path = match &self.peel.end {
            PathEnd::Failed(reason) => Some(reason.to_string()),
            _ => None,
        };
        let of_test = || match &self.test.as_ref()?.end {
            TestEnd::Failed(reason) => Some(format!("in the displacement-controlled test, {reason}")),
            _ => None,
        };
        let of_branch = || match &self.branch.as_ref()?.as_ref()?.peel.end {
            PathEnd::Failed(reason) => Some(format!("on the branch out of the plane, {reason}")),
            _ => None,
        };
        let why = of_path.or_else(of_test).or_else(|| self.missing.clone()).or_else(of_branch);
        why.map_or(End::Done, End::CutShort)
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        Some((&self.journal, !self.peel.unfinished))
    }
}
