//! Pictures of sweeps that are no curve of results over one key: over two keys, and of one followed point.

pub(crate) mod followed;
pub(crate) mod plane;
