//! Mean, standard deviation and quantiles of a sampled number, with their sampling errors.

use super::design::Design;
use super::spread::{Estimate, error_of_mean, quotient};

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
