//! What is to be fitted, and how.

use super::curves::measured_curve::MeasuredCurve;
use super::curves::pulled_curve::PulledCurve;
use crate::model::check::error::Range;
use crate::model::peel::PeelModel;
use crate::study::asked::stop_criteria::StopCriteria;

/// What a parameter changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterOf {
    /// The model, the stiffness of its machine ([`crate::model::Grip::stiffness`]) included
    Model,
    /// d of one curve, the measured displacement at which the model's is zero, nm
    DisplacementZero {
        /// Its place among the curves
        curve: usize,
    },
    /// f of one curve, the measured force at which the model's is zero, nN
    ForceZero {
        /// Its place among the curves
        curve: usize,
    },
}

/// A parameter that is fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FitParameter {
    /// What it is called: the key of a scene
    pub key: String,
    /// Where the search begins, in the unit of the library
    pub initial: f64,
    /// What it may be at all. One above zero is searched for by its logarithm.
    pub range: Range,
    /// Lower bound; none: a hundredth of the initial value where that is above zero, or else what the range allows
    pub from: Option<f64>,
    /// Upper bound; none: a hundred times the initial value, likewise
    pub to: Option<f64>,
    /// What it changes
    pub of: ParameterOf,
}

/// The model with these values of the parameters.
pub type ModelOf<'m> = Box<dyn Fn(&[f64]) -> PeelModel + Send + Sync + 'm>;

/// The curve of something else than a peel with these values of the parameters, computed as long as the criteria let it; or why there is none.
pub(crate) type CurveOf<'m> = Box<dyn Fn(&[f64], &StopCriteria) -> Result<PulledCurve, String> + Send + Sync + 'm>;

/// How the curve is computed.
pub enum CurveBy<'m> {
    /// By the peel of the model, with derivatives
    Peel,
    /// By something that has no derivatives, such as the pull-off of a seta
    Values(CurveOf<'m>),
}

/// A measured curve, and the model that it is of.
pub struct FitCurve<'m> {
    /// What was measured
    pub measured: MeasuredCurve,
    /// The model with these values of the parameters; those of the zeros of the record are not for it. It is checked where it is computed.
    pub model: ModelOf<'m>,
    /// How its curve is computed
    pub by: CurveBy<'m>,
    /// d where it is not fitted, nm
    pub displacement_zero: f64,
    /// f where it is not fitted, nN
    pub force_zero: f64,
}

impl<'m> FitCurve<'m> {
    /// Of a peel, of a record that begins at zero.
    pub fn of_peel(measured: MeasuredCurve, model: ModelOf<'m>) -> Self {
        Self { measured, model, by: CurveBy::Peel, displacement_zero: 0.0, force_zero: 0.0 }
    }
}

/// Parameters, and the curves that have them in common.
pub struct FitProblem<'m> {
    /// In this order
    pub parameters: Vec<FitParameter>,
    /// One at least
    pub curves: Vec<FitCurve<'m>>,
}

/// Of which parameters the profile likelihood is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ProfileChoice {
    /// Of those that are poorly determined, where no parameter has ended at a bound of the search
    #[default]
    Poor,
    /// Of all
    All,
    /// Of none
    None,
}

/// Standard error of the measured displacements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum DisplacementError {
    /// Estimated from the residuals: they are larger where the curve is steep. With another loss than squares it is taken as none.
    #[default]
    Estimated,
    /// Displacements are exact
    None,
    /// nm
    Known(f64),
}

/// How the curves are fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// Standard error of a measured force where its point has none of its own, nN; none: estimated from the residuals
    pub force_error: Option<f64>,
    /// Standard error of a measured displacement
    pub displacement_error: DisplacementError,
    /// Whether the displacements of the measured jumps are data
    pub use_jump: bool,
    /// Of points far from the curve
    pub loss: Loss,
    /// Of which parameters the profile likelihood is computed
    pub profile: ProfileChoice,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            force_error: None,
            displacement_error: DisplacementError::Estimated,
            use_jump: true,
            loss: Loss::Squares,
            profile: ProfileChoice::Poor,
        }
    }
}

// -- How much a point counts that is far from the curve --

/// The loss ρ(t) of a residual t in units of its standard error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loss {
    /// ρ = t²: least squares
    #[default]
    Squares,
    /// Huber: t² up to |t| = 1.345, from there on it rises linearly
    Huber,
    /// Soft L1: 2 (√(1 + t²) - 1)
    SoftL1,
}

/// Huber's constant for an efficiency of 95 % with normal errors (Huber, Robust Statistics, 1981, section 4.5).
const HUBER: f64 = 1.345;

impl Loss {
    /// Weight w = ρ'(t)/(2t) with which t² stands in the squares of an iteration.
    pub(crate) fn weight(self, t: f64) -> f64 {
        match self {
            Self::Squares => 1.0,
            Self::Huber => (HUBER / t.abs()).min(1.0),
            Self::SoftL1 => (1.0 + t * t).sqrt().recip(),
        }
    }

    /// ψ'(t), ψ = ρ'/2.
    fn slope(self, t: f64) -> f64 {
        match self {
            Self::Squares => 1.0,
            Self::Huber => f64::from(u8::from(t.abs() <= HUBER)),
            Self::SoftL1 => (1.0 + t * t).powf(-1.5),
        }
    }

    /// What multiplies (JᵀJ)⁻¹, of the residuals of all points with weight 1, to give the covariance of so many parameters: Huber's
    /// K² [Σψ²/(n - p)] / [Σψ'/n]² with K = 1 + (p/n) var ψ'/(mean ψ')² (Huber 1981, equation 7.6.10, his (X)); 1 for least squares, whose
    /// standard errors stand in J.
    pub(super) fn covariance_factor(self, residuals: &[f64], parameters: usize) -> f64 {
        if self == Self::Squares {
            return 1.0;
        }
        let (count, free) = (residuals.len() as f64, residuals.len().saturating_sub(parameters).max(1) as f64);
        let mean = residuals.iter().map(|&t| self.slope(t)).sum::<f64>() / count;
        let variance = residuals.iter().map(|&t| (self.slope(t) - mean).powi(2)).sum::<f64>() / count;
        let squares: f64 = residuals.iter().map(|&t| (self.weight(t) * t).powi(2)).sum();
        let correction = 1.0 + parameters as f64 / count * variance / (mean * mean);
        correction * correction * (squares / free) / (mean * mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ρ of each loss by its definition, differentiated.
    #[test]
    fn weights_are_half_the_slopes_of_the_losses_over_t() {
        let huber = |t: f64| if t.abs() <= HUBER { t * t } else { 2.0 * HUBER * t.abs() - HUBER * HUBER };
        let soft = |t: f64| 2.0 * ((1.0 + t * t).sqrt() - 1.0);
        let losses: [(Loss, &dyn Fn(f64) -> f64); 3] =
            [(Loss::Squares, &|t| t * t), (Loss::Huber, &huber), (Loss::SoftL1, &soft)];
        for (loss, rho) in losses {
            for t in [-7.0, -1.2, 0.3, 1.4, 20.0] {
                let slope = (rho(t + 1e-5) - rho(t - 1e-5)) / 2e-5;
                assert!((loss.weight(t) - slope / (2.0 * t)).abs() < 1e-8, "{loss:?} at {t}");
                let psi = |t: f64| loss.weight(t) * t;
                let slope = (psi(t + 1e-5) - psi(t - 1e-5)) / 2e-5;
                assert!((loss.slope(t) - slope).abs() < 1e-8, "{loss:?} at {t}");
            }
        }
    }

    /// Without outliers the robust covariance is larger than that of least squares by little: by 1/0.95 for Huber's constant.
    #[test]
    fn a_robust_covariance_is_that_of_least_squares_without_outliers() {
        let normal = |k: usize| {
            let share = (k as f64 + 0.5) / 4000.0;
            statrs::distribution::ContinuousCDF::inverse_cdf(&statrs::distribution::Normal::standard(), share)
        };
        let residuals: Vec<f64> = (0..4000).map(normal).collect();
        assert_eq!(Loss::Squares.covariance_factor(&residuals, 2), 1.0);
        let huber = Loss::Huber.covariance_factor(&residuals, 2);
        assert!((huber - 1.0 / 0.95).abs() < 2e-3, "{huber}");
    }
}
