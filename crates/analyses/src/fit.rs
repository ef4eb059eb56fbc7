//! Parameters of a scene from a measured force-displacement curve, or from steady forces against a key.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::numbers::Pulls;
use crate::session::{Parts, Session};
use peelkit::model::Body;
use peelkit::study::{
    self, CurveBy, DisplacementError, Fit, FitDataError, FitEnd, FitParameter, FitProblem, MeasuredCurve,
    MeasuredPoint, NoFit, ParameterOf, PulledCurve, StopCriteria, Terms,
};
use peelkit_report::overlay::{ForceRecord, read_force_curve};
use peelkit_report::{self as report, FitReport, FitSummary, ReportError, timed};
use peelkit_scene::{FitTable, Key, Scene};
use std::io;
use std::path::{Path, PathBuf};

/// What was measured.
#[derive(Clone, Debug)]
pub enum Data<'d> {
    /// A table in CSV with units in its header
    File(&'d Path),
    /// Points, under this name
    Points(&'d str, Vec<MeasuredPoint>),
}

/// A scene, and a measured curve that is fitted.
pub struct Fitting<'s> {
    scene: &'s Scene,
    table: FitTable,
    parameters: Vec<FitParameter>,
    file: String,
    measured: MeasuredCurve,
    /// The key against which steady forces were measured; none of a curve
    against: Option<&'static Key>,
}

impl<'s> Fitting<'s> {
    /// Of a scene to a curve.
    ///
    /// Fails where nothing can be fitted of the scene, where the file cannot be read, and where the curve is none that can be fitted.
    pub fn of(scene: &'s Scene, data: Data) -> Result<Self, Refusal> {
        let mut table = scene.fit.clone().unwrap_or_default();
        let parameters = parameters(scene)?;
        let (file, record) = match data {
            Data::File(path) => {
                let width = match &scene.model.body {
                    Body::Strip(strip) => Some(strip.width),
                    _ => None,
                };
                let record = read_force_curve(path, &table.columns, width)
                    .map_err(|error| Refusal::asked(&error, &error.remedy))?;
                (path.display().to_string(), record)
            }
            Data::Points(name, points) => (name.to_owned(), ForceRecord { points, against: None }),
        };
        let wrong = |why: FitDataError| Refusal::asked(format!("{file} {why}"), why.remedy());
        let is_fitted = parameters.iter().any(|parameter| parameter.of == ParameterOf::ForceZero);
        let zero = Some(table.options.force_zero).filter(|_| !is_fitted);
        let ForceRecord { points, against } = record;
        let measured = match against {
            None => MeasuredCurve::new(points, table.jump, zero).map_err(wrong)?,
            Some(key) => {
                no_steady_force(scene, key, &parameters)?;
                if points.len() < FEWEST_FORCES {
                    let (points, least) = (points.len(), FEWEST_FORCES);
                    return Err(wrong(FitDataError::TooFew { points, least, before_jump: None }));
                }
                table.options.displacement_error = DisplacementError::None;
                table.options.displacement_zero = 0.0;
                steady(points)
            }
        };
        Ok(Self { scene, table, parameters, file, measured, against })
    }
}

/// Fewest steady forces.
const FEWEST_FORCES: usize = 2;

/// Steady forces in the order of the values at which they were measured.
fn steady(mut points: Vec<MeasuredPoint>) -> MeasuredCurve {
    points.sort_by(|a, b| a.displacement.total_cmp(&b.displacement));
    MeasuredCurve { points, jump: None, behind_jump: Vec::new(), rest: None }
}

/// Why steady forces of a scene are not fitted against a key.
fn no_steady_force(scene: &Scene, key: &Key, parameters: &[FitParameter]) -> Result<(), Refusal> {
    if Pulls::like(scene).is_some() {
        return Err(Refusal::asked(
            "steady forces are those of a peel, and the scene is a seta or a pull at a rate",
            "Remove its table, or give a whole curve.",
        ));
    }
    let path = key.path();
    let fitted = |parameter: &&FitParameter| parameter.key == path || parameter.of == ParameterOf::DisplacementZero;
    match parameters.iter().find(fitted) {
        Some(parameter) => Err(Refusal::asked(
            format!("`{}` is to be fitted to steady forces against `{path}`, which do not have it", parameter.key),
            format!("Remove `{}` from `fit.parameters`.", parameter.key),
        )),
        None => Ok(()),
    }
}

/// Steady forces of a scene at the values of a key.
fn steady_forces(
    scene: &Scene,
    key: &Key,
    values: impl Iterator<Item = f64>,
    stop: &StopCriteria,
) -> Result<PulledCurve, String> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for value in values {
        if points.last().is_some_and(|last| last.0 == value) {
            continue;
        }
        let path = key.path();
        let at = scene.with_numbers([(path.as_str(), value)]);
        at.model.check().map_err(|why| why.to_string())?;
        let peel = study::peel(&at.model, &at.accuracy, stop);
        let Some(plateau) = peel.plateau else {
            return Err(format!("at {path} = {value} {} its path has no plateau, the steady force", key.unit()));
        };
        points.push((value, plateau.force));
    }
    Ok(PulledCurve::of(points))
}

/// What is to be fitted of a scene.
fn parameters(scene: &Scene) -> Result<Vec<FitParameter>, Refusal> {
    let parameters = scene.fit_parameters().map_err(|problem| Refusal::value("`fit.parameters`", &problem))?;
    if parameters.is_empty() {
        return Err(of_scene(&NoFit::NoParameters));
    }
    if scene.model.friction_law().is_some() {
        return Err(Refusal::asked(
            "a curve with friction is not fitted: what the beam does depends on its past, and has no derivative",
            "Remove the table [friction] from the scene.",
        ));
    }
    if scene.accuracy.terms == Terms::Auto {
        return Err(Refusal::asked(
            "a fit takes the model with all of its terms, and the scene has terms = \"auto\"",
            "Give --set terms=all.",
        ));
    }
    Ok(parameters)
}

/// Why a scene is not fitted.
fn of_scene(why: &NoFit) -> Refusal {
    Refusal::scene(why, why.remedy())
}

/// The parameters that were found.
pub struct FitOutcome {
    /// The fit
    pub fit: Fit,
    /// What was fitted
    pub measured: MeasuredCurve,
    /// Where that was read from
    pub file: String,
    /// That the fit took
    pub seconds: f64,
    /// The key against which steady forces were measured; none of a curve
    pub against: Option<&'static Key>,
}

impl Analysis for Fitting<'_> {
    type Found = FitOutcome;

    fn run(&self, session: &Session) -> Result<FitOutcome, Refusal> {
        let Self { scene, table, parameters, file, measured, against } = self;
        let stop = || session.stop(scene);
        let keys = || parameters.iter().map(|parameter| parameter.key.as_str());
        let with = |values: &[f64]| scene.with_numbers(keys().zip(values.iter().copied()));
        let pulls = Pulls::like(scene);
        let varied = parameters.iter().filter(|parameter| parameter.of == ParameterOf::Model).count();
        let meter = pulls.as_ref().map(|pulls| (pulls, pulls.meter(session, Parts::AStep(1 + 2 * varied))));
        let curve = match (&meter, against) {
            (None, None) => CurveBy::Peel,
            (None, Some(key)) => CurveBy::Values(Box::new(|values, stop: &StopCriteria| {
                let at = measured.points.iter().map(|point| point.displacement);
                steady_forces(&with(values), key, at, stop)
            })),
            (Some((pulls, meter)), _) => {
                CurveBy::Values(Box::new(|values, stop: &StopCriteria| meter.over(|| pulls.curve(&with(values), stop))))
            }
        };
        let model = Box::new(|values: &[f64]| with(values).model);
        let problem = FitProblem { parameters: parameters.clone(), model, curve };
        let (found, seconds) = timed(|| {
            if let Some(pulls) = &pulls {
                pulls.prepare(scene, &stop());
            }
            study::fit(&problem, measured, &table.options, &scene.accuracy, &stop)
        });
        let fit = match found {
            Err(_) if session.watcher.asked() => {
                return Err(Refusal::cut_short("interrupted before anything was found"));
            }
            found => found.map_err(|why| of_scene(&why))?,
        };
        Ok(FitOutcome { fit, measured: measured.clone(), file: file.clone(), seconds, against: *against })
    }
}

impl FitOutcome {
    /// What is reported of the fit of a scene.
    pub fn report<'f>(&'f self, scene: &'f Scene) -> FitReport<'f> {
        let Self { fit, measured, file, seconds, against } = self;
        FitReport { scene, file, measured, fit, solve_s: *seconds, against: *against }
    }
}

impl Outcome for FitOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(FitSummary::new(&self.report(scene)), command, FitSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let of = self.report(scene);
        let mut files = vec![FitSummary::new(&of).with_command(command).write(dir)?];
        files.extend(report::write_fit(dir, &self.fit, self.against)?);
        files.push(report::write_parameters(dir, &of.fitted_scene(), command)?);
        files.extend(report::draw_fit(&of, dir)?);
        Ok(files)
    }

    fn end(&self) -> End {
        match &self.fit.end {
            FitEnd::Converged => End::Done,
            FitEnd::Stopped(why) => End::CutShort(format!("the search for the best parameters: {why}")),
            FitEnd::Interrupted => End::CutShort(
                "interrupted; the best parameters so far are written: parameters.toml is a scene that the search begins at if it is fitted again"
                    .to_owned(),
            ),
        }
    }
}
