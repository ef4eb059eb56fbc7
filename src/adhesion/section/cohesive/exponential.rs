//! The exponential law: s = t exp(1 - t), ∫ s from t on = (1 + t) exp(1 - t), in all e; the integral of that is (2 + t)
//! exp(1 - t).
//!
//! Source: J. H. Rose, J. Ferrante, J. R. Smith, Universal binding energy curves for metals and bimetallic interfaces (1981).

use super::at::At;

pub(super) const NAME: &str = "exponential";
pub(super) const CORNERS: f64 = 1.0;
pub(super) const KNOTS: &[f64] = &[0.0];

#[inline]
pub(super) fn at(t: f64) -> At {
    let decay = (1.0 - t).exp();
    [(1.0 + t) * decay, t * decay, (1.0 - t) * decay]
}

#[inline]
pub(super) fn primitive(t: f64) -> f64 {
    (2.0 + t) * (1.0 - t).exp()
}
