//! Where a branch loses its stability: located with the height of a tip as the parameter, which goes on where the displacement turns.
//!
//! Behind the peak of its law the force of a tip falls as it is pulled on. That is stable until it falls faster than the seta yields: there the
//! displacement u of the root turns as the tip's height η goes on, du/dη = 0. With everything else linear du/dη = a + b h(η), h = ∂²E/∂y² of
//! the tip, which says where to look. Where another direction than that of the branch becomes unstable first, du/dη does not turn, and the
//! number of negative eigenvalues alone shows it.

use super::knot::Knot;
use super::options::SetaOptions;
use super::standing::{RootDrive, Standing, TipTangent};
use crate::beam::SPATIAL_UNKNOWNS;
use crate::solve::{NewtonOptions, Observables, PathConstraint, Problem, Solution, SolveError, Workspace, solve};

/// Height among the unknowns of a joint
const HEIGHT: usize = 1;
/// Error of the displacement at a loss, nm.
const LOCATED: f64 = 1e-6;
/// The same where it is found by the number of negative eigenvalues.
const BRACKETED: f64 = 1e-4;
/// First step of a tip, nm, where nothing is known.
const FIRST: f64 = 1.0;
/// Longest step of a tip, nm.
const LONGEST: f64 = 20.0;
/// Shortest one, nm.
const SHORTEST: f64 = 1e-7;
/// Most solutions.
const MOST_SOLVES: usize = 80;
/// Components of the critical direction that differ by this share are equal by symmetry.
const ALIKE: f64 = 1e-6;
/// Most halvings of a step for the sake of its work.
const DEEPEST: usize = 8;

/// A loss of stability.
pub(super) struct Loss {
    /// Equilibria behind the start up to the loss, each with the work to it, aJ
    pub taken: Vec<(Solution, f64)>,
    /// Tips that go first
    pub critical: Vec<usize>,
    /// ∂²E/∂y² of the tip there, nN/nm
    pub slope: f64,
    pub iterations: usize,
}

/// Change of the height of a tip with the parameter of a solution.
pub(super) fn rate(standing: &Standing, solution: &Solution, tip: usize) -> f64 {
    solution.tangent.direction[standing.model.seta.tip_joint(tip) * SPATIAL_UNKNOWNS + HEIGHT]
}

/// A branch along which the height of a tip grows.
struct Along<'a> {
    standing: &'a Standing,
    problem: Problem,
    tip: usize,
    options: &'a SetaOptions,
    iterations: usize,
}

impl Along<'_> {
    fn solve(&mut self, from: &Knot, height: f64, ws: &mut Workspace) -> Result<Knot, SolveError> {
        let per_height = rate(self.standing, &from.solution, self.tip);
        let ahead = (height - from.parameter) / per_height;
        let start = from.solution.moved(&self.problem, ahead);
        let newton = NewtonOptions {
            tolerance: self.options.tolerance,
            largest_update: 3.0,
            most_iterations: 10,
            exact_slope: false,
        };
        let constraint = PathConstraint { weights: Observables::monitor(0), target: height };
        let solution = solve(&self.problem, start, &constraint, &newton, ws)?;
        self.iterations += solution.iterations;
        Ok(Knot::new(height, solution, 1.0))
    }

    /// h = ∂²E/∂y² of the tip at another height.
    fn softening(&self, at: &Knot, height: f64) -> Option<f64> {
        let (mut place, directors) = self.standing.place(&at.solution.at, self.tip);
        place[HEIGHT] += height - at.parameter;
        let own = &self.standing.tips[self.tip];
        let adheres = own.branch(place, directors).adheres();
        adheres.then(|| crate::beam::EndEnergy::response(own, place, directors).hessian[HEIGHT][HEIGHT])
    }

    /// The height ahead at which h falls to this, or the end of the branch.
    fn where_softening_is(&self, at: &Knot, wanted: f64) -> f64 {
        let falls = |height: f64| self.softening(at, height).is_none_or(|h| h < wanted);
        let (mut low, mut step) = (at.parameter, FIRST);
        while !falls(low + step) && step < 1e4 {
            low += step;
            step *= 1.5;
        }
        let mut high = low + step;
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if falls(middle) { high = middle } else { low = middle }
        }
        low
    }

    /// Work by cubics between two knots as good as asked for: solutions in between.
    fn refined(
        &mut self,
        from: &Knot,
        to: Knot,
        depth: usize,
        ws: &mut Workspace,
        out: &mut Vec<Knot>,
    ) -> Result<(), SolveError> {
        if depth < DEEPEST && from.imbalance_to(&to, self.options.balance, 0.0).1 > 1.0 {
            let middle = self.solve(from, 0.5 * (from.parameter + to.parameter), ws)?;
            self.refined(from, middle.clone(), depth + 1, ws, out)?;
            return self.refined(&middle, to, depth + 1, ws, out);
        }
        out.push(to);
        Ok(())
    }
}

/// The loss of stability ahead of a stable equilibrium, on the way of this tip; `slope` is what ∂²E/∂y² was at the loss before.
pub(super) fn locate(
    standing: &Standing,
    drive: &RootDrive,
    here: &Solution,
    tip: usize,
    slope: Option<f64>,
    options: &SetaOptions,
    ws: &mut Workspace,
) -> Result<Loss, SolveError> {
    let problem = standing.problem(drive, Some(tip), TipTangent::Own);
    let per_displacement = rate(standing, here, tip);
    let height = standing.place(&here.at, tip).0[HEIGHT];
    let first = Knot::new(height, here.clone(), per_displacement);
    let mut along = Along { standing, problem, tip, options, iterations: 0 };
    let guess = slope.map_or(height + FIRST, |slope| along.where_softening_is(&first, slope));
    let (mut low, mut high): (Vec<Knot>, Option<Knot>) = (vec![first], None);
    let mut longest = LONGEST;
    let mut next = guess.clamp(height + SHORTEST, height + longest);
    for _ in 0..MOST_SOLVES {
        let from = low[low.len() - 1].clone();
        let solved = along.solve(&from, next, ws);
        let found = match solved {
            Ok(knot) if standing.changing(&knot.solution.at).is_empty() => knot,
            // beyond the end of the branch, or too far
            other => {
                longest = 0.3 * (next - from.parameter);
                if longest < SHORTEST {
                    return match other {
                        // stable up to the end of the branch of the tip
                        Ok(_) if low.len() > 1 => finished(along, low, vec![tip], ws),
                        Ok(_) => Err(SolveError::LimitPointNotConfirmed),
                        Err(cause) => Err(cause),
                    };
                }
                next = from.parameter + longest;
                continue;
            }
        };
        let is_stable = found.solution.negative == 0 && found.slopes[0] > 0.0;
        let turns = found.slopes[0] <= 0.0 || is_stable;
        let estimate = model_root(&along, &from, &found);
        let error = 0.5 * (found.slopes[0] * (estimate - found.parameter)).abs();
        if turns && error < LOCATED {
            let critical = fold_tips(standing, &found.solution);
            low.push(found);
            return finished(along, low, critical, ws);
        }
        if let Some(high) = &high
            && !turns
            && (high.values[0] - from.values[0]).abs() < BRACKETED
        {
            let critical = branching_tips(standing, &along.problem, &found.solution, ws)?;
            return finished(along, low, critical, ws);
        }
        if is_stable {
            low.push(found)
        } else {
            high = Some(found)
        }
        let from = &low[low.len() - 1];
        longest = (1.7 * longest).min(LONGEST);
        next = match &high {
            Some(high) => {
                let (a, b) = (from.parameter, high.parameter);
                let inside = estimate > a && estimate < b && turns;
                if inside { estimate } else { 0.5 * (a + b) }
            }
            None if estimate > from.parameter => estimate.min(from.parameter + longest),
            None => from.parameter + longest.min(2.0 * FIRST),
        };
    }
    Err(SolveError::LimitPointNotConfirmed)
}

/// Where du/dη = a + b h(η) through two knots is zero.
fn model_root(along: &Along, one: &Knot, other: &Knot) -> f64 {
    let h = |knot: &Knot| along.softening(knot, knot.parameter);
    let (Some(first), Some(second)) = (h(one), h(other)) else { return f64::NAN };
    let b = (other.slopes[0] - one.slopes[0]) / (second - first);
    if !(b.is_finite() && b > 0.0) {
        return f64::NAN;
    }
    let wanted = second - other.slopes[0] / b;
    let from = if other.slopes[0] > 0.0 { other } else { one };
    along.where_softening_is(from, wanted)
}

fn finished(mut along: Along, low: Vec<Knot>, critical: Vec<usize>, ws: &mut Workspace) -> Result<Loss, SolveError> {
    let mut knots = vec![low[0].clone()];
    for pair in low.windows(2) {
        along.refined(&pair[0], pair[1].clone(), 0, ws, &mut knots)?;
    }
    let last = &knots[knots.len() - 1];
    let slope = along.softening(last, last.parameter).unwrap_or(0.0);
    let works: Vec<f64> = knots.windows(2).map(|pair| pair[0].work_to(&pair[1])).collect();
    let taken = knots.into_iter().skip(1).map(|knot| knot.solution).zip(works).collect();
    Ok(Loss { taken, critical, slope, iterations: along.iterations })
}

/// Where the branch turns its own direction is critical: the tips that go up the fastest, where equal all of them.
fn fold_tips(standing: &Standing, at: &Solution) -> Vec<usize> {
    fastest(standing, |tip| rate(standing, at, tip))
}

/// Where it branches: by the direction in which the tangent is least stiff.
fn branching_tips(
    standing: &Standing,
    problem: &Problem,
    at: &Solution,
    ws: &mut Workspace,
) -> Result<Vec<usize>, SolveError> {
    use crate::solve::{Bordered, Tangents};
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: at.observables.displacement };
    let tangents = Tangents::new(problem, &at.at, &held, ws)?;
    let unknowns = problem.system.unknowns(&at.at);
    let mut mode: Vec<f64> = (1..=unknowns).map(|k| (0.618_033_988_749_895 * k as f64).fract() - 0.5).collect();
    for _ in 0..4 {
        mode = tangents.solve(&Bordered { direction: mode, last: 0.0 }, ws)?.direction;
        let largest = mode.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        mode.iter_mut().for_each(|x| *x /= largest);
    }
    let of = |tip: usize| mode[standing.model.seta.tip_joint(tip) * SPATIAL_UNKNOWNS + HEIGHT];
    let adhering = (0..standing.tips.len()).filter(|&tip| standing.tips[tip].on.adheres());
    let most = adhering.clone().map(|tip| of(tip).abs()).fold(0.0, f64::max);
    let sign = adhering.clone().find(|&tip| of(tip).abs() >= (1.0 - ALIKE) * most).map_or(1.0, |tip| of(tip).signum());
    Ok(fastest(standing, |tip| sign * of(tip)))
}

fn fastest(standing: &Standing, speed: impl Fn(usize) -> f64) -> Vec<usize> {
    let adhering = (0..standing.tips.len()).filter(|&tip| standing.tips[tip].on.adheres());
    let most = adhering.clone().map(&speed).fold(f64::NEG_INFINITY, f64::max);
    adhering.filter(|&tip| speed(tip) >= most - ALIKE * most.abs()).collect()
}
