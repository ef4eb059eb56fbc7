//! A structure in a grip, on a substrate or on its own: what `solve` is given.
mod chain;
mod ground;
mod lie;
mod peel;
mod profile;
mod rod;
mod spatula;
mod step;
mod steps;
mod strip;
pub use ground::*;
pub use peel::*;
pub use profile::*;
pub use rod::*;
pub use spatula::*;
pub use step::*;
pub use strip::*;
