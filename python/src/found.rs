//! What an analysis has found, but for a peel: its summary, its columns, and its files.

use crate::columns::Column;
use crate::errors::{other, refusal, unsaved};
use crate::interrupt::Watch;
use crate::scene::Source;
use peelkit_analyses::{Analysis, End, Outcome, Refusal, Session};
use peelkit_report::{Existing, OutputFolder};
use peelkit_scene::Scene;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What an analysis of a scene has found.
#[pyclass(name = "Found", module = "peelkit._native", frozen)]
pub struct NativeFound {
    source: Arc<Source>,
    outcome: Box<dyn Outcome + Send + Sync>,
    /// The object of summary.json
    #[pyo3(get)]
    summary: String,
    /// Why it stopped short, if it did
    #[pyo3(get)]
    short: Option<String>,
    /// The columns of its table, where it has one
    columns: Vec<Column>,
    /// The scene that it leads to, as text
    #[pyo3(get)]
    scene: Option<String>,
}

/// The outcome of an analysis of a scene, computed without the interpreter.
pub fn analysed<'s, A: Analysis + Sync>(
    py: Python,
    source: &'s Source,
    of: impl FnOnce(&'s Scene) -> Result<A, Refusal>,
) -> PyResult<A::Found>
where
    A::Found: Send,
{
    let analysis = of(&source.scene).map_err(|why| refusal(py, why))?;
    made(py, |session| analysis.run(session))
}

/// What is computed without the interpreter, which Ctrl-C stops.
pub fn made<T: Send>(py: Python, compute: impl FnOnce(&Session) -> Result<T, Refusal> + Send) -> PyResult<T> {
    let watch = Watch::begin();
    let run = || compute(&Session { watcher: &watch, keeping: None, abrupt: true });
    let found = py.detach(|| watch.over(run));
    watch.end()?;
    let found =
        found.map_err(|_| PyRuntimeError::new_err("peelkit has panicked; what it says stands on standard error"))?;
    found.map_err(|why| refusal(py, why))
}

impl NativeFound {
    /// Of an outcome without columns.
    pub fn new(source: &Arc<Source>, outcome: impl Outcome + Send + Sync + 'static) -> PyResult<Self> {
        let short = match outcome.end() {
            End::Done => None,
            End::CutShort(why) => Some(why),
            End::Interrupted { .. } => Some("interrupted".to_owned()),
            End::Refused { found, .. } => Some(found),
        };
        Ok(Self {
            summary: outcome.json(&source.scene, None)?,
            source: Arc::clone(source),
            outcome: Box::new(outcome),
            short,
            columns: Vec::new(),
            scene: None,
        })
    }

    /// The same with these columns.
    pub fn with_columns(self, columns: Vec<Column>) -> Self {
        Self { columns, ..self }
    }

    /// The same with the scene that it leads to.
    pub fn with_scene(self, scene: Option<Scene>) -> Self {
        Self { scene: scene.map(|scene| scene.to_toml()), ..self }
    }
}

#[pymethods]
impl NativeFound {
    /// The columns of its table.
    fn columns(&self, py: Python) -> Vec<Column> {
        let handed = |(name, unit, kind, memory): &Column| (name.clone(), unit.clone(), *kind, memory.clone_ref(py));
        self.columns.iter().map(handed).collect()
    }

    /// Writes the files of the command to a folder; where each is.
    fn save(&self, py: Python, folder: PathBuf, command: &str, replace: bool) -> PyResult<Vec<PathBuf>> {
        save(py, (&*self.outcome, &self.source.scene), &folder, command, replace)
    }
}

/// Writes the files of an outcome of a scene to a folder; where each is.
pub fn save(
    py: Python,
    (outcome, scene): (&(dyn Outcome + Sync), &Scene),
    folder: &Path,
    command: &str,
    replace: bool,
) -> PyResult<Vec<PathBuf>> {
    let existing = if replace { Existing::Replace } else { Existing::Keep };
    let written =
        py.detach(|| OutputFolder::claim(folder, existing, None)?.write(|dir| outcome.write_all(scene, dir, command)));
    written.map_err(|error| match unsaved(&error) {
        Some(remedy) => other(py, error.to_string(), remedy),
        None => other(py, error.to_string(), ""),
    })
}
