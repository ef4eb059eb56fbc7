//! The work of the root between two equilibria of one branch, from force, displacement and their slopes at both.

use super::standing::Standing;
use crate::number::root::{self, Passing};
use crate::solve::error::{Quantity, SolveError};
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::events::{EventAt, StationQuantity};
use crate::study::states::seta_state::LocationError;

/// Places and weights of Gauss's rule with four points on [0, 1].
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// An equilibrium that the root was moved to.
#[derive(Clone, Debug)]
pub(super) struct Reached {
    pub solution: Solution,
    /// Of the root on the way to it, aJ
    pub work: f64,
    /// Where it stands for a place on the branch, a maximum of the force or the end of the branch: by how much it misses that
    pub location: Option<LocationError>,
}

/// An equilibrium on a branch with a parameter η.
#[derive(Clone, Debug)]
pub(super) struct Knot {
    /// η
    pub parameter: f64,
    /// u (nm) and P (nN)
    pub values: [f64; 2],
    /// Their change with η
    pub slopes: [f64; 2],
    pub solution: Solution,
}

impl Knot {
    /// Of a solution whose slopes are per unit of the parameter times `rate`.
    pub(crate) fn new(parameter: f64, solution: Solution, rate: f64) -> Self {
        let (o, slope) = (&solution.observables, &solution.slope);
        let (values, slopes) = ([o.displacement, o.force], [slope.displacement / rate, slope.force / rate]);
        Self { parameter, values, slopes, solution }
    }

    /// The state where the parameter has another value, on the cubic through this state and that of `other` with their tangents. `per` is by how
    /// much the target of the constraint of either solution changes with the parameter.
    pub(crate) fn predicted(&self, other: &Self, parameter: f64, per: [f64; 2], problem: &Problem) -> State {
        let length = other.parameter - self.parameter;
        let t = (parameter - self.parameter) / length;
        let [own, others] = [(1.0 - t) * (1.0 - t) * t * length * per[0], (t - 1.0) * t * t * length * per[1]];
        let share = (3.0 - 2.0 * t) * t * t;
        let (from, to) = (&self.solution, &other.solution);
        let mut way = problem.system.difference(&from.at.values, &to.at.values);
        let tangents = from.tangent.direction.iter().zip(&to.tangent.direction);
        for (way, (a, b)) in way.iter_mut().zip(tangents) {
            *way = share * *way + own * a + others * b;
        }
        let mut at = from.at.clone();
        problem.system.retract(&mut at, &way, 1.0);
        at.force += share * (to.at.force - from.at.force) + own * from.tangent.force + others * to.tangent.force;
        at
    }

    /// The equilibrium at a displacement between this one and another, by cubics alone: with the energy of this one.
    fn guessed(&self, other: &Self, displacement: f64, problem: &Problem) -> Self {
        let per = [self, other].map(|knot| 1.0 / knot.solution.slope.displacement);
        let at = self.predicted(other, displacement, per, problem);
        let share = (displacement - self.parameter) / (other.parameter - self.parameter);
        let (force, slope) = self.force_at(other, share);
        let observables = Observables { displacement, force, ..self.solution.observables };
        let mut solution = self.solution.clone();
        (solution.at, solution.observables) = (State { force, ..at }, observables);
        Self { parameter: displacement, values: [displacement, force], slopes: [1.0, slope], solution }
    }

    /// P and dP/dt at a share t of the way to another one, with a cubic of η.
    pub(crate) fn force_at(&self, other: &Self, t: f64) -> (f64, f64) {
        self.cubic(other, 1, t)
    }

    /// The share of the way to another one at which the cubic of displacement (0) or force (1), which rises here and falls there, turns.
    pub(crate) fn turn_of(&self, other: &Self, k: usize) -> f64 {
        let (mut first, mut last) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (first + last);
            if self.cubic(other, k, middle).1 > 0.0 { first = middle } else { last = middle }
        }
        0.5 * (first + last)
    }

    /// Displacement (0) or force (1) and its derivative at a share t of the way to another one.
    fn cubic(&self, other: &Self, k: usize, t: f64) -> (f64, f64) {
        let length = other.parameter - self.parameter;
        let (from, rise) = (self.values[k], other.values[k] - self.values[k]);
        let (a, b) = (length * self.slopes[k], length * other.slopes[k]);
        let (c2, c3) = (3.0 * rise - 2.0 * a - b, a + b - 2.0 * rise);
        (from + t * (a + t * (c2 + t * c3)), a + t * (2.0 * c2 + t * 3.0 * c3))
    }

    /// ∫ P du to another one, aJ, with cubics of η for both.
    pub(crate) fn work_to(&self, other: &Self) -> f64 {
        let cubic = |k, t| self.cubic(other, k, t);
        GAUSS.into_iter().map(|(t, weight)| weight * cubic(1, t).0 * cubic(0, t).1).sum()
    }

    /// The work to another one, and by how much it and the change of energy differ, over what is allowed.
    pub(crate) fn imbalance_to(&self, other: &Self, allowed: &Allowed) -> (f64, f64) {
        let (work, gained) = (self.work_to(other), other.solution.energy - self.solution.energy);
        let least = allowed.least * (other.values[0] - self.values[0]).abs();
        let most = allowed.balance * gained.abs().max(work.abs()).max(least) + allowed.round_off;
        (work, (work - gained).abs() / most)
    }
}

/// By how much the work of a step and the change of its energy may differ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    /// Over the larger of the two, or over the work of `least`
    balance: f64,
    /// A force that counts however small that on the root is, nN
    least: f64,
    /// Error of an energy, aJ
    round_off: f64,
}

/// Error of a number over itself, after all that is done with it.
const ROUND_OFF: f64 = 2e-15;

impl Allowed {
    /// From an equilibrium. A place x of the root's distance from the ground and a rotation are known to round-off, against which the section
    /// force N and moment M of the shaft work: N x ε and M ε, beside ε of the energies that are summed.
    pub(crate) fn new(standing: &Standing, here: &Solution, balance: f64) -> Self {
        let energies: f64 = (0..standing.tips.len()).map(|tip| standing.response(&here.at, tip).energy.abs()).sum();
        let root = standing.tree.section(&here.at, 0, 0);
        let size = |v: [f64; 3]| v.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let summed = 2.0 * energies + here.energy.abs() + size(root.force) * size(root.place) + size(root.moment);
        let load = |tip: usize| size(standing.load(&here.at, tip));
        let least = (0..standing.tips.len()).map(load).fold(0.0, f64::max);
        Self { balance, least, round_off: ROUND_OFF * summed }
    }
}

// -- Where the force has its maximum between two equilibria of a stable branch, and by how much it can be missed --
//
// P rises at one of them and falls at the other one, along a parameter η of the branch. The place between where dP/dη = 0 is enclosed ever more
// narrowly. Where P is concave in the enclosure, it lies below the tangents at both of its ends: they meet above the maximum, and by how much
// above the largest force that was computed bounds its error.

/// The force is met to this share.
const MET: f64 = 1e-9;
/// Most solutions.
const MOST_SOLVES: usize = 20;
/// Where the place is expected nearer to an end of the enclosure than this share, the next solution lies twice as far from it, beyond the place.
const NEAR: f64 = 0.1;

/// Solves for the equilibrium where the parameter has a value, from the nearer and the farther one of two known ones.
pub(super) type SolveAt<'a> = dyn FnMut([&Knot; 2], f64) -> Result<Knot, SolveError> + 'a;

/// The maximum between two equilibria, if the force rises at the first one and falls at the second one; one of the two itself where nothing
/// larger was found between them.
pub(super) fn maximum(from: &Knot, to: &Knot, solve_at: &mut SolveAt) -> Option<(Knot, LocationError)> {
    if !(from.slopes[1] > 0.0 && to.slopes[1] < 0.0) {
        return None;
    }
    let (mut low, mut high) = (from.clone(), to.clone());
    for solves in 0..MOST_SOLVES {
        if above(&low, &high) <= MET * largest(&low, &high).values[1].abs() {
            break;
        }
        let width = high.parameter - low.parameter;
        let share = if solves % 4 == 3 { 0.5 } else { low.turn_of(&high, 1) };
        let share = match share {
            share if share < NEAR => 2.0 * share,
            share if share > 1.0 - NEAR => 1.0 - 2.0 * (1.0 - share),
            share => share,
        };
        let place = low.parameter + share * width;
        if !(place > low.parameter && place < high.parameter) {
            break;
        }
        let known = if share < 0.5 { [&low, &high] } else { [&high, &low] };
        let Ok(found) = solve_at(known, place) else { break };
        if found.slopes[1] > 0.0 { low = found } else { high = found }
    }
    let best = largest(&low, &high).clone();
    let [first, last] = [low.values[0], high.values[0]].map(|u| (u - best.values[0]).abs());
    let error = LocationError { force: above(&low, &high), displacement: first.max(last) };
    Some((best, error))
}

fn largest<'a>(low: &'a Knot, high: &'a Knot) -> &'a Knot {
    if low.values[1] > high.values[1] { low } else { high }
}

/// How far above the larger force the tangents meet, nN; where they do not meet between the two, how far they go above it.
fn above(low: &Knot, high: &Knot) -> f64 {
    let width = high.parameter - low.parameter;
    let meet = (high.values[1] - low.values[1] - high.slopes[1] * width) / (low.slopes[1] - high.slopes[1]);
    let most = if (0.0..=width).contains(&meet) {
        low.values[1] + meet * low.slopes[1]
    } else {
        (low.values[1] + width * low.slopes[1]).max(high.values[1] - width * high.slopes[1])
    };
    (most - largest(low, high).values[1]).max(0.0)
}

// -- Where a quantity passes a value between two equilibria of a stable branch, along the displacement of the root --

/// Pieces in each of which the quantity may pass the value once.
const PIECES: usize = 8;
/// The value is met to this share of the largest that is known, or the displacement to this share of itself.
const PASSED: f64 = 1e-11;

/// The equilibrium between two, the displacement of which is the parameter, where a quantity first passes a value in the way that counts, and by how
/// much it may miss it.
pub(super) fn passed(
    problem: &Problem,
    [from, to]: [&Knot; 2],
    (at, value): (&EventAt, &dyn Fn(&Knot) -> f64),
    newton: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Option<(Knot, LocationError)>, SolveError> {
    let above = |knot: &Knot| match value(knot) - at.value {
        above if above.is_finite() => Ok(above),
        _ => Err(SolveError::NotFiniteUpdate { quantity: Quantity::EventQuantity }),
    };
    let ends = [above(from)?, above(to)?];
    let place = |piece: usize| from.parameter + (to.parameter - from.parameter) * piece as f64 / PIECES as f64;
    let mut known = vec![(from.parameter, ends[0])];
    for piece in 1..PIECES {
        known.push((place(piece), above(&from.guessed(to, place(piece), problem))?));
    }
    known.push((to.parameter, ends[1]));
    let passes = |pair: &[(f64, f64)]| at.passes(pair[0].1 + at.value, pair[1].1 + at.value);
    let Some(first) = known.windows(2).position(passes) else { return Ok(None) };
    // what was interpolated is solved, and the piece made wider until it holds what it seemed to hold
    let mut solved = |piece: usize| match piece {
        0 => Ok(known[0]),
        PIECES => Ok(known[PIECES]),
        _ => Ok((place(piece), above(&between(problem, [from, to], place(piece), newton, ws)?)?)),
    };
    let (mut before, mut behind) = (first, first + 1);
    let (mut low, mut high) = (solved(before)?, solved(behind)?);
    while (low.1 >= 0.0) == (high.1 >= 0.0) {
        if before == 0 && behind == PIECES {
            return Ok(None);
        }
        (before, behind) = (before.saturating_sub(1), (behind + 1).min(PIECES));
        (low, high) = (solved(before)?, solved(behind)?);
    }
    let largest = at.value.abs().max(ends[0].abs()).max(ends[1].abs());
    let solve_at = |displacement: f64| {
        let knot = between(problem, [from, to], displacement, newton, ws)?;
        let above = above(&knot)?;
        Ok::<_, SolveError>((knot, above))
    };
    let is_met = |above: f64, displacement: f64, left: f64| {
        above.abs() <= PASSED * largest || left <= PASSED * displacement.abs()
    };
    let (knot, Passing { value: off, left, .. }) = root::passed(low, high, solve_at, is_met)?;
    let (off, slope) = (off.abs(), knot.slopes[1].abs());
    let location = match at.quantity.named() {
        Some(StationQuantity::Force) => LocationError { force: off, displacement: (off / slope).min(left) },
        Some(StationQuantity::Displacement) => LocationError { force: slope * off, displacement: off },
        _ => LocationError { force: slope * left, displacement: left },
    };
    Ok(Some((knot, location)))
}

/// The equilibrium between two at a displacement of the root.
fn between(
    problem: &Problem,
    [from, to]: [&Knot; 2],
    displacement: f64,
    newton: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Knot, SolveError> {
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: displacement };
    let per = [from, to].map(|knot| 1.0 / knot.solution.slope.displacement);
    let nearer = if displacement - from.parameter < to.parameter - displacement { from } else { to };
    let newton = NewtonOptions { exact_slope: true, ..*newton };
    let solution = solve(problem, from.predicted(to, displacement, per, problem), &held, &newton, ws);
    let solution = solution.or_else(|_| solve(problem, nearer.solution.at.clone(), &held, &newton, ws))?;
    Ok(Knot::new(displacement, solution, 1.0))
}
