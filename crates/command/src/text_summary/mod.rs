//! What a run found, laid out for a person.

pub(crate) mod array;
pub(crate) mod fit;
mod found;
mod layout;
pub(crate) mod number;
pub(crate) mod observed;
pub(crate) mod optimisation;
pub(crate) mod peel;
pub(crate) mod rate;
pub(crate) mod sensitivities;
pub(crate) mod seta;
pub(crate) mod seta_law;
pub(crate) mod solid;
mod stability;
pub(crate) mod sweep;
pub(crate) mod swept_rates;
pub(crate) mod swept_setae;
pub(crate) mod tip;
pub(crate) mod uncertainty;
pub(crate) mod units;
