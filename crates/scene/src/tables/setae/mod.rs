//! Tables of setae: one, how it branches, and arrays of them.

pub(crate) mod array;
pub(crate) mod branching;
pub(crate) mod seta;
