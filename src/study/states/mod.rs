//! The beam at chosen points of its path: fields along S, for tables and pictures.

pub(super) mod along_beam;
pub(super) mod beam_state;
pub(super) mod fields;
pub(super) mod locator;
pub(super) mod measured;
pub(super) mod station;
