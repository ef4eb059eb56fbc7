//! A model made into what the solver is given: a beam, the end conditions of its grip, what measures its path, and where that starts.
pub(crate) mod beam_problem;
pub(crate) mod branch;
pub(crate) mod build;
pub(crate) mod motion;
pub(super) mod rod;
pub(crate) mod space;
mod stress_free_placement;
