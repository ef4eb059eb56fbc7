//! Random designs: where searches begin, and neighbours of an optimum. They are reproducible, and projected onto what is feasible.

use super::problem::{ConstraintKind, DesignProblem};
use super::search::FEASIBLE;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use slsqp::{Func, StopTols, minimize};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Waves along a profile that a random one is made of.
const WAVES: usize = 3;
/// Evaluations of a projection; it peels nothing.
const PROJECTION: usize = 200;
/// A projection ends where the square of its distance changes by less.
const NEAR: f64 = 1e-16;
/// Least and largest distance of a neighbour, in coordinates from 0 to 1.
const NEAREST: f64 = 1e-3;
const FARTHEST: f64 = 0.1;

/// The feasible design that is nearest to coordinates; none where there is none, or none was found.
pub(super) fn projected(problem: &DesignProblem, wanted: &[f64]) -> Option<Vec<f64>> {
    let inside: Vec<f64> = wanted.iter().map(|c| c.clamp(0.0, 1.0)).collect();
    if problem.violation(&inside) <= 0.0 {
        return Some(inside);
    }
    let distance = |c: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
        let away = c.iter().zip(&inside).map(|(a, b)| a - b);
        if let Some(gradient) = gradient {
            gradient.iter_mut().zip(away.clone()).for_each(|(out, away)| *out = 2.0 * away);
        }
        away.map(|away| away * away).sum()
    };
    let side = |index: usize, sign: f64| {
        move |c: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
            if let Some(gradient) = gradient {
                let slopes = problem.constraint_gradient(index, c);
                gradient.iter_mut().zip(slopes).for_each(|(out, slope)| *out = sign * slope);
            }
            sign * problem.constraint(index, c)
        }
    };
    let mut sides = Vec::new();
    for (index, constraint) in problem.constraints.iter().enumerate() {
        sides.push(side(index, 1.0));
        if constraint.kind == ConstraintKind::Equal {
            sides.push(side(index, -1.0));
        }
    }
    let constraints: Vec<&dyn Func<()>> = sides.iter().map(|side| side as &dyn Func<()>).collect();
    let bounds = vec![(0.0, 1.0); wanted.len()];
    let tolerance = StopTols { ftol_abs: NEAR, ..StopTols::default() };
    let found = minimize(distance, &inside, &bounds, &constraints, (), PROJECTION, Some(tolerance));
    let (Ok((_, found, _)) | Err((_, found, _))) = found;
    (problem.violation(&found) <= FEASIBLE).then_some(found)
}

/// The random numbers of one design.
fn dice(seed: u64, number: u64) -> ChaCha8Rng {
    let mut dice = ChaCha8Rng::seed_from_u64(seed);
    dice.set_stream(number);
    dice
}

/// A random design: numbers anywhere between their bounds, profiles a few waves long.
pub(super) fn random(problem: &DesignProblem, seed: u64, number: u64) -> Option<Vec<f64>> {
    let mut dice = dice(seed, number);
    let mut columns = BTreeMap::new();
    let mut coordinates = Vec::new();
    for variable in &problem.variables {
        coordinates.push(match variable.along {
            None => dice.random_range(0.1..0.9),
            Some((column, share)) => {
                let waves: &mut Vec<f64> =
                    columns.entry(column).or_insert_with(|| (0..WAVES).map(|_| dice.random_range(-0.4..0.4)).collect());
                let wave = |(k, height): (usize, &f64)| height * (PI * (k + 1) as f64 * share).cos();
                0.5 + waves.iter().enumerate().map(wave).sum::<f64>()
            }
        });
    }
    projected(problem, &coordinates)
}

/// A random feasible neighbour.
pub(super) fn neighbour(problem: &DesignProblem, of: &[f64], seed: u64, number: u64) -> Option<Vec<f64>> {
    // others than those of the starts
    let mut dice = dice(seed, u64::MAX - number);
    let direction: Vec<f64> = of.iter().map(|_| dice.random_range(-1.0..1.0)).collect();
    let length = direction.iter().map(|d: &f64| d * d).sum::<f64>().sqrt();
    let distance = NEAREST * (FARTHEST / NEAREST).powf(dice.random_range(0.0..1.0));
    let moved: Vec<f64> = of.iter().zip(&direction).map(|(c, d)| c + distance * d / length).collect();
    projected(problem, &moved)
}
