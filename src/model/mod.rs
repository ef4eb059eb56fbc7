//! A structure in a grip, on a substrate or on its own: what `solve` is given.
mod chain;
mod rod;
mod strip;
pub use rod::*;
pub use strip::*;
