//! `peel run` of a scene with a rate: its pull in time, and the equilibria beside it.

use super::progress::RunProgress;
use super::{Run, refuse_asked};
use crate::command_line::command_line;
use crate::interrupt::Interrupt;
use crate::output::{list_files, say};
use crate::rate::{pull_beam, pull_seta};
use crate::seta;
use crate::stop::Stop;
use crate::text_summary::{self, LawOfTips};
use peelkit::model::{PullCurve, Seta};
use peelkit::study::{self, InTimeFailureKind, Peel, SetaInTime, SetaInTimeFailureKind, SetaPullOff, StopCriteria};
use peelkit_report::{self as report, Equilibria, PulledAtRate, RateSummary, ReportError, timed};
use peelkit_scene::{Scene, SetaTable, TimeTable};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What a first Ctrl-C does.
const ANSWER: &str = "stopping at the next step in time; Ctrl-C again stops at once";

/// What of `peel run` has no meaning for a pull at a rate.
fn refuse(args: &Run) -> Result<(), Stop> {
    let asked = [
        (args.observed, "--observed", "it follows the jumps themselves"),
        (args.out_of_plane, "--out-of-plane", "the stability is that of equilibria"),
        (args.branch, "--branch", "branches are those of equilibria"),
        (args.sensitivities, "--sensitivities", "the derivatives of its results are not computed"),
        (args.states.is_some(), "--states", "the fields along the beam are written of equilibria alone"),
        (args.animate, "--animate", "equilibria alone are animated"),
    ];
    refuse_asked(&asked, "a pull at a rate", ", or remove [time] from the scene to follow the equilibria.")
}

/// What was found of the pull of a scene.
struct Found {
    pulled: PulledAtRate,
    failed: Option<String>,
    equilibria: Equilibria,
    /// Of the pull and of the equilibria
    seconds: [f64; 2],
    own: Own,
}

/// What was pulled.
enum Own {
    Beam(Box<Peel>),
    Seta(Box<OfSeta>),
}

/// A seta, with the law of its tips, which took so many seconds.
struct OfSeta {
    seta: Seta,
    tip: PullCurve,
    tip_s: f64,
    pulled: SetaInTime,
    pull_off: SetaPullOff,
}

/// The pull at the rate of a scene.
pub fn run(args: &Run, scene: &Scene, table: &TimeTable) -> Result<(), Stop> {
    refuse(args)?;
    let wanted = args.units.wanted()?;
    let output = args.folder().map(|folder| args.out.claim(&folder)).transpose()?;
    let progress = RunProgress::begin();
    let above = progress.clone();
    let interrupt = Interrupt::listen(move || above.above(|| drop(writeln!(io::stderr(), "{ANSWER}"))));
    let stop = progress.watch(interrupt.ends(scene.bounds.from_now()));
    let found = match &scene.seta {
        None => of_beam(scene, table, &stop, &progress),
        Some(seta) => of_seta(scene, table, seta, &stop, &progress),
    };
    progress.finish();
    let found = found?;
    let command = command_line();
    let summary = found.summary(scene).with_command(&command);
    let files = output.map_or(Ok(Vec::new()), |output| {
        output.write(|dir| {
            let mut files = vec![summary.write(dir)?, report::write_rate_curve(dir, &found.pulled)?];
            files.extend(found.own.write(dir)?);
            files.push(report::write_parameters(dir, scene, &command)?);
            if found.pulled.points.len() > 1 {
                files.extend(report::draw_rate(dir, &found.pulled, &found.equilibria, &scene.title)?);
            }
            Ok(files)
        })
    });
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        let Found { pulled, failed, equilibria, seconds, own } = &found;
        let solve_s = seconds.iter().sum::<f64>() + own.law().map_or(0.0, |law| law.seconds);
        let text = text_summary::rate(scene, (pulled, equilibria), own.law(), (failed.as_deref(), solve_s), wanted);
        say(&format!("{text}\n{}", list_files(&files)))?;
    }
    files?;
    match found.failed {
        Some(_) if interrupt.asked() => Err(Stop::cut_short("interrupted")),
        Some(why) => Err(Stop::cut_short(why)),
        None => Ok(()),
    }
}

fn of_beam(scene: &Scene, table: &TimeTable, stop: &StopCriteria, progress: &RunProgress) -> Result<Found, Stop> {
    progress.stage("equilibria");
    let (equilibria, equilibria_s) = timed(|| study::peel(&scene.model, &scene.accuracy, stop));
    progress.stage("pull in time");
    let (pulled, solve_s) = timed(|| pull_beam(scene, table, stop));
    let (pulled, failed) = pulled.map_err(|why| not_begun(&why))?;
    Ok(Found {
        pulled: PulledAtRate::from(&pulled),
        failed,
        equilibria: Equilibria::from(&equilibria),
        seconds: [solve_s, equilibria_s],
        own: Own::Beam(Box::new(equilibria)),
    })
}

fn of_seta(
    scene: &Scene,
    table: &TimeTable,
    seta: &SetaTable,
    stop: &StopCriteria,
    progress: &RunProgress,
) -> Result<Found, Stop> {
    progress.stage("law of the tips");
    let (tip, tip_s) = timed(|| seta::tip_curve(scene));
    let tip = tip.map_err(Stop::cut_short)?;
    let model = seta::model(scene, seta, seta.law(tip.clone()));
    progress.stage("equilibria");
    let (pull_off, equilibria_s) =
        timed(|| study::pull_off(&model, &scene.seta_loading(seta), &seta::options(scene), stop));
    let pull_off =
        pull_off.map_err(|error| Stop::bad_input(error, "`peel keys seta` lists the keys with their ranges."))?;
    progress.stage("pull in time");
    let (pulled, solve_s) = timed(|| pull_seta(scene, (table, seta), &model, stop));
    let (pulled, failed) = pulled.map_err(|why| match &why {
        SetaInTimeFailureKind::InTime(why) => not_begun(why),
        _ => Stop::cut_short(&why),
    })?;
    Ok(Found {
        pulled: PulledAtRate::from(&pulled),
        failed,
        equilibria: Equilibria::from(&pull_off),
        seconds: [solve_s, equilibria_s],
        own: Own::Seta(Box::new(OfSeta { seta: model.seta, tip, tip_s, pulled, pull_off })),
    })
}

/// Why there is no pull: what of the scene is wrong, or no equilibrium at its start.
fn not_begun(why: &InTimeFailureKind) -> Stop {
    match why {
        InTimeFailureKind::Model(_) | InTimeFailureKind::OutOfRange { .. } => {
            Stop::bad_input(why, "`peel keys time` lists the keys with their ranges.")
        }
        _ => Stop::cut_short(why),
    }
}

impl Found {
    fn summary<'a>(&'a self, scene: &'a Scene) -> RateSummary<'a> {
        let summary = RateSummary::new(scene, &self.pulled, &self.equilibria, self.failed.as_deref(), self.seconds);
        match &self.own {
            Own::Beam(_) => summary,
            Own::Seta(own) => summary.with_seta(own.seta.tips(), &own.tip, &own.pulled, own.tip_s),
        }
    }
}

impl Own {
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

    fn law(&self) -> Option<LawOfTips<'_>> {
        match self {
            Self::Beam(_) => None,
            Self::Seta(own) => Some(LawOfTips {
                tips: own.seta.tips(),
                curve: &own.tip,
                events: &own.pulled.events,
                seconds: own.tip_s,
            }),
        }
    }
}
