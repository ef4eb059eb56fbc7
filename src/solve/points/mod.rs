//! Points of a path at which something happens: which steps hold them, where they are, how wrong that may be.
pub(crate) mod bracket;
pub(crate) mod branching;
pub(crate) mod locate;
pub(crate) mod passing;
pub(crate) mod search;
pub(crate) mod tracer;
