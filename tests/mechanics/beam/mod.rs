//! Elements and their forms.

mod convergence;
mod first_integral;
mod forms;
mod rods;
pub mod spatial;
mod tangents;
pub mod trees;
