//! Limit points of a path: which steps hold them, where they are, how wrong that may be.
pub(crate) mod bracket;
pub(crate) mod kind;
pub(crate) mod locate;
pub(crate) mod search;
