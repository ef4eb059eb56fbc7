//! What pulls that are no peel of a beam in equilibrium have in common: of a solid, of a seta, of an array, and at a rate.

pub(crate) mod numbers;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod solid;
