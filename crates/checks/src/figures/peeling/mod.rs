//! Figures of what peels.

pub(super) mod directions;
pub(super) mod friction;
pub(super) mod laws;
pub(super) mod out_of_plane;
pub(super) mod points;
pub(super) mod pull;
pub(super) mod rough;
pub(super) mod spatula;
pub(super) mod spatula_directions;
pub(super) mod stiffness;
pub(super) mod strip;
pub(super) mod work;
