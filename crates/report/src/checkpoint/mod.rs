//! The folder of outputs, and what an unfinished command has found, kept there in a file as it comes and taken up by the next one.

pub(crate) mod folder;
mod frames;
mod header;
pub(crate) mod journal;
pub(crate) mod kind;
pub(crate) mod part;
