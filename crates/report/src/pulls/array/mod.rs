//! What a user gets of the pull of an array of setae: the curve, the events, the rows at the peak, the summary, and the pictures.

pub(crate) mod picture;
pub(crate) mod summary;
pub(crate) mod tables;

use crate::writing::reference::Output;

/// What is written of the pull of an array.
pub(crate) fn outputs() -> Vec<Output> {
    [vec![summary::output()], tables::outputs()].concat()
}
