//! The beam at chosen places of its path.

use crate::columns::floats;
use peelkit::study::{BeamState, StateSections};
use peelkit_report::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField, limit_point_kind_word};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// One equilibrium with its fields along the beam.
#[pyclass(name = "State", module = "peelkit._native", frozen, get_all)]
pub struct NativeState {
    /// nm
    displacement: f64,
    /// nN
    force: f64,
    /// `displacement` or `load` of a limit point
    limit_point: Option<&'static str>,
    /// From 0 to 1
    path_position: f64,
    /// The columns of states.csv, each the memory of its array
    fields: Py<PyDict>,
}

/// The same for Python.
pub fn handed(py: Python, state: &BeamState) -> PyResult<NativeState> {
    let fields = match &state.sections {
        StateSections::Planar(sections) => columns(py, sections, STATE_FIELDS),
        StateSections::Spatial { sections, .. } => columns(py, sections, SPATIAL_STATE_FIELDS),
    };
    Ok(NativeState {
        displacement: state.displacement,
        force: state.force,
        limit_point: state.limit_point.map(limit_point_kind_word),
        path_position: state.path_position,
        fields: fields?.unbind(),
    })
}

fn columns<'py, S>(py: Python<'py>, sections: &[S], fields: &[StateField<S>]) -> PyResult<Bound<'py, PyDict>> {
    let columns = PyDict::new(py);
    for field in fields {
        columns.set_item(field.name, floats(py, sections.iter().map(field.value))?)?;
    }
    Ok(columns)
}
