//! What of a fit is not to be trusted.

use super::coordinate::Coordinate;
use super::result::{Combination, Fit, FittedCurve, PairDetermined, PointPlace};
use super::statistics::Covariance;
use std::fmt;

/// Something that a user of a fit has to know.
#[derive(Clone, Debug, PartialEq)]
pub enum FitWarning {
    /// Parameters that the curve determines together and not each by itself
    Together {
        /// Their keys
        keys: [String; 2],
        /// Of their coordinates
        correlation: f64,
        /// As of [`crate::study::PairDetermined`]
        exponent: Option<f64>,
        /// Likewise
        relative_error: Option<f64>,
    },
    /// A parameter whose interval is wide
    Poor {
        /// Its key
        key: String,
        /// Half its interval over its value
        half: f64,
    },
    /// A parameter that ended at a bound of the search
    AtBound {
        /// Its key
        key: String,
        /// The bound
        bound: f64,
    },
    /// No measured point on the path of the model
    NoneOnPath {
        /// First and last measured displacement, nm
        measured: [f64; 2],
        /// Where the path begins and where it ends or jumps, as the machine records it, nm
        path: [f64; 2],
    },
    /// Measured points behind the first jump of the model
    BehindJump {
        /// How many
        points: usize,
        /// Where the model jumps, as the machine records it, nm
        jump: f64,
    },
    /// Measured points before the path of the model begins
    BeforeStart {
        /// How many
        points: usize,
        /// Where it begins, as the machine records it, nm
        start: f64,
    },
    /// The measured curve jumps and the model does not
    NoJump {
        /// Where the curve jumps, nm
        measured: f64,
    },
    /// Residuals that are far larger than neighbouring points scatter, where displacements were taken as exact
    ExactDisplacements {
        /// Standard error of a force that the residuals show, nN
        residual: f64,
        /// Standard error of a force that neighbouring points show, nN
        scatter: f64,
        /// Standard error of a displacement that would explain the residuals where the curve is steep, nm
        displacement_error: f64,
    },
    /// One of these, of one of several curves
    OfCurve {
        /// Which one, from 1
        number: usize,
        /// What of it
        warning: Box<FitWarning>,
    },
    /// Residuals larger than their standard errors say
    Misfit {
        /// Sum of squares over its degrees of freedom
        reduced: f64,
    },
}

/// A sum of squares over its degrees of freedom n is too large from 1 + this times √(2/n) on.
const MISFIT: f64 = 5.0;
/// Residuals are far larger than the scatter of neighbouring points from so many times on.
const BEYOND_SCATTER: f64 = 3.0;
/// The steep part of a curve is one of so many.
const STEEP: usize = 4;

impl Fit {
    /// What of it is not to be trusted.
    pub fn warnings(&self) -> Vec<FitWarning> {
        let mut found = Vec::new();
        for pair in &self.pairs {
            found.push(FitWarning::Together {
                keys: pair.parameters.map(|index| self.parameters[index].key.clone()),
                correlation: pair.correlation,
                exponent: pair.exponent,
                relative_error: pair.relative_error,
            });
        }
        let paired = |index: &usize| self.pairs.iter().any(|pair| pair.parameters.contains(index));
        for (index, parameter) in self.parameters.iter().enumerate() {
            if let Some(bound) = parameter.at_bound {
                found.push(FitWarning::AtBound { key: parameter.key.clone(), bound });
            } else if let Some([low, high]) = parameter.interval
                && parameter.poorly_determined
                && !paired(&index)
            {
                let half = 0.5 * (high - low) / parameter.value.abs();
                found.push(FitWarning::Poor { key: parameter.key.clone(), half });
            }
        }
        for (index, curve) in self.curves.iter().enumerate() {
            let of_curve = |warning: FitWarning| match self.curves.len() {
                1 => warning,
                _ => FitWarning::OfCurve { number: index + 1, warning: Box::new(warning) },
            };
            found.extend(curve.warnings().into_iter().map(of_curve));
        }
        found.extend(self.displacement_warning());
        let freedom = self.degrees_of_freedom as f64;
        let reduced = self.sum_of_squares / freedom;
        if self.estimated_error.is_none() && reduced > 1.0 + MISFIT * (2.0 / freedom).sqrt() {
            found.push(FitWarning::Misfit { reduced });
        }
        found
    }
}

impl FittedCurve {
    /// What of the curve is not compared with the branch of the model.
    fn warnings(&self) -> Vec<FitWarning> {
        let mut found = Vec::new();
        let ends = |curve: &[(f64, f64)]| (curve.first().map_or(0.0, |at| at.0), curve.last().map_or(0.0, |at| at.0));
        let (start, jump) = ends(&self.curve);
        match (self.count(PointPlace::BehindJump), self.count(PointPlace::BeforeStart)) {
            (behind, before) if behind + before == self.points.len() => {
                let measured = || self.points.iter().map(|point| point.displacement);
                let measured = [measured().fold(f64::INFINITY, f64::min), measured().fold(f64::NEG_INFINITY, f64::max)];
                found.push(FitWarning::NoneOnPath { measured, path: [start, jump] });
            }
            (behind, before) => {
                found.extend((behind > 0).then_some(FitWarning::BehindJump { points: behind, jump }));
                found.extend((before > 0).then_some(FitWarning::BeforeStart { points: before, start }));
            }
        }
        if let Some(jump) = self.jump.filter(|jump| jump.modelled.is_none()) {
            found.push(FitWarning::NoJump { measured: jump.displacement });
        }
        found
    }
}

impl Fit {
    /// That the residuals may be those of the displacements: they are far larger than what neighbouring points show, and largest where the curve is
    /// steep.
    fn displacement_warning(&self) -> Option<FitWarning> {
        let (residual, scatter) = (self.estimated_error?, self.scatter);
        if !self.exact_displacements || residual <= BEYOND_SCATTER * scatter {
            return None;
        }
        let mut points: Vec<(f64, f64)> =
            self.points().map(|point| (point.slope.abs(), (point.modelled - point.force).abs())).collect();
        points.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (steep, level) = points.split_at(points.len() / STEEP);
        let mean = |points: &[(f64, f64)]| {
            (points.iter().map(|point| point.1 * point.1).sum::<f64>() / points.len() as f64).sqrt()
        };
        let slope = (steep.iter().map(|point| point.0 * point.0).sum::<f64>() / steep.len() as f64).sqrt();
        let displacement_error = mean(steep) / slope;
        (mean(steep) > mean(level) && displacement_error.is_finite()).then_some(FitWarning::ExactDisplacements {
            residual,
            scatter,
            displacement_error,
        })
    }
}

impl FitWarning {
    /// A word that stays the same, for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Together { .. } => "determined-together",
            Self::Poor { .. } => "poorly-determined",
            Self::AtBound { .. } => "at-bound",
            Self::NoneOnPath { .. } => "none-on-path",
            Self::BehindJump { .. } => "behind-jump",
            Self::BeforeStart { .. } => "before-start",
            Self::NoJump { .. } => "no-jump",
            Self::ExactDisplacements { .. } => "exact-displacements",
            Self::OfCurve { warning, .. } => warning.code(),
            Self::Misfit { .. } => "misfit",
        }
    }
}

impl fmt::Display for FitWarning {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Together { keys: [one, other], correlation, exponent, relative_error } => {
                write!(
                    f,
                    "{one} and {other} are poorly determined together, their correlation is {correlation:.3}: the curve hardly changes where one makes up for the other"
                )?;
                match exponent.zip(*relative_error) {
                    Some((exponent, error)) => write!(
                        f,
                        "; what it determines is {one} times {other} to the power {exponent:.3}, to ± {:.2} %. Fix one of the two by other knowledge",
                        100.0 * error
                    ),
                    None => write!(f, ". Fix one of the two by other knowledge"),
                }
            }
            Self::Poor { key, half } => write!(
                f,
                "{key} is poorly determined, to ± {:.0} % at 95 %: see its profile likelihood, or measure where the curve depends on it",
                100.0 * half
            ),
            Self::AtBound { key, bound } => write!(
                f,
                "{key} ended at a bound of the search, {bound}: its interval is not known, and those of the others hold at this value. Give it other bounds, or fix it"
            ),
            Self::NoneOnPath { measured: [first, last], path: [start, end] } => write!(
                f,
                "no measured point lies on the path of the model: displacements were measured from {first:.6} to {last:.6} nm, and the path goes from {start:.6} to {end:.6} nm of the machine: nothing of this fit is to be trusted. See whether the header of the data names the right units, and begin with other values"
            ),
            Self::BehindJump { points, jump } => write!(
                f,
                "{points} measured points lie behind the first jump of the model, at {jump:.6} nm of the machine, and were compared with the force there: give the measured displacement of the jump as fit.jump, or remove these points"
            ),
            Self::BeforeStart { points, start } => write!(
                f,
                "{points} measured points lie before the path of the model begins, at {start:.6} nm of the machine, and were compared with the curve reflected there: that is right to the first order only. Remove points that are pressed on"
            ),
            Self::NoJump { measured } => write!(
                f,
                "the measured curve jumps at {measured:.6} nm, and the model does not as far as it was followed: raise bounds.displacement, or set fit.use_jump = false"
            ),
            Self::ExactDisplacements { residual, scatter, displacement_error } => write!(
                f,
                "the residuals are {residual:.1e} nN and neighbouring points scatter by {scatter:.1e} nN, most where the curve is steep: displacements are taken as exact, and the intervals do not have their errors. Give the standard error of a measured displacement, for example fit.displacement_error = \"{displacement_error:.1e} nm\", or the model does not describe the curve"
            ),
            Self::OfCurve { number, warning } => write!(f, "curve {number}: {warning}"),
            Self::Misfit { reduced } => write!(
                f,
                "the residuals are larger than their standard errors, chi² is {reduced:.2} times its degrees of freedom: the errors are too small or the model does not describe the curve, and the intervals are too narrow"
            ),
        }
    }
}

// -- Parameters that the measured curve does not tell apart --

/// Half an interval of a coordinate beyond which a parameter is poorly determined: 10 % of one above zero.
pub(super) const POOR: f64 = 0.1;
/// Two parameters make up for one another from this correlation on.
const TOGETHER: f64 = 0.9;

/// Combinations of the parameters that are searched for by their logarithms.
pub(super) fn combinations(covariance: &Covariance, coordinates: &[Coordinate]) -> Vec<Combination> {
    let among: Vec<usize> =
        covariance.of.iter().copied().filter(|&index| coordinates[index].is_logarithmic()).collect();
    let combination = |(relative_error, direction): (f64, nalgebra::DVector<f64>)| {
        let mut exponents = vec![0.0; coordinates.len()];
        let sign = direction[direction.iamax()].signum();
        among.iter().zip(direction.iter()).for_each(|(&index, &component)| exponents[index] = sign * component);
        Combination { exponents, relative_error }
    };
    covariance.principal(&among).into_iter().map(combination).collect()
}

/// Pairs of which one is `poor` and whose correlation is large, the largest first.
pub(super) fn pairs(covariance: &Covariance, coordinates: &[Coordinate], poor: &[bool]) -> Vec<PairDetermined> {
    let mut found = Vec::new();
    for (k, &one) in covariance.of.iter().enumerate() {
        for &other in &covariance.of[k + 1..] {
            let correlation = covariance.correlation(one, other).unwrap_or(0.0);
            if correlation.abs() < TOGETHER || !(poor[one] || poor[other]) {
                continue;
            }
            let both = coordinates[one].is_logarithmic() && coordinates[other].is_logarithmic();
            let best = if both { best_of_pair(covariance, one, other) } else { None };
            found.push(PairDetermined {
                parameters: [one, other],
                correlation,
                exponent: best.map(|best| best.0),
                relative_error: best.map(|best| best.1),
            });
        }
    }
    found.sort_by(|a, b| b.correlation.abs().total_cmp(&a.correlation.abs()));
    found
}

/// e with which ln p₁ + e ln p₂ has the least variance over 1 + e², and its standard error.
fn best_of_pair(covariance: &Covariance, one: usize, other: usize) -> Option<(f64, f64)> {
    let (error, direction) = covariance.principal(&[one, other]).pop()?;
    let (first, second) = (direction[0], direction[1]);
    (first.abs() > 1e-6).then(|| (second / first, error / first.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Range;
    use crate::study::parameters::fit::problem::{FitParameter, ParameterOf};
    use nalgebra::DMatrix;

    /// Data that hang on p₁ p₂⁻² alone but for a little.
    #[test]
    fn what_is_well_determined_of_two_is_their_product_of_powers() {
        let of = |key: &str| FitParameter {
            key: key.into(),
            initial: 1.0,
            range: Range::Positive,
            from: None,
            to: None,
            of: ParameterOf::Model,
        };
        let coordinates = [of("a"), of("b")].map(|parameter| Coordinate::new(&parameter, 1.0).unwrap());
        let jacobian = DMatrix::from_row_slice(3, 2, &[100.0, -200.0, 100.0, -200.0, 1.0, 0.5]);
        let covariance = Covariance::new(&jacobian, vec![0, 1], 1.0);
        let found = pairs(&covariance, &coordinates, &[true, true]);
        assert_eq!(found.len(), 1);
        assert!(found[0].correlation > 0.99);
        assert!((found[0].exponent.unwrap() + 2.0).abs() < 1e-3, "{found:?}");
        assert!(found[0].relative_error.unwrap() < 0.01);
        let all = combinations(&covariance, &coordinates);
        assert!(all[0].relative_error > 50.0 * all[1].relative_error);
        assert!(pairs(&covariance, &coordinates, &[false, false]).is_empty());
    }
}
