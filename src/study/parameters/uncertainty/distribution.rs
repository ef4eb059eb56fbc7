//! How an uncertain number is distributed.

use crate::model::check::error::Range;
use statrs::function::erf;
use std::f64::consts::SQRT_2;
use std::fmt;

/// The distribution of a number; all its parameters but a deviation of a logarithm have the unit of the number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Density ∝ exp(-(x - m)²/2s²) with the mean m and the standard deviation s
    Normal {
        /// m
        mean: f64,
        /// s
        deviation: f64,
    },
    /// ln x is normal with the mean ln m and the standard deviation s
    Lognormal {
        /// m
        median: f64,
        /// s, of ln x
        log_deviation: f64,
    },
    /// The same density everywhere between two ends
    Uniform {
        /// The lower end
        from: f64,
        /// The upper end
        to: f64,
    },
    /// A density that rises linearly from one end to the mode and falls linearly to the other
    Triangular {
        /// The lower end
        from: f64,
        /// Where the density is largest
        mode: f64,
        /// The upper end
        to: f64,
    },
}

/// What is wrong with the parameters of a distribution.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoDistribution {
    #[error("{name} = {found} is not finite")]
    NotFinite { name: &'static str, found: f64 },
    #[error("{name} = {found} is not above zero")]
    NotPositive { name: &'static str, found: f64 },
    #[error("from = {from} is not below to = {to}")]
    Ends { from: f64, to: f64 },
    #[error("mode = {mode} is not between from = {from} and to = {to}")]
    Mode { from: f64, mode: f64, to: f64 },
}

impl fmt::Display for Distribution {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let named: Vec<String> = self.parameters().into_iter().map(|(name, value)| format!("{name} {value}")).collect();
        write!(f, "{} with {}", self.name(), named.join(", "))
    }
}

impl Distribution {
    /// What a scene calls it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Normal { .. } => "normal",
            Self::Lognormal { .. } => "lognormal",
            Self::Uniform { .. } => "uniform",
            Self::Triangular { .. } => "triangular",
        }
    }

    /// Its parameters as a scene names them.
    pub fn parameters(&self) -> Vec<(&'static str, f64)> {
        match *self {
            Self::Normal { mean, deviation } => vec![("mean", mean), ("deviation", deviation)],
            Self::Lognormal { median, log_deviation } => vec![("median", median), ("log_deviation", log_deviation)],
            Self::Uniform { from, to } => vec![("from", from), ("to", to)],
            Self::Triangular { from, mode, to } => vec![("from", from), ("mode", mode), ("to", to)],
        }
    }

    /// Whether its parameters are those of a distribution.
    ///
    /// # Errors
    /// Which of them is not finite, not above zero or not in order.
    pub fn check(&self) -> Result<(), NoDistribution> {
        if let Some((name, found)) = self.parameters().into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(NoDistribution::NotFinite { name, found });
        }
        let positive =
            |name, found| if found > 0.0 { Ok(()) } else { Err(NoDistribution::NotPositive { name, found }) };
        match *self {
            Self::Normal { deviation, .. } => positive("deviation", deviation),
            Self::Lognormal { median, log_deviation } => {
                positive("median", median).and_then(|()| positive("log_deviation", log_deviation))
            }
            Self::Uniform { from, to } | Self::Triangular { from, to, .. } if from >= to => {
                Err(NoDistribution::Ends { from, to })
            }
            Self::Triangular { from, mode, to } if mode < from || mode > to => {
                Err(NoDistribution::Mode { from, mode, to })
            }
            Self::Uniform { .. } | Self::Triangular { .. } => Ok(()),
        }
    }

    /// The number below which a share `probability` of the distribution lies, 0 < p < 1.
    pub fn quantile(&self, probability: f64) -> f64 {
        match *self {
            Self::Normal { mean, deviation } => mean + deviation * normal_quantile(probability),
            Self::Lognormal { median, log_deviation } => median * (log_deviation * normal_quantile(probability)).exp(),
            Self::Uniform { from, to } => from + (to - from) * probability,
            Self::Triangular { from, mode, to } => {
                let width = to - from;
                if probability * width < mode - from {
                    from + (probability * width * (mode - from)).sqrt()
                } else {
                    to - ((1.0 - probability) * width * (to - mode)).sqrt()
                }
            }
        }
    }

    /// Its mean.
    pub fn mean(&self) -> f64 {
        match *self {
            Self::Normal { mean, .. } => mean,
            Self::Lognormal { median, log_deviation } => median * (0.5 * log_deviation * log_deviation).exp(),
            Self::Uniform { from, to } => 0.5 * (from + to),
            Self::Triangular { from, mode, to } => (from + mode + to) / 3.0,
        }
    }

    /// Its standard deviation.
    pub fn deviation(&self) -> f64 {
        match *self {
            Self::Normal { deviation, .. } => deviation,
            Self::Lognormal { log_deviation, .. } => self.mean() * (log_deviation * log_deviation).exp_m1().sqrt(),
            Self::Uniform { from, to } => (to - from) / 12f64.sqrt(),
            Self::Triangular { from, mode, to } => {
                let (a, b) = (mode - from, to - mode);
                ((a * a + a * b + b * b) / 18.0).sqrt()
            }
        }
    }

    /// The probability of a number outside of a range: what of it cannot be computed.
    pub fn probability_outside(&self, range: Range) -> f64 {
        let (low, high) = match range {
            Range::Positive => (0.0, f64::INFINITY),
            Range::Between(low, high) | Range::From(low, high) => (low, high),
        };
        self.below(low) + self.above(high)
    }

    fn below(&self, x: f64) -> f64 {
        match *self {
            Self::Normal { mean, deviation } => normal_below((x - mean) / deviation),
            Self::Lognormal { median, log_deviation } if x > 0.0 => normal_below((x / median).ln() / log_deviation),
            Self::Lognormal { .. } => 0.0,
            Self::Uniform { from, to } => ((x - from) / (to - from)).clamp(0.0, 1.0),
            Self::Triangular { from, mode, to } => {
                let x = x.clamp(from, to);
                if x < mode {
                    (x - from).powi(2) / ((to - from) * (mode - from))
                } else if x < to {
                    1.0 - (to - x).powi(2) / ((to - from) * (to - mode))
                } else {
                    1.0
                }
            }
        }
    }

    fn above(&self, x: f64) -> f64 {
        match *self {
            _ if x == f64::INFINITY => 0.0,
            Self::Normal { mean, deviation } => normal_below((mean - x) / deviation),
            Self::Lognormal { median, log_deviation } if x > 0.0 => normal_below((median / x).ln() / log_deviation),
            _ => 1.0 - self.below(x),
        }
    }
}

/// Φ(z), the share of a standard normal distribution below z.
pub(super) fn normal_below(z: f64) -> f64 {
    0.5 * erf::erfc(-z / SQRT_2)
}

/// Φ⁻¹(p)
pub(super) fn normal_quantile(probability: f64) -> f64 {
    -SQRT_2 * erf::erfc_inv(2.0 * probability)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const ALL: [Distribution; 5] = [
        Distribution::Normal { mean: 3.0, deviation: 0.5 },
        Distribution::Lognormal { median: 3.0, log_deviation: 0.3 },
        Distribution::Uniform { from: -1.0, to: 3.0 },
        Distribution::Triangular { from: 1.0, mode: 1.5, to: 4.0 },
        Distribution::Triangular { from: 1.0, mode: 4.0, to: 4.0 },
    ];

    /// ∫ x dp and ∫ (x - m)² dp by the midpoint rule over the quantiles.
    #[test]
    fn mean_and_deviation_are_those_of_the_quantiles() {
        let count = 200_000;
        for of in ALL {
            let sampled = |f: &dyn Fn(f64) -> f64| {
                (0..count).map(|i| f(of.quantile((i as f64 + 0.5) / count as f64))).sum::<f64>() / count as f64
            };
            assert_relative_eq!(sampled(&|x| x), of.mean(), max_relative = 1e-5);
            assert_relative_eq!(sampled(&|x| (x - of.mean()).powi(2)).sqrt(), of.deviation(), max_relative = 1e-4);
        }
    }

    #[test]
    fn shares_and_quantiles_are_inverse() {
        for of in ALL {
            for p in [1e-6, 0.03, 0.4, 0.5, 0.9, 0.999] {
                let x = of.quantile(p);
                assert_relative_eq!(of.below(x), p, max_relative = 1e-9);
                assert_relative_eq!(of.above(x), 1.0 - p, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn what_lies_outside_of_a_range() {
        let normal = Distribution::Normal { mean: 10.0, deviation: 2.0 };
        // Φ(-5)
        assert_relative_eq!(normal.probability_outside(Range::Positive), 2.866_515_718_791_94e-7, max_relative = 1e-9);
        let both = normal.probability_outside(Range::From(8.0, 12.0));
        assert_relative_eq!(both, 0.317_310_507_862_914, max_relative = 1e-9);
        let lognormal = Distribution::Lognormal { median: 1e-3, log_deviation: 2.0 };
        assert_eq!(lognormal.probability_outside(Range::Positive), 0.0);
        let uniform = Distribution::Uniform { from: -1.0, to: 3.0 };
        assert_relative_eq!(uniform.probability_outside(Range::Positive), 0.25);
    }

    #[test]
    fn what_is_no_distribution_is_said() {
        let text = |of: Distribution| of.check().unwrap_err().to_string();
        assert_eq!(text(Distribution::Normal { mean: 1.0, deviation: 0.0 }), "deviation = 0 is not above zero");
        assert_eq!(text(Distribution::Uniform { from: 2.0, to: 1.0 }), "from = 2 is not below to = 1");
        let outside = Distribution::Triangular { from: 1.0, mode: 5.0, to: 2.0 };
        assert_eq!(text(outside), "mode = 5 is not between from = 1 and to = 2");
        assert!(text(Distribution::Lognormal { median: f64::NAN, log_deviation: 1.0 }).contains("not finite"));
        assert!(ALL.iter().all(|of| of.check().is_ok()));
    }
}
