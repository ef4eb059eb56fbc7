//! Mean, standard deviation and quantiles of a sampled number, with their sampling errors.

use super::design::Design;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// A quantile with its confidence interval of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantile {
    /// The share of the distribution that lies below
    pub probability: f64,
    /// The estimate
    pub value: f64,
    /// Where its confidence interval begins
    pub from: f64,
    /// Where its confidence interval ends
    pub to: f64,
}

/// What samples of a number say of its distribution. Samples that have none are left out: all is said of the others alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics {
    /// Samples that have a number
    pub count: usize,
    /// Samples that have none
    pub missing: usize,
    /// Mean
    pub mean: Estimate,
    /// Standard deviation
    pub deviation: Estimate,
    /// As they were asked for
    pub quantiles: Vec<Quantile>,
    /// The smallest of the samples
    pub smallest: f64,
    /// The largest of the samples
    pub largest: f64,
}

impl Statistics {
    /// Of the values of a number at the samples of a design, in their order, and of the quantiles at these probabilities; nothing where fewer
    /// than two replicates have a number.
    pub fn of(design: &Design, values: &[Option<f64>], probabilities: &[f64]) -> Option<Self> {
        let replicates = by_replicate(design, values);
        let mut sorted: Vec<f64> = replicates.iter().flatten().copied().collect();
        if replicates.len() < 2 {
            return None;
        }
        sorted.sort_by(f64::total_cmp);
        let sum = |of: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            replicates.iter().map(|numbers| (numbers.iter().map(|&x| of(x)).sum(), numbers.len() as f64)).collect()
        };
        let mean = quotient(&sum(&|x| x));
        let variance = quotient(&sum(&|x| (x - mean.value).powi(2)));
        let quantile = |&probability: &f64| {
            let value = between(&sorted, probability);
            let below: Vec<f64> = replicates.iter().map(|numbers| share_below(numbers, value)).collect();
            // what one sample more or less changes is not seen by the spread
            let error = error_of_mean(&below) + 0.5 / sorted.len() as f64;
            let at = |p: f64| between(&sorted, p.clamp(0.0, 1.0));
            Quantile { probability, value, from: at(probability - error), to: at(probability + error) }
        };
        Some(Self {
            count: sorted.len(),
            missing: values.len() - sorted.len(),
            mean,
            deviation: root(variance),
            quantiles: probabilities.iter().map(quantile).collect(),
            smallest: sorted[0],
            largest: sorted[sorted.len() - 1],
        })
    }
}

/// The numbers of each replicate that has one.
fn by_replicate(design: &Design, values: &[Option<f64>]) -> Vec<Vec<f64>> {
    let numbers = |of: &[Option<f64>]| of.iter().copied().flatten().collect::<Vec<f64>>();
    values.chunks(design.samples_of_replicate()).map(numbers).filter(|numbers| !numbers.is_empty()).collect()
}

/// The square root of a variance.
fn root(variance: Estimate) -> Estimate {
    let value = variance.value.max(0.0).sqrt();
    Estimate { value, error: if value > 0.0 { 0.5 * variance.error / value } else { 0.0 } }
}

/// The quantile of sorted numbers, linear between them.
fn between(sorted: &[f64], probability: f64) -> f64 {
    let place = probability * (sorted.len() - 1) as f64;
    let (low, high) = (place.floor() as usize, place.ceil() as usize);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

fn share_below(numbers: &[f64], value: f64) -> f64 {
    numbers.iter().filter(|&&x| x <= value).count() as f64 / numbers.len() as f64
}

// -- What independent replicates say of a number: its estimate, and how far that may be off by chance --

/// Probability with which a true value is within its error.
pub(crate) const CONFIDENCE: f64 = 0.95;

/// A number estimated from samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The estimate
    pub value: f64,
    /// Half the width of its confidence interval of 95 %
    pub error: f64,
}

/// Half the width of the confidence interval of a mean of independent numbers of the same distribution, by Student's t.
pub(super) fn error_of_mean(numbers: &[f64]) -> f64 {
    let count = numbers.len() as f64;
    if numbers.len() < 2 {
        return f64::INFINITY;
    }
    let mean = numbers.iter().sum::<f64>() / count;
    let variance = numbers.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0);
    student(numbers.len() - 1) * (variance / count).sqrt()
}

/// The t of the confidence interval.
fn student(freedoms: usize) -> f64 {
    StudentsT::new(0.0, 1.0, freedoms as f64).map_or(f64::INFINITY, |law| law.inverse_cdf(0.5 * (1.0 + CONFIDENCE)))
}

/// The quotient of two sums, each over replicates, with what its spread from replicate to replicate says of its error: of x/y that is the
/// spread of (xᵣ - x/y yᵣ)/ȳ.
pub(super) fn quotient(parts: &[(f64, f64)]) -> Estimate {
    let sum = |of: fn(&(f64, f64)) -> f64| parts.iter().map(of).sum::<f64>();
    let (above, below) = (sum(|part| part.0), sum(|part| part.1));
    let value = above / below;
    let scale = below / parts.len() as f64;
    let residuals: Vec<f64> = parts.iter().map(|(x, y)| (x - value * y) / scale).collect();
    Estimate { value, error: error_of_mean(&residuals) }
}

// -- How much of a number's variance comes from which inputs: Sobol's sensitivity indices --
//
// With the rows A, B and A_g of a design, A with the inputs of g from B, and f₀ the mean of f,
//
// S_g V  = E[(f(B) - f₀) (f(A_g) - f(A))],   or   V - ½ E[(f(B) - f(A_g))²],
// ST_g V = ½ E[(f(A) - f(A_g))²].
//
// The first one is Saltelli's (Comput. Phys. Commun. 181 (2010) 259), exact where an input does nothing; the second and the third are Jansen's
// (Comput. Phys. Commun. 117 (1999) 35), of which the second is exact where an input does everything. S_g is the mean of both, each weighted by
// the variance that is left to the other: (1 - ST_g) of the first and ST_g of the second.

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
mod sobol_indices_tests {
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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn students_t_is_that_of_the_tables() {
        assert_relative_eq!(student(9), 2.262_157_16, max_relative = 1e-8);
        assert_relative_eq!(student(1), 12.706_204_74, max_relative = 1e-8);
    }

    #[test]
    fn the_error_of_a_mean_is_that_of_students_t() {
        // mean 3, standard deviation √2.5
        let error = error_of_mean(&[1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_relative_eq!(error, 2.776_445_105 * (2.5f64 / 5.0).sqrt(), max_relative = 1e-8);
        assert_eq!(error_of_mean(&[1.0]), f64::INFINITY);
    }

    #[test]
    fn a_quotient_that_is_the_same_in_all_replicates_has_no_error() {
        let found = quotient(&[(2.0, 1.0), (6.0, 3.0), (4.0, 2.0)]);
        assert_eq!((found.value, found.error), (2.0, 0.0));
    }
}
