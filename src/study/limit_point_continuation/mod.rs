//! A limit point followed in a parameter of the model, and where two of them meet.
mod confirmation;
mod continuation;
pub(super) mod cusp;
mod elements;
pub(super) mod failure;
mod initial_limit_point;
pub(super) mod result;
mod rows;
mod strand;
pub(super) mod sweep;
mod values;
