//! The displacement-controlled test of a scene.

use crate::columns::{counts, floats};
use crate::errors::refused;
use crate::interrupt::Watch;
use crate::scene::NativeScene;
use peelkit::study::{Observed, observed};
use peelkit_report::{ObservedSummary, timed, to_json};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// What a machine that holds the displacement would record.
#[pyclass(name = "Test", module = "peelkit._native", frozen, get_all)]
pub struct NativeTest {
    /// The object `observed` of summary.json
    summary: String,
    /// The columns of observed.csv: numbers, each the memory of its array
    numbers: Py<PyDict>,
    /// Whether a point is behind a jump, likewise
    jump: Py<PyAny>,
    /// Of each point in words
    branch: Vec<&'static str>,
    /// Of each point in words
    adheres: Vec<&'static str>,
}

/// Tests a scene, without the interpreter.
#[pyfunction]
pub fn test(py: Python, scene: &NativeScene) -> PyResult<NativeTest> {
    let (source, watch) = (scene.source.clone(), Watch::begin());
    let scene = source.of_peel(py)?;
    let (found, solve_s) = py.detach(|| {
        let stop = watch.on(scene.bounds.from_now());
        timed(|| observed(&scene.model, &scene.accuracy, &stop))
    });
    watch.end()?;
    let test = found.map_err(|none| refused(py, format!("there is no observed test: {none}"), &none.remedy()))?;
    handed(py, &test, solve_s)
}

fn handed(py: Python, test: &Observed, solve_s: f64) -> PyResult<NativeTest> {
    let summary = to_json(&ObservedSummary::new(test, solve_s))?;
    let (points, numbers) = (&test.points, PyDict::new(py));
    numbers.set_item("machine_displacement", floats(py, points.iter().map(|at| at.machine))?)?;
    numbers.set_item("displacement", floats(py, points.iter().map(|at| at.displacement))?)?;
    numbers.set_item("force", floats(py, points.iter().map(|at| at.force))?)?;
    numbers.set_item("work", floats(py, points.iter().map(|at| at.work))?)?;
    numbers.set_item("front", floats(py, points.iter().map(|at| at.front))?)?;
    Ok(NativeTest {
        summary,
        numbers: numbers.unbind(),
        jump: counts(py, points.iter().map(|at| usize::from(at.jumped)))?.into_any().unbind(),
        branch: points.iter().map(|at| at.way.word()).collect(),
        adheres: points.iter().map(|at| at.adheres.word()).collect(),
    })
}
