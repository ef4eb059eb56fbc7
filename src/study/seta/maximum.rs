//! Where the force has its maximum between two equilibria of a stable branch, and by how much it can be missed.
//!
//! P rises at one of them and falls at the other one, along a parameter η of the branch. The place between where dP/dη = 0 is enclosed ever more
//! narrowly. Where P is concave in the enclosure, it lies below the tangents at both of its ends: they meet above the maximum, and by how much
//! above the largest force that was computed bounds its error.

use super::knot::Knot;
use super::result::LocationError;
use crate::solve::error::SolveError;

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
