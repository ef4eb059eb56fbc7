//! What a fit found.

use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;
use crate::study::parameters::sensitivity::quantity::NoSensitivities;

/// How a fit ended.
#[derive(Clone, Debug, PartialEq)]
pub enum FitEnd {
    /// At a least sum of squares
    Converged,
    /// Before it: the best parameters so far, and why
    Stopped(String),
    /// The caller has interrupted it: the best parameters so far
    Interrupted,
}

/// A parameter that was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedParameter {
    /// What it is called
    pub key: String,
    /// Where the search began, in the unit of the library
    pub initial: f64,
    /// Where it ended
    pub value: f64,
    /// Whether it was searched for by its logarithm
    pub logarithmic: bool,
    /// Standard error, in the unit of the value; of a logarithm times the value. None at a bound
    pub standard_error: Option<f64>,
    /// 95 % confidence interval from the standard error; of one that is searched for by its logarithm, symmetric in that. It ends at the bounds
    /// of the search. None at a bound
    pub interval: Option<[f64; 2]>,
    /// Bounds of the search
    pub bounds: [f64; 2],
    /// The bound at which the search ended, if it is one
    pub at_bound: Option<f64>,
    /// Whether its interval is wider than 10 % of its value to either side
    pub poorly_determined: bool,
    /// Where it was computed
    pub profile: Option<Profile>,
}

/// The least sum of squares with one parameter held.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// (value, by how much the least sum of squares there exceeds the least of all), ascending
    pub points: Vec<(f64, f64)>,
    /// Where the excess reaches that of 95 %; none where it does not up to the bound of the search
    pub interval: [Option<f64>; 2],
    /// That excess
    pub level: f64,
}

/// Where the model has a measured point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointPlace {
    /// Before its path begins: on the curve reflected there
    BeforeStart,
    /// On its first stable branch
    OnBranch,
    /// Behind its first jump: compared with the force there
    BehindJump,
}

/// A measured point and what the model says of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedPoint {
    /// As measured, nm
    pub displacement: f64,
    /// As measured, nN
    pub force: f64,
    /// Of the model, nN
    pub modelled: f64,
    /// dP/dU of the model there, nN/nm
    pub slope: f64,
    /// Standard error of the measured force, with what that of its displacement adds, nN
    pub error: f64,
    /// How much it counts, from 0 to 1: 1 for least squares
    pub weight: f64,
    /// Where the model has it
    pub place: PointPlace,
}

impl FittedPoint {
    /// Modelled less measured force, over its standard error.
    pub fn residual(&self) -> f64 {
        (self.modelled - self.force) / self.error
    }
}

/// The first jump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedJump {
    /// As measured, nm
    pub displacement: f64,
    /// Its standard error, nm
    pub error: f64,
    /// Of the model, as the machine would record it, nm; none where its branch goes on as far as it was followed
    pub modelled: Option<f64>,
    /// Whether it counts as a datum
    pub used: bool,
}

/// Π pₖ^eₖ of the parameters that are searched for by their logarithms: errors of different combinations are independent.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// eₖ of all parameters, their squares adding up to 1; 0 for those that take no part
    pub exponents: Vec<f64>,
    /// Standard error of its logarithm
    pub relative_error: f64,
}

/// Two parameters that the curve hardly tells apart.
#[derive(Clone, Debug, PartialEq)]
pub struct PairDetermined {
    /// Their places among the parameters
    pub parameters: [usize; 2],
    /// Of their coordinates
    pub correlation: f64,
    /// e with which p₁ p₂^e is determined best; none where one of the two is not searched for by its logarithm
    pub exponent: Option<f64>,
    /// Standard error of its logarithm, the other parameters being free
    pub relative_error: Option<f64>,
}

/// A measured curve and what the model says of it.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedCurve {
    /// In the order of their displacements
    pub points: Vec<FittedPoint>,
    /// None where none was measured
    pub jump: Option<FittedJump>,
    /// d, nm
    pub displacement_zero: f64,
    /// f, nN
    pub force_zero: f64,
    /// (U + d, P + f) of the model up to its first jump
    pub curve: Vec<(f64, f64)>,
    /// The same of the model at the beginning
    pub initial_curve: Vec<(f64, f64)>,
    /// The model that was found
    pub model: PeelModel,
}

impl FittedCurve {
    /// How many points the model has at a place.
    pub fn count(&self, place: PointPlace) -> usize {
        self.points.iter().filter(|point| point.place == place).count()
    }
}

/// What a fit found.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// In the order of the problem
    pub parameters: Vec<FittedParameter>,
    /// Of their coordinates; none of one at a bound
    pub correlations: Vec<Vec<Option<f64>>>,
    /// The one with the largest error first
    pub combinations: Vec<Combination>,
    /// Pairs of which one at least is poorly determined, because the other makes up for it
    pub pairs: Vec<PairDetermined>,
    /// Largest over least singular value of the derivatives by the coordinates
    pub condition: Option<f64>,
    /// In the order of the problem
    pub curves: Vec<FittedCurve>,
    /// Sum of squares of the residuals over their standard errors, weighted
    pub sum_of_squares: f64,
    /// Data less parameters
    pub degrees_of_freedom: usize,
    /// The standard error of a force that was estimated from the residuals, nN; none where it is known
    pub estimated_error: Option<f64>,
    /// The standard error of a displacement that was estimated likewise, nm; none where it is known or none
    pub estimated_displacement_error: Option<f64>,
    /// Standard error of a force from how neighbouring points differ, nN
    pub scatter: f64,
    /// Whether the measured displacements were taken as exact
    pub exact_displacements: bool,
    /// How many paths were computed
    pub paths: usize,
    /// How often residuals were weighted anew
    pub weightings: usize,
    /// How it ended
    pub end: FitEnd,
}

impl Fit {
    /// Whether the search has found no parameters: it stopped before the least sum of squares, or at a bound of every one.
    pub(super) fn is_lost(&self) -> bool {
        matches!(self.end, FitEnd::Stopped(_)) || self.parameters.iter().all(|parameter| parameter.at_bound.is_some())
    }

    /// Whether the search has come to its end.
    pub fn converged(&self) -> bool {
        self.end == FitEnd::Converged
    }

    /// Points of all curves.
    pub fn points(&self) -> impl Iterator<Item = &FittedPoint> {
        self.curves.iter().flat_map(|curve| &curve.points)
    }
}

// -- Why there is no fit --

/// Why a measured curve cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum FitDataError {
    #[error("has {points} points{}, and a curve has at least {least}", match .before_jump { Some(at) => format!(" up to its jump at {at} nm"), None => String::new() })]
    TooFew { points: usize, least: usize, before_jump: Option<f64> },
    #[error("goes from {from} nm to {turn} nm and back to {to} nm: it holds the way there and the way back")]
    ThereAndBack { from: f64, turn: f64, to: f64 },
    #[error("has displacements from {from} nm to {to} nm, and the jump is said to be at {jump} nm")]
    JumpOutside { from: f64, to: f64, jump: f64 },
    #[error("has the same force, {force} nN, in all its rows")]
    NoForce { force: f64 },
}

impl FitDataError {
    /// What would be right.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "Measure more points on the branch before the first jump, or fit fewer parameters.",
            Self::ThereAndBack { .. } => "Give the rows of the retreat alone, from contact to detachment.",
            Self::JumpOutside { .. } => {
                "Give as `fit.jump` the measured displacement at which the force falls, or omit it."
            }
            Self::NoForce { .. } => "Give the column of the measured force.",
        }
    }
}

/// Why nothing is fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoFit {
    #[error("there is no parameter to fit")]
    NoParameters,
    #[error("{data} data do not determine {parameters} parameters: there have to be more data than parameters")]
    TooFewData { data: usize, parameters: usize },
    #[error("{key} = {value:e} is not between its bounds, {from:e} and {to:e}")]
    OutsideBounds { key: String, value: f64, from: f64, to: f64 },
    #[error(
        "{key} changes the force nowhere by more than {largest:.1e} nN per unit of its coordinate: it has no influence on the measured part of the curve"
    )]
    NoInfluence { key: String, largest: f64 },
    #[error("the model cannot be computed: {0}")]
    Model(#[from] ModelError),
    #[error("the curve of the scene as it is written was not computed: {0}")]
    NoStart(String),
    #[error(
        "no parameters were found within their bounds, because the measured curve is of another size: its forces reach {:.3e} nN and its displacements {:.3e} nm, those of the scene {:.3e} nN and {:.3e} nm",
        forces.measured, displacements.measured, forces.modelled, displacements.modelled
    )]
    OtherScale { forces: Scale, displacements: Scale },
    #[error("the curve cannot be differentiated: {0}")]
    NoDerivatives(#[from] NoSensitivities),
}

/// The largest number of a measured curve and that of the model, in nN or nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// As measured
    pub measured: f64,
    /// Of the model
    pub modelled: f64,
}

impl Scale {
    /// By how many powers of 1000 the measured one is larger, to the nearest.
    pub(crate) fn thousands(&self) -> i32 {
        let powers = (self.measured / self.modelled).log10() / 3.0;
        if powers.is_finite() { powers.round() as i32 } else { 0 }
    }

    /// Which unit was most likely given in place of which; nothing where both are alike, or no usual units differ so much.
    fn likely_unit(&self, what: &str, unit: char) -> Option<String> {
        const PREFIXES: [&str; 4] = ["n", "u", "m", ""];
        let powers = self.thousands();
        let other = PREFIXES.get(powers.unsigned_abs() as usize).filter(|_| powers != 0)?;
        let (given, meant) = if powers > 0 { (*other, PREFIXES[0]) } else { (PREFIXES[0], *other) };
        Some(format!(
            "Correct the unit of the {what} in the first line of the data: most likely {given}{unit} is written there and {meant}{unit} is meant. "
        ))
    }
}

impl NoFit {
    /// What would be right.
    pub fn remedy(&self) -> String {
        let remedy = match self {
            Self::NoParameters => "Add to the scene for example\n[fit]\nparameters = [\"adhesion.hamaker_constant\"]",
            Self::TooFewData { .. } => "Measure more points, or fit fewer parameters.",
            Self::OutsideBounds { .. } => "Give bounds around the value of the scene.",
            Self::NoInfluence { .. } => "Remove it from `fit.parameters`.",
            Self::Model(error) => return error.remedy(),
            Self::OtherScale { forces, displacements } => {
                let units = [forces.likely_unit("forces", 'N'), displacements.likely_unit("displacements", 'm')];
                let units: String = units.into_iter().flatten().collect();
                return format!(
                    "{units}Otherwise set the parameters of the scene nearer to the measured curve, or give wider bounds."
                );
            }
            Self::NoStart(_) => {
                "Try `peel run` with the scene. Set its parameters near to the measured curve, or raise its [bounds]."
            }
            Self::NoDerivatives(_) => "Omit what the message names, or do not fit this parameter.",
        };
        remedy.to_owned()
    }
}
