//! `peel fit`: parameters of a scene from a measured force-displacement curve.

mod help;

use crate::command_line::command_line;
use crate::input::SceneArgs;
use crate::interrupt::Interrupt;
use crate::output::{OutArgs, list_files, say};
use crate::stop::Stop;
use crate::text_summary;
use clap::Args;
use indicatif::ProgressBar;
use peelkit::study::{self, FitDataError, FitEnd, FitProblem, MeasuredCurve, NoFit, Terms};
use peelkit_report::overlay::read_force_curve;
use peelkit_report::{self as report, FitReport, FitSummary, ReportError, timed};
use peelkit_scene::{FitTable, Scene};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Determines parameters of a scene from a measured force-displacement curve, with intervals
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::LONG)]
pub struct Fit {
    #[command(flatten)]
    scene: SceneArgs,

    /// The measured curve: a CSV with displacement, force and, if known, its error
    ///
    /// The header has names and units: displacement_nm,force_nN or u (um),P (mN),P error (mN).
    #[arg(long, value_name = "CSV", required = true)]
    data: PathBuf,

    #[command(flatten)]
    out: OutArgs,

    /// Prints summary.json alone; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

impl Fit {
    /// Where files go, if they are written.
    fn folder(&self) -> Option<PathBuf> {
        let data = self.data.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match &self.out.out {
            None if self.json => None,
            None => Some(self.scene.default_folder(&["fit".to_owned(), data])),
            given => given.clone(),
        }
    }
}

pub fn fit(args: &Fit) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let table = scene.fit.clone().unwrap_or_default();
    let file = args.data.display().to_string();
    let problem = problem(&scene, &args.scene.path)?;
    let measured = measured(&args.data, &table)?;
    let folder = args.folder().map(|folder| args.out.claim(&folder)).transpose()?;
    let bar = ProgressBar::new_spinner().with_message("fitting");
    bar.enable_steady_tick(Duration::from_millis(200));
    let above = bar.clone();
    let interrupt = Interrupt::listen(move || {
        above.println("stopping: the best parameters so far are kept; Ctrl-C again stops at once")
    });
    let stop = || interrupt.ends(scene.bounds.from_now());
    let (found, solve_s) = timed(|| study::fit(&problem, &measured, &table.options, &scene.accuracy, &stop));
    bar.finish_and_clear();
    let fit = match found {
        Err(_) if interrupt.asked() => return Err(Stop::cut_short("interrupted before anything was found")),
        found => found.map_err(|why| of_scene(&args.scene.path, &why))?,
    };
    let report = FitReport { scene: &scene, file: &file, measured: &measured, fit: &fit, solve_s };
    let command = command_line();
    let summary = FitSummary::new(&report).with_command(&command);
    let files = folder.map_or(Ok(Vec::new()), |folder| folder.write(|dir| write(dir, &report, &summary, &command)));
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::fit(&report), list_files(&files)))?;
    }
    files?;
    match &fit.end {
        FitEnd::Converged => Ok(()),
        FitEnd::Stopped(why) => Err(Stop::cut_short(format!("the search for the best parameters: {why}"))),
        FitEnd::Interrupted => Err(Stop::cut_short(
            "interrupted; the best parameters so far are written: parameters.toml is a scene that the search begins at if it is fitted again",
        )),
    }
}

/// What is to be fitted of a scene.
fn problem<'s>(scene: &'s Scene, path: &Path) -> Result<FitProblem<'s>, Stop> {
    let parameters = scene.fit_parameters().map_err(|problem| Stop::bad_argument("`fit.parameters`", &problem))?;
    if parameters.is_empty() {
        return Err(of_scene(path, &NoFit::NoParameters));
    }
    if scene.model.friction_law().is_some() {
        return Err(Stop::bad_input(
            "a curve with friction is not fitted: what the beam does depends on its past, and has no derivative",
            "Remove the table [friction] from the scene.",
        ));
    }
    if scene.accuracy.terms == Terms::Auto {
        return Err(Stop::bad_input(
            "a fit takes the model with all of its terms, and the scene has terms = \"auto\"",
            "Give --set terms=all.",
        ));
    }
    let keys: Vec<String> = parameters.iter().map(|parameter| parameter.key.clone()).collect();
    let model =
        move |values: &[f64]| scene.with_numbers(keys.iter().map(String::as_str).zip(values.iter().copied())).model;
    Ok(FitProblem { parameters, model: Box::new(model) })
}

/// The measured curve.
fn measured(path: &Path, table: &FitTable) -> Result<MeasuredCurve, Stop> {
    let points = read_force_curve(path)?;
    MeasuredCurve::new(points, table.jump)
        .map_err(|why: FitDataError| Stop::bad_input(format!("{} {why}", path.display()), why.remedy()))
}

/// Why a scene is not fitted.
fn of_scene(path: &Path, why: &NoFit) -> Stop {
    Stop::bad_input(format!("{}: {why}", path.display()), why.remedy())
}

fn write(dir: &Path, report: &FitReport, summary: &FitSummary, command: &str) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![summary.write(dir)?];
    files.extend(report::write_fit(dir, report.fit)?);
    files.push(report::write_parameters(dir, &report.fitted_scene(), command)?);
    files.extend(report::draw_fit(report.measured, report.fit, &report.scene.title, dir)?);
    Ok(files)
}
