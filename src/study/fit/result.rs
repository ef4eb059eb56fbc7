//! What a fit found.

use crate::model::peel::PeelModel;

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
    /// In the order of their displacements
    pub points: Vec<FittedPoint>,
    /// None where none was measured
    pub jump: Option<FittedJump>,
    /// Sum of squares of the residuals over their standard errors, weighted
    pub sum_of_squares: f64,
    /// Data less parameters
    pub degrees_of_freedom: usize,
    /// The standard error of a force that was estimated from the residuals, nN; none where it is known
    pub estimated_error: Option<f64>,
    /// Standard error of a force from how neighbouring points differ, nN
    pub scatter: f64,
    /// Whether the measured displacements were taken as exact
    pub exact_displacements: bool,
    /// d, nm
    pub displacement_zero: f64,
    /// (U + d, P) of the model up to its first jump
    pub curve: Vec<(f64, f64)>,
    /// The same of the model at the beginning
    pub initial_curve: Vec<(f64, f64)>,
    /// The model that was found
    pub model: PeelModel,
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

    /// How many points the model has at a place.
    pub fn count(&self, place: PointPlace) -> usize {
        self.points.iter().filter(|point| point.place == place).count()
    }
}
