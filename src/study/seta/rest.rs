//! Where a seta comes to rest at a root that stands still, while tips detach or adhere.
//!
//! Down the energy in the metric of the seta's own stiffness: each step solves K⁺ δ = -R, where K⁺ is the tangent without what softens the
//! tips, so that δ always leads downhill and no step goes over a ridge into another equilibrium: the force of every tip is as it is, and the
//! seta yields to it; then the forces follow. A step ends where the first tip comes to the end of its branch; that tip goes over to the other
//! branch there. Where no tip changes any more and the step is small, Newton's own method finds the equilibrium, which has to be stable.

use super::loss::{critical_direction, disturbed};
use super::result::TipChange;
use super::standing::{HEIGHT, RootDrive, Standing, TipTangent};
use crate::model::seta::tip_law::TipBranch;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, damped_step, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::system::Coefficients;
use crate::solve::workspace::Workspace;

/// Steps, of which each may change a tip.
const MOST_STEPS: usize = 4000;
/// Most that a tip that adheres moves in a step in the directions in which something holds it, nm.
const MOST_MOVED: f64 = 10.0;
/// Below this step, in units of the scales of the tree, Newton's own method is tried.
const NEAR: f64 = 0.5;
/// Halvings of a step until the place is found at which a tip changes.
const HALVINGS: usize = 40;
/// A step this small that ends in an unstable equilibrium has come to a saddle.
const SADDLE: f64 = 1e-4;
/// Pseudo-times of damping: the longest and the shortest, what is left of one with which the energy does not fall, and the growth of one with
/// which it does.
const LONGEST_TIME: f64 = 1e6;
const SHORTEST_TIME: f64 = 1e-9;
const LESS_TIME: f64 = 0.1;
const MORE_TIME: f64 = 2.0;
/// Longest damped step, in units of the scales of the tree.
const MOST_DAMPED: f64 = 5.0;
/// Tips whose shares of a step differ by less change at once: they do so by symmetry.
const AT_ONCE: f64 = 1e-7;

/// A stable equilibrium, and how it was reached.
pub(in crate::study) struct Rested {
    pub solution: Solution,
    pub changes: Vec<TipChange>,
    pub iterations: usize,
}

/// Lets tips change, and all that follows from that; the displacement is held.
pub(in crate::study) fn come_to_rest(
    standing: &mut Standing,
    drive: &RootDrive,
    (mut at, displacement): (State, f64),
    first: &[usize],
    tolerance: f64,
    ws: &mut Workspace,
) -> Result<Rested, (SolveError, usize)> {
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: displacement };
    let mut changes: Vec<TipChange> = first.iter().map(|&tip| changed(standing, &at, tip)).collect();
    let (mut iterations, mut time) = (0, f64::INFINITY);
    let mut problem = standing.problem(drive, None, TipTangent::Convex);
    for _ in 0..MOST_STEPS {
        let (mut next, size) =
            downhill(&problem, &at, &held, &mut time, &mut iterations, ws).map_err(|cause| (cause, changes.len()))?;
        let share = largest_share(standing, &at, &next);
        let share = if time.is_finite() { share.min(MOST_DAMPED / size) } else { share };
        let step = (problem.system.difference(&at.values, &next.values), next.force - at.force);
        let shortened = |share: f64| {
            let mut part = at.clone();
            problem.system.retract(&mut part, &step.0, share);
            part.force += share * step.1;
            part
        };
        if share < 1.0 {
            next = shortened(share);
        }
        if time.is_finite() && energy(&problem, &next) > energy(&problem, &at) {
            time *= LESS_TIME;
            continue;
        }
        let changing = standing.changing(&next);
        if changing.is_empty() {
            at = next;
            if size > NEAR {
                continue;
            }
            let own = standing.problem(drive, None, TipTangent::Own);
            let newton =
                NewtonOptions { tolerance, largest_update: 2.0 * NEAR, most_iterations: 12, exact_slope: true };
            let Ok(solution) = solve(&own, at.clone(), &held, &newton, ws) else { continue };
            iterations += solution.iterations;
            if solution.negative == 0 && standing.changing(&solution.at).is_empty() {
                standing.note(&solution.at);
                return Ok(Rested { solution, changes, iterations });
            }
            if size < SADDLE && solution.negative > 0 {
                // by symmetry downhill leads to a saddle
                let mode = critical_direction(&own, &solution, ws).map_err(|cause| (cause, changes.len()))?;
                at = disturbed(&own, &solution.at, &mode);
            }
            continue;
        }
        let mut shares: Vec<(f64, usize)> =
            changing.into_iter().map(|tip| (share_of_change(standing, &at, &next, tip), tip)).collect();
        shares.sort_by(|a, b| a.0.total_cmp(&b.0));
        let least = shares[0].0;
        let part = shortened(least * share);
        for (_, tip) in shares.into_iter().take_while(|(share, _)| *share <= least + AT_ONCE) {
            changes.push(changed(standing, &part, tip));
        }
        problem = standing.problem(drive, None, TipTangent::Convex);
        at = part;
    }
    let cause = SolveError::NotConverged { update: f64::NAN, iterations: MOST_STEPS };
    Err((cause, changes.len()))
}

/// A step downhill, and its size. Where K⁺ is not positive, as where beams buckle, with damping: K⁺ + C/Δt with a pseudo-time Δt so short that
/// it is.
fn downhill(
    problem: &Problem,
    at: &State,
    held: &PathConstraint,
    time: &mut f64,
    iterations: &mut usize,
    ws: &mut Workspace,
) -> Result<(State, f64), SolveError> {
    loop {
        let mut next = at.clone();
        *iterations += 1;
        let damping = Coefficients { per_damping: *time, ..Coefficients::STATIC };
        let (size, (negative, _)) = damped_step(problem, &mut next, held, damping, f64::INFINITY, ws)?;
        if negative == 0 {
            *time = if *time > LONGEST_TIME { f64::INFINITY } else { MORE_TIME * *time };
            return Ok((next, size));
        }
        *time = (LESS_TIME * *time).min(LONGEST_TIME);
        if *time < SHORTEST_TIME {
            return Err(SolveError::NotConverged { update: size, iterations: *iterations });
        }
    }
}

/// Of a state that need not be in equilibrium, aJ.
pub(super) fn energy(problem: &Problem, at: &State) -> f64 {
    let still = vec![0.0; problem.system.unknowns(at)];
    problem.system.evaluate(at, &still).0.energy
}

fn changed(standing: &mut Standing, at: &State, tip: usize) -> TipChange {
    let load = standing.load(at, tip);
    let to = standing.change(at, tip);
    TipChange { tip, to, load }
}

/// The part of a step in which no tip that adheres moves too far; along the ground it may, where it slides.
fn largest_share(standing: &Standing, from: &State, to: &State) -> f64 {
    let mut most: f64 = 0.0;
    for tip in (0..standing.tips.len()).filter(|&tip| standing.tips[tip].on != TipBranch::Detached) {
        let (a, b) = (standing.place(from, tip).0, standing.place(to, tip).0);
        let hessian = standing.response(from, tip).hessian;
        let counts = |&i: &usize| i == HEIGHT || hessian[i].iter().any(|&own| own != 0.0);
        most = most.max((0..3).filter(counts).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max));
    }
    (MOST_MOVED / most).min(1.0)
}

/// The part of a step at which a tip changes, its place taken along a straight line.
pub(in crate::study) fn share_of_change(standing: &Standing, from: &State, to: &State, tip: usize) -> f64 {
    let ((a, directors), (b, _)) = (standing.place(from, tip), standing.place(to, tip));
    let own = &standing.tips[tip];
    let changes = |share: f64| {
        let place = std::array::from_fn(|i| a[i] + share * (b[i] - a[i]));
        own.adheres(place, directors) != own.on.adheres()
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if changes(middle) { high = middle } else { low = middle }
    }
    high
}
