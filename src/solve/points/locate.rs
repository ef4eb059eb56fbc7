//! Limit points of the path, located and not sampled, with a bound on their error from half as many elements again.

use super::search::{BendRule, Bends, LimitPointKind, LimitPointSearch};
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, on_more_elements, slopes, solve};
use crate::solve::path::segment::PathSegment;
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::system::StepDependence;
use crate::solve::workspace::{Pace, Workspace};
use std::sync::Arc;

/// A point of the path found by a constraint on it.
#[derive(Clone, Debug)]
pub struct Located {
    /// The solution next to it.
    pub solution: Arc<Solution>,
    /// The observables there.
    pub observables: Observables,
    /// Their difference to those on half as many elements again.
    pub difference: Observables,
    /// d²P/du² there, for a turn of the force.
    pub force_curvature: f64,
    /// Whether the force is too flat there for its place to be determined.
    pub flat: bool,
    /// By how much what turns changes over pairs of limit points beside it that are left out as too weak.
    pub left_out: f64,
    /// Newton iterations it took, on both meshes.
    pub iterations: usize,
}

impl Located {
    /// Whether its numbers and their errors are finite.
    pub(crate) fn is_finite(&self) -> bool {
        self.observables.is_finite() && self.difference.is_finite()
    }

    /// Whether its place is less certain than the accuracy `relative`, but the force does not change by a share of it over that error.
    pub(crate) fn is_flat(&self, relative: f64) -> bool {
        let (o, d) = (&self.observables, &self.difference);
        let change = 0.5 * self.force_curvature * d.displacement.powi(2);
        d.displacement.abs() > 0.1 * relative * o.displacement.abs() && change.abs() < FLAT * relative * o.force.abs()
    }
}

/// Most solves until a limit point is located.
const MOST_SOLVES: usize = 8;
/// A turn of the force is flat where what is left to find changes it by less than this share of the accuracy.
const FLAT: f64 = 0.2;
/// Most guesses by the chord of the slopes, and most halvings of the bracket behind them.
const MOST_GUESSES: usize = 24;
const MOST_BISECTIONS: usize = 16;
/// Where nothing closes in further a bracket is good enough over which, and between two meshes, displacement and force change by less than this,
/// relative.
const BRACKETED: f64 = 1e-6;
/// Its slopes must have come down to this share of those at the ends of the step: where they jump from one sign to the other is no limit point.
const LEVEL: f64 = 1e-3;
/// How near a corner of the path is closed in to, at best, over its step.
const CORNER: f64 = 1e-5;
/// The secant rule starts when it expects to move by no more than this share of the step.
const NEAR: f64 = 0.05;

/// Error of a solution on the way to a limit point, relative as in [`crate::solve::System::size`], and where a wary search finds no better.
pub(crate) const ROUGH: f64 = 1e-10;
const WARY: f64 = 1e-8;

fn options(tolerance: f64, exact_slope: bool) -> NewtonOptions {
    NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 10, exact_slope }
}

/// A further solution on a segment, at the label `at`, with an error of `tolerance`; from fewer points where more extrapolate badly.
pub(crate) fn solve_on(
    problem: &Problem,
    segment: &PathSegment,
    at: f64,
    tolerance: f64,
    ws: &mut Workspace,
) -> Result<Arc<Solution>, SolveError> {
    let constraint = PathConstraint { weights: segment.weights, target: segment.target(at) };
    let mut trouble = SolveError::SingularGrip;
    for points in [6, 3, 2] {
        let start = segment.near(problem, at).unwrap_or_else(|| segment.start(problem, at, points));
        match solve(problem, start, &constraint, &options(tolerance, ws.pace() == Pace::Watchful), ws) {
            Ok(solution) => return Ok(Arc::new(solution)),
            Err(error) => trouble = error,
        }
    }
    let looser = ws.pace() != Pace::Quick && tolerance < WARY;
    if looser { solve_on(problem, segment, at, WARY, ws).map_err(|_| trouble) } else { Err(trouble) }
}

/// How often the way to a solution inside a step is halved.
const MOST_HALVINGS: i32 = 4;
/// Most tries on that way: where there is no solution at its end, steps towards it would become shorter for ever.
const MOST_TRIES: usize = 40;

/// A further solution on a segment, which it joins, at the label `at`; where the start is too far away, by way of solutions
/// between there and `from`, where one is known.
pub(crate) fn step_to(
    problem: &Problem,
    segment: &mut PathSegment,
    from: f64,
    at: f64,
    tolerance: f64,
    ws: &mut Workspace,
) -> Result<Arc<Solution>, SolveError> {
    let mut known = from;
    let mut share = 1.0;
    let mut trouble = SolveError::SingularGrip;
    for _ in 0..MOST_TRIES {
        let next = if share == 1.0 { at } else { known + share * (at - known) };
        match solve_on(problem, segment, next, tolerance, ws) {
            Ok(solution) => {
                segment.insert(solution.clone());
                if share == 1.0 {
                    return Ok(solution);
                }
                known = next;
                share = 1.0;
            }
            Err(error) if share > 0.5f64.powi(MOST_HALVINGS) => {
                trouble = error;
                share *= 0.5;
            }
            Err(error) => return Err(error),
        }
    }
    Err(trouble)
}

/// Slope of a quantity at a solution on a segment, per unit of its label: at the solution itself.
pub(in crate::solve) fn slope_at(
    problem: &Problem,
    segment: &PathSegment,
    solution: &Solution,
    turn: LimitPointKind,
    ws: &mut Workspace,
) -> Result<f64, SolveError> {
    let constraint = PathConstraint { weights: segment.weights, target: segment.weights.dot(&solution.observables) };
    let (displacement, force) = slopes(problem, &solution.at, &constraint, ws)?;
    Ok(turn.pick()(&Observables { displacement, force, ..Observables::default() }))
}

/// Locates the limit point of `turn` between the labels `from` and `to`, at which its slope differs in sign.
///
/// First on meshes that follow the front, by chords of the slope; once near, on one mesh, on which the path is smooth to
/// rounding, by the secant rule for the slope. With an accuracy `relative`, a turn of the force in a segment over which it
/// hardly changes, measured by that, is taken as it stands.
pub fn locate(
    problem: &Problem,
    around: &PathSegment,
    turn: LimitPointKind,
    (from, to): (f64, f64),
    relative: Option<f64>,
    ws: &mut Workspace,
) -> Result<Located, SolveError> {
    let mut segment = around.clone();
    let mut iterations = 0;
    let (first, second) = around.end_slopes();
    let (mut low, mut high) = ((from, turn.pick()(&first)), (to, turn.pick()(&second)));
    let rising = if from == 0.0 { low.1 < 0.0 } else { high.1 > 0.0 };
    // where the slope is the discretisation's, the quantity may go further than where it seems to turn
    let furthest = |segment: &PathSegment, turned| segment.extreme(turn.pick(), rising, (from, to)).unwrap_or(turned);
    let mut guess = segment.observable(turn.pick(), 0.5 * (from + to)).turning_point(from, to);
    // next to a corner no bracket is worth more than another
    let bisections = if problem.system.step_dependence().exists() { 0 } else { MOST_BISECTIONS };
    for k in 1..=MOST_GUESSES + bisections {
        let nearer = if guess - low.0 < high.0 - guess { low.0 } else { high.0 };
        let solution = match step_to(problem, &mut segment, nearer, guess, ROUGH, ws) {
            Ok(solution) => solution,
            Err(cause) => {
                let known = known_at_corner(problem, &segment, turn, rising, (from, to)).ok_or(cause)?;
                let spanned = spanned_at_corner(&segment, turn, &known, [low, high]);
                return Ok(beside(problem, &segment, known, spanned, iterations, ws));
            }
        };
        iterations += solution.iterations;
        let label = segment.label(&solution.observables);
        // Newton's last slope is one update back: next to a turn, and where the force is flat, that is too far
        let slope = slope_at(problem, &segment, &solution, turn, ws)?;
        if (slope < 0.0) == rising {
            low = (label, slope);
        } else {
            high = (label, slope);
        }
        let width = high.0 - low.0;
        let value = turn.pick()(&solution.observables);
        if relative.is_some_and(|r| (slope * width).abs() < FLAT * r * value.abs()) {
            return flat(problem, &segment, furthest(&segment, solution), slope * width, iterations, ws);
        }
        let bend = (high.1 - low.1) / width;
        let left = (slope / bend).abs();
        if left < NEAR * (to - from) && left * solution.slope.monitors[0].abs() < NEAR * problem.measure.monitors[0] {
            let other = segment.observable(turn.other().pick(), label).at(label).2;
            let bends = match turn {
                LimitPointKind::Displacement => Bends { displacement: bend, force: other },
                LimitPointKind::Load => Bends { displacement: other, force: bend },
            };
            let search = LimitPointSearch { problem, weights: segment.weights, kind: turn, width: to - from };
            let slack = NEAR * (to - from);
            match confirmed(&search, &solution, segment.target(label), bends, rising, ws) {
                Ok(located) if (low.0 - slack..high.0 + slack).contains(&segment.label(&located.observables)) => {
                    return Ok(Located { iterations: iterations + located.iterations, ..located });
                }
                // the secant rule went elsewhere, or the turn is weak: close in further
                Ok(_) | Err(_) => iterations += MOST_SOLVES,
            }
        }
        // the chord of the slopes, kept off the ends; every third guess halves the bracket
        let chord = (low.0 - low.1 / bend).max(low.0 + 0.01 * width).min(high.0 - 0.01 * width);
        let bisects = k % 3 == 0 || k > MOST_GUESSES || !chord.is_finite();
        guess = if bisects { 0.5 * (low.0 + high.0) } else { chord };
    }
    let middle = solve_on(problem, &segment, 0.5 * (low.0 + high.0), ROUGH, ws)
        .or_else(|cause| known_at_corner(problem, &segment, turn, rising, (from, to)).ok_or(cause))?;
    if problem.system.step_dependence().exists() {
        let spanned = spanned_at_corner(&segment, turn, &middle, [low, high]);
        return Ok(beside(problem, &segment, middle, spanned, iterations, ws));
    }
    let change = turn.pick()(&middle.slope) * (high.0 - low.0);
    if relative.is_some_and(|r| change.abs() < r * middle.observables.force.abs()) {
        return flat(problem, &segment, furthest(&segment, middle), change, iterations, ws);
    }
    // where a path is watched all others have lost it: slopes may be round-off
    let falls = low.1.abs().max(high.1.abs()) <= LEVEL * turn.pick()(&first).abs().max(turn.pick()(&second).abs());
    let level = falls || ws.pace() == Pace::Watchful;
    if level && turn == LimitPointKind::Displacement && on_more_elements(problem, &middle, segment.weights, ws).is_ok()
    {
        let spanned = spanned(&segment, turn, &middle, [low, high]);
        let located = beside(problem, &segment, middle, spanned, iterations, ws);
        let (d, o) = (&located.difference, &located.observables);
        if d.displacement <= BRACKETED * o.displacement.abs() && d.force <= BRACKETED * o.force.abs() {
            return Ok(located);
        }
    }
    Err(SolveError::NotConverged { update: (high.0 - low.0) / (to - from), iterations })
}

/// Of a path that remembers, what is known next to a corner, where Newton's method may go to and fro: the turn is no farther than the bracket is wide.
fn known_at_corner(
    problem: &Problem,
    segment: &PathSegment,
    turn: LimitPointKind,
    rising: bool,
    bracket: (f64, f64),
) -> Option<Arc<Solution>> {
    let extreme = || segment.extreme(turn.pick(), rising, bracket);
    match problem.system.step_dependence() {
        StepDependence::None => None,
        StepDependence::Friction => extreme(),
        StepDependence::Yielding => extreme().or_else(|| Some(segment.first())),
    }
}

/// By how much displacement and force may change over a bracket around a solution, each of whose ends has the slope there of what turns,
/// per label.
fn spanned(
    segment: &PathSegment,
    turn: LimitPointKind,
    solution: &Solution,
    [low, high]: [(f64, f64); 2],
) -> Observables {
    let (steepest, width) = (low.1.abs().max(high.1.abs()), high.0 - low.0);
    let per_label = solution.slope.times(width / segment.weights.dot(&solution.slope));
    let across = |own: LimitPointKind| if own == turn { steepest * width } else { own.pick()(&per_label).abs() };
    Observables {
        displacement: across(LimitPointKind::Displacement),
        force: across(LimitPointKind::Load),
        ..Observables::default()
    }
}

/// The same next to a corner of the path, which is closed in to no further than [`CORNER`].
fn spanned_at_corner(
    segment: &PathSegment,
    turn: LimitPointKind,
    solution: &Solution,
    bracket: [(f64, f64); 2],
) -> Observables {
    let change = segment.change();
    let Observables { displacement, force, .. } = spanned(segment, turn, solution, bracket);
    Observables {
        displacement: CORNER * change.displacement.abs() + displacement,
        force: CORNER * change.force.abs() + force,
        ..Observables::default()
    }
}

/// A limit point of which no more is known than a solution beside it, and what displacement and force span between there and the point:
/// one at which the path has a corner, as where a face that slid sticks, or one that round-off hides.
fn beside(
    problem: &Problem,
    segment: &PathSegment,
    solution: Arc<Solution>,
    spanned: Observables,
    iterations: usize,
    ws: &mut Workspace,
) -> Located {
    let finer = on_more_elements(problem, &solution, segment.weights, ws);
    // no solution there either: what is missed by the width is far more
    let change = finer.map_or_else(|_| Observables::default(), |finer| finer.observables.since(&solution.observables));
    let difference = Observables {
        displacement: change.displacement.abs() + spanned.displacement,
        force: change.force.abs() + spanned.force,
        ..change
    };
    Located {
        observables: solution.observables,
        solution,
        difference,
        force_curvature: 0.0,
        flat: false,
        left_out: 0.0,
        iterations,
    }
}

/// A limit point that could not be located: the solution where an interpolant has it, or an end of its step, with the step as the error of both numbers.
pub(crate) fn unlocated(
    problem: &Problem,
    segment: &PathSegment,
    turn: LimitPointKind,
    ws: &mut Workspace,
) -> Result<Located, SolveError> {
    let end = segment.end();
    let guess = segment.observable(turn.pick(), 0.5 * end).turning_point(0.0, end);
    let solution = step_to(problem, &mut segment.clone(), 0.0, guess, ROUGH, ws).unwrap_or_else(|_| segment.first());
    let mut difference = difference_within_step(problem, &solution, ws)?;
    difference.displacement = segment.change().displacement.abs();
    difference.force = difference.force.abs() + segment.change().force.abs();
    let (observables, flat) = (solution.observables, turn == LimitPointKind::Load);
    Ok(Located { observables, solution, difference, force_curvature: 0.0, flat, left_out: 0.0, iterations: 3 })
}

/// [`difference_on_more_elements`] where the whole step counts as the error. Of a path that remembers nothing more where there is no solution on these:
/// there turns of what is remembered lie between points.
fn difference_within_step(problem: &Problem, coarse: &Solution, ws: &mut Workspace) -> Result<Observables, SolveError> {
    match difference_on_more_elements(problem, coarse, ws) {
        Err(_) if problem.system.step_dependence().exists() => Ok(Observables::default()),
        difference => difference,
    }
}

/// A limit point of the force in a segment so flat that its place cannot be determined and does not matter: a solution in it, with the whole step as the error of its displacement and `change` as that of its force.
fn flat(
    problem: &Problem,
    segment: &PathSegment,
    solution: Arc<Solution>,
    change: f64,
    iterations: usize,
    ws: &mut Workspace,
) -> Result<Located, SolveError> {
    let mut difference = difference_within_step(problem, &solution, ws)?;
    difference.displacement = segment.change().displacement.abs();
    difference.force = difference.force.abs() + change.abs();
    Ok(Located {
        observables: solution.observables,
        solution,
        difference,
        force_curvature: 0.0,
        flat: true,
        left_out: 0.0,
        iterations: iterations + 2,
    })
}

/// The limit point next to `near` on its mesh, by the secant rule, and on half as many elements again. It is a minimum where the slope is
/// `rising` through zero: of two limit points near by the other one does not.
fn confirmed(
    search: &LimitPointSearch,
    near: &Solution,
    target: f64,
    bends: Bends,
    rising: bool,
    ws: &mut Workspace,
) -> Result<Located, SolveError> {
    let coarse = search.run(near.at.clone(), target, BendRule::Secant(bends), ws)?;
    let start = search.problem.system.refined(&coarse.configuration(search.problem));
    let fine = search
        .run(start, coarse.target + coarse.ahead, BendRule::Secant(coarse.bends), ws)
        .map_err(|_| SolveError::LimitPointNotConfirmed)?;
    let bend = fine.bends.of(search.kind);
    if (bend > 0.0) != rising {
        return Err(SolveError::LimitPointNotConfirmed);
    }
    let difference = fine.observables.since(&coarse.observables);
    Ok(Located {
        solution: Arc::new(coarse.solution),
        observables: coarse.observables,
        difference: Observables {
            displacement: difference.displacement.abs() + coarse.neglected.displacement.abs(),
            force: difference.force.abs() + coarse.neglected.force.abs(),
            ..difference
        },
        force_curvature: bend / fine.solution.slope.displacement.powi(2),
        flat: false,
        left_out: 0.0,
        iterations: coarse.iterations + fine.iterations,
    })
}

/// Difference to the solution on half as many elements again at the same displacement.
pub(crate) fn difference_on_more_elements(
    problem: &Problem,
    coarse: &Solution,
    ws: &mut Workspace,
) -> Result<Observables, SolveError> {
    Ok(on_more_elements(problem, coarse, Observables::DISPLACEMENT, ws)?.observables.since(&coarse.observables))
}
