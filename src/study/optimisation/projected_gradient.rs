//! First-order conditions of an optimum.
//!
//! With the gradient f' of what is minimised and the gradients a of the constraints that are active, the bounds among them, multipliers λ
//! (not below zero where a constraint has one side) leave of f' + Σ λ a as little as they can. What is left, the projected gradient, is zero at an
//! optimum (Karush, Kuhn and Tucker).

use super::problem::{ConstraintKind, DesignProblem};
use nalgebra::{DMatrix, DVector};

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
    pub fn largest(&self) -> f64 {
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
