//! The element of every beam: its shape functions and Gauss points, the energy density that it integrates.
pub(crate) mod basis;
pub(crate) mod energy_density;
pub(crate) mod integrand;
pub(crate) mod integration;
pub(crate) mod piecewise;
