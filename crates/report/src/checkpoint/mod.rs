//! What an unfinished command has found, kept in a file as it comes and taken up by the next one.

mod frames;
mod header;
pub(crate) mod journal;
pub(crate) mod part;
