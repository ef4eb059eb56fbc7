//! What an unfinished command has found, kept in a file as it comes and taken up by the next one.

pub(crate) mod collection;
pub(crate) mod damaged;
mod growing_file;
mod lines;
pub(crate) mod optimisation;
pub(crate) mod part;
pub(crate) mod partial_file;
pub(crate) mod run;
pub(crate) mod seta;
pub(crate) mod sweep;
pub(crate) mod uncertainty;
