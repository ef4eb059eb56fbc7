//! The other subcommands, one file or folder each.

pub(crate) mod cite;
pub(crate) mod figures;
mod hard_scenes;
pub(crate) mod keys;
pub(crate) mod new;
pub(crate) mod plot;
pub(crate) mod schema;
pub(crate) mod serve;
pub(crate) mod shell;
pub(crate) mod verify;
