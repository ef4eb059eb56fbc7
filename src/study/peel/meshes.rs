//! A path on one mesh after another: a mesh from the accuracy asked for, the path on it, and, where the error bounds say
//! so, a finer mesh and the path again.

use super::assembly::{Whole, empty};
use super::attempt::{Attempt, Lost};
use super::budget::{Budget, Checkpoint, Limits};
use super::equilibrium_path::follow::follow;
use super::result::{Effort, Failure, GivenUp, PathEnd, PathFailure, Peel};
use super::step_dependence::Common;
use crate::beam::grip_state::StepsTaken;
use crate::beam::mesh::{Focus, MeshKind, Reach};
use crate::beam::planar::model_limits::{PoleInReach, UprightSection};
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::path::options::PathOptions;
use crate::solve::problem::MeasuredBeside;
use crate::solve::workspace::Pace;
use crate::study::asked::accuracy::{Accuracy, Choice, MOST_FAILED_IN_SPACE, Resolution, most_elements, refined};
use crate::study::asked::stop_criteria::{Bound, Stage};
use crate::study::initial::error::NotPrepared;
use crate::study::initial::prepared::{Prepared, prepared};
use std::sync::Arc;

/// Length of the steps of a path that confirms another, over those of the other.
const SHORTER: f64 = 0.5;
/// Most such paths.
const MOST_SHORTER: i32 = 3;
/// What steps of half the length change at best, over what those before have changed: where even that does not come down to the accuracy asked for
/// no further path is tried.
const LESS_AT_BEST: f64 = 4.0;
/// Meshes on which the path of a beam that is held may be unusable before it is watched: what more of them cure takes longer.
const MOST_FAILED_HELD: usize = 3;
/// Newton iterations after which a path in space is lost that is followed warily, over those of all meshes before.
const WARILY: usize = 2;

/// Error wanted of a prediction on a branch, over that on a path from rest: with longer steps a branch came back to the path that it had left
/// from far away, 0.8 nm before it meets it in the strip 40 nm wide.
const FROM_BRANCH_POINT: f64 = 2.5e-3;

/// A path that begins at an equilibrium that is known, beside a branch point.
pub(in crate::study) struct KnownStart {
    /// With that equilibrium as its start
    pub problem: Arc<BeamProblem>,
    /// Of the first step from there, nm
    pub first_displacement: f64,
}

/// What becomes of a path whose steps collapse on a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Collapsed {
    /// It is tried on a finer one.
    Refined,
    /// It is lost: on a fixed mesh each element that is longer than the process zone takes its steps as the front crosses it, and one that is
    /// finer by half takes as many.
    Lost,
}

/// The path on one mesh after another, until its bounds are what is wanted; where no mesh gives one that can be used, at the next of the `paces`.
pub(super) fn on_meshes(
    model: &PeelModel,
    accuracy: &Accuracy,
    limits: &Limits,
    start: Option<&KnownStart>,
    paces: &[Pace],
    collapsed: Collapsed,
    budget: &mut Budget,
) -> Peel {
    let accuracy = &accuracy.fitted(model);
    let Choice { mesh, form, .. } = accuracy.choice;
    let first = Resolution::first(model, accuracy);
    let how = Discretisation::moving(form, first.order).on(mesh);
    let prepared = match start {
        Some(known) => Ok((known.problem.clone(), StepsTaken::default(), None)),
        None => prepared(model, how, limits.should_stop())
            .map(|Prepared { problem, steps, relaxed }| (Arc::new(problem), steps, relaxed)),
    };
    let (problem, steps, relaxed) = match prepared {
        Ok(prepared) => prepared,
        Err(NotPrepared { why, steps }) => {
            let (end, asked) = (PathEnd::Failed(Failure::NoStart(why)), accuracy.relative);
            let StepsTaken { ends, ways, jumps } = *steps;
            return Peel {
                steps: ends,
                step_ways: ways,
                step_jumps: jumps,
                end,
                asked,
                choice: accuracy.choice,
                ..empty(model)
            };
        }
    };
    let mut meshes = Meshes {
        model,
        accuracy,
        start,
        collapsed,
        how,
        far: model.line_law().cutoff_distance(),
        iterations: 0,
        unfinished: false,
        gives_up: false,
        budget,
        lost: None,
        lost_again: None,
        wholes: Vec::new(),
    };
    let mut best: Option<Attempt> = None;
    for &pace in paces {
        // a fixed mesh that is too coarse is so at any pace: watched, a path begins on the one that came farthest
        let farthest = best.as_ref().filter(|_| pace == Pace::Watchful && mesh != MeshKind::Moving);
        let farthest = farthest.map(|best| best.peel.effort.elements);
        let reached = farthest.or(meshes.lost_again.filter(|_| pace == Pace::Wary));
        let from = Resolution { elements: reached.unwrap_or(first.elements), ..first };
        let again = meshes.followed_at(pace, from, &problem, limits);
        best = meshes.better(best, again);
        if best.as_ref().is_none_or(|best| best.failure().is_none()) || limits.reached().is_some() || meshes.gives_up {
            break;
        }
        let counts = pace == Pace::Quick && mesh == MeshKind::Moving;
        let finely = model.counted_finely(&problem, how).filter(|_| counts);
        if let Some(finely) = finely.filter(|finely| best.as_ref().is_some_and(|best| best.is_beside_front(finely))) {
            let limits = Limits { stop: limits.stop, checkpoint: &Checkpoint::NOTHING };
            let again = meshes.followed_at(pace, first, &Arc::new(finely), &limits);
            best = meshes.better(best, again);
            if best.as_ref().is_none_or(|best| best.failure().is_none()) || limits.reached().is_some() {
                break;
            }
        }
    }
    // who interrupts it knows that he did
    let stopped = limits.stop.reached_bound(Stage::Path).filter(|bound| *bound != Bound::Interrupted);
    let stopped = stopped.map(GivenUp::Stopped);
    let Meshes { mut iterations, mut unfinished, far, mut wholes, budget, .. } = meshes;
    if let Some(best) = best.as_mut().filter(|best| best.worst() > 1.0) {
        best.confirm(&wholes);
        best.widen(&wholes);
    }
    if problem.system.step_dependence().exists() && accuracy.choice.step.is_none() && !unfinished {
        best = best.map(|best| {
            let shorter = Shorter { model, problem: &problem, accuracy, limits, far, budget };
            let (confirmed, further) = shorter.confirmed(best, &mut wholes);
            iterations += further;
            unfinished = confirmed.cut;
            confirmed
        });
    }
    if let Some(best) = &mut best {
        let late = best.peel.integrate_works(limits.should_stop());
        best.trouble = best.trouble.take().or(late);
    }
    let given_up = stopped.or_else(|| budget.is_spent().then_some(GivenUp::Work));
    let mut peel = best.map_or_else(|| empty(model), |best| best.into_peel(given_up));
    (peel.steps, peel.step_ways, peel.step_jumps) = (steps.ends, steps.ways, steps.jumps);
    peel.relaxed_start = relaxed;
    peel.effort.newton_iterations = iterations;
    peel.unfinished = unfinished;
    peel
}

/// The meshes that have been tried.
struct Meshes<'r> {
    model: &'r PeelModel,
    accuracy: &'r Accuracy,
    start: Option<&'r KnownStart>,
    collapsed: Collapsed,
    /// How the beam is discretised.
    how: Discretisation,
    far: f64,
    /// Newton iterations on all of them.
    iterations: usize,
    /// Whether the last one was left for want of time, or because the user wanted it.
    unfinished: bool,
    /// Whether no further one is begun.
    gives_up: bool,
    /// The work that is left.
    budget: &'r mut Budget,
    /// Where the path on the last one was lost, if it was.
    lost: Option<Lost>,
    /// The elements of the mesh on which the path was lost where it had been lost before.
    lost_again: Option<usize>,
    /// The limit points of every path that could be used.
    wholes: Vec<Whole>,
}

impl Meshes<'_> {
    /// The best path at a pace, from one resolution on.
    fn followed_at(
        &mut self,
        pace: Pace,
        first: Resolution,
        problem: &Arc<BeamProblem>,
        limits: &Limits,
    ) -> Option<Attempt> {
        let (model, accuracy) = (self.model, self.accuracy);
        // where a strip turns about its axis, or a plane nearly loses its stability, its roll alone goes forward
        let (problem, most) = match (pace, model.space) {
            (Pace::Wary, Some(_)) => {
                (&Arc::new(problem.measured_beside(MeasuredBeside::Roll)), WARILY * self.iterations)
            }
            _ => (problem, usize::MAX),
        };
        let most_failed = match pace {
            _ if model.space.is_some() => MOST_FAILED_IN_SPACE,
            Pace::Quick if model.is_held() => MOST_FAILED_HELD,
            _ => usize::MAX,
        };
        let given = problem;
        let (mut problem, mut upright) = (given.clone(), NearlyUpright::nowhere());
        let mut failed = 0;
        refined(first, most_elements(model), Attempt::is_better_than, |resolution, best: Option<&Attempt>| {
            let mut options = PathOptions { pace, ..resolution.path_options(model, accuracy.relative) };
            if let Some(known) = self.start {
                options.first_displacement = known.first_displacement;
                options.step_tolerance *= FROM_BRANCH_POINT;
            }
            let followed = follow(model, &problem, options, self.far, accuracy.relative, limits, self.budget);
            self.iterations += followed.iterations;
            self.budget.spend(followed.iterations, options.elements);
            let mut attempt = Attempt::new(model, &problem, followed, resolution, accuracy);
            let unresolved = attempt.unresolved();
            let finer = unresolved.and_then(|at| upright.resolved((model, self.how), given, &at, resolution));
            if let Some((finer, resolution)) = finer {
                (problem, attempt.next) = (finer, resolution);
            }
            let enough = accuracy.choice.elements.is_some()
                || attempt.is_enough()
                || best.is_some_and(|best| attempt.is_stuck_behind(best));
            let over = attempt.cut || limits.reached().is_some();
            self.unfinished = over && (attempt.cut || attempt.trouble.is_some() || !enough);
            failed += usize::from(attempt.trouble.is_some());
            let hopeless = attempt.trouble.is_some() && (failed == most_failed || self.iterations > most);
            let collapses = matches!(attempt.trouble, Some(PathFailure::TooManyPoints { .. }));
            self.gives_up |= collapses && self.collapsed == Collapsed::Lost || self.budget.is_spent();
            self.wholes.extend(attempt.whole());
            let again = self.is_lost_again(&attempt, pace);
            let finer = (!enough && !over && !hopeless && !self.gives_up && !again).then_some(attempt.next);
            (attempt, finer)
        })
    }

    /// Whether the path was lost where the mesh before had lost it: then the mesh is not to blame, and the next pace goes on from this one. Watched,
    /// a path comes past such a place on one mesh and not on another.
    fn is_lost_again(&mut self, attempt: &Attempt, pace: Pace) -> bool {
        let hangs = pace == Pace::Quick && self.model.is_held();
        let lost = if hangs { attempt.missing() } else { attempt.lost() };
        let before = std::mem::replace(&mut self.lost, lost);
        let near = |(lost, before): (Lost, Lost)| lost.is_near(&before) || hangs && lost.is_near_by_largest(&before);
        let again = pace != Pace::Watchful && lost.zip(before).is_some_and(near);
        if again {
            self.lost_again = Some(attempt.peel.effort.elements);
        }
        again
    }

    /// The better one of two, told what the other meshes gave.
    fn better(&self, best: Option<Attempt>, again: Option<Attempt>) -> Option<Attempt> {
        let better = |one: Attempt, other: Attempt| if other.is_better_than(&one) { other } else { one };
        let mut best = best.into_iter().chain(again).reduce(better)?;
        best.compare(&self.wholes);
        Some(best)
    }
}

/// Where the material points remember how they have slid, what a path ends in depends on its steps: it is followed again with shorter
/// ones.
struct Shorter<'r> {
    model: &'r PeelModel,
    problem: &'r Arc<BeamProblem>,
    accuracy: &'r Accuracy,
    limits: &'r Limits<'r>,
    far: f64,
    budget: &'r Budget,
}

impl Shorter<'_> {
    /// The same path with shorter steps, until what that changes is within the accuracy asked for, with bounds that hold it; and the
    /// Newton iterations it took. Where the bounds of one are missed by far the next has a finer mesh as well. One that cannot be confirmed, by
    /// shorter steps and one of the `wholes` on another mesh, has failed.
    fn confirmed(&self, mut best: Attempt, wholes: &mut Vec<Whole>) -> (Attempt, usize) {
        let mut iterations = 0;
        let relative = self.accuracy.relative;
        let first = Resolution::first(self.model, self.accuracy);
        for tries in 1..=MOST_SHORTER {
            if best.trouble.is_some() || best.cut {
                break;
            }
            let Effort { elements, order, .. } = best.peel.effort;
            let mesh = if best.misses_by_far() { best.next } else { Resolution { elements, order, ..first } };
            let resolution = Resolution { stride: SHORTER.powi(tries), ..mesh };
            let options = resolution.path_options(self.model, relative);
            let mut followed = follow(self.model, self.problem, options, self.far, relative, self.limits, self.budget);
            iterations += followed.iterations;
            followed.leave_out_unresolved();
            // steps that are close by their length alone may turn on a level force wherever they are
            let least = if self.problem.system.step_dependence().is_yielding() { relative } else { 0.0 };
            let common = Common::of(&best.peel, &followed, least);
            let others = common.of_longer(&best.peel.limit_points);
            let whole = followed.trouble.is_none() && !followed.cut;
            if whole {
                common.leave(&mut followed);
            }
            // how a film that yields lets go at its very end depends on the steps; what lies before is what is asked
            let differ = if least > 0.0 && !others.is_empty() { None } else { common.differ() };
            if let Some((shorter, longer)) = differ.filter(|_| whole) {
                followed.trouble = Some(PathFailure::StepsMatter { shorter, longer, same: others.len() });
            }
            let mut next = Attempt::new(self.model, self.problem, followed, resolution, self.accuracy);
            let change = next.allow_for(&others, self.problem);
            if self.problem.system.step_dependence().is_yielding() {
                next.peel.bound_plateau_by(&best.peel);
            }
            next.confirm_steps(wholes);
            wholes.extend(next.whole());
            best = next;
            let met = change <= relative && !best.misses_by_far();
            if met || change > relative * LESS_AT_BEST.powi(MOST_SHORTER - tries) {
                break;
            }
        }
        (best, iterations)
    }
}

// -- A mesh that resolves sections which are nearly upright, in the reach of a pole of their law --
//
// Where a beam hangs between its front and its grip, an upright pull brings its sections near to 90 degrees. The energy of the near face alone,
// -b|W|/cos θ, softens a tilt there by 2b|W|/cos³θ, and tension and bending hold it with V + EI/y², y the height. Where they no longer do is a displacement
// limit point of the path, behind which cos θ falls to nothing at one place. Elements that follow the front are too long there to see it.

/// Length of the elements at such a section over that over which the pole bends the beam.
const ELEMENT: f64 = 0.33;
/// The same where that was not short enough, over the time before.
const SHORTER_ELEMENTS: f64 = 0.6;

/// Where elements are small because sections there are nearly upright.
pub(super) struct NearlyUpright {
    foci: Vec<Focus>,
    /// How many elements of the mesh those are.
    elements: usize,
    /// Over the length that was taken at first.
    share: f64,
}

impl NearlyUpright {
    /// No such section.
    pub(super) const fn nowhere() -> Self {
        Self { foci: Vec::new(), elements: 0, share: 1.0 }
    }

    /// The problem on a mesh that resolves a section which this one does not, and the elements it takes.
    pub(super) fn resolved(
        &mut self,
        (model, how): (&PeelModel, Discretisation),
        problem: &BeamProblem,
        section: &UprightSection,
        resolution: Resolution,
    ) -> Option<(Arc<BeamProblem>, Resolution)> {
        let PoleInReach::Unresolved { length, .. } = section.pole else { return None };
        let (beam, whole) = (problem.beam.planar()?, model.length());
        // what hangs is as long as it is high, at least
        let hanging = section.height.max(whole - section.place).min(whole);
        let front = (section.place - hanging).max(0.0);
        let at_front = beam.mesh.front_foci.iter().map(|focus| Focus { center: front + focus.center, ..*focus });
        let others: Vec<Focus> = at_front.chain(beam.mesh.fixed_foci.iter().copied()).collect();
        let before = resolution.elements - self.elements;
        let each = Focus::between(&others, 0.0, whole) / before as f64;
        if !self.foci.is_empty() {
            self.share *= SHORTER_ELEMENTS;
        }
        let weight = each * hanging / (ELEMENT * self.share * length);
        let focus = Focus { center: section.place, length: hanging, weight, reach: Reach::Near };
        self.foci.retain(|other| (other.center - section.place).abs() > hanging);
        self.foci.push(focus);
        self.elements = (Focus::between(&self.foci, 0.0, whole) / each).ceil() as usize;
        let finer = resolution.with_elements((before + self.elements) as f64);
        Some((Arc::new(model.with_foci(problem, how, &self.foci)?), finer))
    }
}
