//! Figures of how well and how fast it is computed.

pub(super) mod beam;
pub(super) mod levels;
pub(super) mod round_off;
pub(super) mod speed;
pub(super) mod verification;
