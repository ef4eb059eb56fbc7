//! What is written of many peels: of a sweep, a fit, an optimisation, uncertain parameters, and the law of a tip.

pub(crate) mod fit;
pub(crate) mod optimisation;
pub(crate) mod seta_law;
pub(crate) mod sweep;
pub(crate) mod tip;
pub(crate) mod tip_law;
pub(crate) mod uncertainty;

use crate::writing::reference::Output;

/// What is written of them.
pub(crate) fn outputs() -> Vec<Output> {
    [
        sweep::outputs(),
        fit::outputs(),
        optimisation::outputs(),
        uncertainty::outputs(),
        tip::outputs(),
        seta_law::outputs(),
    ]
    .concat()
}
