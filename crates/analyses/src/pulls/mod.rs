//! The common part of all pulls that are not the peel of a beam in equilibrium: of a solid, of a seta, of an array, and at a rate.

pub(crate) mod numbers;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod solid;
