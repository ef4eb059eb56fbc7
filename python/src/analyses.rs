//! Analyses of a scene, as their outcomes are handed on.

use crate::columns::{Column, of_cells, of_records};
use crate::errors::refused;
use crate::found::{NativeFound, analysed};
use crate::interrupt::Watch;
use crate::scene::NativeScene;
use peelkit::study::coarsening::{CoarseningOptions, PadEnd};
use peelkit::study::{MeasuredPoint, observed};
use peelkit_analyses::{
    ArrayRun, Asked, Data, Fitting, Optimisation, PeelRun, RateRun, SetaRun, SolidRun, TipCoarsening, Uncertainty,
};
use peelkit_report::{ObservedSummary, Record, array_columns, pull_off_columns, rate_columns, solid_columns, timed};
use pyo3::prelude::*;
use std::path::Path;

/// The pull-off of the seta of a scene.
#[pyfunction]
pub fn pull_off(py: Python, scene: &NativeScene) -> PyResult<NativeFound> {
    let found = analysed(py, &scene.source, |scene| SetaRun::of(scene, Asked::default()))?;
    let columns = of_cells(py, pull_off_columns(&found.pull_off().points))?;
    Ok(NativeFound::new(&scene.source, found)?.with_columns(columns))
}

/// The pull of a scene at its rate.
#[pyfunction]
pub fn pull_at_rate(py: Python, scene: &NativeScene) -> PyResult<NativeFound> {
    let found = analysed(py, &scene.source, |scene| RateRun::of(scene, Asked::default()))?;
    let columns = of_cells(py, rate_columns(&found.pulled.points))?;
    Ok(NativeFound::new(&scene.source, found)?.with_columns(columns))
}

/// The peel of the strip of a scene as a solid.
#[pyfunction]
pub fn peel_solid(py: Python, scene: &NativeScene) -> PyResult<NativeFound> {
    let found = analysed(py, &scene.source, |scene| SolidRun::of(scene, Asked::default()))?;
    let columns = of_cells(py, solid_columns(&found.peel.points))?;
    Ok(NativeFound::new(&scene.source, found)?.with_columns(columns))
}

/// The pull of the array of setae of a scene, whose columns are those of curve.csv, with those of events.csv and of rows.csv.
#[pyfunction]
pub fn pull_array(py: Python, scene: &NativeScene) -> PyResult<(NativeFound, Vec<Column>, Vec<Column>)> {
    let found = analysed(py, &scene.source, |scene| ArrayRun::of(scene, Asked::default()))?;
    let [curve, events, rows] = array_columns(&found.pull);
    let (curve, events, rows) = (of_cells(py, curve)?, of_cells(py, events)?, of_cells(py, rows)?);
    Ok((NativeFound::new(&scene.source, found)?.with_columns(curve), events, rows))
}

/// The stability of the planar path of a scene against leaving its plane and, where asked for, the branch on which it leaves.
#[pyfunction]
pub fn out_of_plane(py: Python, scene: &NativeScene, branch: bool) -> PyResult<NativeFound> {
    scene.source.of_peel(py)?;
    let asked = Asked { out_of_plane: true, branch, ..Asked::default() };
    NativeFound::new(&scene.source, analysed(py, &scene.source, |scene| PeelRun::of(scene, asked))?)
}

/// The law of a tip from the spatula of a scene. What is not given is as wide as usual; nm, rad.
#[pyfunction]
pub fn coarsen(
    py: Python,
    scene: &NativeScene,
    tolerance: f64,
    press: Option<f64>,
    lateral: Option<[f64; 2]>,
    rotation: Option<[f64; 2]>,
) -> PyResult<NativeFound> {
    let usual = TipCoarsening::usual(scene.source.of_peel(py)?);
    if lateral.is_some() && usual.pad_end == PadEnd::Sliding {
        let found = "`lateral` is of no use: the pad of this scene slides, and v changes nothing";
        let remedy = "Omit it, or give `with_(\"grip.horizontal\", \"fixed\")`, which holds the free end of the pad.";
        return Err(refused(py, found.into(), remedy));
    }
    let mut options = CoarseningOptions { tolerance, ..usual };
    options.range.press = press.unwrap_or(options.range.press);
    options.range.lateral = lateral.unwrap_or(options.range.lateral);
    options.range.rotation = rotation.unwrap_or(options.range.rotation);
    let found = analysed(py, &scene.source, |scene| TipCoarsening::of(scene, options))?;
    NativeFound::new(&scene.source, found)
}

/// The best design of a scene with a table [optimise], and the scene of the optimum.
#[pyfunction]
pub fn optimise(py: Python, scene: &NativeScene) -> PyResult<NativeFound> {
    let found = analysed(py, &scene.source, Optimisation::of)?;
    let best = found.best(&scene.source.scene);
    Ok(NativeFound::new(&scene.source, found)?.with_scene(best))
}

/// The measured points that were given: displacement in nm, force and its standard error in nN.
type Points = Vec<(f64, f64, Option<f64>)>;

/// The parameters of a scene from a measured curve, a file in CSV or points, or from the curves that it names, and the fitted scene.
#[pyfunction]
pub fn fit(py: Python, scene: &NativeScene, file: Option<&str>, points: Option<Points>) -> PyResult<NativeFound> {
    let data = match (file, points) {
        (None, _) => Data::OfScene,
        (Some(name), Some(points)) => Data::Points(name, points.into_iter().map(measured_point).collect()),
        (Some(file), None) => Data::File(Path::new(file)),
    };
    let found = analysed(py, &scene.source, |scene| Fitting::of(scene, data))?;
    let fitted = found.report(&scene.source.scene).fitted_scene();
    Ok(NativeFound::new(&scene.source, found)?.with_scene(Some(fitted)))
}

fn measured_point((displacement, force, force_error): (f64, f64, Option<f64>)) -> MeasuredPoint {
    MeasuredPoint { displacement, force, force_error }
}

/// What the distributions of a table [uncertainty] make of the results.
#[pyfunction]
pub fn uncertainty(py: Python, scene: &NativeScene) -> PyResult<NativeFound> {
    NativeFound::new(&scene.source, analysed(py, &scene.source, Uncertainty::of)?)
}

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
