//! What was found of many pulls, laid out for a person.

pub(crate) mod fit;
pub(crate) mod optimisation;
pub(crate) mod sensitivities;
pub(crate) mod sweep;
pub(crate) mod swept_pulls;
pub(crate) mod tip;
pub(crate) mod uncertainty;
