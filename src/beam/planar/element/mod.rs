//! An element: its shape functions and Gauss points, the integrand there, and the frontal matrix into which it is assembled.
pub(crate) mod basis;
pub(crate) mod frontal_matrix;
pub(crate) mod integrand;
pub(crate) mod piecewise;
pub(crate) mod planar_element;
