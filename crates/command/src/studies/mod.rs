//! The subcommands that compute a scene, one file or folder each, and what drives them all.

pub(crate) mod accuracy;
pub(crate) mod coarsen;
pub(crate) mod collect;
mod drive;
pub(crate) mod fit;
pub(crate) mod optimise;
pub(crate) mod ready;
pub(crate) mod run;
pub(crate) mod sweep;
pub(crate) mod uncertainty;
