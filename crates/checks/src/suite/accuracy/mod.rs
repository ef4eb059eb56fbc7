//! How wrong the numbers are: orders of convergence, and bounds against true errors.

pub(crate) mod bounds;
pub(crate) mod orders;
