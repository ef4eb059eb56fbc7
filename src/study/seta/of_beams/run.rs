//! Step after step of the loading the root is moved along stable equilibria, up to where they lose their stability. There the seta comes to rest with
//! its root held, by gradient flow, and goes on.
//!
//! A spatula whose free end has turned up by more than 45 degrees stands on the face of its end: what that face would hold is not what a pad holds by,
//! so it lets go there and does not adhere until it is clear of the ground.

use super::piece::PieceEnd;
use super::progress::{AT_END, BeamsProgress, BeamsPullOff, NUDGE, Run, SeeBeams, location};
use crate::model::seta::check::SetaError;
use crate::model::seta::spatulae::SetaOfBeams;
use crate::solve::error::SolveError;
use crate::solve::newton::{Solution, solve};
use crate::solve::path::options::PathOptions;
use crate::solve::relax::{Held, RelaxError, RelaxOptions, Relaxation, relax, relax_until};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::seta::loading::{SetaLoading, SetaStart, SetaStep, StepEnd};
use crate::study::seta::result::{EventCause, SetaEnd, SetaEvent, SetaFailure, SetaPullOff, TipChange};
use crate::study::seta::standing::RootDrive;
use crate::study::states::seta_state::TipState;
use std::sync::Arc;

/// A spatula that let go adheres again once it is so far from the ground, over the distance within which its law acts.
const CLEAR: f64 = 10.0;
/// Longest step of a relaxation, and the share of an energy that is round-off: stored energy and adhesion are much larger than their sum.
const RELAXING: RelaxOptions = RelaxOptions { round_off: 1e-12, ..RelaxOptions::by(0.3) };
/// Most losses of stability in one step of the loading.
const MOST_LOSSES: usize = 1000;
/// How far the root is moved on where a path is stuck, over the time before, and at most, nm.
const MORE: f64 = 4.0;
const LONGEST_NUDGE: f64 = 20.0;
/// An energy that is released, aJ, below which nothing has happened.
const NOTHING: f64 = 1e-3;
/// A jump may take so much of the energy: that is the error of its work. More of it says that the mesh is too coarse.
const BALANCED: f64 = 1e-4;

/// Pulls a seta of beams off as the loading says, from its start or from what an earlier run of the same has reached.
///
/// # Errors
/// What of the seta or of the loading cannot be computed. Where the computation stops short, the result says so and has what was reached.
pub fn pull_off_of_beams(
    model: &SetaOfBeams,
    loading: &SetaLoading,
    options: &PathOptions,
    stop: &StopCriteria,
    reached: Option<BeamsProgress>,
    see: &mut SeeBeams,
) -> Result<BeamsPullOff, SetaError> {
    let is_new = reached.is_none();
    let mut run = Run::new(model, loading, options, stop, reached, see)?;
    if is_new && let Err(cause) = run.start() {
        let end = SetaEnd::Failed(SetaFailure::NoStart { cause });
        return Ok(BeamsPullOff { result: SetaPullOff { end, ..run.reached.result }, before_peak: None });
    }
    let end = run.go().err().unwrap_or(SetaEnd::Completed);
    let last = run.reached.here.as_ref().map(|here| run.state(&here.at, run.last(), None));
    let BeamsProgress { result, before_peak, .. } = run.reached;
    Ok(BeamsPullOff { result: SetaPullOff { last, end, ..result }, before_peak })
}

impl Run<'_> {
    /// The equilibrium at the start.
    fn start(&mut self) -> Result<(), SolveError> {
        let drive = RootDrive::new(self.loading.steps[0].direction, self.reached.from);
        let at = match self.loading.start {
            SetaStart::Adhering => self.model.lying(&self.tree),
            SetaStart::Above(height) => self.tree.stress_free_above(height),
        };
        self.reached.here = Some(self.at_rest(&drive, at, 0.0)?);
        Ok(())
    }

    fn go(&mut self) -> Result<(), SetaEnd> {
        while let Some(step) = self.loading.steps.get(self.reached.step) {
            let drive = RootDrive::new(step.direction, self.reached.from);
            self.go_step(step, &drive)?;
            let reached = &mut self.reached;
            (reached.from, reached.displacement) = (drive.root(reached.displacement), 0.0);
            // the next step counts from here
            if let Some(here) = &mut reached.here {
                Arc::make_mut(here).observables.displacement = 0.0;
            }
            (reached.step, reached.losses, reached.ahead) = (reached.step + 1, 0, NUDGE);
        }
        Ok(())
    }

    /// A step of the loading, to its end.
    fn go_step(&mut self, step: &SetaStep, drive: &RootDrive) -> Result<(), SetaEnd> {
        while self.reached.losses < MOST_LOSSES {
            let points = self.reached.result.points.len();
            let (at, start, nudge) = match self.follow(step, drive)? {
                PieceEnd::Done => {
                    return self.bound_of_displacement().map_or(Ok(()), |bound| Err(SetaEnd::Bound(bound)));
                }
                PieceEnd::Lost(at, start) => (at, *start, 0.0),
                PieceEnd::Stuck(_, cause) if self.reached.ahead > LONGEST_NUDGE => return Err(self.lost(cause)),
                PieceEnd::Stuck(at, _) => {
                    let (start, left) = (at.at.clone(), self.left(step, &at));
                    (at, start, self.reached.ahead.min(left))
                }
            };
            // where the path has gone on, the next time it is stuck is another one
            let has_gone_on = self.reached.result.points.len() > points + 2;
            self.reached.ahead = if has_gone_on { NUDGE } else { MORE * self.reached.ahead };
            self.reached.losses += 1;
            let rest = self.lose(drive, &at, start, nudge)?;
            if matches!(step.until, StepEnd::Detached(_)) && self.is_off(&rest.at) {
                return Ok(());
            }
        }
        Err(self.lost(SolveError::LimitPointNotConfirmed))
    }

    /// How far the root may go at most in a step, nm.
    fn left(&self, step: &SetaStep, at: &Solution) -> f64 {
        let PathConstraint { weights, target } = self.target(step);
        if weights == Observables::DISPLACEMENT { target - at.observables.displacement } else { f64::INFINITY }
    }

    /// From where stability is lost to where the seta comes to rest; where it is not known to be lost there, with the root a little farther on, nm.
    fn lose(&mut self, drive: &RootDrive, at: &Solution, start: State, ahead: f64) -> Result<Arc<Solution>, SetaEnd> {
        let (before, displacement, step) = (self.last(), at.observables.displacement + ahead, self.reached.step);
        let left = self.state(&at.at, before, Some(location(at, ahead)));
        let rest = self.at_rest(drive, start, displacement);
        let rest = rest.map_err(|cause| match self.is_cut_short(&cause) {
            true => self.lost(cause),
            false => SetaEnd::Failed(SetaFailure::Restless { step, displacement, changes: 0, cause }),
        })?;
        let change = |(tip, own): (usize, &TipState)| {
            let to = self.branch(&rest.at, tip);
            (own.on != to).then_some(TipChange { tip, to, load: own.load })
        };
        let tips: Vec<TipChange> = left.tips.iter().enumerate().filter_map(change).collect();
        let mut after = self.point(drive, &rest, before);
        // a tip that lets go does so at the beginning; where none does the seta may have gone on as it was
        let force = if tips.is_empty() { 0.5 * (before.force_along + after.force_along) } else { before.force_along };
        let work = ahead * force;
        let released = before.energy + work - rest.energy;
        after.work += work;
        let has_gone_on = ahead > 0.0 && tips.is_empty() && released.abs() < NOTHING;
        after.released += if has_gone_on { 0.0 } else { released };
        let behind = self.push(&rest, after, None);
        self.keep_peak(&behind, None);
        if !has_gone_on {
            if self.is_last() && tips.iter().any(|tip| !tip.to.adheres()) {
                self.reached.result.first_detachment.get_or_insert_with(|| left.clone());
                self.reached.result.last_detachment = Some(left.clone());
            }
            let imbalance = -released / before.energy.abs().max(rest.energy.abs());
            if imbalance > BALANCED {
                return Err(SetaEnd::Failed(SetaFailure::Unbalanced { step, displacement, imbalance }));
            }
            let cause = if tips.is_empty() { EventCause::Buckling } else { EventCause::Tips };
            self.reached.result.events.push(SetaEvent { before, after, cause, tips, released });
        }
        let stopped = self.reached.result.take_jump(&self.stop.events, &left, &behind);
        (self.see)(&behind, Some(&self.reached));
        stopped.map(|()| rest)
    }

    /// The stable equilibrium to which the energy falls with the root held; spatulae that come to stand on their end let go on the way.
    pub(crate) fn at_rest(
        &mut self,
        drive: &RootDrive,
        mut at: State,
        displacement: f64,
    ) -> Result<Arc<Solution>, SolveError> {
        loop {
            let (problem, held) = (self.problem(drive), Held::Displacement(displacement));
            let mut ws = std::mem::take(&mut self.ws);
            let ended = relax_until(&problem, at, held, &RELAXING, &mut ws, |at| self.upright(at).next().is_some());
            self.ws = ws;
            match ended.map_err(RelaxError::cause)? {
                Relaxation::Left { at: left, eliminations, .. } => {
                    self.reached.result.effort.newton_iterations += eliminations;
                    let standing: Vec<usize> = self.upright(&left).collect();
                    standing.into_iter().for_each(|tip| self.reached.off[tip] = true);
                    at = left;
                }
                Relaxation::Rest(relaxed) => {
                    self.reached.result.effort.newton_iterations += relaxed.eliminations;
                    return self.clear(drive, relaxed.solution).map(Arc::new);
                }
            }
        }
    }

    /// An equilibrium in which the spatulae that let go and are clear of the ground may adhere again, on the mesh that it asks for itself: a path from it
    /// goes on to that of its next points.
    fn clear(&mut self, drive: &RootDrive, rest: Solution) -> Result<Solution, SolveError> {
        let far = CLEAR * self.model.spatula.sections.lying.gap_scale;
        let off = &self.reached.off;
        let is_clear = |tip: &usize| off[*tip] && self.tree.nearest(&rest.at, self.model.spatula_of(*tip)) > far;
        let clear: Vec<usize> = (0..off.len()).filter(is_clear).collect();
        clear.into_iter().for_each(|tip| self.reached.off[tip] = false);
        let (problem, o) = (self.problem(drive), &rest.observables);
        let held = PathConstraint { weights: Observables::DISPLACEMENT, target: o.displacement };
        let at = problem.system.refocused(&rest.at, o.monitors);
        if let Ok(solution) = solve(&problem, at.clone(), &held, &AT_END, &mut self.ws) {
            self.reached.result.effort.newton_iterations += solution.iterations;
            return Ok(solution);
        }
        let held = Held::Displacement(o.displacement);
        let relaxed = relax(&problem, at, held, &RELAXING, &mut self.ws).map_err(RelaxError::cause)?;
        self.reached.result.effort.newton_iterations += relaxed.eliminations;
        Ok(relaxed.solution)
    }
}
