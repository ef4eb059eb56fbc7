//! Sensitivities as exponents: d ln Q/d ln p.

use super::quantity::PeelQuantity;
use super::run::Sensitivities;
use crate::study::peel::result::Peel;

/// By which power of a parameter a number changes: d ln Q/d ln p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent {
    /// The number
    pub of: PeelQuantity,
    /// Which of the variations, whose coordinate is ln p
    pub variation: usize,
    /// d ln Q/d ln p
    pub value: f64,
    /// Bound on its error
    pub error: f64,
}

impl Sensitivities {
    /// The derivatives by variations in ln p, each over its number: those of one number together, in the order in which the numbers were asked for,
    /// largest first. A number that is zero has none.
    pub fn exponents(&self, peel: &Peel) -> Vec<Exponent> {
        let one = |derivative: &crate::study::parameters::sensitivity::Derivative| {
            let number = derivative.of.value(peel).filter(|number| *number != 0.0)?;
            let value = derivative.value / number;
            let uncertain = value.abs() * derivative.of.error(peel).unwrap_or(0.0);
            let error = (derivative.error + uncertain) / number.abs();
            Some(Exponent { of: derivative.of, variation: derivative.variation, value, error })
        };
        let mut exponents: Vec<Exponent> = self.derivatives.iter().filter_map(one).collect();
        for group in exponents.chunk_by_mut(|a, b| a.of == b.of) {
            group.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
        }
        exponents
    }
}
