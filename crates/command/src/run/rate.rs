//! `peel run` of a scene with a rate: its pull in time, and the equilibria beside it.

use super::progress::RunProgress;
use super::{Run, refuse_asked};
use crate::command_line::command_line;
use crate::interrupt::Interrupt;
use crate::output::{list_files, say};
use crate::stop::Stop;
use crate::text_summary;
use peelkit::solve::ShouldStop;
use peelkit::study::{self, InTimeFailureKind, PullInTime, Stage, StopCriteria};
use peelkit_report::{self as report, RateSummary, timed};
use peelkit_scene::{Scene, TimeTable};
use std::io::{self, Write};
use std::sync::Arc;

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

/// The pull at the rate of a scene.
pub fn run(args: &Run, scene: &Scene, table: &TimeTable) -> Result<(), Stop> {
    refuse(args)?;
    let wanted = args.units.wanted()?;
    let output = args.folder().map(|folder| args.out.claim(&folder)).transpose()?;
    let progress = RunProgress::begin();
    let above = progress.clone();
    let interrupt = Interrupt::listen(move || above.above(|| drop(writeln!(io::stderr(), "{ANSWER}"))));
    let stop = progress.watch(interrupt.ends(scene.bounds.from_now()));
    progress.stage("equilibria");
    let (equilibria, equilibria_s) = timed(|| study::peel(&scene.model, &scene.accuracy, &stop));
    progress.stage("pull in time");
    let (pull, accuracy) = (scene.pull_rate(table), scene.time_accuracy(table));
    let material = table.moving_material();
    let (pulled, solve_s) =
        timed(|| study::pull_in_time(&scene.model, &material, &pull, &accuracy, should_stop(&stop)));
    progress.finish();
    let (pulled, failed): (PullInTime, Option<String>) = match pulled {
        Ok(pulled) => (pulled, None),
        Err(failure) => match failure.reached {
            Some(reached) => (*reached, Some(failure.why.to_string())),
            None => return Err(not_begun(&failure.why)),
        },
    };
    let command = command_line();
    let summary = RateSummary::new(scene, &pulled, &equilibria, failed.as_deref(), [solve_s, equilibria_s]);
    let summary = summary.with_command(&command);
    let files = output.map_or(Ok(Vec::new()), |output| {
        output.write(|dir| {
            let mut files = vec![
                summary.write(dir)?,
                report::write_rate_curve(dir, &pulled)?,
                report::write_equilibria(dir, &equilibria)?,
                report::write_parameters(dir, scene, &command)?,
            ];
            if pulled.points.len() > 1 {
                files.extend(report::draw_rate(dir, &pulled, &equilibria, &scene.title)?);
            }
            Ok(files)
        })
    });
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        let text = text_summary::rate(scene, &pulled, &equilibria, (failed.as_deref(), solve_s + equilibria_s), wanted);
        say(&format!("{text}\n{}", list_files(&files)))?;
    }
    files?;
    match failed {
        Some(_) if interrupt.asked() => Err(Stop::cut_short("interrupted")),
        Some(why) => Err(Stop::cut_short(why)),
        None => Ok(()),
    }
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

/// What stops a step in time.
pub fn should_stop(stop: &StopCriteria) -> Option<ShouldStop> {
    let check = stop.should_stop.clone()?;
    Some(Arc::new(move || check(Stage::Path).is_some()))
}
