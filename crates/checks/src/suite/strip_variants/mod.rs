//! Strips that differ from the paper's in one thing: the law of adhesion, friction, or the direction of the pull.

pub(super) mod friction;
pub(super) mod laws;
pub(super) mod pull;
mod turns;
