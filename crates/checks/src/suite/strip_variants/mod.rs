//! Strips that differ from the paper's in one thing: the law of adhesion, friction, the direction of the pull, or that they may leave their
//! plane.

pub(super) mod laws;
pub(super) mod out_of_plane;
pub(super) mod pull;
pub(super) mod turns;
