//! `peel accuracy`: computing time against error.

use crate::terminal::command_line::command_line;
use crate::terminal::folder_name::default_folder;
use crate::terminal::help;
use crate::terminal::input::{SceneArgs, parse_override};
use crate::terminal::output::{OutArgs, list_files, progress_bar, say};
use crate::terminal::stop::Stop;
use clap::Args;
use peelkit_checks::{AUTOMATIC, Trial, WorkPrecision, work_precision, write_work_precision};
use peelkit_report::write_parameters;
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// Measures computing time against error over orders, elements, meshes, forms and steps
#[derive(Args)]
#[command(after_long_help = help::accuracy(), mut_arg("out", |out| out.help(FOLDER)))]
pub struct Accuracy {
    /// The scene: a TOML file [default: the strip of 100 nm that `peel new` writes]
    #[arg(value_name = "SCENE")]
    path: Option<PathBuf>,

    /// Sets a key of the scene: strip.length="50 nm"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_override)]
    overrides: Vec<(String, String)>,

    #[command(flatten)]
    out: OutArgs,
}

const FOLDER: &str = "Folder for the outputs [default: out/accuracy, named after what is asked]";

/// The scene where none is given.
const PLAIN: &str = include_str!("../../scenes/strip-100nm.toml");

pub fn accuracy(args: &Accuracy) -> Result<(), Stop> {
    let overrides = args.overrides.clone();
    let scene = match &args.path {
        Some(path) => SceneArgs { path: path.clone(), overrides }.load()?,
        None => Scene::parse("strip-100nm.toml", PLAIN, &overrides)?,
    };
    let folder = args.out.out.clone().unwrap_or_else(|| {
        let stem = args.path.as_ref().and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy().into_owned());
        default_folder(Path::new("accuracy"), stem.as_slice(), &args.overrides)
    });
    let folder = args.out.claim(&folder, None)?;
    let bar = progress_bar(0);
    let measured = work_precision(&scene.model, &scene.bounds, &|lines| {
        bar.set_length(lines as u64);
        bar.inc(1);
    });
    bar.finish_and_clear();
    let measured = measured.map_err(|reason| Stop::cut_short(&reason))?;
    let files = folder.write(|dir| {
        let mut files = write_work_precision(dir, &measured, &scene.title)?;
        files.push(write_parameters(dir, &scene, &command_line())?);
        Ok(files)
    });
    say(&format!("{}\n{}", table(&measured), list_files(&files)))?;
    files?;
    Ok(())
}

/// The automatic choice, and the fastest run with no larger error.
fn table(measured: &WorkPrecision) -> String {
    let mut text = format!("{AUTOMATIC}; errors against a refined run, CPU time on one core\n\n");
    text += "requested  error of points  of curve      time  order  elements  points  iterations  fastest run with no larger error\n";
    for trial in &measured.automatic {
        text += &line(measured, trial);
    }
    text
}

fn line(measured: &WorkPrecision, trial: &Trial) -> String {
    let error = trial.errors.points();
    let faster = error.and_then(|error| measured.best(error)).filter(|best| best.0 < trial.seconds);
    let best = faster.map_or("this one".into(), |(seconds, name)| {
        format!("{:.2} ms, {name} (this takes {:.2} times that)", 1e3 * seconds, trial.seconds / seconds)
    });
    let effort = trial.effort;
    format!(
        "{:8.0e}   {:>15}   {:8.1e}  {:5.2} ms  {:5}  {:8}  {:6}  {:10}  {best}\n",
        trial.accuracy.relative,
        error.map_or("none".into(), |error| format!("{error:.1e}")),
        trial.errors.curve,
        1e3 * trial.seconds,
        effort.order,
        effort.elements,
        effort.points,
        effort.newton_iterations,
    )
}
