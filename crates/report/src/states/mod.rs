//! The beam at chosen points of its path: states.csv, and a time series that ParaView opens.

mod fields;
mod table;
mod vtk;

pub use fields::{STATE_FIELDS, StateField};
pub use table::write_states;
pub use vtk::write_vtk;
