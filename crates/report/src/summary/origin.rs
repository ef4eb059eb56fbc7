//! Where an output comes from: which program wrote it, by which command, and which keys it has.

/// The version of the program that writes these outputs.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The number of the set of keys and columns that outputs have. Keys and columns may be added to a set; where one is renamed, removed or
/// means something else, the number grows by one.
pub const SCHEMA: u32 = 1;
