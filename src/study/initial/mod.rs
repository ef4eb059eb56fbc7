//! Where a path starts: how the beam comes to lie on its ground, and what the grip does before the pull.
pub(super) mod error;
mod grip_control;
mod loading_steps;
pub(crate) mod prepared;
mod settled;
pub(super) mod stability;
mod step_jump;
