//! What is to be fitted, and how.

use super::loss::Loss;
use super::pulled_curve::PulledCurve;
use crate::model::check::error::Range;
use crate::model::peel::PeelModel;
use crate::study::stop_criteria::StopCriteria;

/// What a parameter changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterOf {
    /// The model, the stiffness of its machine ([`crate::model::Grip::stiffness`]) included
    Model,
    /// d, the measured displacement at which the model's is zero, nm
    DisplacementZero,
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
pub type CurveOf<'m> = Box<dyn Fn(&[f64], &StopCriteria) -> Result<PulledCurve, String> + Send + Sync + 'm>;

/// How the curve is computed.
pub enum CurveBy<'m> {
    /// By the peel of the model, with derivatives
    Peel,
    /// By something that has no derivatives, such as the pull-off of a seta
    Values(CurveOf<'m>),
}

/// Parameters, and the model that has their values.
pub struct FitProblem<'m> {
    /// In this order
    pub parameters: Vec<FitParameter>,
    /// The model with these values of the parameters; those of [`ParameterOf::DisplacementZero`] are not for it. It is checked where it is
    /// computed.
    pub model: ModelOf<'m>,
    /// How its curve is computed
    pub curve: CurveBy<'m>,
}

/// Of which parameters the profile likelihood is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ProfileChoice {
    /// Of those that are poorly determined
    #[default]
    Poor,
    /// Of all
    All,
    /// Of none
    None,
}

/// How the curve is fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// Standard error of a measured force where its point has none of its own, nN; none: estimated from the residuals
    pub force_error: Option<f64>,
    /// Standard error of a measured displacement, nm; none: displacements are exact
    pub displacement_error: Option<f64>,
    /// d where it is not fitted, nm
    pub displacement_zero: f64,
    /// Whether the displacement of the measured jump is a datum
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
            displacement_error: None,
            displacement_zero: 0.0,
            use_jump: true,
            loss: Loss::Squares,
            profile: ProfileChoice::Poor,
        }
    }
}
