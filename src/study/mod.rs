//! Many runs: the whole peel of one scene, sweeps over a parameter.
mod peel;
mod sweep;
pub use peel::*;
pub use sweep::*;
