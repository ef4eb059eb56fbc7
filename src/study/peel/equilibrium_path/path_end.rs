//! Where a path ends, and its last point there.

use crate::beam::planar::model_limits::BondedLoss;
use crate::beam::planar::planar_beam::{FrictionHistory, TIP_ROTATION};
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::near_branch::is_mirrored;
use crate::solve::path::options::PathError;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::{Located, ROUGH, solve_on};
use crate::solve::points::search::LimitPointKind;
use crate::solve::problem::Direction;
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::workspace::{Pace, ShouldStop, Workspace};
use crate::study::asked::stop_criteria::{Bound, FollowedUntil};
use crate::study::peel::budget::Limits;
use crate::study::peel::result::{PathEnd, PathFailure};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Most steps of the secant rule to where a beam is clear of the substrate.
const MOST_SECANTS: usize = 20;
/// A force below this share of its scale is none.
const PUSH: f64 = 1e-6;
/// What is farther from the substrate than this many times the distance at rest does not adhere.
const OFF: f64 = 2.0;
/// A roll that is none, rad, and what is left of roll and yaw in the plane, over the roll at the beginning.
const NO_ROLL: f64 = 1e-7;
const IN_PLANE: f64 = 1e-4;
/// A path that cannot be continued is next to its plane where its roll is less than this share of the largest.
const NEXT_TO_PLANE: f64 = 0.02;
/// The ratio of yaw and roll changes by less over a step through the plane.
const SAME_RATIO: f64 = 0.1;
/// A section this near to 90 degrees stands upright, rad: there the path meets that of upright strips, and may go on
/// along it without passing the upright position.
const UPRIGHT: f64 = 1e-8;
/// A free end that is as near to 90 degrees has come to the upright position, rad, if what was this many times as far, and no farther than that, shows
/// that the path is symmetric there: by this share of how force and displacement changed.
const NEARLY_UPRIGHT: f64 = 1e-2;
const FARTHER: f64 = 4.0;
const TOWARDS_UPRIGHT: f64 = 0.3;
const PROPORTIONAL: f64 = 0.1;

/// Takes one step; the end, if it is reached.
pub(super) fn step(
    problem: &BeamProblem,
    path: &mut Path,
    pace: Pace,
    far: f64,
    relative: f64,
    limits: &Limits,
) -> Result<Option<PathEnd>, PathError> {
    let stop = limits.stop;
    if path.points().len() >= stop.points {
        return Ok(Some(PathEnd::Bound(Bound::Points(stop.points))));
    }
    let newest = path.advance()?;
    let o = newest.observables;
    if path.points().len() < 3 {
        return Ok(None);
    }
    if is_clear(problem, path, far) {
        return Ok(Some(PathEnd::Detached));
    }
    if pace == Pace::Watchful && lets_go(problem, path, relative) {
        return Ok(Some(PathEnd::Detached));
    }
    if slides(problem, path) {
        return Ok(Some(PathEnd::Sliding));
    }
    let sticks = problem.system.step_dependence().exists() && !problem.system.step_dependence().is_yielding();
    if sticks && newest.slope.displacement < 0.0 {
        return Ok(Some(PathEnd::Snapped));
    }
    // a strip that has closed again passes u = 0 and P = 0 together
    if o.displacement <= 0.0 {
        return Ok(Some(PathEnd::TurnedBack));
    }
    // a grip that turns may push where its moment peels
    let turns = problem.grip.gear != 0.0 && path.points().iter().all(|point| point.slope.displacement >= 0.0);
    if o.force <= 0.0 && has_pulled(problem, path.points()) && !turns {
        return Ok(Some(PathEnd::Pivoting));
    }
    if stands_upright(problem, path.points()) || comes_upright(problem, path.points(), pace) {
        return Ok(Some(PathEnd::Pivoting));
    }
    if is_back_in_plane(problem, path.points()) {
        return Ok(Some(PathEnd::BackInPlane));
    }
    if let Some(end) = model_end(problem, path.points(), relative) {
        return Ok(Some(end));
    }
    if is_behind(problem, path.points(), stop.until) {
        return Ok(Some(PathEnd::Bound(Bound::Until(stop.until))));
    }
    let beyond = stop.displacement.filter(|&most| o.displacement > most);
    Ok(beyond.map(|most| PathEnd::Bound(Bound::Displacement(most))))
}

/// Path points behind the first jump: what locates a limit point looks at its neighbours.
const BEHIND_JUMP: usize = 2;
/// What is farther from the substrate than this many times the distance at rest is nearer than what adheres nowhere.
const NO_CONTACT: f64 = 4.0;

/// Whether the newest point is behind what the path is to be followed to.
fn is_behind(problem: &BeamProblem, points: &[Arc<Solution>], until: FollowedUntil) -> bool {
    let turns_back = |pair: &[Arc<Solution>]| pair[0].slope.displacement > 0.0 && pair[1].slope.displacement < 0.0;
    let mut jumps = points.windows(2).enumerate().filter(|(_, pair)| turns_back(pair)).map(|(after, _)| after);
    match until {
        FollowedUntil::End => false,
        FollowedUntil::FirstJump => jumps.next().is_some_and(|after| points.len() > after + BEHIND_JUMP),
        FollowedUntil::Detachment => {
            let Some(newest) = points.last() else { return false };
            let furthest = jumps.map(|after| points[after].observables.displacement).reduce(f64::max);
            newest.slope.displacement > 0.0
                && furthest.is_some_and(|furthest| newest.observables.displacement > furthest)
                && is_off(problem, &points[0], newest, NO_CONTACT)
        }
    }
}

/// Whether the beam is farther from what it cannot pass than so many times as far as at rest.
fn is_off(problem: &BeamProblem, rest: &Solution, newest: &Solution, times: f64) -> bool {
    problem.beam.clearance(&newest.at) > times * problem.beam.clearance(&rest.at)
}

/// Whether no part of the beam is nearer to the substrate than `far`, nm, at the newest point.
pub(in crate::study) fn is_clear(problem: &BeamProblem, path: &Path, far: f64) -> bool {
    path.points().last().is_none_or(|point| problem.beam.is_clear(&point.at, far))
}

/// Whether nothing adheres any more, and the force is next to nothing, at the newest point of a path that is watched: what attracts there pulls less
/// and less, and where no force holds the beam no equilibrium is certain.
fn lets_go(problem: &BeamProblem, path: &Path, relative: f64) -> bool {
    let [first, .., newest] = path.points() else { return false };
    let largest = path.points().iter().map(|point| point.observables.force.abs()).fold(0.0, f64::max);
    newest.observables.force.abs() <= relative * largest && is_off(problem, first, newest, OFF)
}

/// Friction that is next to nothing, over that of a process zone at rest.
const LET_GO: f64 = 0.5;

/// Whether all that is in contact slides one way, or next to nothing is left of the friction that alone holds the beam along the
/// substrate.
fn slides(problem: &BeamProblem, path: &Path) -> bool {
    let rest = problem.beam.planar().and_then(|beam| beam.memory.slip_at_rest());
    let (Some(now), Some(rest)) = (path.history(), rest) else { return false };
    let little = LET_GO * problem.beam.process_length() / problem.beam.length();
    FrictionHistory(now).slides(little * FrictionHistory(rest).capacity())
}

/// Whether the force has been above zero: where a beam is curved in its stress-free configuration, the grip may have to push at first.
fn has_pulled(problem: &BeamProblem, points: &[Arc<Solution>]) -> bool {
    let pushes = points[0].observables.force < -PUSH * problem.measure.force;
    !pushes || points.iter().any(|point| point.observables.force > 0.0)
}

/// Whether the strip has just passed the upright position, all of it near 90 degrees: it hangs from its edge, and behind
/// that, on a flat substrate, the path is the mirror image of itself.
fn stands_upright(problem: &BeamProblem, points: &[Arc<Solution>]) -> bool {
    let [.., before, newest] = points else { return false };
    let Some(beam) = problem.beam.planar() else { return false };
    if !has_mirror_image(problem) {
        return false;
    }
    let away = 3.0 * tip(before).abs().max(tip(newest).abs());
    let rotations = beam.nodes(&newest.at.values).iter().skip(beam.rotation).step_by(beam.fields());
    tip(before) < -UPRIGHT && tip(newest) >= -UPRIGHT && rotations.into_iter().all(|r| (r - FRAC_PI_2).abs() <= away)
}

/// Whether a path that is watched has come to the upright position of its free end, which hangs from its edge, however the rest of the strip is held:
/// near it displacement and force change with the rotation of the free end in proportion to what is left of that, or both turn on the step that passes
/// it, where no eigenvalue changes its sign. So what follows is the mirror image of what was.
fn comes_upright(problem: &BeamProblem, points: &[Arc<Solution>], pace: Pace) -> bool {
    let [.., last, newest] = points else { return false };
    let left = tip(newest);
    if pace != Pace::Watchful || !has_mirror_image(problem) {
        return false;
    }
    if passes_upright(points) && is_mirrored(last, newest) {
        return true;
    }
    if left.abs() > NEARLY_UPRIGHT {
        return false;
    }
    let Some(before) = points.iter().rev().find(|point| tip(point).abs() >= FARTHER * left.abs()) else { return false };
    let is_proportional = |pick: fn(&Observables) -> f64| {
        let [far, near] = [before, newest].map(|point| pick(&point.slope) / point.slope.monitors[TIP_ROTATION]);
        (near - far * left / tip(before)).abs() <= PROPORTIONAL * far.abs()
    };
    (-TOWARDS_UPRIGHT..0.0).contains(&tip(before))
        && is_proportional(|o| o.displacement)
        && is_proportional(|o| o.force)
}

/// Whether the free end passes the upright position on the last step.
fn passes_upright(points: &[Arc<Solution>]) -> bool {
    let [.., before, newest] = points else { return false };
    tip(before) < 0.0 && tip(newest) >= 0.0
}

/// Whether what adheres may be mirrored: only a strip that is pulled straight up from flat ground has a mirror image.
fn has_mirror_image(problem: &BeamProblem) -> bool {
    problem.grip.direction == Direction::UP && problem.beam.planar().is_some_and(|beam| beam.substrate.is_flat())
}

/// By how much the free end has turned beyond 90 degrees, rad.
fn tip(solution: &Solution) -> f64 {
    solution.observables.monitors[TIP_ROTATION] - FRAC_PI_2
}

/// Whether a path that begins out of its plane has come back into it, or to its mirror image: its grip had a roll, and has neither roll
/// nor yaw any more. A branch between two points of a planar path comes back at the second of them, where its inertia does not change. Where the
/// pull is not symmetric there is no such plane.
fn is_back_in_plane(problem: &BeamProblem, points: &[Arc<Solution>]) -> bool {
    let (Some(beam), [first, .., before, newest]) = (problem.beam.spatial(), points) else { return false };
    if !problem.has_plane_of_symmetry() {
        return false;
    }
    let [first, before, newest] = [first, before, newest].map(|point| beam.angles_of_grip(&point.at));
    let is_zero = |angle: usize| newest[angle].abs() <= IN_PLANE * first[2].abs();
    // in a mirror image both have turned over, and their ratio is what it was
    let [one, other] = [newest[1] * before[2], newest[2] * before[1]];
    let is_mirrored = newest[2] * before[2] < 0.0 && (one - other).abs() <= SAME_RATIO * one.abs();
    first[2].abs() > NO_ROLL && (is_zero(1) && is_zero(2) || is_mirrored)
}

/// Whether such a path is so near to its plane, and comes nearer, that it ends there.
pub(super) fn is_next_to_plane(problem: &BeamProblem, points: &[Arc<Solution>]) -> bool {
    let (Some(beam), [.., before, newest]) = (problem.beam.spatial(), points) else { return false };
    let roll = |point: &Arc<Solution>| beam.angles_of_grip(&point.at)[2].abs();
    let largest = points.iter().map(roll).fold(0.0, f64::max);
    problem.has_plane_of_symmetry()
        && roll(&points[0]) > NO_ROLL
        && roll(newest) < roll(before)
        && roll(newest) <= NEXT_TO_PLANE * largest
}

impl Followed {
    /// Moves the last point of a path that crossed P = 0, u = 0 or the upright position onto the crossing. Where that fails the point beyond it
    /// stays: it is an equilibrium too.
    pub(super) fn finish(&mut self, problem: &BeamProblem, far: f64) {
        let n = self.points.len();
        if self.end == PathEnd::Detached {
            return self.finish_detached(problem, far);
        }
        let (weights, target) = match self.end {
            PathEnd::Pivoting => match comes_upright(problem, &self.points, self.pace) {
                // its free end is not upright yet, or is so just now
                true if !passes_upright(&self.points) => return,
                comes if comes || stands_upright(problem, &self.points) => {
                    (Observables::monitor(TIP_ROTATION), FRAC_PI_2)
                }
                _ => (Observables::FORCE, 0.0),
            },
            PathEnd::TurnedBack => (Observables::DISPLACEMENT, 0.0),
            // beyond its model the point says nothing; in the plane it is one of the planar path
            PathEnd::BondedPartUnstable(_) | PathEnd::BackInPlane => {
                self.points.pop();
                return;
            }
            _ => return,
        };
        let (before, beyond) = (&self.points[n - 2], &self.points[n - 1]);
        let segment = PathSegment::around(problem, &self.points, n - 2);
        let (from, to) = (weights.dot(&before.observables) - target, weights.dot(&beyond.observables) - target);
        let start = segment.start(problem, segment.end() * from / (from - to), 4);
        let options = NewtonOptions { tolerance: 1e-10, largest_update: 0.5, most_iterations: 10, exact_slope: false };
        let constraint = PathConstraint { weights, target };
        match solve(problem, start, &constraint, &options, &mut Workspace::default()) {
            Ok(mut last) => {
                self.iterations += last.iterations;
                // where the constraint falls along the path, a slope per unit of it points backwards
                last.slope = last.slope.times((to - from).signum());
                self.points[n - 1] = Arc::new(last);
            }
            // upright the path meets its mirror image and may be singular: it ends before that
            Err(_) if target != 0.0 => {
                self.points.pop();
            }
            Err(_) => {}
        }
        self.upright = target != 0.0;
    }

    /// Moves the last point of a path that has left the substrate to where its distance is `far`, by the secant rule.
    fn finish_detached(&mut self, problem: &BeamProblem, far: f64) {
        let n = self.points.len();
        let segment = PathSegment::around(problem, &self.points, n - 2);
        let mut ws = Workspace::default();
        let beyond = |s: &Solution| problem.beam.beyond(&s.at, far);
        let (mut low, mut high) = ((0.0, beyond(&self.points[n - 2])), (segment.end(), beyond(&self.points[n - 1])));
        for _ in 0..MOST_SECANTS {
            let label = (low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1)).clamp(0.0, segment.end());
            // where nothing pulls any more no equilibrium is certain: nearer to where something does
            let Ok(solution) = solve_on(problem, &segment, label, ROUGH, &mut ws) else {
                high.0 = label;
                continue;
            };
            self.iterations += solution.iterations;
            let value = beyond(&solution);
            if value.abs() < 1e-6 * far {
                self.points[n - 1] = solution;
                return;
            }
            // an end that stays has half of its value, so that the other does not creep (Illinois)
            if value < 0.0 {
                (low, high.1) = ((label, value), 0.5 * high.1);
            } else {
                (high, low.1) = ((label, value), 0.5 * low.1);
            }
        }
    }
}

// -- A path that has been followed --

/// A path with its limit points.
pub(in crate::study::peel) struct Followed {
    pub points: Vec<Arc<Solution>>,
    /// In path order, each with the index of the point before it.
    pub turns: Vec<(LimitPointKind, usize, Located)>,
    /// Where an eigenvalue passes through zero although the displacement does not turn, likewise.
    pub branch_points: Vec<(usize, Located)>,
    pub end: PathEnd,
    /// Whether time or the user ended it.
    pub cut: bool,
    pub iterations: usize,
    /// Whether it ended with the strip upright, where an eigenvalue is zero by symmetry.
    pub upright: bool,
    /// Load limit points left out because the force hardly changes between them.
    pub ripple: usize,
    /// Whether the first maximum of the force is so level that no place on it has more than others: nothing is missed
    /// where its place is not known.
    pub level: bool,
    /// Largest spread of the first integral along the beam at any point, over the work of adhesion.
    pub spread: f64,
    /// The end that the model gives where the path cannot be continued.
    pub beyond: Option<PathEnd>,
    /// Why the path cannot be used, if it cannot.
    pub trouble: Option<PathFailure>,
    /// At which pace it was followed, and is looked around on.
    pub pace: Pace,
    /// Says when its limit points and its work are no longer to be computed.
    pub(super) should_stop: Option<ShouldStop>,
}

impl Followed {
    /// What looks around on the path with, until it is late.
    pub(in crate::study::peel) fn workspace(&self) -> Workspace {
        Workspace::until(self.should_stop.clone()).at(self.pace)
    }

    /// What came out too late may be a ripple that is a turn, or an interpolant for a solution: to be asked in the end.
    pub(in crate::study::peel) fn late(&self) -> Option<PathFailure> {
        self.workspace().is_stopped().then_some(PathFailure::OutOfTime)
    }
}

// -- Whether a path has come to where the model itself ends --

/// A force below this share of the work of adhesion over the width is none, where a path cannot be continued.
const NO_FORCE: f64 = 1e-6;

/// The end at the newest point, if its model says so: a section is where the energy has a pole, or what is bonded has lost its stability
/// since the point before. Then a negative eigenvalue comes without a limit point; where the sections tilt to one side from the front on
/// instead, none does, and the path goes on in a stable state.
pub(super) fn model_end(problem: &BeamProblem, points: &[Arc<Solution>], relative: f64) -> Option<PathEnd> {
    let [.., before, newest] = points else { return None };
    let beam = problem.beam.planar()?;
    if let Some(upright) = beam.upright_section(&newest.at, relative) {
        return Some(PathEnd::Upright(upright));
    }
    let turned = newest.slope.displacement * before.slope.displacement <= 0.0;
    if turned || newest.negative <= before.negative || loss(problem, before).is_some() {
        return None;
    }
    loss(problem, newest).map(PathEnd::BondedPartUnstable)
}

fn loss(problem: &BeamProblem, at: &Solution) -> Option<BondedLoss> {
    let beam = problem.beam.planar()?;
    beam.limits.bonded.as_ref()?;
    beam.limits.bonded_loss(beam.grip_forces(&at.at).horizontal)
}

/// The end of a path that cannot be continued where its model says why.
pub(super) fn stopped_by_model(
    problem: &BeamProblem,
    points: &[Arc<Solution>],
    trouble: &PathFailure,
) -> Option<PathEnd> {
    if let PathFailure::NearUpright(upright) = trouble {
        return Some(PathEnd::Upright(*upright));
    }
    let [_, _, .., newest] = points else { return None };
    let beam = problem.beam.planar()?;
    if let Some(section) = beam.held_upright(&newest.at) {
        return Some(PathEnd::Upright(section));
    }
    if newest.observables.force < NO_FORCE * problem.measure.force && newest.slope.force < 0.0 {
        return Some(PathEnd::Pivoting);
    }
    beam.limits.bonded.as_ref()?;
    beam.limits.near_bonded_loss(beam.grip_forces(&newest.at).horizontal).map(PathEnd::BondedPartUnstable)
}
