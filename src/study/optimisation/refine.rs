//! Newton's method at the end of a search over few variables: with gradients to the accuracy asked for and the curvature by differences of
//! gradients. How far its last step goes is the error of the values.

use super::evaluation::{Evaluator, Precise};
use super::problem::DesignProblem;
use super::projected_gradient::projected_gradient;
use nalgebra::{DMatrix, DVector};

/// Most variables, whose gradients are differenced.
const MOST: usize = 4;
/// Step of the differences, in coordinates from 0 to 1.
const STEP: f64 = 1e-3;
/// A step of Newton's method that is longer is no refinement, and steps at most.
const FAR: f64 = 0.05;
const STEPS: usize = 3;
/// A variable nearer to a bound stays there.
const AT_BOUND: f64 = 1e-6;
/// The bound on the error is this times the step that is left.
const SAFETY: f64 = 2.0;

/// A design with the gradient at it.
pub(super) struct Refined {
    pub coordinates: Vec<f64>,
    /// d ln Q/d coordinate with a bound on its error; none where there is none
    pub precise: Option<Precise>,
    /// Of the coordinates; none where there is no curvature
    pub errors: Option<Vec<f64>>,
}

/// Moves a design to where the gradient by its free variables vanishes.
pub(super) fn refined(problem: &DesignProblem, evaluator: &Evaluator, from: &[f64]) -> Refined {
    let mut best = Refined { coordinates: from.to_vec(), precise: evaluator.precise(from), errors: None };
    let free: Vec<usize> =
        (0..from.len()).filter(|&i| from[i] > AT_BOUND + STEP && from[i] < 1.0 - AT_BOUND - STEP).collect();
    if best.precise.is_none() || free.is_empty() || free.len() > MOST || !problem.constraints.is_empty() {
        return best;
    }
    let Some(curvature) = curvature(evaluator, from, &free) else { return best };
    for _ in 0..STEPS {
        let Some(precise) = &best.precise else { return best };
        let sign = problem.goal.sign();
        let slope = DVector::from_iterator(free.len(), free.iter().map(|&i| sign * precise.gradient[i]));
        let Some(cholesky) = (curvature.clone() * sign).cholesky() else { return best };
        let step = cholesky.solve(&slope);
        let inverse = cholesky.inverse();
        let unsure = |row: usize| {
            let by_error: f64 =
                free.iter().enumerate().map(|(k, &i)| inverse[(row, k)].abs() * precise.errors[i]).sum();
            SAFETY * (step[row].abs() + by_error)
        };
        let mut errors = vec![0.0; from.len()];
        free.iter().enumerate().for_each(|(row, &i)| errors[i] = unsure(row));
        best.errors = Some(errors);
        if step.amax() > FAR {
            best.errors = None;
            return best;
        }
        let mut moved = best.coordinates.clone();
        free.iter().enumerate().for_each(|(row, &i)| moved[i] = (moved[i] - step[row]).clamp(0.0, 1.0));
        let largest = |at: &[f64], precise: &Precise| {
            let minimised: Vec<f64> = precise.gradient.iter().map(|slope| sign * slope).collect();
            projected_gradient(problem, at, &minimised).largest()
        };
        let Some(next) = evaluator.precise(&moved) else { return best };
        if largest(&moved, &next) >= largest(&best.coordinates, precise) {
            return best;
        }
        best = Refined { coordinates: moved, precise: Some(next), errors: best.errors };
    }
    best
}

/// ∂² ln Q by the free variables, symmetric.
fn curvature(evaluator: &Evaluator, at: &[f64], free: &[usize]) -> Option<DMatrix<f64>> {
    let gradient = |index: usize, step: f64| {
        let mut moved = at.to_vec();
        moved[index] += step;
        let found = evaluator.evaluate(&moved, true);
        (!found.gradient.is_empty()).then_some(found.gradient)
    };
    let mut matrix = DMatrix::zeros(free.len(), free.len());
    for (column, &index) in free.iter().enumerate() {
        let (ahead, behind) = (gradient(index, STEP)?, gradient(index, -STEP)?);
        for (row, &other) in free.iter().enumerate() {
            matrix[(row, column)] = (ahead[other] - behind[other]) / (2.0 * STEP);
        }
    }
    Some(0.5 * (&matrix + matrix.transpose()))
}
