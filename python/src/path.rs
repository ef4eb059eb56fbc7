//! A path of equilibria driven point by point. It is followed in a thread of its own, which computes a point when it is asked for one.

use crate::errors::{computation_error, refused};
use crate::interrupt::Watch;
use crate::scene::NativeScene;
use peelkit::model::{Discretisation, PeelModel};
use peelkit::solve::{PathOptions, ShouldStop, Solution};
use peelkit::study::{Accuracy, FOLLOWED_ORDER, PathPoints, Stage, StopReason, prepared};
use peelkit_report::{end_reason, end_word};
use peelkit_scene::BoundsTable;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// A path that is being followed: an iterator over its points.
#[pyclass(name = "Path", module = "peelkit._native", frozen)]
pub struct NativePath {
    line: Mutex<Line>,
    /// Whether nobody waits for the point that is being computed
    left: Arc<AtomicBool>,
}

/// What connects to the thread that follows the path.
struct Line {
    requests: Sender<()>,
    points: Receiver<Result<Next, String>>,
    /// How the path has ended, and why
    end: Option<End>,
}

/// The word for an end, and its reason where it has one.
type End = (&'static str, Option<String>);

/// What a request is answered with.
enum Next {
    Point(Point),
    End(End),
}

/// Displacement, force, energy, negative eigenvalues with the displacement and with the force held, Newton iterations.
type Point = (f64, f64, f64, usize, usize, usize);

/// Begins a path on so many elements, its steps so long that a prediction is wrong by the step tolerance.
#[pyfunction]
pub fn path(py: Python, scene: &NativeScene, elements: usize, step_tolerance: f64) -> PyResult<NativePath> {
    let options = PathOptions { elements, step_tolerance, ..PathOptions::default() };
    let scene = scene.source.of_peel(py)?;
    scene.check().map_err(|error| refused(py, format!("`{}` {}", error.key(), error.found()), &error.remedy()))?;
    let model = scene.model.in_the_plane().unwrap_or_else(|| scene.model.clone());
    let (accuracy, bounds) = (scene.accuracy, scene.bounds);
    let choice = accuracy.choice;
    let how = Discretisation::moving(choice.form, FOLLOWED_ORDER).on(choice.mesh);
    let left = Arc::new(AtomicBool::new(false));
    let ((requests, asked), (found, points)) = (channel(), channel());
    let stop: ShouldStop = {
        let left = Arc::clone(&left);
        Arc::new(move || left.load(Ordering::Relaxed))
    };
    thread::spawn(move || follow(&model, (how, options), (&accuracy, bounds), &stop, &asked, &found));
    Ok(NativePath { line: Mutex::new(Line { requests, points, end: None }), left })
}

/// Follows the path as long as somebody asks for points, and to its end.
fn follow(
    model: &PeelModel,
    (how, options): (Discretisation, PathOptions),
    (accuracy, bounds): (&Accuracy, BoundsTable),
    stop: &ShouldStop,
    asked: &Receiver<()>,
    found: &Sender<Result<Next, String>>,
) {
    if asked.recv().is_err() {
        return;
    }
    let start = match prepared(model, how, Some(Arc::clone(stop))) {
        Ok(start) => start,
        // nobody may wait for it any more
        Err(error) => return drop(found.send(Err(error.why.to_string()))),
    };
    let left = Arc::clone(stop);
    // who asks for the points looks at the clock himself
    let criteria = BoundsTable { time_s: None, ..bounds }
        .from_now()
        .or_when(move |_: Stage| left().then_some(StopReason::Interrupted));
    let mut path = PathPoints::new(model, &start.problem, options, accuracy, criteria);
    for point in path.by_ref() {
        let over = point.is_err();
        let sent = found.send(point.map(|point| Next::Point(handed(&point))).map_err(|error| error.to_string()));
        if over || sent.is_err() || asked.recv().is_err() {
            return;
        }
    }
    // nobody may wait for it any more
    path.end().into_iter().for_each(|end| drop(found.send(Ok(Next::End((end_word(end), end_reason(end)))))));
}

fn handed(point: &Solution) -> Point {
    let at = &point.observables;
    (at.displacement, at.force, point.energy, point.negative, point.negative_load, point.iterations)
}

#[pymethods]
impl NativePath {
    /// The next point, computed without the interpreter; none behind the end of the path, or one that could not be computed.
    fn advance(&self, py: Python) -> PyResult<Option<Point>> {
        let watch = Watch::begin();
        let found = py.detach(|| {
            let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
            let found = line.requests.send(()).ok().and_then(|()| watch.wait(&line.points));
            if let Some(Ok(Next::End(end))) = &found {
                line.end = Some(end.clone());
            }
            found
        });
        watch.end().inspect_err(|_| self.left.store(true, Ordering::Relaxed))?;
        match found.transpose().map_err(|reason| computation_error(py, reason))? {
            Some(Next::Point(point)) => Ok(Some(point)),
            Some(Next::End(_)) | None => Ok(None),
        }
    }

    /// How the path has ended, and why; none before that.
    fn end(&self) -> Option<End> {
        self.line.lock().unwrap_or_else(PoisonError::into_inner).end.clone()
    }
}

impl Drop for NativePath {
    fn drop(&mut self) {
        self.left.store(true, Ordering::Relaxed);
    }
}
