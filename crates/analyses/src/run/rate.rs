//! The pull of a scene at its rate, and the equilibria beside it.

use super::asked::{self, Asked};
use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::rate::{pull_beam, pull_seta};
use crate::pulls::seta;
use crate::session::Session;
use peelkit::model::{PullCurve, Seta};
use peelkit::study::{self, InTimeFailureKind, Peel, SetaInTime, SetaInTimeFailureKind, SetaPullOff, StopCriteria};
use peelkit_report::{self as report, Equilibria, PassedAt, PulledAtRate, RateSummary, ReportError, timed};
use peelkit_scene::{Scene, SetaTable, TimeTable};
use std::io;
use std::path::{Path, PathBuf};

/// The pull of a scene at its rate.
pub struct RateRun<'s> {
    scene: &'s Scene,
    table: &'s TimeTable,
}

impl<'s> RateRun<'s> {
    /// Of a scene with a rate.
    ///
    /// Fails where something is asked for that has no meaning for a pull at a rate.
    pub fn of(scene: &'s Scene, asked: Asked) -> Result<Self, Refusal> {
        let options = [
            (asked.observed, "--observed", "it follows the jumps themselves"),
            (asked.out_of_plane, "--out-of-plane", "the stability is that of equilibria"),
            (asked.branch, "--branch", "branches are those of equilibria"),
            (asked.sensitivities, "--sensitivities", "the derivatives of its results are not computed"),
            (asked.states.is_some(), "--states", "the fields along the beam are written of equilibria alone"),
            (asked.animate, "--animate", "equilibria alone are animated"),
        ];
        asked::refuse(&options, "a pull at a rate", ", or remove [time] from the scene to follow the equilibria.")?;
        let table = scene.time.as_ref().ok_or_else(|| Refusal::scene("it has no table [time]", "Add one."))?;
        Ok(Self { scene, table })
    }
}

/// A pull at a rate, as far as it went.
pub struct RateOutcome {
    /// The pull
    pub pulled: PulledAtRate,
    /// Why it stopped short
    pub failed: Option<String>,
    /// Without rate
    pub equilibria: Equilibria,
    /// That the pull and the equilibria took
    pub seconds: [f64; 2],
    /// What was pulled
    pub of: Pull,
    interrupted: bool,
}

/// What was pulled.
pub enum Pull {
    /// A beam, with its path of equilibria
    Beam(Box<Peel>),
    /// A seta
    Seta(Box<OfSeta>),
}

/// A seta that was pulled, with the law of its tips.
pub struct OfSeta {
    /// The seta
    pub seta: Seta,
    /// The curve of the normal pull of a tip
    pub tip: PullCurve,
    /// That this curve took
    pub tip_s: f64,
    /// The pull
    pub pulled: SetaInTime,
    /// The equilibria beside it
    pub pull_off: SetaPullOff,
}

impl Analysis for RateRun<'_> {
    type Found = RateOutcome;

    fn run(&self, session: &Session) -> Result<RateOutcome, Refusal> {
        let stop = session.stop(self.scene);
        let found = match &self.scene.seta {
            None => self.of_beam(&stop, session)?,
            Some(seta) => self.of_seta(seta, &stop, session)?,
        };
        Ok(RateOutcome { interrupted: session.watcher.asked(), ..found })
    }
}

impl RateRun<'_> {
    /// The same stop criteria with the stations and events of the scene, which are those of the pull and not of the equilibria beside it.
    fn looking(&self, stop: &StopCriteria) -> StopCriteria {
        StopCriteria { events: self.scene.looked_for(), ..stop.clone() }
    }

    fn of_beam(&self, stop: &StopCriteria, session: &Session) -> Result<RateOutcome, Refusal> {
        let Self { scene, table } = *self;
        session.stage("equilibria");
        let (equilibria, equilibria_s) = timed(|| study::peel(&scene.model, &scene.accuracy, stop));
        session.stage("pull in time");
        let (pulled, solve_s) = timed(|| pull_beam(scene, table, &self.looking(stop)));
        let (pulled, failed) = pulled.map_err(|why| not_begun(&why))?;
        Ok(RateOutcome {
            pulled: PulledAtRate::from(&pulled),
            failed,
            equilibria: Equilibria::from(&equilibria),
            seconds: [solve_s, equilibria_s],
            of: Pull::Beam(Box::new(equilibria)),
            interrupted: false,
        })
    }

    fn of_seta(&self, seta: &SetaTable, stop: &StopCriteria, session: &Session) -> Result<RateOutcome, Refusal> {
        let Self { scene, table } = *self;
        session.stage("law of the tips");
        let (tip, tip_s) = timed(|| seta::tip_curve(scene));
        let tip = tip.map_err(Refusal::cut_short)?;
        let model = seta::model(scene, seta, seta.law(tip.clone()));
        session.stage("equilibria");
        let (pull_off, equilibria_s) =
            timed(|| study::pull_off(&model, &scene.seta_loading(seta), &seta::options(scene), stop));
        let pull_off =
            pull_off.map_err(|error| Refusal::asked(error, "`peel keys seta` lists the keys with their ranges."))?;
        session.stage("pull in time");
        let (pulled, solve_s) = timed(|| pull_seta(scene, (table, seta), &model, &self.looking(stop)));
        let (pulled, failed) = pulled.map_err(|why| match &why {
            SetaInTimeFailureKind::InTime(why) => not_begun(why),
            _ => Refusal::cut_short(&why),
        })?;
        Ok(RateOutcome {
            pulled: PulledAtRate::from(&pulled),
            failed,
            equilibria: Equilibria::from(&pull_off),
            seconds: [solve_s, equilibria_s],
            of: Pull::Seta(Box::new(OfSeta { seta: model.seta, tip, tip_s, pulled, pull_off })),
            interrupted: false,
        })
    }
}

/// Why there is no pull: what of the scene is wrong, or no equilibrium at its start.
fn not_begun(why: &InTimeFailureKind) -> Refusal {
    match why {
        InTimeFailureKind::Model(_) | InTimeFailureKind::OutOfRange { .. } => {
            Refusal::asked(why, "`peel keys time` lists the keys with their ranges.")
        }
        _ => Refusal::cut_short(why),
    }
}

impl RateOutcome {
    fn summary<'a>(&'a self, scene: &'a Scene) -> RateSummary<'a> {
        let summary = RateSummary::new(scene, &self.pulled, &self.equilibria, self.failed.as_deref(), self.seconds);
        match &self.of {
            Pull::Beam(_) => summary,
            Pull::Seta(own) => summary.with_seta(own.seta.tips(), &own.tip, &own.pulled, own.tip_s),
        }
    }
}

impl Outcome for RateOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(self.summary(scene), command, RateSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let pulled = &self.pulled;
        let mut files =
            vec![self.summary(scene).with_command(command).write(dir)?, report::write_rate_curve(dir, pulled)?];
        files.extend(self.of.write(dir)?);
        files.push(report::write_parameters(dir, scene, command)?);
        let passed = PassedAt::of_rate(pulled, &scene.looked_for());
        if !passed.is_empty() {
            files.push(report::write_passed(dir, &passed)?);
        }
        if pulled.points.len() > 1 {
            files.extend(report::draw_rate(dir, (pulled, &passed), &self.equilibria, scene)?);
        }
        Ok(files)
    }

    fn end(&self) -> End {
        match &self.failed {
            Some(_) if self.interrupted => End::Interrupted { done: None, short: None },
            Some(why) => End::CutShort(why.clone()),
            None => End::Done,
        }
    }
}

impl Pull {
    /// The tables that a beam, or a seta, has besides the curve.
    fn write(&self, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
        match self {
            Self::Beam(equilibria) => Ok(vec![report::write_equilibria(dir, equilibria)?]),
            Self::Seta(own) => Ok(vec![
                report::write_seta_equilibria(dir, &own.pull_off)?,
                report::write_seta_rate_events(dir, &own.pulled, &own.seta)?,
                report::write_tip_curve(dir, &own.tip)?,
            ]),
        }
    }
}
