//! What resists sliding, with memory.

mod dahl;
pub use dahl::{FrictionLaw, FrictionState, Traction};
