//! By which power of each parameter the results change.

use crate::number::Finite;
use peelkit::study::Exponent;

/// d ln Q/d ln p of one number by one parameter.
#[derive(Debug, serde::Serialize)]
pub struct SensitivitySummary {
    of: &'static str,
    key: String,
    d_ln_d_ln: Finite,
    error: Finite,
}

impl SensitivitySummary {
    /// Of an exponent by the parameters with these keys.
    pub fn new(exponent: &Exponent, keys: &[String]) -> Self {
        Self {
            of: exponent.of.name(),
            key: keys[exponent.variation].clone(),
            d_ln_d_ln: Finite(exponent.value),
            error: Finite(exponent.error),
        }
    }
}
