//! Rows of a sweep, one by one.

use crate::errors::other;
use crate::interrupt::Watch;
use crate::scene::NativeScene;
use peelkit_analyses::{SceneRows, Session};
use pyo3::prelude::*;

/// Rows of scenes like one, whose setae share the law of their tips.
#[pyclass(name = "Rows", module = "peelkit._native", frozen)]
pub struct NativeRows(SceneRows);

#[pymethods]
impl NativeRows {
    #[new]
    fn new(scene: &NativeScene) -> Self {
        Self(SceneRows::like(&scene.source.scene))
    }

    /// The row of sweep.csv of a scene as the text of an object, but for the value of the sweep.
    fn row(&self, py: Python, scene: &NativeScene) -> PyResult<String> {
        let (source, watch) = (scene.source.clone(), Watch::begin());
        let row = py.detach(|| self.0.row(&source.scene, &Session { watcher: &watch, keeping: None, abrupt: true }));
        watch.end()?;
        row.map_err(|error| other(py, format!("the row of the sweep is not written: {error}"), ""))
    }
}
