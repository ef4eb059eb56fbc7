//! A structure on a substrate in a grip: what `solve` is given.
mod strip;
pub use strip::*;
