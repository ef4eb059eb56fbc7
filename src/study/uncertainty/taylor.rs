//! What the derivatives at the means of the inputs say of a number: the Taylor polynomials of first and second order.

use super::design::Design;
use super::spread::{Estimate, error_of_mean};
use super::statistics::Statistics;
use nalgebra::DMatrix;

/// A number as a polynomial of second degree in the inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Taylor {
    /// The inputs where it is expanded: their means
    pub center: Vec<f64>,
    /// The number there
    pub value: f64,
    /// Its first derivatives, by the inputs in the units of their distributions
    pub gradient: Vec<f64>,
    /// Its second derivatives; none where they are not known
    pub hessian: Option<DMatrix<f64>>,
}

/// Of which order a Taylor polynomial is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Linear in the inputs
    First,
    /// With the second derivatives
    Second,
}

/// What a Taylor polynomial gives for a distribution, beside what was sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Propagation {
    /// Of which polynomial
    pub order: Order,
    /// Its mean
    pub mean: f64,
    /// Its standard deviation
    pub deviation: f64,
    /// Its mean less that of the number, both at the samples that have one
    pub mean_difference: Estimate,
    /// The same for the standard deviations
    pub deviation_difference: Estimate,
}

/// A difference to the sample that does not matter, over the standard deviation.
const NEGLIGIBLE: f64 = 0.01;

impl Propagation {
    /// Whether one of its differences to the sample is larger than chance explains, and large enough to matter.
    pub fn fails(&self) -> bool {
        [self.mean_difference, self.deviation_difference].iter().any(|difference| self.is_failure(difference))
    }

    /// Whether a difference to the sample is larger than its error and than 1 % of the standard deviation.
    pub fn is_failure(&self, difference: &Estimate) -> bool {
        difference.value.abs() > difference.error.max(NEGLIGIBLE * self.deviation)
    }
}

impl Taylor {
    /// The polynomial at these inputs; that of second order is the linear one where second derivatives are not known.
    pub fn at(&self, order: Order, inputs: &[f64]) -> f64 {
        let away: Vec<f64> = inputs.iter().zip(&self.center).map(|(x, center)| x - center).collect();
        let linear = self.value + away.iter().zip(&self.gradient).map(|(d, slope)| d * slope).sum::<f64>();
        match (&self.hessian, order) {
            (Some(hessian), Order::Second) => {
                let row = |i: usize| away[i] * (0..away.len()).map(|j| hessian[(i, j)] * away[j]).sum::<f64>();
                linear + 0.5 * (0..away.len()).map(row).sum::<f64>()
            }
            _ => linear,
        }
    }

    /// Mean and standard deviation of the polynomial, beside those of a number: both at the samples of the design that have one, so that what
    /// chance does to both cancels in their difference. Nothing where fewer than two replicates have a number, or where second derivatives are
    /// asked for and not known.
    pub fn propagation(&self, order: Order, design: &Design, values: &[Option<f64>]) -> Option<Propagation> {
        if order == Order::Second && self.hessian.is_none() {
            return None;
        }
        let polynomial: Vec<Option<f64>> = values
            .iter()
            .enumerate()
            .map(|(sample, value)| value.map(|_| self.at(order, &design.inputs(design.place(sample)))))
            .collect();
        let of_number = Statistics::of(design, values, &[])?;
        let own = Statistics::of(design, &polynomial, &[])?;
        let each = |of: &[Option<f64>], whole: &Statistics| -> Vec<(f64, f64)> {
            of.chunks(design.samples_of_replicate()).filter_map(|of| moments(of, whole.mean.value)).collect()
        };
        let pairs: Vec<_> = each(&polynomial, &own).into_iter().zip(each(values, &of_number)).collect();
        let mean_error = error_of_mean(&pairs.iter().map(|(own, other)| own.0 - other.0).collect::<Vec<_>>());
        // of a root of a variance, to first order
        let root = |variance: f64, whole: &Statistics| 0.5 * variance / whole.deviation.value.max(f64::MIN_POSITIVE);
        let deviations = pairs.iter().map(|(p, q)| root(p.1, &own) - root(q.1, &of_number));
        let deviation_error = error_of_mean(&deviations.collect::<Vec<_>>());
        Some(Propagation {
            order,
            mean: own.mean.value,
            deviation: own.deviation.value,
            mean_difference: Estimate { value: own.mean.value - of_number.mean.value, error: mean_error },
            deviation_difference: Estimate {
                value: own.deviation.value - of_number.deviation.value,
                error: deviation_error,
            },
        })
    }
}

/// Mean, and mean square about `center`, of the numbers of a replicate that has some.
fn moments(values: &[Option<f64>], center: f64) -> Option<(f64, f64)> {
    let numbers: Vec<f64> = values.iter().copied().flatten().collect();
    let count = numbers.len() as f64;
    let mean = |of: &dyn Fn(f64) -> f64| numbers.iter().map(|&x| of(x)).sum::<f64>() / count;
    (count > 0.0).then(|| (mean(&|x| x), mean(&|x| (x - center).powi(2))))
}
