//! The beam at chosen points of its path: states.csv, and time series that ParaView opens.

pub(crate) mod fields;
pub(crate) mod grid;
pub(crate) mod surface;
pub(crate) mod table;
pub(crate) mod vtk;

use crate::writing::reference::Output;

/// What is written of the states of a beam.
pub(crate) fn outputs() -> Vec<Output> {
    table::outputs()
}
