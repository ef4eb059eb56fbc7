//! Pulls at a rate: a beam, and a seta, of viscous material.
pub(super) mod pull;
pub(super) mod seta;
mod tip_losses;
