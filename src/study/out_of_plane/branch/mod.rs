//! The branch out of the plane: from where a planar path loses its stability on, followed in space to its end.
mod embedding;
pub(crate) mod result;
mod rolled;
mod run;
mod switching;
