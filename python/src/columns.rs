//! The points of a path as columns of numbers: those of curve.csv, without their units.

use peelkit::model::SpatialGrip;
use peelkit::study::PathPoint;
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

/// A column of numbers.
pub struct Column {
    pub name: &'static str,
    pub value: fn(&PathPoint) -> f64,
}

/// A column of counts.
pub struct CountColumn {
    pub name: &'static str,
    pub value: fn(&PathPoint) -> usize,
}

/// Numbers of every path; nm, nN, rad, aJ.
pub const NUMBERS: &[Column] = &[
    Column { name: "displacement", value: |at| at.displacement },
    Column { name: "force", value: |at| at.force },
    Column { name: "end_rotation", value: |at| at.end_rotation },
    Column { name: "work", value: |at| at.work },
    Column { name: "front", value: |at| at.front },
];

/// Counts of every path.
pub const COUNTS: &[CountColumn] = &[
    CountColumn { name: "negative_eigenvalues", value: |at| at.negative_eigenvalues },
    CountColumn { name: "negative_eigenvalues_load", value: |at| at.negative_eigenvalues_load },
    CountColumn { name: "newton_iterations", value: |at| at.iterations },
];

/// Numbers of a path in space; nN nm, degrees, nN.
pub const IN_SPACE: &[Column] = &[
    Column { name: "torque", value: |at| grip(at).torque },
    Column { name: "roll", value: |at| grip(at).roll.to_degrees() },
    Column { name: "yaw", value: |at| grip(at).yaw.to_degrees() },
    Column { name: "reaction_across", value: |at| grip(at).across },
    Column { name: "reaction_lateral", value: |at| grip(at).lateral },
];

fn grip(point: &PathPoint) -> SpatialGrip {
    point.in_space.unwrap_or_default()
}

/// Numbers as the memory of an array of float64, which `numpy.frombuffer` takes as it is.
pub fn floats<'py>(py: Python<'py>, values: impl ExactSizeIterator<Item = f64>) -> PyResult<Bound<'py, PyByteArray>> {
    memory(py, values.len(), values.map(f64::to_ne_bytes))
}

/// Counts as the memory of an array of int64.
pub fn counts<'py>(py: Python<'py>, values: impl ExactSizeIterator<Item = usize>) -> PyResult<Bound<'py, PyByteArray>> {
    memory(py, values.len(), values.map(|count| (count as i64).to_ne_bytes()))
}

fn memory<'py>(
    py: Python<'py>,
    length: usize,
    items: impl Iterator<Item = [u8; 8]>,
) -> PyResult<Bound<'py, PyByteArray>> {
    PyByteArray::new_with(py, 8 * length, |memory| {
        memory.chunks_exact_mut(8).zip(items).for_each(|(place, item)| place.copy_from_slice(&item));
        Ok(())
    })
}
