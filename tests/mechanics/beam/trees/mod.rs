//! Trees of beams in space.

mod adhering;
mod as_chain;
mod column;
mod refusals;
pub mod setup;
mod tangents;
mod two_levels;
