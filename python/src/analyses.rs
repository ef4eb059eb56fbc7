//! Analyses of a scene that says what is free, fitted or uncertain. Each hands on its summary as text.

use crate::errors::{computation_error, refused};
use crate::interrupt::Watch;
use crate::scene::{NativeScene, Source};
use peelkit::study::optimisation::{NoOptimum, OptimisationOptions, optimise as find};
use peelkit::study::uncertainty::{ALONE_AT, Analysis, Design, SampledPeel, one_at_a_time, sample, taylor_polynomials};
use peelkit::study::{FitProblem, MeasuredCurve, MeasuredPoint, NoFit, Terms, fit as fitted};
use peelkit_report::overlay::read_force_curve;
use peelkit_report::{FitReport, FitSummary, OptimisationSummary, UncertaintySummary, timed};
use peelkit_scene::Scene;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::path::Path;
use std::thread;

/// What a thread has found that may have panicked.
fn joined<T>(found: thread::Result<T>) -> PyResult<T> {
    found.map_err(|_| PyRuntimeError::new_err("peelkit has panicked; what it says stands on standard error"))
}

/// The best design of a scene with a table [optimise]: its summary, and the scene of the optimum as text.
#[pyfunction]
pub fn optimise(py: Python, scene: &NativeScene) -> PyResult<(String, Option<String>)> {
    let (source, watch) = (scene.source.clone(), Watch::begin());
    let scene = &source.scene;
    let Some((table, problem)) = scene.optimisation.as_ref().zip(scene.design_problem()) else {
        let remedy = "Add a table `optimise` with for example objective = \"initiation_peak.force_nN\" and width = { from = \"5 nm\", to = \"20 nm\" }.";
        return Err(refused(py, "nothing is free in this scene: it lacks the table [optimise]".into(), remedy));
    };
    let options = OptimisationOptions {
        stop: &|| watch.on(scene.bounds.from_now()),
        go_on: &|| !watch.interrupted(),
        ..table.options(scene.accuracy)
    };
    let (found, solve_s) = timed(|| py.detach(|| watch.over(|| find(&problem, &options))));
    watch.end()?;
    let optimum = joined(found)?.map_err(|error| match error {
        NoOptimum::AllBad { .. } => computation_error(py, error.to_string()),
        error => {
            let remedy = "Change the table `optimise`; a run of the same scene shows what its peel has.";
            refused(py, format!("there is no optimum: {error}"), remedy)
        }
    })?;
    let summary = OptimisationSummary::new(scene, &problem, &optimum, solve_s).to_json()?;
    Ok((summary, scene.of_design(&optimum.after.values).map(|best| best.to_toml())))
}

/// The measured points that were given: displacement in nm, force and its standard error in nN.
type Points = Vec<(f64, f64, Option<f64>)>;

/// The parameters of a scene from a measured curve, a file in CSV or points: the summary, and the fitted scene as text.
#[pyfunction]
pub fn fit(py: Python, scene: &NativeScene, file: &str, points: Option<Points>) -> PyResult<(String, String)> {
    let (source, watch) = (scene.source.clone(), Watch::begin());
    let scene = &source.scene;
    let table = scene.fit.clone().unwrap_or_default();
    let problem = fit_problem(py, scene)?;
    let measured = match points {
        Some(points) => points.into_iter().map(measured_point).collect(),
        None => read_force_curve(Path::new(file)).map_err(|error| refused(py, error.to_string(), &error.remedy))?,
    };
    let measured =
        MeasuredCurve::new(measured, table.jump).map_err(|why| refused(py, format!("{file} {why}"), why.remedy()))?;
    let stop = || watch.on(scene.bounds.from_now());
    let work = || fitted(&problem, &measured, &table.options, &scene.accuracy, &stop);
    let (found, solve_s) = timed(|| py.detach(|| watch.over(work)));
    watch.end()?;
    let fit = joined(found)?.map_err(|why| not_fitted(py, &why))?;
    let report = FitReport { scene, file, measured: &measured, fit: &fit, solve_s };
    Ok((FitSummary::new(&report).to_json()?, report.fitted_scene().to_toml()))
}

fn measured_point((displacement, force, force_error): (f64, f64, Option<f64>)) -> MeasuredPoint {
    MeasuredPoint { displacement, force, force_error }
}

fn not_fitted(py: Python, why: &NoFit) -> PyErr {
    refused(py, why.to_string(), &why.remedy().to_string())
}

/// What is to be fitted of a scene.
fn fit_problem<'s>(py: Python, scene: &'s Scene) -> PyResult<FitProblem<'s>> {
    let parameters = scene
        .fit_parameters()
        .map_err(|problem| refused(py, format!("`fit.parameters` {}", problem.found), &problem.remedy))?;
    if parameters.is_empty() {
        return Err(not_fitted(py, &NoFit::NoParameters));
    }
    if scene.model.friction_law().is_some() {
        let found =
            "a curve with friction is not fitted: what the beam does depends on its past, and has no derivative";
        return Err(refused(py, found.into(), "Remove the table `friction` from the scene."));
    }
    if scene.accuracy.terms == Terms::Auto {
        let found = "a fit takes the model with all of its terms, and the scene has terms = \"auto\"";
        return Err(refused(py, found.into(), "Give `with_(\"terms\", \"all\")`."));
    }
    let keys: Vec<String> = parameters.iter().map(|parameter| parameter.key.clone()).collect();
    let model =
        move |values: &[f64]| scene.with_numbers(keys.iter().map(String::as_str).zip(values.iter().copied())).model;
    Ok(FitProblem { parameters, model: Box::new(model) })
}

/// What the distributions of a table [uncertainty] make of the results: the summary, and how many samples were cut short.
#[pyfunction]
pub fn uncertainty(py: Python, scene: &NativeScene) -> PyResult<(String, usize)> {
    let (source, watch) = (scene.source.clone(), Watch::begin());
    let scene = &source.scene;
    let Some(table) = scene.uncertainty.as_ref() else {
        let remedy = "Add a table `uncertainty` with for example inputs = [{ key = \"strip.height\", distribution = \"normal\", deviation = \"0.5 nm\" }].";
        return Err(refused(py, "nothing is uncertain in this scene: it lacks the table [uncertainty]".into(), remedy));
    };
    let design = Design::new(table.plan(scene))
        .map_err(|error| refused(py, error.to_string(), "Change the table `uncertainty`."))?;
    let (found, solve_s) = timed(|| py.detach(|| watch.over(|| sampled(&source, design, &watch))));
    watch.end()?;
    let Some(analysis) = joined(found)? else { return Err(computation_error(py, "no sample was computed".into())) };
    let summary = UncertaintySummary::new(scene, &analysis, solve_s).to_json()?;
    Ok((summary, analysis.cut_short().iter().map(|of| of.count).sum()))
}

/// The sample, and beside it what derivatives give; nothing where the scene has no table.
fn sampled(source: &Source, design: Design, watch: &Watch) -> Option<Analysis> {
    let scene = &source.scene;
    let table = scene.uncertainty.as_ref()?;
    let model =
        |values: &[f64]| table.model(scene, values).map_err(|error| format!("{}. {}", error.found, error.remedy));
    let stop = || watch.on(scene.bounds.from_now());
    let peel = SampledPeel { model: &model, of: &table.quantities, accuracy: &scene.accuracy, stop: &stop };
    let taylors = taylor_polynomials(design.plan(), &peel);
    let alone = one_at_a_time(design.plan(), ALONE_AT, &peel);
    let run = |at| peel.outcome(&design.inputs(at));
    let outcomes = sample(&design, &|| !watch.interrupted(), &run);
    Some(Analysis::new(design, &table.quantities, outcomes, taylors, alone))
}
