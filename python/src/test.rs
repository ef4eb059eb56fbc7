//! The displacement-controlled test of a scene.

use crate::columns::{Column, of_records};
use crate::errors::refused;
use crate::interrupt::Watch;
use crate::scene::NativeScene;
use peelkit::study::observed;
use peelkit_report::{ObservedSummary, Record, timed};
use pyo3::prelude::*;

/// What a machine that holds the displacement would record.
#[pyclass(name = "Test", module = "peelkit._native", frozen, get_all)]
pub struct NativeTest {
    /// The object `observed` of summary.json
    summary: String,
    /// The columns of observed.csv
    columns: Vec<Column>,
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
    let summary = ObservedSummary::new(&test, solve_s).to_json()?;
    Ok(NativeTest { summary, columns: of_records(py, test.points.iter())? })
}
