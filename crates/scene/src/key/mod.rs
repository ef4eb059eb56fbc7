//! Keys of a scene: what each takes, which scenes have it, where its value goes, and every message about it.

pub(crate) mod access;
pub(crate) mod belongs;
pub(crate) mod choice;
pub(crate) mod kind;
pub(crate) mod list;
mod listing;
mod message;
mod pieces;
pub(crate) mod table;
