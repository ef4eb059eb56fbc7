//! A number of the fields of a beam that a Python function computes, as an event of the path.

use crate::states::handed;
use peelkit::study::{BeamState, EventAt, Passing};
use pyo3::prelude::*;
use std::sync::{Arc, Mutex, PoisonError};

/// What a function has raised, if it has.
#[derive(Clone, Default)]
pub struct Raised(Arc<Mutex<Option<PyErr>>>);

impl Raised {
    /// Raises it in the caller.
    pub fn end(&self) -> PyResult<()> {
        match self.0.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }

    /// The number of a state: none where the function raises something, of which the first is kept.
    fn called(&self, function: &Py<PyAny>, state: &BeamState) -> f64 {
        Python::attach(|py| {
            let number = handed(py, state).and_then(|state| function.call1(py, (state,))?.extract(py));
            number.unwrap_or_else(|error: PyErr| {
                self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                f64::NAN
            })
        })
    }
}

/// The event with a name at which what a function returns of a native state passes a value, and what the function may have raised.
pub fn event(name: &str, function: Py<PyAny>, value: f64, passing: Passing) -> (EventAt, Raised) {
    let raised = Raised::default();
    let own = raised.clone();
    let of_fields = EventAt::of_beam(name, move |state| own.called(&function, state));
    (EventAt { value, passing, ..of_fields }, raised)
}
