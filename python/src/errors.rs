//! Failures as the exceptions of `peelkit.errors`.

use peelkit_scene::SceneError;
use pyo3::call::PyCallArgs;
use pyo3::prelude::*;

/// Where the classes stand.
const MODULE: &str = "peelkit.errors";

/// A scene that cannot be used, as `peelkit.SceneError`.
pub fn scene_error(py: Python, error: &SceneError) -> PyErr {
    raised(py, "SceneError", (error.problem(), error.remedy(), error.key(), error.value(), error.place()))
}

/// What cannot be computed of a scene that can be read, as `peelkit.SceneError` without a key.
pub fn refused(py: Python, found: String, remedy: &str) -> PyErr {
    raised(py, "SceneError", (found, remedy))
}

/// A computation that stopped short, as `peelkit.ComputationError`.
pub fn computation_error(py: Python, reason: String) -> PyErr {
    raised(py, "ComputationError", (format!("the computation stopped short: {reason}"),))
}

/// Anything else, as `peelkit.PeelkitError`.
pub fn other(py: Python, found: String, remedy: &str) -> PyErr {
    raised(py, "PeelkitError", (found, remedy))
}

/// The exception of this class; where it cannot be made, why not.
fn raised<'py>(py: Python<'py>, class: &str, arguments: impl PyCallArgs<'py>) -> PyErr {
    let made = || py.import(MODULE)?.getattr(class)?.call1(arguments);
    made().map_or_else(|error| error, PyErr::from_value)
}
