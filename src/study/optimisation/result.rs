//! What an optimisation finds.

use super::certificate::Certificate;
use super::problem::DesignFound;
use super::search::SearchResult;

/// One design with its peels, to the accuracy that was asked for.
#[derive(Debug)]
pub struct Design {
    /// Of the variables, in the unit of the library
    pub values: Vec<f64>,
    /// From 0 to 1 between the bounds
    pub coordinates: Vec<f64>,
    /// Q, in its unit
    pub objective: f64,
    /// Bound on the error of Q; none where the number of the peel has none
    pub error: Option<f64>,
    /// What the objective is made of
    pub of: DesignFound,
}

/// The best design that was found.
#[derive(Debug)]
pub struct Optimum {
    /// The design at the start
    pub before: Design,
    /// The best one
    pub after: Design,
    /// Bounds on the errors of its values, in their units: how far it is to where the gradient vanishes. Of variables at a bound zero; none
    /// where the curvature is not known, as of many variables and under constraints
    pub value_errors: Option<Vec<f64>>,
    /// Q after over Q before
    pub gain: f64,
    /// Bound on the error of that
    pub gain_error: Option<f64>,
    /// The searches, in the order of their starts
    pub searches: Vec<SearchResult>,
    /// Which search found the best
    pub best_search: usize,
    /// Why it is an optimum; none after an interruption
    pub certificate: Option<Certificate>,
    /// Whether it was interrupted
    pub unfinished: bool,
}
