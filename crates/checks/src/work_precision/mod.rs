//! Computing time against error, measured and plotted.

mod measure;
mod report;

pub use measure::{Errors, Line, Trial, WorkPrecision, work_precision};
pub use report::{AUTOMATIC, write_work_precision};
