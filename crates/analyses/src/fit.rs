//! Parameters of a scene from a measured force-displacement curve.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::Pulls;
use crate::session::{Parts, Session};
use peelkit::study::{
    self, CurveBy, Fit, FitDataError, FitEnd, FitParameter, FitProblem, MeasuredCurve, MeasuredPoint, NoFit,
    ParameterOf, StopCriteria, Terms,
};
use peelkit_report::overlay::read_force_curve;
use peelkit_report::{self as report, FitReport, FitSummary, ReportError, timed};
use peelkit_scene::{FitTable, Scene};
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
}

impl<'s> Fitting<'s> {
    /// Of a scene to a curve.
    ///
    /// Fails where nothing can be fitted of the scene, where the file cannot be read, and where the curve is none that can be fitted.
    pub fn of(scene: &'s Scene, data: Data) -> Result<Self, Refusal> {
        let table = scene.fit.clone().unwrap_or_default();
        let parameters = parameters(scene)?;
        let (file, points) = match data {
            Data::File(path) => {
                let points = read_force_curve(path).map_err(|error| Refusal::asked(&error, &error.remedy))?;
                (path.display().to_string(), points)
            }
            Data::Points(name, points) => (name.to_owned(), points),
        };
        let wrong = |why: FitDataError| Refusal::asked(format!("{file} {why}"), why.remedy());
        let measured = MeasuredCurve::new(points, table.jump).map_err(wrong)?;
        Ok(Self { scene, table, parameters, file, measured })
    }
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
}

impl Analysis for Fitting<'_> {
    type Found = FitOutcome;

    fn run(&self, session: &Session) -> Result<FitOutcome, Refusal> {
        let Self { scene, table, parameters, file, measured } = self;
        let stop = || session.stop(scene);
        let keys = || parameters.iter().map(|parameter| parameter.key.as_str());
        let with = |values: &[f64]| scene.with_numbers(keys().zip(values.iter().copied()));
        let pulls = Pulls::like(scene);
        let varied = parameters.iter().filter(|parameter| parameter.of == ParameterOf::Model).count();
        let meter = pulls.as_ref().map(|pulls| (pulls, pulls.meter(session, Parts::AStep(1 + 2 * varied))));
        let curve = match &meter {
            None => CurveBy::Peel,
            Some((pulls, meter)) => {
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
        Ok(FitOutcome { fit, measured: measured.clone(), file: file.clone(), seconds })
    }
}

impl FitOutcome {
    /// What is reported of the fit of a scene.
    pub fn report<'f>(&'f self, scene: &'f Scene) -> FitReport<'f> {
        let Self { fit, measured, file, seconds } = self;
        FitReport { scene, file, measured, fit, solve_s: *seconds }
    }
}

impl Outcome for FitOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(FitSummary::new(&self.report(scene)), command, FitSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let of = self.report(scene);
        let mut files = vec![FitSummary::new(&of).with_command(command).write(dir)?];
        files.extend(report::write_fit(dir, &self.fit)?);
        files.push(report::write_parameters(dir, &of.fitted_scene(), command)?);
        files.extend(report::draw_fit(&self.measured, &self.fit, &scene.title, dir)?);
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
