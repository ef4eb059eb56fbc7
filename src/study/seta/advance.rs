//! One step of the root: along the branch, to a contact, or to a loss of stability.

use super::knot::{Allowed, Knot, Reached, maximum};
use super::loading::SetaOptions;
use super::loss::{Loss, Watched, locate};
use super::rest::share_of_change;
use super::standing::{HEIGHT, RootDrive, Standing, TipTangent};
use crate::beam::spatial::tree::branching_beam::EndEnergy;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::states::seta_state::LocationError;

/// Error of the displacement at which a tip comes to the end of its branch, nm.
const LOCATED: f64 = 1e-6;
/// How far behind that a step is aimed, nm, and the error of both together.
const BEHIND: f64 = 0.3 * LOCATED;
const LATE: f64 = LOCATED + BEHIND;
/// A step to a contact that is no longer than this, nm, is taken whatever its work.
const SHORT: f64 = 1e-3;
/// What is left of a step that was refused.
const SHORTER: f64 = 0.4;
/// Most growth of a step.
const GROWTH: f64 = 2.0;
/// Steps are as long as the error of their work allows, less this factor of safety; the error goes with the fifth power.
const SAFETY: f64 = 0.8;
const ORDER: f64 = 0.2;
/// A force is met to this share.
const MET: f64 = 1e-9;
/// A tip that the ground attracts by less than this, nN, is not loaded.
const UNLOADED: f64 = 1e-6;
/// The softest tip is said to lose its hold where it has gone this far on the way to where the last one did.
const WARY: f64 = 0.7;
/// Where a place of a joint goes on this many times as fast as the root, the displacement may be about to turn.
const FAST: f64 = 4.0;

/// What a step comes to.
pub(super) enum Advance {
    /// An equilibrium of the same branch, before it one where the force has a maximum, and how far to go next, nm; where the force has that maximum
    /// at the start of the step, by how much the start misses it
    Taken { taken: Vec<Reached>, start: Option<LocationError>, next: f64 },
    /// One where tips come to the end of their branch
    Contact { taken: Box<Reached>, tips: Vec<usize> },
    /// Stability is lost, or nearly
    Lost(Loss),
    /// Try so far, nm
    Shorter { ahead: f64, why: Refusal },
}

/// Why a step is to be shorter.
pub(super) enum Refusal {
    /// No equilibrium was found there.
    Unsolved(SolveError),
    /// The equilibrium there is not stable.
    Unstable,
    /// Work and energy differ by so many times what is allowed.
    Unbalanced(f64),
    /// What is looked for lies before its end.
    TooFar,
}

/// A step of so far from an equilibrium; to a force where one is wanted. With it the Newton iterations. `softest` is the ∂²E/∂y² of a tip at
/// which stability was lost before.
pub(super) fn advance(
    standing: &Standing,
    drive: &RootDrive,
    (here, ahead): (&Solution, f64),
    (softest, preload): (Option<f64>, Option<f64>),
    options: &SetaOptions,
    ws: &mut Workspace,
) -> (Advance, usize) {
    let problem = standing.problem(drive, None, TipTangent::Own);
    let near = |&(_, h): &(usize, f64)| softest.is_some_and(|softest| h < WARY * softest);
    let own = softest_ahead(standing, &problem, here, ahead);
    let drawn = || drawn_ahead(standing, &problem, here, ahead).map(|tip| (tip, f64::NEG_INFINITY));
    let softening = own.filter(near).or_else(drawn).or(own);
    let mut iterations = 0;
    if let Some((tip, _)) = softening.filter(near)
        && let Ok(loss) = locate(standing, drive, here, Watched::tip(standing, tip), softest, options, ws)
    {
        iterations += loss.iterations;
        return (Advance::Lost(loss), iterations);
    }
    let from = here.observables.displacement;
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: from + ahead };
    let newton = NewtonOptions { most_iterations: 9, ..options.newton() };
    let refused = match solve(&problem, moved(here, &problem, ahead), &held, &newton, ws) {
        Ok(solution) if solution.negative == 0 => {
            iterations += solution.iterations;
            match judged(standing, &problem, (here, ahead), solution, preload, options, (&mut iterations, ws)) {
                refused @ Advance::Shorter { why: Refusal::Unbalanced(_), .. } => refused,
                other => return (other, iterations),
            }
        }
        Err(SolveError::Stopped) => {
            let stopped = Refusal::Unsolved(SolveError::Stopped);
            return (Advance::Shorter { ahead: 0.0, why: stopped }, iterations);
        }
        Ok(_) => Advance::Shorter { ahead: SHORTER * ahead, why: Refusal::Unstable },
        Err(cause) => Advance::Shorter { ahead: SHORTER * ahead, why: Refusal::Unsolved(cause) },
    };
    let Advance::Shorter { why, .. } = &refused else { return (refused, iterations) };
    // what may lie ahead: a tip that loses its hold, a turn of the displacement, another shape
    let mut followed = Vec::new();
    let is_unbalanced = matches!(why, Refusal::Unbalanced(_));
    followed.extend(softening.filter(|own| own.1 < 0.0 && !is_unbalanced).map(|own| Watched::tip(standing, own.0)));
    let (fastest, rate) = Watched::fastest(standing, here, ahead);
    if rate > FAST || (matches!(why, Refusal::Unstable) && followed.is_empty()) {
        followed.push(fastest);
    }
    for watched in followed {
        if let Ok(loss) = locate(standing, drive, here, watched, softest, options, ws) {
            iterations += loss.iterations;
            return (Advance::Lost(loss), iterations);
        }
    }
    (refused, iterations)
}

/// What a stable equilibrium ahead is good for.
fn judged(
    standing: &Standing,
    problem: &Problem,
    (here, ahead): (&Solution, f64),
    solution: Solution,
    preload: Option<f64>,
    options: &SetaOptions,
    (iterations, ws): (&mut usize, &mut Workspace),
) -> Advance {
    let changing = standing.changing(&solution.at);
    let shares: Vec<(f64, usize)> =
        changing.iter().map(|&tip| (share_of_change(standing, &here.at, &solution.at, tip), tip)).collect();
    let least = shares.iter().map(|share| share.0).fold(f64::INFINITY, f64::min);
    let late = |share: f64| (1.0 - share) * ahead <= LOCATED;
    if !shares.is_empty() && !late(least) {
        return Advance::Shorter { ahead: least * ahead + BEHIND, why: Refusal::TooFar };
    }
    let from = Knot::new(here.observables.displacement, here.clone(), here.slope.displacement);
    let knot = Knot::new(solution.observables.displacement, solution, 1.0);
    let (work, imbalance) = from.imbalance_to(&knot, &Allowed::new(standing, here, options.balance));
    // a seta without a tip that adheres or is attracted has one equilibrium, and no force but round-off
    let is_loaded = || [here, &knot.solution].into_iter().any(|at| largest_load(standing, at) > UNLOADED);
    let imbalance = if standing.attached() == 0 && !is_loaded() { 0.0 } else { imbalance };
    if imbalance > 1.0 && (shares.is_empty() || ahead > SHORT) {
        let factor = (SAFETY * imbalance.powf(-ORDER)).clamp(0.1, 0.7);
        return Advance::Shorter { ahead: factor * ahead, why: Refusal::Unbalanced(imbalance) };
    }
    if !shares.is_empty() {
        let location = LocationError { force: (knot.slopes[1] * LATE).abs(), displacement: LATE };
        return Advance::Contact {
            taken: Box::new(Reached { solution: knot.solution, work, location: Some(location) }),
            tips: changing,
        };
    }
    if let Some(shorter) = preload.and_then(|preload| before_preload(&from, &knot, preload)) {
        return Advance::Shorter { ahead: shorter, why: Refusal::TooFar };
    }
    let next = ahead * (SAFETY * imbalance.max(1e-12).powf(-ORDER)).clamp(0.3, GROWTH);
    let (mut taken, mut start) = (Vec::new(), None);
    let mut last = from;
    if preload.is_none() && has_maximum(&last, &knot, MET * largest_load(standing, here)) {
        let newton = NewtonOptions { exact_slope: true, ..options.newton() };
        let mut solve_at = |[near, far]: [&Knot; 2], displacement: f64| {
            let held = PathConstraint { weights: Observables::DISPLACEMENT, target: displacement };
            let per = [near, far].map(|knot| 1.0 / knot.solution.slope.displacement);
            let start = near.predicted(far, displacement, per, problem);
            let solution = solve(problem, start, &held, &newton, ws)?;
            *iterations += solution.iterations;
            let is_stable = solution.negative == 0 && standing.changing(&solution.at).is_empty();
            let knot = Knot::new(displacement, solution, 1.0);
            if is_stable { Ok(knot) } else { Err(SolveError::LimitPointNotConfirmed) }
        };
        match maximum(&last, &knot, &mut solve_at) {
            Some((highest, error)) if highest.parameter > last.parameter => {
                let work = last.work_to(&highest);
                taken.push(Reached { solution: highest.solution.clone(), work, location: Some(error) });
                last = highest;
            }
            highest => start = highest.map(|(_, error)| error),
        }
    }
    if knot.parameter > last.parameter {
        let work = last.work_to(&knot);
        taken.push(Reached { solution: knot.solution, work, location: None });
    }
    Advance::Taken { taken, start, next }
}

/// Of all tips, nN: a seta that slides carries no force, and is balanced all the same.
fn largest_load(standing: &Standing, here: &Solution) -> f64 {
    let load = |tip: usize| standing.load(&here.at, tip).iter().fold(0.0f64, |most, f| most.max(f.abs()));
    (0..standing.tips.len()).map(load).fold(0.0, f64::max)
}

/// The step to where the force reaches a preload, if that lies within the step and not at its end.
fn before_preload(from: &Knot, to: &Knot, preload: f64) -> Option<f64> {
    if to.values[1] <= preload * (1.0 + MET) {
        return None;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if from.force_at(to, middle).0 >= preload { high = middle } else { low = middle }
    }
    Some(high * (to.parameter - from.parameter))
}

/// Whether the force turns from rising to falling, by more than round-off. A force below `round_off`, nN, is none.
fn has_maximum(from: &Knot, to: &Knot, round_off: f64) -> bool {
    let carries = from.values[1].abs().max(to.values[1].abs()) > round_off;
    carries && from.slopes[1] > 0.0 && to.slopes[1] < -MET * from.slopes[1]
}

/// The tip whose softening counts the most a step ahead, as far as the tangent says, and its ∂²E/∂y² = h; none where none adheres. The stiffness
/// along the branch is that of all with h v² of every tip, v its part in the tangent: the softest tip counts little where it is not moved.
fn softest_ahead(standing: &Standing, problem: &Problem, here: &Solution, ahead: f64) -> Option<(usize, f64)> {
    let at = moved(here, problem, ahead);
    let mut softest: Option<(usize, f64, f64)> = None;
    for (tip, own) in standing.tips.iter().enumerate().filter(|(_, own)| own.on.adheres()) {
        let rate = Watched::tip(standing, tip).rate(here) / here.slope.displacement;
        if rate <= 0.0 {
            continue;
        }
        let (place, directors) = standing.place(&at, tip);
        let h = if own.adheres(place, directors) {
            standing.softening(&own.response(place, directors), tip, &here.tangent.direction)
        } else {
            f64::NEG_INFINITY
        };
        let counts = h * rate * rate;
        if softest.is_none_or(|(.., least)| counts < least) {
            softest = Some((tip, h, counts));
        }
    }
    softest.map(|(tip, h, _)| (tip, h))
}

/// The detached tip that the ground draws on to where it snaps on first a step ahead, as far as the tangent says.
fn drawn_ahead(standing: &Standing, problem: &Problem, here: &Solution, ahead: f64) -> Option<usize> {
    let at = moved(here, problem, ahead);
    let direction = &here.tangent.direction;
    let is_drawn = |&tip: &usize| {
        standing.place(&at, tip).0[HEIGHT] < standing.place(&here.at, tip).0[HEIGHT]
            && standing.snaps_on_within(&at, tip, 0.0)
            && standing.softening(&standing.response(&here.at, tip), tip, direction) < 0.0
    };
    let share = |tip: usize| (tip, share_of_change(standing, &here.at, &at, tip));
    let drawn = (0..standing.tips.len()).filter(is_drawn).map(share);
    drawn.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(tip, _)| tip)
}

/// Where the tangent leads when the root goes so far, nm.
fn moved(here: &Solution, problem: &Problem, ahead: f64) -> State {
    here.moved(problem, ahead / here.slope.displacement)
}
