//! The beam at chosen points of its path: states.csv, and time series that ParaView opens.

mod fields;
mod grid;
mod spatial_fields;
mod surface;
mod table;
mod vtk;

use crate::reference::Output;

pub use fields::{STATE_FIELDS, StateField};
pub(crate) use grid::{Grid, PointData, collection};
pub use spatial_fields::SPATIAL_STATE_FIELDS;
pub(crate) use surface::outline;
pub use table::write_states;
pub use vtk::write_vtk;

/// What is written of the states of a beam.
pub(crate) fn outputs() -> Vec<Output> {
    table::outputs()
}
