//! Strips that differ from the paper's in one thing: the law of adhesion, friction, the direction of the pull, or that they may leave their
//! plane.

mod crack;
pub(super) mod friction;
pub(super) mod laws;
pub(super) mod out_of_plane;
pub(super) mod pull;
mod turns;
