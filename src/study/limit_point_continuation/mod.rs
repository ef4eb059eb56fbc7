//! A limit point followed in a parameter of the model, and where two of them meet.
mod confirmation;
mod continuation;
pub(super) mod cusp;
pub(super) mod result;
mod strand;
pub(super) mod sweep;
mod values;
