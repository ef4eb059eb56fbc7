//! The coordinate in which a parameter is searched for, and its bounds.

use super::problem::FitParameter;
use super::result::NoFit;
use crate::model::check::error::Range;

/// How many times its initial value a parameter above zero may become, and how small a share of it, unless its bounds say.
const WITHIN: f64 = 100.0;
/// A coordinate that begins nearer to a bound than this share of the way between both is moved inside: at the bound the search would stay.
const INSIDE: f64 = 1e-3;
/// How far inside its range a parameter stays that has a range, in its coordinate: derivatives are taken over a part of that.
const MARGIN: f64 = 2e-3;

/// The coordinate x of a parameter p: ln(p/p₀) where it is above zero, or else (p - p₀)/scale. The search runs over z with
/// x = middle + half · sin z, which keeps x between its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coordinate {
    initial: f64,
    /// None: logarithmic
    scale: Option<f64>,
    low: f64,
    high: f64,
}

impl Coordinate {
    /// Of a parameter; `span` is the scale of one that may be zero and has no bounds.
    pub(crate) fn new(parameter: &FitParameter, span: f64) -> Result<Self, NoFit> {
        let FitParameter { key, initial, range, from, to, .. } = parameter;
        let initial = *initial;
        let (low, high, scale) = match *range {
            Range::Positive => (initial / WITHIN, initial * WITHIN, None),
            Range::Between(low, high) | Range::From(low, high) => {
                let wide = (high - low).min(2.0 * span.max(initial.abs()));
                ((initial - wide).max(low + MARGIN * wide), (initial + wide).min(high - MARGIN * wide), Some(wide))
            }
        };
        let (from, to) = match scale {
            None => (from.unwrap_or(low), to.unwrap_or(high)),
            Some(_) => (from.map_or(low, |from| from.max(low)), to.map_or(high, |to| to.min(high))),
        };
        if !(from < to && from <= initial && initial <= to && (scale.is_some() || from > 0.0)) {
            return Err(NoFit::OutsideBounds { key: key.clone(), value: initial, from, to });
        }
        let mut coordinate = Self { initial, scale, low: 0.0, high: 0.0 };
        (coordinate.low, coordinate.high) = (coordinate.of(from), coordinate.of(to));
        Ok(coordinate)
    }

    pub(crate) fn is_logarithmic(&self) -> bool {
        self.scale.is_none()
    }

    /// x of a value.
    pub(crate) fn of(&self, value: f64) -> f64 {
        match self.scale {
            None => (value / self.initial).ln(),
            Some(scale) => (value - self.initial) / scale,
        }
    }

    /// The value at x.
    pub(crate) fn value(&self, x: f64) -> f64 {
        match self.scale {
            None => self.initial * x.exp(),
            Some(scale) => self.initial + scale * x,
        }
    }

    /// dp/dx
    pub(crate) fn rate(&self, x: f64) -> f64 {
        self.scale.unwrap_or_else(|| self.value(x))
    }

    /// Both bounds of x.
    pub(crate) fn bounds(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    /// z of x.
    pub(crate) fn inner(&self, x: f64) -> f64 {
        let sine = (x - 0.5 * (self.low + self.high)) / self.half();
        let most = 1.0 - 2.0 * INSIDE;
        sine.clamp(-most, most).asin()
    }

    /// x at z.
    pub(crate) fn outer(&self, z: f64) -> f64 {
        0.5 * (self.low + self.high) + self.half() * z.sin()
    }

    /// dx/dz
    pub(crate) fn inner_rate(&self, z: f64) -> f64 {
        self.half() * z.cos()
    }

    /// Which bound x has come to, if one: -1 or 1.
    pub(crate) fn at_bound(&self, x: f64) -> Option<i8> {
        let near = INSIDE * (self.high - self.low);
        if x < self.low + near {
            Some(-1)
        } else if x > self.high - near {
            Some(1)
        } else {
            None
        }
    }

    fn half(&self) -> f64 {
        0.5 * (self.high - self.low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::parameters::fit::problem::ParameterOf;

    fn parameter(initial: f64, range: Range) -> FitParameter {
        FitParameter { key: "k".into(), initial, range, from: None, to: None, of: ParameterOf::Model }
    }

    #[test]
    fn values_and_coordinates_are_inverse_and_stay_within_bounds() {
        for (range, initial) in [(Range::Positive, 2.0), (Range::POISSONS_RATIO, 0.2), (Range::OFFSET, 0.0)] {
            let c = Coordinate::new(&parameter(initial, range), 3.0).unwrap();
            for z in [-1.4, -0.2, 0.0, 1.1] {
                let x = c.outer(z);
                assert!((c.inner(x) - z).abs() < 1e-9);
                assert!((c.of(c.value(x)) - x).abs() < 1e-12);
                assert!(range.contains(c.value(x)), "{range:?} {z}");
                let slope = (c.value(x + 1e-6) - c.value(x - 1e-6)) / 2e-6;
                assert!((slope / c.rate(x) - 1.0).abs() < 1e-8);
                let slope = (c.outer(z + 1e-6) - c.outer(z - 1e-6)) / 2e-6;
                assert!((slope / c.inner_rate(z) - 1.0).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn a_value_outside_its_bounds_is_refused() {
        let bounded = FitParameter { from: Some(3.0), to: Some(4.0), ..parameter(2.0, Range::Positive) };
        assert!(matches!(Coordinate::new(&bounded, 1.0), Err(NoFit::OutsideBounds { .. })));
        let crossed = FitParameter { from: Some(4.0), to: Some(1.0), ..parameter(2.0, Range::Positive) };
        assert!(Coordinate::new(&crossed, 1.0).is_err());
    }
}
