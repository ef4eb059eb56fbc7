//! One stable piece of a pull-off: equilibria of the path on which the root moves, to the end of the step or to where stability is lost.

use super::progress::{AT_END, BeforePeak, LOCATED, Run, location};
use crate::solve::error::SolveError;
use crate::solve::newton::{Solution, solve};
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::Located;
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceOptions};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::study::asked::stop_criteria::Bound;
use crate::study::peel::step_dependence::StepCurve;
use crate::study::seta::loading::{SetaStep, StepEnd};
use crate::study::seta::loss::critical_direction;
use crate::study::seta::result::{SetaEnd, SetaFailure};
use crate::study::seta::standing::RootDrive;
use crate::study::states::seta_state::LocationError;
use std::sync::Arc;

/// What is looked for: limit points and losses of stability, with points behind them that an interpolation may use.
const TRACED: TraceOptions = TraceOptions {
    kinds: &[LimitPointKind::Displacement, LimitPointKind::Load],
    branches: true,
    relative: LOCATED,
    behind: 2,
};
/// Work and energy of a step may differ by this share of the energy before the step is solved in between.
const ROUGH: f64 = 1e-5;
/// Steps before the one with the largest force at which a finer mesh begins.
const WELL_BEFORE: usize = 2;
/// Sizes by which a state is moved along its critical direction, of which that with the least energy is taken.
const DISTURBED: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];

/// What a stable piece ends with.
pub(super) enum PieceEnd {
    /// The step is done.
    Done,
    /// Stability is lost, or a spatula stands on its end: where that is, and where relaxing begins.
    Lost(Arc<Solution>, Box<State>),
    /// No further point was found behind this one, and why.
    Stuck(Arc<Solution>, SolveError),
}

/// Points of a path, and the one behind which the run goes on.
#[derive(Clone, Copy)]
pub(super) struct Stretch<'p> {
    pub problem: &'p Problem,
    pub points: &'p [Arc<Solution>],
    pub after: usize,
}

impl Stretch<'_> {
    fn segment(&self) -> PathSegment {
        PathSegment::around(self.problem, self.points, self.after)
    }

    /// A point from which a finer mesh may come to what lies on this step.
    fn well_before(&self) -> &Arc<Solution> {
        &self.points[self.after.saturating_sub(WELL_BEFORE)]
    }
}

impl Run<'_> {
    /// The stable equilibria from where the run stands, to the end of the step or to where stability is lost.
    pub(crate) fn follow(&mut self, step: &SetaStep, drive: &RootDrive) -> Result<PieceEnd, SetaEnd> {
        let (problem, target) = (self.problem(drive), self.target(step));
        let at = self.reached.here.as_ref().map_or_else(|| self.model.lying(&self.tree), |here| here.at.clone());
        let path = Path::from(&problem, *self.options, at).until(self.stop.while_followed());
        let mut tracer = PathTracer::new(&problem, path, TRACED);
        let mut looked = 0;
        let ended = loop {
            if let Some(bound) = self.bound() {
                break Err(SetaEnd::Bound(bound));
            }
            let event = match tracer.advance() {
                Ok(event) => event,
                Err(why) => {
                    // where the path has no first point, it is stuck where it begins
                    let (cause, last) = (why.cause(), tracer.path().points()[..looked].last());
                    break match last.cloned().or_else(|| self.reached.here.clone()) {
                        Some(last) if !self.is_cut_short(&cause) => Ok(PieceEnd::Stuck(last, cause)),
                        _ => Err(self.lost(cause)),
                    };
                }
            };
            let on = |after: usize| Stretch { problem: &problem, points: tracer.path().points(), after };
            match event {
                PathEvent::InertiaChange { .. } => {}
                PathEvent::LimitPoint { kind: LimitPointKind::Load, after, located } => {
                    self.note_maximum(drive, on(after), &located);
                }
                PathEvent::LimitPoint { after, located, .. } | PathEvent::BranchPoint { after, located } => {
                    break match is_before(target, &located.observables) {
                        true => self.take_lost(drive, on(after), &located),
                        false => self.arrive(drive, on(after), target),
                    };
                }
                PathEvent::Point(point) => {
                    let before = looked;
                    looked += 1;
                    let is_within = is_before(target, &point.observables);
                    let taken = match before {
                        0 => {
                            self.begin(drive, &point);
                            Ok(())
                        }
                        _ if is_within => {
                            let stretch = on(before - 1);
                            let segment = stretch.segment();
                            self.take(drive, (stretch, &segment), (segment.end(), &point), None)
                        }
                        _ => break self.arrive(drive, on(before - 1), target),
                    };
                    if let Err(end) = taken {
                        break Err(end);
                    }
                    let is_off = matches!(step.until, StepEnd::Detached(_)) && self.is_off(&point.at);
                    if is_off || !is_within {
                        break Ok(PieceEnd::Done);
                    }
                    let deepest = self.loading.deepest(self.model.seta.brush_height);
                    if let (StepEnd::Preload(preload), true) = (step.until, point.observables.displacement > deepest) {
                        let (step, displacement) = (self.reached.step, point.observables.displacement);
                        break Err(SetaEnd::Failed(SetaFailure::NoPreload { step, preload, displacement }));
                    }
                    if self.upright(&point.at).next().is_some() {
                        let start = Box::new(point.at.clone());
                        break Ok(PieceEnd::Lost(point, start));
                    }
                }
            }
        };
        self.reached.result.effort.newton_iterations += tracer.iterations();
        ended
    }

    /// Which observable ends a step, and at what.
    pub(crate) fn target(&self, step: &SetaStep) -> PathConstraint {
        match step.until {
            StepEnd::Travel(length) | StepEnd::Detached(length) => {
                let target = self.most_displacement().map_or(length, |most| most.min(length));
                PathConstraint { weights: Observables::DISPLACEMENT, target }
            }
            StepEnd::Preload(target) => PathConstraint { weights: Observables::FORCE, target },
        }
    }

    /// The equilibrium at the end of a step, which lies between two points.
    fn arrive(&mut self, drive: &RootDrive, stretch: Stretch, target: PathConstraint) -> Result<PieceEnd, SetaEnd> {
        let Stretch { problem, points, after } = stretch;
        let mut segment = stretch.segment();
        let [from, to] = [after, after + 1].map(|k| target.weights.dot(&points[k].observables));
        let start = segment.start(problem, (target.target - from) / (to - from) * segment.end(), 4);
        let solution = solve(problem, start, &target, &AT_END, &mut self.ws).map_err(|cause| self.lost(cause))?;
        let solution = Arc::new(solution);
        let label = segment.insert(Arc::clone(&solution));
        self.take(drive, (stretch, &segment), (label, &solution), None)?;
        Ok(PieceEnd::Done)
    }

    /// Goes on to where stability is lost.
    fn take_lost(&mut self, drive: &RootDrive, stretch: Stretch, located: &Located) -> Result<PieceEnd, SetaEnd> {
        let (problem, lost, mut segment) = (stretch.problem, &located.solution, stretch.segment());
        let label = segment.insert(lost.clone());
        self.take(drive, (stretch, &segment), (label, lost), Some(location(lost, 0.0)))?;
        let direction = critical_direction(problem, lost, &mut self.ws).map_err(|cause| self.lost(cause))?;
        // the way along which the path goes on, where it turns
        let along: f64 = direction.iter().zip(&lost.tangent.direction).map(|(a, b)| a * b).sum();
        let onward: Vec<f64> = direction.iter().map(|x| x.copysign(x * along)).collect();
        // far along the straight line sections would be in the ground
        let unit = problem.system.size(&onward, &lost.at);
        let moved = |size: f64| {
            let mut at = lost.at.clone();
            problem.system.retract(&mut at, &onward, size / unit);
            at
        };
        let energy = |at: &State| problem.system.evaluate(at, &vec![0.0; onward.len()]).0.energy;
        let tried = DISTURBED.map(moved).into_iter().filter(|at| problem.system.is_admissible(at));
        let start = tried.min_by(|a, b| energy(a).total_cmp(&energy(b)));
        Ok(PieceEnd::Lost(lost.clone(), Box::new(start.unwrap_or_else(|| lost.at.clone()))))
    }

    /// The force has a maximum on the way to the next point.
    fn note_maximum(&mut self, drive: &RootDrive, stretch: Stretch, located: &Located) {
        let (mut segment, from) = (stretch.segment(), stretch.well_before());
        let label = segment.insert(located.solution.clone());
        let mut point = self.point(drive, &located.solution, self.last());
        point.work += StepCurve::interpolated(&segment, label, &located.solution).work();
        let state = self.state(&located.solution.at, point, Some(location(&located.solution, 0.0)));
        self.keep_peak(&state, Some(self.before_peak(drive, from)));
    }

    /// Goes on to an equilibrium of the same piece, at this label of the step to it, or to where an event of the user on the way there stops the run.
    fn take(
        &mut self,
        drive: &RootDrive,
        (stretch, segment): (Stretch, &PathSegment),
        (label, to): (f64, &Arc<Solution>),
        location: Option<LocationError>,
    ) -> Result<(), SetaEnd> {
        let stopped = self.look(drive, (stretch, segment), label)?;
        let (label, to, end) = match &stopped {
            Some((label, solution, name)) => {
                (*label, solution, Err(SetaEnd::Bound(Bound::Event { name: name.clone() })))
            }
            None => (label, to, Ok(())),
        };
        let location = location.filter(|_| end.is_ok());
        let before = self.last();
        let mut point = self.point(drive, to, before);
        let work = StepCurve::interpolated(segment, label, to).work();
        let scale = before.energy.abs().max(point.energy.abs());
        // what the energy does not gain is an error of the interpolation, where the step is long
        let gained = point.energy - before.energy;
        let miss = |work: &f64| (work - gained).abs();
        let mut works = vec![work];
        if miss(&work) > ROUGH * scale {
            let pieces = StepCurve::pieces((stretch.problem, scale), segment, label, to, &mut self.ws);
            works.push(pieces.iter().map(StepCurve::work).sum());
        }
        // a state in between may be found on another branch
        point.work += works.into_iter().min_by(|a, b| miss(a).total_cmp(&miss(b))).unwrap_or(work);
        let state = self.push(to, point, location);
        let from = self.before_peak(drive, stretch.well_before());
        self.keep_peak(&state, Some(from));
        (self.see)(&state, None);
        end
    }

    /// The first point of a path, and of a step that nothing has happened in yet.
    fn begin(&mut self, drive: &RootDrive, at: &Arc<Solution>) {
        if self.has_begun_step() {
            return;
        }
        let point = self.point(drive, at, self.last());
        let state = self.push(at, point, None);
        if self.is_last() {
            self.reached.result.initial_stiffness = Some(at.slope.force / at.slope.displacement);
        }
        self.keep_peak(&state, None);
        (self.see)(&state, None);
    }

    /// From where a peak behind this point is come to.
    fn before_peak(&self, drive: &RootDrive, from: &Arc<Solution>) -> BeforePeak {
        BeforePeak { from: from.clone(), off: self.reached.off.clone(), step: self.reached.step, root: drive.from }
    }
}

fn is_before(PathConstraint { weights, target }: PathConstraint, at: &Observables) -> bool {
    weights.dot(at) < target
}
