//! The peel of a strip or a spatula as a solid.

pub(super) mod finer;
pub(super) mod peel;
