//! A chain of elements of a beam in space: its fronts, and what is read off it. It is eliminated from its left end to its right one.

pub(super) mod assembly;
pub(in crate::beam::spatial) mod fields_along;
pub(crate) mod projection;
pub(crate) mod read;
pub(crate) mod room;
pub(crate) mod spatial_chain;
pub(super) mod sweep;
