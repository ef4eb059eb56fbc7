//! One design evaluated: ln Q and its gradient from one peel a factor of the objective, and one adjoint; or ln Q alone where something else than a
//! peel has the number.

use super::options::{Evaluation, OptimisationOptions};
use super::problem::{DesignFound, DesignProblem, Factor, NumberBy};
use super::search_path::SearchPath;
use crate::study::limit_point_continuation::result::Spacing;
use crate::study::peel::result::Peel;
use crate::study::peeling::peel;
use crate::study::sensitivity::run::sensitivities;
use crate::study::sensitivity::{Derivative, Variation};

/// A gradient of ln Q to the accuracy asked for.
#[derive(Clone, Debug)]
pub(super) struct Precise {
    pub gradient: Vec<f64>,
    pub errors: Vec<f64>,
}

/// Evaluates designs.
pub(super) struct Evaluator<'p> {
    problem: &'p DesignProblem<'p>,
    options: &'p OptimisationOptions<'p>,
    /// None where the number is not that of a peel
    paths: Vec<(Factor, SearchPath)>,
}

impl<'p> Evaluator<'p> {
    /// From what was computed of the start.
    pub fn new(problem: &'p DesignProblem<'p>, options: &'p OptimisationOptions<'p>, start: &DesignFound) -> Self {
        let path = |(factor, peel): (Factor, &Peel)| (factor, SearchPath::new(factor.of, peel));
        let paths = match start {
            DesignFound::Peels(peels) => problem.objective.factors().into_iter().zip(peels).map(path).collect(),
            DesignFound::Curves(_) => Vec::new(),
        };
        Self { problem, options, paths }
    }

    /// ln Q at coordinates, with its gradient where that is asked for.
    pub fn evaluate(&self, coordinates: &[f64], with_gradient: bool) -> Evaluation {
        let found = match &self.problem.number {
            NumberBy::Peel => self.by_peels(coordinates, with_gradient),
            NumberBy::Values(number) => {
                let values = self.problem.values(coordinates);
                let log_of = |factor: &Factor| {
                    let found =
                        number(&values, factor.angle, &(self.options.stop)()).ok().filter(|found| found.value > 0.0)?;
                    Some(factor.power * found.value.ln())
                };
                let sum: Option<f64> = self.problem.objective.factors().iter().map(log_of).sum();
                sum.filter(|sum| sum.is_finite()).map(|sum| (sum, Vec::new()))
            }
        };
        let (log_value, gradient) = found.map_or((None, Vec::new()), |(value, gradient)| (Some(value), gradient));
        Evaluation { coordinates: coordinates.to_vec(), log_value, gradient }
    }

    fn by_peels(&self, coordinates: &[f64], with_gradient: bool) -> Option<(f64, Vec<f64>)> {
        let model = self.problem.model_at(coordinates)?;
        let (mut sum, mut gradient) = (0.0, vec![0.0; if with_gradient { coordinates.len() } else { 0 }]);
        for (factor, path) in &self.paths {
            let peel = path.peel(&factor.model(model.clone()), self.options);
            let value = factor.of.value(&peel).filter(|&value| value > 0.0)?;
            sum += factor.power * value.ln();
            if with_gradient {
                for (slope, total) in
                    derivatives(self.problem, factor, &peel, coordinates).ok()?.iter().zip(&mut gradient)
                {
                    *total += factor.power * slope.value / value;
                }
            }
        }
        (sum.is_finite() && gradient.iter().all(|slope| slope.is_finite())).then_some((sum, gradient))
    }

    /// The gradient of ln Q from peels to the accuracy asked for; none where the number is not that of a peel.
    pub fn precise(&self, coordinates: &[f64]) -> Option<Precise> {
        if self.paths.is_empty() {
            return None;
        }
        let model = self.problem.model_at(coordinates)?;
        let zero = || vec![0.0; coordinates.len()];
        let mut sum = Precise { gradient: zero(), errors: zero() };
        for (factor, _) in &self.paths {
            let peel = peel(&factor.model(model.clone()), &self.options.accuracy, &(self.options.stop)());
            let value = factor.of.value(&peel).filter(|&value| value > 0.0)?;
            for (k, slope) in derivatives(self.problem, factor, &peel, coordinates).ok()?.iter().enumerate() {
                sum.gradient[k] += factor.power * slope.value / value;
                sum.errors[k] += slope.error / value;
            }
        }
        Some(sum)
    }
}

/// The derivatives of the number of a factor by the coordinates, or why there are none.
pub(super) fn derivatives(
    problem: &DesignProblem,
    factor: &Factor,
    peel: &Peel,
    coordinates: &[f64],
) -> Result<Vec<Derivative>, String> {
    let base = &peel.model;
    let ranges: Vec<f64> = problem.variables.iter().map(|variable| variable.range()).collect();
    let variation = |index: usize| {
        // of a logarithmic coordinate x is ln of the value, else a share of the range
        let share = if problem.variables[index].spacing == Spacing::Logarithmic { 1.0 / ranges[index] } else { 1.0 };
        let model = move |x: f64| {
            let mut moved = coordinates.to_vec();
            moved[index] += share * x;
            // the bounds lie inside the range in which there is a model
            problem.model_at(&moved).map_or_else(|| base.clone(), |model| factor.model(model))
        };
        (share, Variation { key: problem.variables[index].name.clone(), model: Box::new(model) })
    };
    let (shares, variations): (Vec<f64>, Vec<Variation>) = (0..coordinates.len()).map(variation).unzip();
    let found = sensitivities(peel, &[factor.of], &variations).map_err(|why| why.to_string())?;
    let one = |(index, share): (usize, &f64)| {
        let slope = found.of(factor.of, index).copied();
        let refused = || found.refused.iter().find(|(variation, _)| *variation == index);
        slope
            .map(|slope| Derivative { value: slope.value / share, error: slope.error / share, ..slope })
            .ok_or_else(|| refused().map_or_else(|| factor.of.name().to_owned(), |(_, why)| why.to_string()))
    };
    shares.iter().enumerate().map(one).collect()
}
