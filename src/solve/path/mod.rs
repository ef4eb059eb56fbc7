//! Paths of equilibria: stepped, predicted, interpolated.
pub(crate) mod equilibrium_path;
pub(crate) mod hermite;
mod metric;
pub(crate) mod near_branch;
pub(crate) mod options;
pub(crate) mod predictor;
pub(crate) mod segment;
