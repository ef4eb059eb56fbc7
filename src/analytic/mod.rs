//! Closed forms to hold the computed against.
mod column;
pub(crate) mod peeling;
pub use column::{buckling_load, propped_buckling_load};
pub use peeling::{kendall_force, sliding_force, steady_force};
