//! The element of every beam: its shape functions and Gauss points, the energy density that it integrates, and the frontal matrix into which it is
//! assembled.
pub(crate) mod basis;
pub(crate) mod energy_density;
pub(crate) mod frontal_matrix;
pub(crate) mod integrand;
pub(crate) mod integration;
pub(crate) mod piecewise;
