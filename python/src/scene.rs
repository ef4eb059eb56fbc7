//! A scene: its text, the keys that replace those of the text, and what they make together.

use crate::errors::scene_error;
use crate::interrupt::Watch;
use crate::peel::NativePeel;
use peelkit::study::{self, Checkpoint};
use peelkit_report::timed;
use peelkit_scene::Scene;
use pyo3::prelude::*;
use std::sync::Arc;

/// A scene that has been checked.
#[pyclass(name = "Scene", module = "peelkit._native", frozen)]
pub struct NativeScene {
    /// Shared with the results of its runs
    pub(crate) source: Arc<Source>,
}

/// A scene and what it was read from.
pub struct Source {
    pub(crate) scene: Scene,
    text: String,
    overrides: Vec<(String, String)>,
}

impl Source {
    /// Reads and checks a scene.
    fn read(py: Python, name: &str, text: String, overrides: Vec<(String, String)>) -> PyResult<NativeScene> {
        let scene = Scene::parse_any(name, &text, &overrides).map_err(|error| scene_error(py, &error))?;
        Ok(NativeScene { source: Arc::new(Self { scene, text, overrides }) })
    }

    /// The scene of a peel: one with a seta, or with a rate, is refused.
    pub fn of_peel(&self, py: Python) -> PyResult<&Scene> {
        match (&self.scene.seta, &self.scene.time) {
            (None, None) => Ok(&self.scene),
            _ => {
                let again = Scene::parse(&self.scene.name, &self.text, &self.overrides);
                again.map(|_| &self.scene).map_err(|error| scene_error(py, &error))
            }
        }
    }
}

#[pymethods]
impl NativeScene {
    /// Reads a scene; `overrides` are keys with values in TOML that replace those of the text.
    #[new]
    fn new(py: Python, name: &str, text: String, overrides: Vec<(String, String)>) -> PyResult<Self> {
        Source::read(py, name, text, overrides)
    }

    /// The same with further keys replaced.
    fn with_values(&self, py: Python, overrides: Vec<(String, String)>) -> PyResult<Self> {
        let Source { scene, text, overrides: before } = &*self.source;
        Source::read(py, &scene.name, text.clone(), [before.as_slice(), &overrides].concat())
    }

    /// Name, text and overrides from which it is read again anywhere: a text that names files with what they hold in their place.
    fn parts(&self) -> (&str, String, Vec<(String, String)>) {
        let Source { scene, text, overrides } = &*self.source;
        let tables = &scene.table_texts;
        match tables.profile.is_empty() && tables.substrate.is_empty() {
            true => (&scene.name, text.clone(), overrides.clone()),
            false => (&scene.name, scene.to_toml(), Vec::new()),
        }
    }

    /// Where it was read from.
    #[getter]
    fn name(&self) -> &str {
        &self.source.scene.name
    }

    #[getter]
    fn title(&self) -> &str {
        &self.source.scene.title
    }

    /// Every key with its value, as a text that makes the same scene.
    fn to_toml(&self) -> String {
        self.source.scene.to_toml()
    }

    /// What a run of it computes: "peel", "seta", or "rate".
    #[getter]
    fn subject(&self) -> &'static str {
        match (&self.source.scene.time, &self.source.scene.seta) {
            (Some(_), _) => "rate",
            (None, Some(_)) => "seta",
            (None, None) => "peel",
        }
    }

    /// The whole peel, computed without the interpreter.
    fn run(&self, py: Python) -> PyResult<NativePeel> {
        let scene = self.source.of_peel(py)?;
        let (source, watch) = (self.source.clone(), Watch::begin());
        let (peel, solve_s) = py.detach(|| {
            let stop = watch.on(scene.bounds.from_now());
            timed(|| study::peel_on(&scene.model, &scene.accuracy, &stop, &Checkpoint::NOTHING))
        });
        watch.end()?;
        Ok(NativePeel::new(source, peel, solve_s))
    }
}
