//! Computing time against error, measured and plotted.

pub(crate) mod measure;
pub(crate) mod report;
