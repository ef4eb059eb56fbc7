//! Which inputs vary together, and how: a Gaussian copula.

use super::plan::{NoDesign, Plan};
use nalgebra::{Cholesky, DMatrix};

/// The dependence of inputs: z = L w makes of independent standard normal numbers w correlated ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Dependence {
    /// L, lower triangular, L Lᵀ the matrix of the correlations; none where all inputs are independent
    factor: Option<DMatrix<f64>>,
    /// The inputs that vary together, each in one group; the groups are independent of one another
    pub groups: Vec<Vec<usize>>,
}

impl Dependence {
    /// Fails where the correlations contradict one another.
    pub fn of(plan: &Plan) -> Result<Self, NoDesign> {
        let count = plan.inputs.len();
        let groups = groups(plan);
        if plan.correlations.is_empty() {
            return Ok(Self { factor: None, groups });
        }
        let mut matrix = DMatrix::identity(count, count);
        for correlation in &plan.correlations {
            let [i, j] = correlation.inputs;
            matrix[(i, j)] = correlation.coefficient;
            matrix[(j, i)] = correlation.coefficient;
        }
        let factor = Cholesky::new(matrix).ok_or(NoDesign::Contradiction)?.l();
        Ok(Self { factor: Some(factor), groups })
    }

    /// Whether no inputs vary together.
    pub fn is_independent(&self) -> bool {
        self.factor.is_none()
    }

    /// z = L w
    pub fn correlated(&self, independent: &[f64]) -> Vec<f64> {
        match &self.factor {
            None => independent.to_vec(),
            Some(factor) => {
                let row = |i: usize| (0..=i).map(|j| factor[(i, j)] * independent[j]).sum();
                (0..independent.len()).map(row).collect()
            }
        }
    }
}

/// The connected parts of the graph of correlations, each ascending, by their first inputs.
fn groups(plan: &Plan) -> Vec<Vec<usize>> {
    let mut group: Vec<usize> = (0..plan.inputs.len()).collect();
    for correlation in &plan.correlations {
        let [a, b] = correlation.inputs.map(|input| group[input]);
        group.iter_mut().filter(|of| **of == a.max(b)).for_each(|of| *of = a.min(b));
    }
    let members = |of: usize| -> Vec<usize> { (0..group.len()).filter(|&input| group[input] == of).collect() };
    (0..group.len()).map(members).filter(|members| !members.is_empty()).collect()
}
