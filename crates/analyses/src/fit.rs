//! Parameters of a scene from a measured force-displacement curve, or from steady forces against a key.

use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::numbers::Pulls;
use crate::session::{Parts, Session};
use peelkit::study::{
    self, CurveBy, DisplacementError, Fit, FitCurve, FitDataError, FitEnd, FitParameter, FitProblem, MeasuredCurve,
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
    /// The curves that the table `fit` of the scene names
    OfScene,
}

/// A curve that was measured, as it was read.
#[derive(Clone, Debug)]
struct Record {
    /// Its name
    file: String,
    measured: MeasuredCurve,
    /// d and f where they are not fitted, nm and nN
    zeros: [f64; 2],
    /// The scene with the numbers that are others for it
    scene: Scene,
}

/// A scene, and measured curves that are fitted.
pub struct Fitting<'s> {
    scene: &'s Scene,
    table: FitTable,
    parameters: Vec<FitParameter>,
    records: Vec<Record>,
    /// The key against which steady forces were measured; none of a curve
    against: Option<&'static Key>,
}

impl<'s> Fitting<'s> {
    /// Of a scene to what was measured.
    ///
    /// Fails where nothing can be fitted of the scene, where a file cannot be read, and where a curve is none that can be fitted.
    pub fn of(scene: &'s Scene, data: Data) -> Result<Self, Refusal> {
        let table = scene.fit.clone().unwrap_or_default();
        let parameters = parameters(scene)?;
        let mut fitting = Self { scene, table, parameters, records: Vec::new(), against: None };
        match (fitting.table.curves.is_empty(), data) {
            (true, Data::OfScene) => {
                return Err(Refusal::asked(
                    "there is nothing to fit to: no data were given, and the scene names none",
                    "Give --data CSV, or the curves in the scene: curves = [{ data = \"at-90.csv\" }] under [fit].",
                ));
            }
            (false, Data::OfScene) => {
                for (index, curve) in fitting.table.curves.clone().iter().enumerate() {
                    let own = scene.of_curve(index);
                    let (file, record) = read(&scene.beside(&curve.data), &fitting.table, &own)?;
                    if let Some(key) = record.against {
                        return Err(Refusal::asked(
                            format!(
                                "{file} has steady forces against `{}`, and `fit.curves` takes curves alone",
                                key.path()
                            ),
                            "Give --data CSV with steady forces, and remove `fit.curves`.",
                        ));
                    }
                    let zeros = [
                        curve.displacement_zero.unwrap_or(fitting.table.displacement_zero),
                        curve.force_zero.unwrap_or(fitting.table.force_zero),
                    ];
                    fitting.add(own, file, record.points, zeros, curve.jump)?;
                }
            }
            (false, _) => {
                return Err(Refusal::asked(
                    "data are given beside `fit.curves` of the scene, which name their own",
                    "Omit --data, or remove `curves` under [fit].",
                ));
            }
            (true, Data::File(path)) => {
                let (file, record) = read(path, &fitting.table, scene)?;
                fitting.add_record(file, record)?;
            }
            (true, Data::Points(name, points)) => {
                fitting.add_record(name.to_owned(), ForceRecord { points, against: None })?;
            }
        }
        Ok(fitting)
    }

    /// A curve, or steady forces.
    fn add_record(&mut self, file: String, ForceRecord { points, against }: ForceRecord) -> Result<(), Refusal> {
        let zeros = [self.table.displacement_zero, self.table.force_zero];
        let Some(key) = against else { return self.add(self.scene.clone(), file, points, zeros, None) };
        no_steady_force(self.scene, key, &self.parameters)?;
        if points.len() < FEWEST_FORCES {
            let (points, least) = (points.len(), FEWEST_FORCES);
            return Err(wrong(&file, FitDataError::TooFew { points, least, before_jump: None }));
        }
        self.table.options.displacement_error = DisplacementError::None;
        self.against = Some(key);
        let scene = self.scene.clone();
        self.records.push(Record { file, measured: steady(points), zeros: [0.0, zeros[1]], scene });
        Ok(())
    }

    /// A curve of a scene, with its zeros and, where it is not that of all, the displacement of its first jump.
    fn add(
        &mut self,
        scene: Scene,
        file: String,
        points: Vec<MeasuredPoint>,
        zeros: [f64; 2],
        jump: Option<f64>,
    ) -> Result<(), Refusal> {
        let curve = self.records.len();
        let is_fitted = self.parameters.iter().any(|parameter| parameter.of == ParameterOf::ForceZero { curve });
        let zero = Some(zeros[1]).filter(|_| !is_fitted);
        let measured = MeasuredCurve::new(points, jump.or(self.table.jump), zero).map_err(|why| wrong(&file, why))?;
        self.records.push(Record { file, measured, zeros, scene });
        Ok(())
    }
}

/// What is wrong with a file.
fn wrong(file: &str, why: FitDataError) -> Refusal {
    Refusal::asked(format!("{file} {why}"), why.remedy())
}

/// Reads a file that was measured with the body of a scene.
fn read(path: &Path, table: &FitTable, scene: &Scene) -> Result<(String, ForceRecord), Refusal> {
    let width = scene.model.strip().map(|strip| strip.width);
    let record =
        read_force_curve(path, &table.columns, width).map_err(|error| Refusal::asked(&error, &error.remedy))?;
    Ok((path.display().to_string(), record))
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
    let fitted = |parameter: &&FitParameter| {
        parameter.key == path || matches!(parameter.of, ParameterOf::DisplacementZero { .. })
    };
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
    if !scene.model.adhesion.healing {
        return Err(Refusal::asked(
            "a curve of an adhesion that does not heal is not fitted: what it does depends on its past, and has no derivative",
            "Remove `adhesion.healing` from the scene: as long as nothing that has opened closes again, the curve is the same.",
        ));
    }
    if scene.model.yields() {
        return Err(Refusal::asked(
            "a curve of a film that yields is not fitted: what it does depends on its past, and has no derivative",
            "Remove `strip.yield_strength` from the scene, or vary it with peel sweep.",
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
    /// What was fitted, each with where it was read from
    pub measured: Vec<(String, MeasuredCurve)>,
    /// That the fit took
    pub seconds: f64,
    /// The key against which steady forces were measured; none of a curve
    pub against: Option<&'static Key>,
}

impl Analysis for Fitting<'_> {
    type Found = FitOutcome;

    fn run(&self, session: &Session) -> Result<FitOutcome, Refusal> {
        let Self { scene, table, parameters, records, against } = self;
        let stop = || session.stop(scene);
        let pulls = Pulls::like(scene);
        let varied = parameters.iter().filter(|parameter| parameter.of == ParameterOf::Model).count();
        let steps = records.len() * (1 + 2 * varied);
        let meter = pulls.as_ref().map(|pulls| (pulls, pulls.meter(session, Parts::AStep(steps))));
        let curves = records.iter().map(|record| {
            let with = move |values: &[f64]| {
                let keys = parameters.iter().map(|parameter| parameter.key.as_str());
                record.scene.with_numbers(keys.zip(values.iter().copied()))
            };
            let by = match (&meter, against) {
                (None, None) => CurveBy::Peel,
                (None, Some(key)) => CurveBy::Values(Box::new(move |values, stop: &StopCriteria| {
                    let at = record.measured.points.iter().map(|point| point.displacement);
                    steady_forces(&with(values), key, at, stop)
                })),
                (Some((pulls, meter)), _) => CurveBy::Values(Box::new(move |values, stop: &StopCriteria| {
                    meter.over(|| pulls.curve(&with(values), stop))
                })),
            };
            let [displacement_zero, force_zero] = record.zeros;
            let model = Box::new(move |values: &[f64]| with(values).model);
            FitCurve { measured: record.measured.clone(), model, by, displacement_zero, force_zero }
        });
        let problem = FitProblem { parameters: parameters.clone(), curves: curves.collect() };
        let (found, seconds) = timed(|| {
            if let Some(pulls) = &pulls {
                records.iter().for_each(|record| pulls.prepare(&record.scene, &stop()));
            }
            study::fit(&problem, &table.options, &scene.accuracy, &stop)
        });
        let fit = match found {
            Err(_) if session.watcher.asked() => {
                return Err(Refusal::cut_short("interrupted before anything was found"));
            }
            found => found.map_err(|why| of_scene(&why))?,
        };
        let measured = records.iter().map(|record| (record.file.clone(), record.measured.clone())).collect();
        Ok(FitOutcome { fit, measured, seconds, against: *against })
    }
}

impl FitOutcome {
    /// What is reported of the fit of a scene.
    pub fn report<'f>(&'f self, scene: &'f Scene) -> FitReport<'f> {
        let Self { fit, measured, seconds, against } = self;
        FitReport { scene, measured, fit, solve_s: *seconds, against: *against }
    }
}

/// The same with the files of its curves by their whole paths, so that it can be fitted wherever it is written.
fn found_anywhere(mut scene: Scene) -> Scene {
    let Some(mut table) = scene.fit.take() else { return scene };
    for curve in &mut table.curves {
        if let Ok(path) = std::path::absolute(scene.beside(&curve.data)) {
            curve.data = path.display().to_string();
        }
    }
    Scene { fit: Some(table), ..scene }
}

impl Outcome for FitOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(FitSummary::new(&self.report(scene)), command, FitSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let of = self.report(scene);
        let mut files = vec![FitSummary::new(&of).with_command(command).write(dir)?];
        files.extend(report::write_fit(dir, &self.fit, self.against)?);
        files.push(report::write_parameters(dir, &found_anywhere(of.fitted_scene()), command)?);
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
