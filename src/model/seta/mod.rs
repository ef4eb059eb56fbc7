//! A seta as a tree of beams: a shaft that forks again and again, with a spatula at each tip that adheres by a law of its own.
mod check;
mod geometry;
mod mesh;
mod normal_pull;
mod parameters;
mod tip;
mod tip_law;
pub use check::{MOST_FORKS, SetaError};
pub use mesh::SetaMesh;
pub use normal_pull::{CurvePoint, NormalPull, PullCurve, PullCurveError, Sideways};
pub use parameters::{Seta, SetaModel};
pub use tip::AdheringTip;
pub use tip_law::{TipBranch, TipLaw};
