//! What is written of each result: its tables and its summary.json.

mod located;
pub(crate) mod model;
pub(crate) mod observed;
pub(crate) mod of_many;
mod out_of_plane;
pub(crate) mod passed;
pub(crate) mod path;
pub(crate) mod peel;
pub(crate) mod pulled;
pub(crate) mod steps;
pub(crate) mod summary;

use crate::writing::reference::Output;

/// What is written of peels, of their sweeps, and of what is made of many peels.
pub(crate) fn outputs() -> Vec<Output> {
    [peel::outputs(), path::outputs(), steps::outputs(), passed::outputs(), observed::outputs(), of_many::outputs()]
        .concat()
}
