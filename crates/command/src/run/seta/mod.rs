//! `peel run` of a scene with a seta: its pull-off.

mod by_table;
mod kept;
mod sampler;

use super::progress::RunProgress;
use super::{GOES_ON, Run, refuse_asked};
use crate::command_line::command_line;
use crate::interrupt::Interrupt;
use crate::output::{list_files, say};
use crate::seta::{TipLawOf, options, tip_curve};
use crate::stop::Stop;
use crate::text_summary;
use by_table::{Pull, Pulled};
use kept::KeptSeta;
use peelkit::model::{PullCurve, SetaModel};
use peelkit::study::{self, Bound, SetaEnd, SetaPoint, SetaPullOff, SetaState};
use peelkit_report::{self as report, ReportError, SetaSummary, timed};
use peelkit_scene::{Scene, SetaTable};
use sampler::Sampler;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What a first Ctrl-C does.
const ANSWER: &str = "stopping at the next equilibrium of the seta; Ctrl-C again stops at once";
/// States of an animation.
const FRAMES: usize = 60;

/// What of `peel run` has no meaning for a seta.
fn refuse(args: &Run) -> Result<(), Stop> {
    let asked = [
        (args.observed, "--observed", "its pull-off is displacement-controlled, with every jump as an event"),
        (args.out_of_plane, "--out-of-plane", "it is in space, and its stability is that in space"),
        (args.branch, "--branch", "it is in space, and follows stable branches alone"),
        (args.sensitivities, "--sensitivities", "the derivatives of its results are not computed"),
    ];
    refuse_asked(&asked, "a seta", "; curve.csv and events.csv hold the pull-off with its jumps.")
}

/// The pull-off of the seta of a scene.
pub fn run(args: &Run, scene: &Scene, table: &SetaTable) -> Result<(), Stop> {
    refuse(args)?;
    let wanted = args.units.wanted()?;
    let states = (args.states.unwrap_or(0) as usize).max(if args.animate { FRAMES } else { 0 });
    let sampler = Sampler::new(states);
    let open = |folder: PathBuf| KeptSeta::open(&args.out, args.fresh, &folder, scene, &sampler);
    let mut kept = args.folder().map(open).transpose()?;
    let progress = RunProgress::begin();
    let above = progress.clone();
    let interrupt = Interrupt::listen(move || above.above(|| drop(writeln!(io::stderr(), "{ANSWER}"))));
    let stop = progress.watch(interrupt.ends(scene.bounds.from_now()));
    progress.stage("law of the tips");
    let (tip, tip_s) = timed(|| tip_curve(scene));
    let tip = tip.map_err(Stop::cut_short)?;
    let (law, table_s) = timed(|| TipLawOf::new(scene, table, &stop));
    let law = law?;
    let tip_s = tip_s + table_s;
    let loading = scene.seta_loading(table);
    let options = options(scene);
    let mut see = |point: &SetaPoint| progress.seta(point);
    let pull = Pull { scene, table, loading: &loading, options: &options, stop: &stop, states };
    let (pulled, solve_s) = timed(|| pull.pulled(law, &tip, kept.as_mut(), &mut see));
    let Pulled { model, law, followed, outside } = pulled?;
    let pull_off = &followed.pull_off;
    let sampler = followed.sampler();
    progress.stage("peak on finer meshes");
    let wanted_error = scene.accuracy.relative;
    let (peak, peak_s) = timed(|| study::converged_peak(&model, &loading, &options, pull_off, wanted_error, &stop));
    let peak = peak.map_err(Stop::other)?;
    // nothing of what comes behind the pull-off is kept
    let interrupted = interrupt.quit_next() && matches!(pull_off.end, SetaEnd::Bound(Bound::Interrupted));
    progress.finish();
    let command = command_line();
    let found = Found { scene, model: &model, tip: &tip, pull_off, command: &command };
    let summary = SetaSummary::new(scene, &table.seta, &tip, (pull_off, peak.as_ref()), [tip_s, solve_s, peak_s])
        .with_command(&command)
        .with_table(law.growing())
        .with_outside(outside.as_ref());
    let (files, left) = kept
        .as_mut()
        .map_or((Ok(Vec::new()), None), |kept| kept.write(&followed, |dir| found.write(dir, &summary, sampler, args)));
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        let (found, seconds) = ((pull_off, peak.as_ref()), tip_s + solve_s + peak_s);
        let text = text_summary::seta(scene, &model, (&tip, law.growing(), outside.as_ref()), found, seconds, wanted);
        let taken = text_summary::equilibria_taken(kept.as_ref().map_or(0, KeptSeta::taken));
        let left = left.as_ref().map(|left| format!("\n{left}: {GOES_ON}\n")).unwrap_or_default();
        say(&format!("{text}{taken}\n{}{left}", list_files(&files)))?;
    }
    files?;
    match &pull_off.end {
        SetaEnd::Failed(failure) => Err(Stop::cut_short(failure)),
        SetaEnd::Bound(_) if interrupted => match left {
            Some(left) => Err(Stop::cut_short(format!("interrupted; {left}: {GOES_ON}"))),
            None => Err(Stop::cut_short("interrupted")),
        },
        SetaEnd::Completed | SetaEnd::Bound(_) => {
            let unknown = outside.filter(|outside| !outside.peak_is_inside);
            unknown.map_or(Ok(()), |outside| Err(Stop::cut_short(outside)))
        }
    }
}

/// The states that have names.
fn moments(pull_off: &SetaPullOff) -> Vec<(&'static str, &SetaState)> {
    let all = [
        ("first-detachment", &pull_off.first_detachment),
        ("peak", &pull_off.peak),
        ("last-detachment", &pull_off.last_detachment),
        ("end", &pull_off.last),
    ];
    all.into_iter().filter_map(|(name, state)| Some((name, state.as_ref()?))).collect()
}

/// What a run found.
struct Found<'f> {
    scene: &'f Scene,
    model: &'f SetaModel,
    tip: &'f PullCurve,
    pull_off: &'f SetaPullOff,
    command: &'f str,
}

impl Found<'_> {
    fn write(
        &self,
        dir: &Path,
        summary: &SetaSummary,
        sampler: &Sampler,
        args: &Run,
    ) -> Result<Vec<PathBuf>, ReportError> {
        let Self { scene, model, pull_off, .. } = *self;
        let seta = &model.seta;
        let mut files = vec![
            summary.write(dir)?,
            report::write_seta_curve(dir, pull_off)?,
            report::write_seta_events(dir, pull_off, seta)?,
            report::write_tips(dir, seta, &moments(pull_off))?,
            report::write_tip_curve(dir, self.tip)?,
            report::write_parameters(dir, scene, self.command)?,
        ];
        if pull_off.points.len() > 1 {
            files.extend(report::draw_pull_off(dir, pull_off, seta, &scene.title)?);
        }
        let seen = |count| sampler.evenly(count, moments(pull_off).into_iter().map(|(_, state)| state.clone()));
        if let Some(count) = args.states {
            let poses: Vec<_> = seen(count as usize).iter().map(|state| report::SetaPose::of(state, seta)).collect();
            files.extend(report::write_seta_states(dir, &poses)?);
        }
        let frames = if args.animate { seen(FRAMES) } else { Vec::new() };
        if frames.len() > 1 {
            files.push(report::write_seta_animation(dir, pull_off, &frames, seta, &scene.title)?);
        }
        Ok(files)
    }
}
