//! Taylor polynomials of numbers of a peel about the means of its inputs, and what one input does alone.

use super::outcome::Outcome;
use super::plan::Plan;
use super::taylor::Taylor;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// How far an input is moved for differences of numbers, over its standard deviation: second differences divide the errors of the numbers by its
/// square.
const BETWEEN_NUMBERS: f64 = 0.5;

/// Numbers of a peel at any inputs; called from any thread.
pub type NumbersAt<'n> = dyn Fn(&[f64]) -> Outcome + Sync + 'n;

/// Of each number its Taylor polynomial about the means, by differences of numbers at inputs half a standard deviation away; none where one of them
/// is missing.
pub fn taylor_by_differences(plan: &Plan, numbers: usize, at: &NumbersAt) -> Vec<Option<Taylor>> {
    let center: Vec<f64> = plan.inputs.iter().map(|input| input.distribution.mean()).collect();
    let steps: Vec<f64> = plan.inputs.iter().map(|input| BETWEEN_NUMBERS * input.distribution.deviation()).collect();
    let count = center.len();
    let signs = [1.0, -1.0];
    let mut moves: Vec<Vec<(usize, f64)>> = vec![Vec::new()];
    for i in 0..count {
        moves.extend(signs.map(|sign| vec![(i, sign)]));
    }
    for i in 0..count {
        for j in 0..i {
            moves.extend(signs.map(|sign| vec![(i, sign), (j, sign)]));
        }
    }
    let moved = |by: &Vec<(usize, f64)>| {
        let mut inputs = center.clone();
        by.iter().for_each(|&(input, sign)| inputs[input] += sign * steps[input]);
        at(&inputs).values
    };
    let found: Vec<Vec<Option<f64>>> = moves.par_iter().map(moved).collect();
    let polynomial = |number: usize| {
        let values = found.iter().map(|values| values[number]).collect::<Option<Vec<f64>>>()?;
        Some(fitted(&center, &steps, &values))
    };
    (0..numbers).map(polynomial).collect()
}

/// From the values at the center, at both sides of each input, and at both corners of each pair of inputs.
fn fitted(center: &[f64], steps: &[f64], values: &[f64]) -> Taylor {
    let count = center.len();
    let (value, sides, mut corners) = (values[0], &values[1..=2 * count], values[2 * count + 1..].chunks(2));
    let along = |i: usize| sides[2 * i] + sides[2 * i + 1] - 2.0 * value;
    let mut hessian = DMatrix::zeros(count, count);
    for i in 0..count {
        hessian[(i, i)] = along(i) / (steps[i] * steps[i]);
        for j in 0..i {
            let corner = corners.next().map_or(f64::NAN, |pair| pair[0] + pair[1] - 2.0 * value);
            let mixed = 0.5 * (corner - along(i) - along(j)) / (steps[i] * steps[j]);
            hessian[(i, j)] = mixed;
            hessian[(j, i)] = mixed;
        }
    }
    let gradient = (0..count).map(|i| 0.5 * (sides[2 * i] - sides[2 * i + 1]) / steps[i]).collect();
    Taylor { center: center.to_vec(), value, gradient, hessian: Some(hessian) }
}

/// What one input does alone.
#[derive(Clone, Debug, PartialEq)]
pub struct OneAtATime {
    /// The input below which `probability` of its distribution lies, and that above which it does
    pub inputs: [f64; 2],
    /// The numbers there, with all other inputs at their means
    pub outcomes: [Outcome; 2],
}

/// For each input what the numbers are where it is at its quantiles of `probability` and 1 - `probability`, and all others at their means.
pub fn one_at_a_time(plan: &Plan, probability: f64, at: &NumbersAt) -> Vec<OneAtATime> {
    let center: Vec<f64> = plan.inputs.iter().map(|input| input.distribution.mean()).collect();
    let one = |(index, input): (usize, &super::Input)| {
        let inputs = [probability, 1.0 - probability].map(|p| input.distribution.quantile(p));
        let outcomes = inputs.map(|value| {
            let mut inputs = center.clone();
            inputs[index] = value;
            at(&inputs)
        });
        OneAtATime { inputs, outcomes }
    };
    plan.inputs.par_iter().enumerate().map(one).collect()
}
