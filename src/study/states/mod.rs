//! The beam at chosen points of its path: fields along S, for tables and pictures.

mod along_beam;
mod along_path;

pub use along_beam::{BeamState, SectionFields};
