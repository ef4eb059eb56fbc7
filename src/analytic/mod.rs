//! Closed forms to put beside what is computed.
mod peeling;
pub use peeling::{kendall_force, steady_force};
