//! What a user gets of a pull at a rate: the curve, the summary, the picture; of a sweep of them the table and its picture.

mod curve;
mod picture;
mod pulled;
mod summary;
mod sweep_picture;
mod sweep_row;
mod sweep_table;

use crate::record::Record;
use crate::reference::Output;

pub use curve::{rate_columns, write_rate_curve};
pub use picture::draw_rate;
pub use pulled::{Contact, Equilibria, PointAtRate, PulledAtRate, SlowPeak};
pub use summary::{RateFound, RateSummary};
pub use sweep_picture::draw_swept_rates;
pub use sweep_row::{RateResult, RateRow};
pub use sweep_table::write_swept_rates;

/// What is written of pulls at a rate.
pub(crate) fn outputs() -> Vec<Output> {
    vec![summary::output(), curve::output(), Output::table("sweep.csv of rates", RateRow::keys())]
}
