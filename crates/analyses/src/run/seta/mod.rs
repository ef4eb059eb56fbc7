//! The pull-off of the seta of a scene.

mod by_table;
mod follow;
mod of_beams;
mod sampler;

use super::asked::{self, Asked};
use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::seta::{PulledSeta, TipLawOf, options, tip_curve};
use crate::session::{Progress, Session};
use by_table::{Pull, Pulled};
use follow::{KeptSeta, is_unfinished};
use peelkit::model::{PullCurve, Seta};
use peelkit::study::coarsening::{GrowingTable, OutsideTable};
use peelkit::study::{Bound, ConvergedPeak, SetaEnd, SetaPoint, SetaPullOff, SetaState, StopCriteria};
use peelkit_report::{self as report, Journal, JournalKind, PassedAt, ReportError, SetaSummary, timed};
use peelkit_scene::{Scene, SetaTable};
use sampler::Sampler;
use std::io;
use std::path::{Path, PathBuf};

/// States of an animation.
const FRAMES: usize = 60;

/// The pull-off of the seta of a scene.
pub struct SetaRun<'s> {
    scene: &'s Scene,
    table: &'s SetaTable,
    asked: Asked,
}

impl<'s> SetaRun<'s> {
    /// Of a scene with a seta and without rate.
    ///
    /// Fails where something is asked for that has no meaning for a seta.
    pub fn of(scene: &'s Scene, asked: Asked) -> Result<Self, Refusal> {
        let options = [
            (asked.observed, "--observed", "its pull-off is displacement-controlled, with every jump as an event"),
            (asked.out_of_plane, "--out-of-plane", "it is in space, and its stability is that in space"),
            (asked.branch, "--branch", "it is in space, and follows stable branches alone"),
            (asked.sensitivities, "--sensitivities", "the derivatives of its results are not computed"),
        ];
        asked::refuse(&options, "a seta", "; curve.csv and events.csv hold the pull-off with its jumps.")?;
        let table = scene.seta.as_ref().ok_or_else(|| Refusal::scene("it has no table [seta]", "Add one."))?;
        Ok(Self { scene, table, asked })
    }
}

/// The pull-off of a seta, with the law of its tips.
pub struct SetaOutcome {
    /// The curve of the normal pull of a tip
    pub tip: PullCurve,
    /// The largest force on finer meshes, where it was found there
    pub peak: Option<ConvergedPeak>,
    /// Tips that are outside of their table, which does not grow any more
    pub outside: Option<OutsideTable>,
    /// That the law of the tips, the pull-off and the finer meshes took
    pub seconds: [f64; 3],
    /// Equilibria of an earlier run
    pub taken: usize,
    of: PulledSeta,
    law: TipLawOf,
    sampler: Sampler,
    interrupted: bool,
    asked: Asked,
    kept: KeptSeta,
}

impl Analysis for SetaRun<'_> {
    type Found = SetaOutcome;

    fn journal(&self) -> Option<JournalKind> {
        Some(JournalKind::SETA)
    }

    fn run(&self, session: &Session) -> Result<SetaOutcome, Refusal> {
        let Self { scene, table, asked } = *self;
        let states = (asked.states.unwrap_or(0) as usize).max(if asked.animate { FRAMES } else { 0 });
        let mut kept = KeptSeta::open(session, scene, &Sampler::new(states))?;
        let plain = session.stop(scene);
        let stop = StopCriteria { events: scene.looked_for(), ..plain.clone() };
        session.stage("law of the tips");
        let (tip, tip_s) = timed(|| tip_curve(scene));
        let tip = tip.map_err(Refusal::cut_short)?;
        let (law, table_s) = timed(|| TipLawOf::new(scene, table, &stop));
        let law = law?;
        let (loading, options) = (scene.seta_loading(table), options(scene));
        let mut see = |point: &SetaPoint| session.watcher.see(Progress::Equilibrium(point));
        let pull = Pull { scene, table, loading: &loading, options: &options, stop: &stop, states };
        let (pulled, solve_s) = timed(|| pull.pulled(law, &tip, &mut kept, &mut see));
        let Pulled { of, law, sampler, outside } = pulled?;
        session.stage("peak on finer meshes");
        let (peak, peak_s) = timed(|| of.peak(scene, table, &plain));
        let peak = peak.map_err(|error| Refusal::Other(error.to_string()))?;
        // nothing of what comes behind the pull-off is kept
        let asked_to_stop = session.watcher.nothing_more_is_kept();
        let interrupted = asked_to_stop && matches!(of.pull_off().end, SetaEnd::Bound(Bound::Interrupted));
        Ok(SetaOutcome {
            tip,
            peak,
            outside,
            seconds: [tip_s + table_s, solve_s, peak_s],
            taken: kept.taken(),
            of,
            law,
            sampler,
            interrupted,
            asked,
            kept,
        })
    }
}

impl SetaOutcome {
    /// The pull-off.
    pub fn pull_off(&self) -> &SetaPullOff {
        self.of.pull_off()
    }

    /// What was pulled off.
    pub fn seta(&self) -> &Seta {
        self.of.seta()
    }

    /// Order of its elements.
    pub fn order(&self) -> usize {
        self.of.order()
    }

    /// The table that the tips follow, where they follow one.
    pub fn table(&self) -> Option<&GrowingTable> {
        self.law.growing()
    }

    fn summary<'a>(&'a self, scene: &'a Scene) -> SetaSummary<'a> {
        SetaSummary::new(scene, self.seta(), &self.tip, (self.pull_off(), self.peak.as_ref()), self.seconds)
            .with_table(self.table())
            .with_outside(self.outside.as_ref())
    }

    /// The states that have names.
    fn moments(&self) -> Vec<(&'static str, &SetaState)> {
        let pull_off = self.pull_off();
        let all = [
            ("first-detachment", &pull_off.first_detachment),
            ("peak", &pull_off.peak),
            ("last-detachment", &pull_off.last_detachment),
            ("end", &pull_off.last),
        ];
        all.into_iter().filter_map(|(name, state)| Some((name, state.as_ref()?))).collect()
    }

    /// So many states along the pull-off, evenly, with those that have names: of those that the run was asked to keep.
    pub fn states(&self, count: usize) -> Vec<SetaState> {
        self.sampler.evenly(count, self.moments().into_iter().map(|(_, state)| state.clone()))
    }
}

impl Outcome for SetaOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(self.summary(scene), command, SetaSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let (pull_off, seta) = (self.pull_off(), self.seta());
        let mut files = vec![
            self.summary(scene).with_command(command).write(dir)?,
            report::write_seta_curve(dir, pull_off)?,
            report::write_seta_events(dir, pull_off, seta)?,
            report::write_tips(dir, seta, &self.moments())?,
            report::write_tip_curve(dir, &self.tip)?,
            report::write_parameters(dir, scene, command)?,
        ];
        let passed = PassedAt::of_pull_off(pull_off, &scene.looked_for());
        if !passed.is_empty() {
            files.push(report::write_passed(dir, &passed)?);
        }
        if pull_off.points.len() > 1 {
            files.extend(report::draw_pull_off(dir, pull_off, seta, &passed, scene)?);
        }
        if let Some(count) = self.asked.states {
            let states = self.states(count as usize);
            let poses: Vec<_> = states.iter().map(|state| report::SetaPose::of(state, seta)).collect();
            files.extend(report::write_seta_states(dir, &poses)?);
        }
        let frames = if self.asked.animate { self.states(FRAMES) } else { Vec::new() };
        if frames.len() > 1 {
            files.push(report::write_seta_animation(dir, pull_off, &frames, seta, &scene.title)?);
        }
        Ok(files)
    }

    fn end(&self) -> End {
        match &self.pull_off().end {
            SetaEnd::Failed(failure) => End::CutShort(failure.to_string()),
            SetaEnd::Bound(_) if self.interrupted => End::Interrupted { done: None, short: None },
            SetaEnd::Completed | SetaEnd::Bound(_) => {
                let unknown = self.outside.as_ref().filter(|outside| !outside.peak_is_inside);
                unknown.map_or(End::Done, |outside| End::CutShort(outside.to_string()))
            }
        }
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        Some((self.kept.journal(), !is_unfinished(self.pull_off())))
    }
}
