//! The beam at chosen points of its path: fields along S, for tables and pictures.

pub(super) mod along_beam;
mod along_path;
pub(super) mod beam_state;
pub(super) mod in_space;
