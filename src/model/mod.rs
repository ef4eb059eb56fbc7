//! A structure in a grip, on a substrate or on its own: what `solve` is given.
mod chain;
mod peel;
mod rod;
mod spatula;
mod strip;
pub use peel::*;
pub use rod::*;
pub use spatula::*;
pub use strip::*;
