//! Newton's method at the end of a search over few variables: with gradients to the accuracy asked for and the curvature by differences of
//! gradients. How far its last step goes is the error of the values.

use super::evaluation::{Evaluator, Precise};
use super::problem::{ConstraintKind, DesignProblem};
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

// -- First-order conditions of an optimum --
//
// With the gradient f' of what is minimised and the gradients a of the constraints that are active, the bounds among them, multipliers λ
// (not below zero where a constraint has one side) leave of f' + Σ λ a as little as they can. What is left, the projected gradient, is zero at an
// optimum (Karush, Kuhn and Tucker).

/// A constraint or bound of which less is left is active.
const ACTIVE: f64 = 1e-6;
/// Of the singular values of the active gradients, relative: what is below is none.
const DEPENDENT: f64 = 1e-10;

/// A constraint, or a bound of a variable, that holds the optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct ActiveConstraint {
    /// Its name, or that of the variable with the bound
    pub name: String,
    /// How much ln Q would gain where the constraint gave way by 1, or the bound by the whole range of its variable
    pub multiplier: f64,
}

/// What is active at a design, and the gradient of what it holds.
struct Active {
    name: String,
    one_sided: bool,
    gradient: Vec<f64>,
}

fn active(problem: &DesignProblem, at: &[f64]) -> Vec<Active> {
    let unit = |index: usize, sign: f64| {
        let mut gradient = vec![0.0; at.len()];
        gradient[index] = sign;
        gradient
    };
    let mut found = Vec::new();
    for (index, (variable, &c)) in problem.variables.iter().zip(at).enumerate() {
        if c <= ACTIVE {
            let name = format!("{} at its lower bound", variable.name);
            found.push(Active { name, one_sided: true, gradient: unit(index, -1.0) });
        } else if c >= 1.0 - ACTIVE {
            let name = format!("{} at its upper bound", variable.name);
            found.push(Active { name, one_sided: true, gradient: unit(index, 1.0) });
        }
    }
    for (index, constraint) in problem.constraints.iter().enumerate() {
        let one_sided = constraint.kind == ConstraintKind::AtMost;
        if !one_sided || problem.constraint(index, at) >= -ACTIVE {
            let gradient = problem.constraint_gradient(index, at);
            found.push(Active { name: constraint.name.clone(), one_sided, gradient });
        }
    }
    found
}

/// What the multipliers leave of a gradient, with the constraints that have one.
pub(super) struct Projected {
    pub left: Vec<f64>,
    pub held: Vec<ActiveConstraint>,
}

impl Projected {
    pub(crate) fn largest(&self) -> f64 {
        self.left.iter().map(|slope| slope.abs()).fold(0.0, f64::max)
    }
}

/// The gradient of what is minimised, less what active constraints hold: least squares, without a one-sided constraint whose multiplier would
/// be below zero.
pub(super) fn projected_gradient(problem: &DesignProblem, at: &[f64], minimised: &[f64]) -> Projected {
    let mut all = active(problem, at);
    let gradient = DVector::from_column_slice(minimised);
    loop {
        let columns: Vec<DVector<f64>> =
            all.iter().map(|active| DVector::from_column_slice(&active.gradient)).collect();
        if columns.is_empty() {
            return Projected { left: minimised.to_vec(), held: Vec::new() };
        }
        let matrix = DMatrix::from_columns(&columns);
        let svd = matrix.clone().svd(true, true);
        let cutoff = DEPENDENT * svd.singular_values.max();
        let Ok(multipliers) = svd.solve(&-&gradient, cutoff) else {
            return Projected { left: minimised.to_vec(), held: Vec::new() };
        };
        let negative = |&index: &usize| all[index].one_sided && multipliers[index] < 0.0;
        let worst = (0..all.len()).filter(negative).min_by(|&a, &b| multipliers[a].total_cmp(&multipliers[b]));
        if let Some(worst) = worst {
            all.remove(worst);
            continue;
        }
        let left = gradient + matrix * &multipliers;
        let hold = |(active, &multiplier): (&Active, &f64)| ActiveConstraint { name: active.name.clone(), multiplier };
        return Projected {
            left: left.iter().copied().collect(),
            held: all.iter().zip(multipliers.iter()).map(hold).collect(),
        };
    }
}
