//! How a result becomes a file: records and their reference, numbers and words, files and folders, and what goes wrong with them.

pub(crate) mod error;
pub(crate) mod file;
pub(crate) mod in_units;
pub(crate) mod names;
pub(crate) mod number;
pub(crate) mod record;
pub(crate) mod reference;
