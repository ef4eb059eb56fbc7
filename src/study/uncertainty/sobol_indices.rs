//! How much of a number's variance comes from which inputs: Sobol's sensitivity indices.
//!
//! With the rows A, B and A_g of a design, A with the inputs of g from B, and f₀ the mean of f,
//!
//!   S_g V  = E[(f(B) - f₀) (f(A_g) - f(A))],   or   V - ½ E[(f(B) - f(A_g))²],
//!   ST_g V = ½ E[(f(A) - f(A_g))²].
//!
//! The first one is Saltelli's (Comput. Phys. Commun. 181 (2010) 259), exact where an input does nothing; the second and the third are Jansen's
//! (Comput. Phys. Commun. 117 (1999) 35), of which the second is exact where an input does everything. S_g is the mean of both, each weighted by
//! the variance that is left to the other: (1 - ST_g) of the first and ST_g of the second.

use super::design::Design;
use super::spread::{Estimate, quotient};

/// The indices of one group of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct SobolIndex {
    /// Its inputs, by their numbers: one, or those that vary together
    pub inputs: Vec<usize>,
    /// The share of the variance that would go if these inputs were known
    pub first: Estimate,
    /// The share of the variance that would stay if all others were known
    pub total: Estimate,
}

/// Shares of a variance that differ by less are alike.
const ALIKE: f64 = 0.01;

impl SobolIndex {
    /// Whether the estimates are shares that no variance has, by more than a hundredth of it: a negative one, or a total below the first order.
    pub fn is_impossible(&self) -> bool {
        self.first.value < -ALIKE || self.total.value < self.first.value - ALIKE
    }
}

/// What one replicate gives of a group, each a sum over its points.
#[derive(Clone, Copy, Default)]
struct Sums {
    saltelli: f64,
    jansen: f64,
    total: f64,
    variance: f64,
}

/// The indices of every group of a design, from the values of a number at its samples, in their order; nothing where the design has no rows for
/// them, where fewer than two replicates have a number, or where the number does not vary. Points of which a row has no number are left out.
pub fn sobol_indices(design: &Design, values: &[Option<f64>]) -> Vec<SobolIndex> {
    let rows = design.rows();
    if rows < 3 {
        return Vec::new();
    }
    let points: Vec<Option<Vec<f64>>> =
        values.chunks(rows).map(|point| point.iter().copied().collect::<Option<Vec<f64>>>()).collect();
    let replicates: Vec<Vec<&Vec<f64>>> =
        points.chunks(design.points()).map(|of| of.iter().flatten().collect()).collect();
    let replicates: Vec<_> = replicates.into_iter().filter(|points: &Vec<_>| !points.is_empty()).collect();
    let (sum, count) = replicates.iter().flatten().fold((0.0, 0), |(sum, count), of| (sum + of[0] + of[1], count + 2));
    let mean = sum / f64::from(count.max(1));
    let index = |(group, inputs): (usize, &Vec<usize>)| {
        let sums: Vec<Sums> = replicates.iter().map(|points| sums(points, group + 2, mean)).collect();
        if sums.len() < 2 || sums.iter().map(|of| of.variance).sum::<f64>() <= 0.0 {
            return None;
        }
        let of =
            |part: &dyn Fn(&Sums) -> f64| quotient(&sums.iter().map(|of| (part(of), of.variance)).collect::<Vec<_>>());
        let total = of(&|of| of.total);
        let weight = total.value.clamp(0.0, 1.0);
        let first = of(&|of| (1.0 - weight) * of.saltelli + weight * of.jansen);
        Some(SobolIndex { inputs: inputs.clone(), first, total })
    };
    design.groups().iter().enumerate().filter_map(index).collect()
}

fn sums(points: &[&Vec<f64>], row: usize, mean: f64) -> Sums {
    points.iter().fold(Sums::default(), |sums, point| {
        let (a, b, mixed) = (point[0] - mean, point[1] - mean, point[row] - mean);
        let variance = 0.5 * (a * a + b * b);
        Sums {
            saltelli: sums.saltelli + b * (mixed - a),
            jansen: sums.jansen + variance - 0.5 * (b - mixed).powi(2),
            total: sums.total + 0.5 * (a - mixed).powi(2),
            variance: sums.variance + variance,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_total_below_the_first_order_and_a_negative_share_are_impossible() {
        let estimate = |value| Estimate { value, error: 0.1 };
        let is_impossible = |first, total| {
            SobolIndex { inputs: vec![0], first: estimate(first), total: estimate(total) }.is_impossible()
        };
        assert!(is_impossible(0.4165, 0.3281) && is_impossible(-0.02, 0.01));
        assert!(!is_impossible(0.30, 0.35) && !is_impossible(0.301, 0.300) && !is_impossible(-0.001, 0.0));
    }
}
