//! The branch out of the plane: from where a planar path loses its stability on, followed in space to its end.
pub(crate) mod result;
mod run;
mod switching;
