//! Speed against error: what an accuracy costs, measured and drawn.

mod measure;
mod report;

pub use measure::{ASKED, Errors, Line, Trial, WorkPrecision, work_precision};
pub use report::{AUTOMATIC, write_work_precision};
