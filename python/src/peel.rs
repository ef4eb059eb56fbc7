//! The result of a run.

use crate::columns::{Column, counts, floats, of_cells, of_records};
use crate::errors::{other, refused};
use crate::found::save;
use crate::interrupt::Watch;
use crate::number;
use crate::scene::{NativeScene, Source};
use crate::states::{self, NativeState};
use peelkit::study::{self, Events, Passing, PathEnd, Peel, PeelResult, Stations, StopCriteria};
use peelkit_analyses::PeelOutcome;
use peelkit_report::chart::Heading;
use peelkit_report::pictures::peel::{captioned, curve, numbered_points};
use peelkit_report::{GripOfPoint, PeelSummary, Record, SweepLine, VERSION, end_reason, end_word, steps_columns};
use peelkit_scene::{BoundsTable, station};
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyBytes};
use serde::{Deserialize, Serialize};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// The whole path of a scene with what was located on it.
#[pyclass(name = "Peel", module = "peelkit._native", frozen)]
pub struct NativePeel {
    source: Arc<Source>,
    peel: Arc<Peel>,
    solve_s: f64,
    /// summary.json, once it was asked for
    summary: OnceLock<String>,
    solutions: Solutions,
}

/// The solutions behind the points of a path.
enum Solutions {
    /// Of the run itself
    Computed,
    /// Not kept: computed again where they are asked for
    Dropped(OnceLock<Arc<Peel>>),
}

/// What is kept of a result but its scene. The solutions behind the points are not: they follow from the scene.
#[derive(Serialize, Deserialize)]
struct Kept<P> {
    version: String,
    peel: P,
    solve_s: f64,
    summary: String,
}

impl NativePeel {
    /// Of a run that took so many seconds.
    pub fn new(source: Arc<Source>, peel: Peel, solve_s: f64) -> Self {
        Self { source, peel: Arc::new(peel), solve_s, summary: OnceLock::new(), solutions: Solutions::Computed }
    }

    /// The scene that was run.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The peel with the solutions behind its points: one that was stored is run again, which gives every bit of it.
    pub fn with_solutions(&self, py: Python) -> PyResult<&Arc<Peel>> {
        let again = match &self.solutions {
            Solutions::Computed => return Ok(&self.peel),
            Solutions::Dropped(again) => again,
        };
        if let Some(peel) = again.get() {
            return Ok(peel);
        }
        let peel = self.run_again(py)?;
        Ok(again.get_or_init(|| Arc::new(peel)))
    }

    fn run_again(&self, py: Python) -> PyResult<Peel> {
        let (watch, scene) = (Watch::begin(), &self.source.scene);
        // the points follow from the scene: time has only said where the path is left
        let points = match self.peel.end {
            PathEnd::Bound(study::Bound::Time { .. }) => self.peel.points.len(),
            _ => scene.bounds.points,
        };
        let bounds = BoundsTable { points, time_s: None, ..scene.bounds };
        let stop = StopCriteria { events: scene.events.clone(), ..watch.on(bounds.from_now()) };
        let peel = py.detach(|| study::peel(&scene.model, &scene.accuracy, &stop));
        watch.end()?;
        if peel.points != self.peel.points {
            let found = "the solutions behind a stored result are not known: its run was stopped, and another one goes elsewhere";
            return Err(other(py, found.into(), "Run the scene again, with a larger `bounds.time`."));
        }
        Ok(peel)
    }

    fn summary_text(&self, py: Python) -> PyResult<&str> {
        if let Some(text) = self.summary.get() {
            return Ok(text);
        }
        let scene = &self.source.scene;
        let stations: Vec<Stations> = scene.stations.iter().map(|&at| self.peel.stations(at)).collect();
        let events: Vec<Events> = scene.events.iter().map(|at| self.peel.events(at)).collect();
        let made =
            PeelSummary::new(scene, &self.peel, self.solve_s).with_stations(&stations).with_events(&events).to_json();
        let text = made.map_err(|error| unwritten(py, "summary", error))?;
        Ok(self.summary.get_or_init(|| text))
    }
}

/// What `summary` or `row` of a run is, was not made: a number is not finite.
fn unwritten(py: Python, what: &str, error: io::Error) -> PyErr {
    let remedy = "The scene is at the limit of what can be computed: look at `curve`, and try other values.";
    other(py, format!("the {what} of the run cannot be written: {error}"), remedy)
}

#[pymethods]
impl NativePeel {
    /// A result from what `kept` has returned, with the scene of it.
    #[new]
    fn restored(py: Python, scene: &NativeScene, kept: &[u8]) -> PyResult<Self> {
        let remedy = "Run the scene again: a result is read by the version that has written it.";
        let unreadable = |why: String| other(py, format!("the stored result of a run cannot be read: {why}"), remedy);
        let (version, _) = postcard::take_from_bytes::<String>(kept).map_err(|error| unreadable(error.to_string()))?;
        if version != VERSION {
            return Err(unreadable(format!("it is of peelkit {version}, and this is {VERSION}")));
        }
        let Kept { peel, solve_s, summary, .. } =
            postcard::from_bytes::<Kept<Peel>>(kept).map_err(|error| unreadable(error.to_string()))?;
        let solutions = Solutions::Dropped(OnceLock::new());
        Ok(Self { source: scene.source.clone(), peel: Arc::new(peel), solve_s, summary: summary.into(), solutions })
    }

    /// The result as bytes, every bit of its numbers.
    fn kept<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let summary = self.summary_text(py)?.to_owned();
        let kept = Kept { version: VERSION.to_owned(), peel: &*self.peel, solve_s: self.solve_s, summary };
        let bytes = postcard::to_stdvec(&kept).map_err(|error| {
            other(py, format!("the result cannot be stored: {error}"), "Keep `summary()` and `curve` in its place.")
        })?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The scene that was run.
    #[getter]
    fn scene(&self) -> NativeScene {
        NativeScene { source: self.source.clone() }
    }

    /// How the path ends, in a word.
    #[getter]
    fn end(&self) -> &'static str {
        end_word(&self.peel.end)
    }

    /// Why it ends, of the ends `bound` and `failed`.
    #[getter]
    fn reason(&self) -> Option<String> {
        end_reason(&self.peel.end)
    }

    /// The object of summary.json as text.
    fn summary(&self, py: Python) -> PyResult<&str> {
        self.summary_text(py)
    }

    /// The row of sweep.csv as the text of an object, but for the value of the sweep.
    fn row(&self, py: Python) -> PyResult<String> {
        let found = PeelResult::from(&*self.peel);
        SweepLine::new(0.0, None, &found, self.solve_s).to_json().map_err(|error| unwritten(py, "row", error))
    }

    /// The columns of curve.csv.
    fn curve(&self, py: Python) -> PyResult<Vec<Column>> {
        let points = self.peel.points.iter();
        match points.clone().any(|point| point.in_space.is_some()) {
            true => of_records(py, points.map(|point| (point, GripOfPoint(point.in_space.unwrap_or_default())))),
            false => of_records(py, points),
        }
    }

    /// The columns of steps.csv; none where no steps come before the pull.
    fn steps(&self, py: Python) -> PyResult<Vec<Column>> {
        of_cells(py, steps_columns(&self.peel))
    }

    /// The beam at every limit point and at `count` places evenly along the path.
    fn states(&self, py: Python, count: usize) -> PyResult<Vec<NativeState>> {
        let peel = self.with_solutions(py)?;
        let states = py.detach(|| peel.states(count));
        states.iter().map(|state| states::handed(py, state)).collect()
    }

    /// The equilibria at a value, `displacement=10 nm`, as the text of an object of summary.json.
    fn stations(&self, py: Python, text: &str) -> PyResult<String> {
        let at = station(text).map_err(|why| refused(py, format!("{text} {}", why.found), &why.remedy))?;
        let peel = self.with_solutions(py)?;
        py.detach(|| peel.stations(at)).to_json().map_err(|error| unwritten(py, "station", error))
    }

    /// The equilibria at which a Python function of a state passes a value, in a way that counts, as an object of summary.json has events.
    fn passed(&self, py: Python, function: Py<PyAny>, value: f64, passing: &str) -> PyResult<String> {
        let signs = Passing::NAMED.map(|named| format!("\"{}\"", named.0)).join(", ");
        let known = Passing::NAMED.into_iter().find(|named| named.0 == passing);
        let found = || format!("`passing` is \"{passing}\", which is none of {signs}");
        let (_, passing) = known.ok_or_else(|| other(py, found(), "Give one of these."))?;
        let (at, raised) = number::event("where", function, value, passing);
        let peel = self.with_solutions(py)?;
        let text = py.detach(|| peel.events(&at)).to_json();
        raised.end()?;
        text.map_err(|error| unwritten(py, "station", error))
    }

    /// Writes the files of `peel run` to a folder; where each is.
    fn save(&self, py: Python, folder: PathBuf, command: &str, replace: bool) -> PyResult<Vec<PathBuf>> {
        let outcome = PeelOutcome::of(Arc::clone(self.with_solutions(py)?), self.solve_s);
        let outcome = outcome.with_stations(&self.source.scene);
        save(py, (&outcome, &self.source.scene), &folder, command, replace)
    }

    /// The picture of the curve as SVG.
    fn svg(&self, py: Python) -> PyResult<String> {
        let peel = self.with_solutions(py)?;
        let scene = &self.source.scene;
        let heading = Heading { title: &captioned(peel, &scene.title), units: scene.units };
        let drawn = curve(peel, &numbered_points(peel), heading, Path::new("the curve"))
            .map_err(|error| error.to_string())
            .and_then(|picture| picture.svg().map_err(|error| error.to_string()));
        drawn.map_err(|error| other(py, error, "Look at `end` and `reason` of the result."))
    }

    /// Displacement, force and negative eigenvalues with intervals between the path points, for a picture.
    fn dense_curve<'py>(&self, py: Python<'py>, per_step: usize) -> PyResult<[Bound<'py, PyByteArray>; 3]> {
        let curve = self.with_solutions(py)?.dense_curve(per_step.max(1));
        let (displacement, force) = (curve.iter().map(|at| at.0), curve.iter().map(|at| at.1));
        Ok([floats(py, displacement)?, floats(py, force)?, counts(py, curve.iter().map(|at| at.2))?])
    }
}
