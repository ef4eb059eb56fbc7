//! What peels from ground that is not flat.

pub(in crate::figures) mod spatula;
pub(in crate::figures) mod strip;
