//! Why there are no sensitivities.

use crate::model::check::error::ModelError;
use crate::model::problem::build::NoSuchOrder;
use crate::solve::error::SolveError;
use crate::study::initial::error::NoEquilibrium;

/// Why results cannot be differentiated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoSensitivities {
    #[error(
        "with friction what a beam does depends on its past, and no derivative of it is computed; set friction to none"
    )]
    Friction,
    #[error("terms of the model were left out of the path ({terms}); ask for all of them with terms = \"all\"")]
    TermsLeftOut { terms: String },
    #[error("the solutions behind the path are not known: it was read and not computed, or it has no point")]
    NoSolutions,
    #[error(
        "{key} changed by {change:e} gives a model that cannot be computed: {cause}; it stands at an end of its range"
    )]
    AtTheEdge { key: String, change: f64, cause: ModelError },
    #[error(
        "{key} a little larger or smaller gives a model of another kind, with other unknowns; it has no derivative here"
    )]
    AnotherKind { key: String },
    #[error("{key} changed by {change:e} gives a model without a start: {cause}")]
    NoStart { key: String, change: f64, cause: NoEquilibrium },
    #[error("{key} makes the derivative of {of} no number: the model is not smooth in it here")]
    NotFinite { key: String, of: &'static str },
    #[error("at u = {displacement} nm there is no point of the first stable branch, which goes from 0 to {most} nm")]
    NotOnBranch { displacement: f64, most: f64 },
    #[error(transparent)]
    Order(#[from] NoSuchOrder),
    #[error("{of} could not be solved for again beside its limit point: {cause}")]
    NotSolved { of: &'static str, cause: SolveError },
}
