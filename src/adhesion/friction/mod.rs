//! What resists sliding, with memory.

pub(crate) mod dahl;
