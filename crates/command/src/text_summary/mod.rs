//! What a run found, laid out for a person.

pub(crate) mod array;
mod derived;
mod found;
pub(crate) mod number;
pub(crate) mod observed;
pub(crate) mod of_many;
pub(crate) mod peel;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod solid;
mod stability;
pub(crate) mod units;
