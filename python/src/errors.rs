//! Failures as the exceptions of `peelkit.errors`.

use peelkit_analyses::Refusal;
use peelkit_report::ReportError;
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

/// Why an analysis has no outcome.
pub fn refusal(py: Python, why: Refusal) -> PyErr {
    match why {
        Refusal::Asked { found, remedy } | Refusal::Scene { found, remedy } => {
            // what the command sets, a scene has with other values
            refused(py, found, &remedy.replace("--set terms=all", "`with_(\"terms\", \"all\")`"))
        }
        Refusal::CutShort(why) => computation_error(py, why),
        Refusal::Report(error) => other(py, error.to_string(), ""),
        Refusal::Other(why) => other(py, why, ""),
    }
}

/// What to try where files could not be written, if anything is known to help.
pub fn unsaved(error: &ReportError) -> Option<&'static str> {
    match error {
        ReportError::Exists { .. } => {
            Some("Give another folder, or `replace=True` to replace the files of the same names.")
        }
        ReportError::InUse { .. } => Some("Wait until it has ended, or give another folder."),
        ReportError::Write { .. } => {
            Some("Give a folder in which you may write, and make room on the disk where it is full.")
        }
        _ => None,
    }
}

/// The exception of this class; where it cannot be made, why not.
fn raised<'py>(py: Python<'py>, class: &str, arguments: impl PyCallArgs<'py>) -> PyErr {
    let made = || py.import(MODULE)?.getattr(class)?.call1(arguments);
    made().map_or_else(|error| error, PyErr::from_value)
}
