//! What a user gets of the peel of a solid: the curve, the limit points, the summary, the pictures, and states for ParaView.

pub(crate) mod fields;
pub(crate) mod picture;
mod shapes;
pub(crate) mod summary;
pub(crate) mod sweep;
pub(crate) mod tables;

use crate::writing::record::Record;
use crate::writing::reference::Output;
use sweep::SolidRow;

/// What is written of the peel of a solid.
pub(crate) fn outputs() -> Vec<Output> {
    [vec![summary::output()], tables::outputs(), vec![Output::table("sweep.csv of solids", SolidRow::keys())]].concat()
}
