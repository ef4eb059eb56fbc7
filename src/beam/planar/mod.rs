//! The planar beam: energy densities with and without adhesion, elements, chains of them, and the system that they make.
pub(crate) mod chain;
pub(crate) mod density;
pub(crate) mod model_end;
pub(crate) mod model_limits;
pub(crate) mod planar_beam;
pub(crate) mod planar_motion;
mod planar_system;
pub(crate) mod uniform_chain;
