//! What a user gets of a pull at a rate: the curve, the summary, the picture; of a sweep of them the table and its picture.

pub(crate) mod curve;
pub(crate) mod picture;
pub(crate) mod summary;
pub(crate) mod sweep;

use crate::writing::record::Record;
use crate::writing::reference::Output;

use sweep::RateRow;

/// What is written of pulls at a rate.
pub(crate) fn outputs() -> Vec<Output> {
    vec![summary::output(), curve::output(), Output::table("sweep.csv of rates", RateRow::keys())]
}
