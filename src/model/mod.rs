//! A structure in a grip, on a substrate or on its own: what `solve` is given.
mod chain;
mod friction;
mod ground;
mod lie;
mod peel;
mod profile;
mod rod;
mod spatula;
mod strip;
pub use friction::*;
pub use ground::*;
pub use peel::*;
pub use profile::*;
pub use rod::*;
pub use spatula::*;
pub use strip::*;
