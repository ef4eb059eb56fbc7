//! What a user gets of the pull of an array of setae: the curve, the events, the rows at the peak, the summary, the pictures, and sweeps.

pub(crate) mod picture;
pub(crate) mod summary;
pub(crate) mod sweep;
pub(crate) mod tables;

use crate::writing::record::Record;
use crate::writing::reference::Output;
use sweep::SweptArray;

/// What is written of the pull of an array.
pub(crate) fn outputs() -> Vec<Output> {
    [vec![summary::output()], tables::outputs(), vec![Output::table("sweep.csv of arrays", SweptArray::keys())]]
        .concat()
}
