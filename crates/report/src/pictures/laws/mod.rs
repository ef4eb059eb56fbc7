//! Pictures of laws: that of a tip, and that of a seta.

pub(crate) mod seta;
pub(crate) mod tip;
