//! A scene: its text, the keys that replace those of the text, and what they make together.

use crate::errors::{refusal, scene_error};
use crate::found::made;
use crate::interrupt::Watch;
use crate::number;
use crate::peel::NativePeel;
use peelkit::study::{self, Checkpoint, EventAt, Passing, StopCriteria};
use peelkit_analyses::MissingLaw;
use peelkit_report::timed;
use peelkit_scene::{Described, KEYS, Key, Scene, Value, find_key};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList};
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
        match self.scene.describes() {
            Described::Peel => Ok(&self.scene),
            _ => {
                let again = Scene::parse(&self.scene.name, &self.text, &self.overrides);
                again.map(|_| &self.scene).map_err(|error| scene_error(py, &error))
            }
        }
    }
}

/// A value for Python; a number of a key with a unit as a text with it.
fn handed<'py>(py: Python<'py>, value: &Value, unit: &str, whole: bool) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        Value::Text(text) => text.into_pyobject(py)?.into_any(),
        Value::Number(number) if !unit.is_empty() => format!("{number} {unit}").into_pyobject(py)?.into_any(),
        Value::Number(number) if whole => (*number as i64).into_pyobject(py)?.into_any(),
        Value::Number(number) => number.into_pyobject(py)?.into_any(),
        Value::Flag(flag) => PyBool::new(py, *flag).to_owned().into_any(),
        Value::List(items) => {
            let items: PyResult<Vec<_>> = items.iter().map(|item| handed(py, item, "", false)).collect();
            PyList::new(py, items?)?.into_any()
        }
        Value::Table(entries) => {
            let table = PyDict::new(py);
            for (name, value) in entries {
                table.set_item(name, handed(py, value, "", false)?)?;
            }
            table.into_any()
        }
        // no key of a scene has one
        Value::Other(what) => what.into_pyobject(py)?.into_any(),
    })
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
        let has_law = scene.array.as_ref().is_some_and(|array| array.fitted.is_some());
        match scene.table_texts.is_empty() && !has_law {
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

    /// The scene with the law of its setae, which is made where it names a folder without one and the scene of the seta.
    fn with_law(&self, py: Python) -> PyResult<Self> {
        let Source { scene, text, overrides } = &*self.source;
        let Some(missing) = MissingLaw::of(scene).map_err(|why| refusal(py, why))? else {
            return Ok(Self { source: Arc::clone(&self.source) });
        };
        made(py, |session| missing.make(session, "peelkit"))?;
        Source::read(py, &scene.name, text.clone(), overrides.clone())
    }

    /// Every key with its value, as a text that makes the same scene.
    fn to_toml(&self) -> String {
        self.source.scene.to_toml()
    }

    /// Every key with its value: table, name, and the value as the text has it, but quantities as texts with their unit.
    fn entries(&self, py: Python) -> PyResult<Vec<(&'static str, &'static str, Py<PyAny>)>> {
        let scene = &self.source.scene;
        let has = |key: &&Key| key.belongs_to(scene);
        let entry = |key: &'static Key| {
            let value = key.value(scene)?;
            let whole = matches!(value, Value::Number(number) if key.is_written_whole(number));
            Some(handed(py, &value, key.unit(), whole).map(|value| (key.table, key.name, value.unbind())))
        };
        KEYS.iter().filter(has).filter_map(entry).collect()
    }

    /// The number of a key in the unit that `peel keys` lists; none of a key that is no number, and of one without a value.
    fn number(&self, path: &str) -> Option<f64> {
        let key = find_key(path).ok().filter(|key| key.is_numeric())?;
        let Value::Number(number) = key.value(&self.source.scene)? else { return None };
        Some(in_usual_unit(key, number))
    }

    /// What a run of it computes: "peel", "solid", "seta", "array", or "rate".
    #[getter]
    fn subject(&self) -> &'static str {
        self.source.scene.describes().word()
    }

    /// The whole peel, computed without the interpreter: up to where a Python function of a state passes zero, if it is given.
    #[pyo3(signature = (stop_where=None))]
    fn run(&self, py: Python, stop_where: Option<Py<PyAny>>) -> PyResult<NativePeel> {
        let scene = self.source.of_peel(py)?;
        let (source, watch) = (self.source.clone(), Watch::begin());
        let (event, raised) =
            stop_where.map(|function| number::event("stop_where", function, 0.0, Passing::Either)).unzip();
        let event = event.map(EventAt::stopping);
        let (peel, solve_s) = py.detach(|| {
            let events = scene.events.iter().cloned().chain(event).collect();
            let stop = StopCriteria { events, ..watch.on(scene.bounds.from_now()) };
            timed(|| study::peel_on(&scene.model, &scene.accuracy, &stop, &Checkpoint::NOTHING))
        });
        watch.end()?;
        raised.map_or(Ok(()), |raised| raised.end())?;
        Ok(NativePeel::new(source, peel, solve_s))
    }
}

/// Every key with the unit in which a bare number is taken, as `peel keys` lists it; empty where it takes none.
#[pyfunction]
pub fn keys() -> Vec<(String, &'static str)> {
    KEYS.iter().map(|key| (key.path(), key.usual_unit())).collect()
}

/// The number of a quantity in the unit that `peel keys` lists; none where this key takes no such text.
#[pyfunction]
pub fn usual(path: &str, text: &str) -> Option<f64> {
    let key = find_key(path).ok().filter(|key| key.dimension().is_some())?;
    Some(in_usual_unit(key, key.parse_number(text).ok()?))
}

/// A number of a key in the unit that `peel keys` lists: one that reads as the same number again.
fn in_usual_unit(key: &Key, number: f64) -> f64 {
    let usual = number * key.per_usual_unit();
    // 60 deg and not what is left of it behind its way to radians and back
    let short = format!("{usual:.14e}").parse().ok();
    let reads_as = |short: &f64| key.parse_number(&format!("{short} {}", key.usual_unit())) == Ok(number);
    short.filter(reads_as).unwrap_or(usual)
}
