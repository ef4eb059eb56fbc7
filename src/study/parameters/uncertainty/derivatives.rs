//! Taylor polynomials of numbers of a peel about the means of its inputs, and what one input does alone.

use super::design::{Design, SamplePlace};
use super::plan::{Outcome, Plan, peel_numbers};
use super::statistics::{Estimate, Statistics, error_of_mean};
use crate::model::peel::PeelModel;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::parameters::sensitivity::quantity::PeelQuantity;
use crate::study::parameters::sensitivity::quantity::Variation;
use crate::study::parameters::sensitivity::run::sensitivities;
use crate::study::parameters::sweep::sweep;
use crate::study::terms::term_selection::peel;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// How far an input is moved between the first derivatives of a second one, over its standard deviation.
const BETWEEN_DERIVATIVES: f64 = 0.25;
/// The same between numbers: second differences divide their errors by the square of this.
const BETWEEN_NUMBERS: f64 = 0.5;

/// Where derivatives come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DerivativesBy {
    /// The first ones by [`sensitivities`], the second ones as their differences
    Sensitivities,
    /// Differences of whole peels, where there are no sensitivities: with friction, say
    Differences,
}

/// Of each number its Taylor polynomial about the means of the inputs, and how it was found; none of a number that the peel does not have there.
pub fn taylor_polynomials(plan: &Plan, of: &SampledPeel) -> (Vec<Option<Taylor>>, DerivativesBy) {
    match by_sensitivities(plan, of) {
        Some(found) => (found, DerivativesBy::Sensitivities),
        None => (taylor_by_differences(plan, of), DerivativesBy::Differences),
    }
}

fn means(plan: &Plan) -> Vec<f64> {
    plan.inputs.iter().map(|input| input.distribution.mean()).collect()
}

fn steps(plan: &Plan, share: f64) -> Vec<f64> {
    plan.inputs.iter().map(|input| share * input.distribution.deviation()).collect()
}

/// The inputs with one of them moved.
fn moved(inputs: &[f64], input: usize, by: f64) -> Vec<f64> {
    let mut inputs = inputs.to_vec();
    inputs[input] += by;
    inputs
}

/// By sensitivities at the means, and a step to both sides of each; nothing where there are none at the means.
fn by_sensitivities(plan: &Plan, of: &SampledPeel) -> Option<Vec<Option<Taylor>>> {
    let (center, steps) = (means(plan), steps(plan, BETWEEN_DERIVATIVES));
    let count = center.len();
    let at_center = first_order(plan, of, &center)?;
    let sides = (0..count).flat_map(|input| [1.0, -1.0].map(|sign| (input, sign * steps[input])));
    let sides: Vec<(usize, f64)> = sides.collect();
    let around: Vec<Option<Vec<Option<FirstOrder>>>> =
        sides.par_iter().map(|&(input, by)| first_order(plan, of, &moved(&center, input, by))).collect();
    let polynomial = |number: usize| {
        let (value, gradient) = at_center[number].clone()?;
        let slopes = |side: usize| around[side].as_ref()?[number].as_ref().map(|(_, gradient)| gradient);
        let row = |i: usize| {
            let (above, below) = (slopes(2 * i)?, slopes(2 * i + 1)?);
            Some((0..count).map(|j| 0.5 * (above[j] - below[j]) / steps[i]).collect::<Vec<f64>>())
        };
        let rows = (0..count).map(row).collect::<Option<Vec<Vec<f64>>>>();
        let hessian = rows.map(|rows| DMatrix::from_fn(count, count, |i, j| 0.5 * (rows[i][j] + rows[j][i])));
        Some(Taylor { center: center.clone(), value, gradient, hessian })
    };
    Some((0..of.of.len()).map(polynomial).collect())
}

/// A number and its first derivatives by the inputs.
type FirstOrder = (f64, Vec<f64>);

/// Each number and its first derivatives there, none of a number that the peel does not have; nothing where one of the inputs has no derivative.
fn first_order(plan: &Plan, of: &SampledPeel, inputs: &[f64]) -> Option<Vec<Option<FirstOrder>>> {
    let base = (of.model)(inputs).ok()?;
    let peel = peel(&base, of.accuracy, &(of.stop)());
    let scale = |input: usize| inputs[input].abs().max(plan.inputs[input].distribution.deviation());
    let variation = |input: usize| {
        let model = of.model;
        let base = base.clone();
        let inputs = inputs.to_vec();
        // a model that does not change reveals a step out of the range of the input
        Variation::new(plan.inputs[input].name.clone(), move |x| {
            model(&moved(&inputs, input, x * scale(input))).unwrap_or_else(|_| base.clone())
        })
    };
    let variations: Vec<Variation> = (0..inputs.len()).map(variation).collect();
    let is_inside =
        |input: usize| [1.0, -1.0].iter().all(|x| (of.model)(&moved(inputs, input, x * BESIDE * scale(input))).is_ok());
    if !(0..inputs.len()).all(is_inside) {
        return None;
    }
    let found = sensitivities(&peel, of.of, &variations).ok().filter(|found| found.refused.is_empty())?;
    let number = |quantity: &PeelQuantity| {
        let value = quantity.value(&peel)?;
        let slope = |input: usize| found.of(*quantity, input).map(|of| of.value / scale(input));
        Some((value, (0..inputs.len()).map(slope).collect::<Option<Vec<f64>>>()?))
    };
    Some(of.of.iter().map(number).collect())
}

/// More than sensitivities change a coordinate by.
const BESIDE: f64 = 2e-3;

/// The same by differences of numbers at inputs half a standard deviation away; none where one of them is missing.
pub fn taylor_by_differences(plan: &Plan, of: &dyn Sampled) -> Vec<Option<Taylor>> {
    let (center, steps) = (means(plan), steps(plan, BETWEEN_NUMBERS));
    let count = center.len();
    let signs = [1.0, -1.0];
    let mut points = vec![center.clone()];
    for i in 0..count {
        points.extend(signs.map(|sign| moved(&center, i, sign * steps[i])));
    }
    for i in 0..count {
        for j in 0..i {
            points.extend(signs.map(|sign| moved(&moved(&center, i, sign * steps[i]), j, sign * steps[j])));
        }
    }
    let found: Vec<Outcome> = points.par_iter().map(|inputs| of.outcome(inputs)).collect();
    let polynomial = |number: usize| {
        let values = found.iter().map(|outcome| outcome.values[number]).collect::<Option<Vec<f64>>>()?;
        Some(fitted(&center, &steps, &values))
    };
    (0..of.numbers()).map(polynomial).collect()
}

/// From the values at the center, at both sides of each input, and at two corners of each pair of inputs.
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
    /// The input at two quantiles of its distribution
    pub inputs: [f64; 2],
    /// The numbers there, with all other inputs at their means
    pub outcomes: [Outcome; 2],
}

/// For each input what the numbers are where it is at its quantiles of `probability` and 1 - `probability`, and all others at their means.
pub fn one_at_a_time(plan: &Plan, probability: f64, of: &dyn Sampled) -> Vec<OneAtATime> {
    let center = means(plan);
    let one = |index: usize| {
        let distribution = plan.inputs[index].distribution;
        let inputs = [probability, 1.0 - probability].map(|p| distribution.quantile(p));
        OneAtATime { inputs, outcomes: inputs.map(|value| of.outcome(&moved(&center, index, value - center[index]))) }
    };
    (0..center.len()).into_par_iter().map(one).collect()
}

// -- A peel as a function of its uncertain inputs --

/// Numbers as a function of uncertain inputs, of a peel or of something else. Its functions are called from any thread.
pub trait Sampled: Sync {
    /// How many numbers there are
    fn numbers(&self) -> usize;

    /// The numbers with these inputs, in the order and units of the plan.
    fn outcome(&self, inputs: &[f64]) -> Outcome;
}

impl Sampled for SampledPeel<'_> {
    fn numbers(&self) -> usize {
        self.of.len()
    }

    fn outcome(&self, inputs: &[f64]) -> Outcome {
        SampledPeel::outcome(self, inputs)
    }
}

/// A peel as a function of its uncertain inputs. All of its functions are called from any thread.
#[derive(Clone, Copy)]
pub struct SampledPeel<'p> {
    /// The model with these inputs, in the order and units of the plan; or why there is none
    pub model: &'p (dyn Fn(&[f64]) -> Result<PeelModel, String> + Sync),
    /// What is asked for
    pub of: &'p [PeelQuantity],
    /// Of every peel
    pub accuracy: &'p Accuracy,
    /// The stop criteria of one path, anew for each
    pub stop: &'p (dyn Fn() -> StopCriteria + Sync),
}

impl SampledPeel<'_> {
    /// What the peel with these inputs gives.
    pub fn outcome(&self, inputs: &[f64]) -> Outcome {
        match (self.model)(inputs) {
            Ok(model) => peel_numbers(&model, self.of, self.accuracy, self.stop),
            Err(why) => Outcome::refused(self.of.len(), why),
        }
    }
}

/// Runs the samples of a design on all cores, replicate after replicate. `go_on` is asked before each: once it says no, no other is begun, and
/// the samples that were not begun have no result. The results stand in the order of the samples, however many cores there are.
pub fn sample<R: Send>(
    design: &Design,
    go_on: &(dyn Fn() -> bool + Sync),
    run: &(dyn Fn(SamplePlace) -> R + Sync),
) -> Vec<Option<R>> {
    let replicate = |number: usize| {
        let count = design.samples_of_replicate();
        let places: Vec<SamplePlace> =
            (number * count..(number + 1) * count).map(|sample| design.place(sample)).collect();
        let one = |&place: &SamplePlace| go_on().then(|| run(place));
        sweep(&places, &|| true, &one)
    };
    (0..design.replicates()).flat_map(replicate).collect()
}

// -- What the derivatives at the means of the inputs say of a number: the Taylor polynomials of first and second order --

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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Differences are exact for a polynomial of second degree.
    #[test]
    fn a_quadratic_is_its_own_polynomial() {
        let f = |x: &[f64]| 1.0 + 2.0 * x[0] - x[2] + 3.0 * x[0] * x[1] - 0.5 * x[1] * x[2] + x[2] * x[2];
        let (center, steps) = ([1.0, -2.0, 0.5], [0.1, 0.2, 0.3]);
        let mut values = vec![f(&center)];
        for i in 0..3 {
            values.extend([1.0, -1.0].map(|sign| f(&moved(&center, i, sign * steps[i]))));
        }
        for (i, j) in [(1, 0), (2, 0), (2, 1)] {
            let both = |sign: f64| moved(&moved(&center, i, sign * steps[i]), j, sign * steps[j]);
            values.extend([1.0, -1.0].map(|sign| f(&both(sign))));
        }
        let found = fitted(&center, &steps, &values);
        for (slope, exact) in found.gradient.iter().zip([2.0 - 6.0, 3.0 - 0.25, -1.0 + 1.0 + 1.0]) {
            assert_relative_eq!(*slope, exact, max_relative = 1e-12);
        }
        let exact = DMatrix::from_row_slice(3, 3, &[0.0, 3.0, 0.0, 3.0, 0.0, -0.5, 0.0, -0.5, 2.0]);
        assert_relative_eq!(found.hessian.unwrap(), exact, epsilon = 1e-11);
    }
}
