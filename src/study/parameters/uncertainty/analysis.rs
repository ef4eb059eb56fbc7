//! All that a sample and the derivatives at the means say of each number.

use super::derivatives::{DerivativesBy, OneAtATime, Order, Propagation, Taylor};
use super::design::Design;
use super::plan::Outcome;
use super::statistics::{SobolIndex, Statistics, sobol_indices};
use crate::study::parameters::sensitivity::quantity::PeelQuantity;

/// The quantiles that are reported.
pub(crate) const PROBABILITIES: [f64; 7] = [0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99];
/// The quantile of an input, and its counterpart, at which it is looked at alone.
pub const ALONE_AT: f64 = 0.05;

/// What is known of one number.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberAnalysis {
    /// Which number
    pub of: PeelQuantity,
    /// At the samples, in their order; none where the path does not have it or was not computed as far
    pub values: Vec<Option<f64>>,
    /// None where fewer than two replicates have the number
    pub statistics: Option<Statistics>,
    /// Of each group of inputs; empty where they were not asked for
    pub indices: Vec<SobolIndex>,
    /// By derivatives at the means of the inputs; none where the peel does not have the number there
    pub taylor: Option<Taylor>,
    /// What the derivatives give, of first and of second order
    pub propagations: Vec<Propagation>,
    /// Of each input what the number is where it is at its quantiles of [`ALONE_AT`] and the counterpart, all others at their means
    pub alone: Vec<[Option<f64>; 2]>,
}

/// What an uncertain peel gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// Where it was sampled
    pub design: Design,
    /// In the order of the samples; none where it was not computed
    pub outcomes: Vec<Option<Outcome>>,
    /// In the order asked for
    pub numbers: Vec<NumberAnalysis>,
    /// Where the derivatives come from
    pub derivatives_by: DerivativesBy,
    /// At which values each input was looked at alone
    pub alone: Vec<OneAtATime>,
}

impl Analysis {
    /// Of these numbers of the samples of a design, with their polynomials about the means, and each input alone.
    pub fn new(
        design: Design,
        of: &[PeelQuantity],
        outcomes: Vec<Option<Outcome>>,
        (taylors, derivatives_by): (Vec<Option<Taylor>>, DerivativesBy),
        alone: Vec<OneAtATime>,
    ) -> Self {
        let number = |(number, (&of, taylor)): (usize, (&PeelQuantity, Option<Taylor>))| {
            let values: Vec<Option<f64>> =
                outcomes.iter().map(|outcome| outcome.as_ref().and_then(|outcome| outcome.values[number])).collect();
            let propagation = |order| taylor.as_ref().and_then(|taylor| taylor.propagation(order, &design, &values));
            NumberAnalysis {
                of,
                statistics: Statistics::of(&design, &values, &PROBABILITIES),
                indices: sobol_indices(&design, &values),
                propagations: [Order::First, Order::Second].into_iter().filter_map(propagation).collect(),
                alone: alone.iter().map(|of| of.outcomes.each_ref().map(|outcome| outcome.values[number])).collect(),
                taylor,
                values,
            }
        };
        let numbers = of.iter().zip(taylors).enumerate().map(number).collect();
        Self { design, outcomes, numbers, derivatives_by, alone }
    }

    /// Samples that were computed.
    pub fn computed(&self) -> usize {
        self.outcomes.iter().flatten().count()
    }

    /// Why samples were cut short, each reason with how many have it and the first of them, the most frequent first. Reasons that differ in their
    /// numbers alone are one: that of the first.
    pub fn cut_short(&self) -> Vec<CutShort> {
        let mut found: Vec<(String, CutShort)> = Vec::new();
        for (sample, outcome) in self.outcomes.iter().enumerate() {
            let Some(reason) = outcome.as_ref().and_then(|outcome| outcome.cut_short.as_ref()) else { continue };
            let words: String = reason.chars().filter(|c| c.is_alphabetic() || *c == ' ').collect();
            match found.iter_mut().find(|(known, _)| *known == words) {
                Some((_, known)) => known.count += 1,
                None => found.push((words, CutShort { reason: reason.clone(), count: 1, first: sample })),
            }
        }
        let mut all: Vec<CutShort> = found.into_iter().map(|(_, of)| of).collect();
        all.sort_by_key(|of| std::cmp::Reverse(of.count));
        all
    }
}

/// A reason for which samples were cut short.
#[derive(Clone, Debug, PartialEq)]
pub struct CutShort {
    /// Of the first one
    pub reason: String,
    /// How many have it
    pub count: usize,
    /// The number of the first of them
    pub first: usize,
}
