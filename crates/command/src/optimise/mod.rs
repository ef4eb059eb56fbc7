//! `peel optimise`: the best design of a scene that says what is free.

mod help;
mod kept;

use crate::command_line::command_line;
use crate::input::SceneArgs;
use crate::output::{OutArgs, list_files, say};
use crate::stop::Stop;
use crate::text_summary;
use clap::Args;
use kept::Keeper;
use peelkit::study::optimisation::{DesignProblem, NoOptimum, OptimisationOptions, Optimum, optimise as find};
use peelkit_report::{self as report, OptimisationSummary, OutputFolder, ReportError};
use peelkit_scene::{OptimisationTable, Scene};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Optimises keys of a scene, or width and height along the body
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::long())]
pub struct Optimise {
    #[command(flatten)]
    pub scene: SceneArgs,

    #[command(flatten)]
    pub out: OutArgs,

    /// Prints one JSON object only; writes files only if --out is given
    #[arg(long)]
    pub json: bool,

    /// Discards the checkpoint of an interrupted optimisation and starts anew
    #[arg(long)]
    pub fresh: bool,
}

pub fn optimise(args: &Optimise) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let (table, problem) =
        scene.optimisation.as_ref().zip(scene.design_problem()).ok_or_else(|| without_table(&scene))?;
    let command = command_line();
    let keeper = Keeper::open(args, &scene, table.starts * table.evaluations)?;
    let started = Instant::now();
    let optimum = found(&scene, table, &problem, &keeper)?;
    let solve_s = started.elapsed().as_secs_f64();
    let summary = OptimisationSummary::new(&scene, &problem, &optimum, solve_s).with_command(&command);
    let files = match &keeper.output {
        Some(output) => write(output, &scene, &command, (&problem, &optimum), &summary),
        None => Ok(Vec::new()),
    };
    if files.is_ok() && !optimum.unfinished {
        keeper.discard()?;
    }
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        let taken = keeper.taken_text();
        let text = text_summary::optimum(&scene, &problem, &optimum, solve_s);
        say(&format!("{text}{taken}\n{}", list_files(&files)))?;
    }
    files?;
    if optimum.unfinished {
        let designs: usize = optimum.searches.iter().map(|search| search.evaluations.len()).sum();
        let goes_on = match keeper.output {
            Some(_) => "the same command resumes from there, --fresh starts anew",
            None => "nothing was kept, because no folder was given with --out",
        };
        return Err(Stop::cut_short(format!("interrupted, {designs} designs are evaluated; {goes_on}")));
    }
    Ok(())
}

fn without_table(scene: &Scene) -> Stop {
    Stop::bad_input(
        format!("{}: nothing is free in this scene: it lacks the table [optimise]", scene.name),
        "Add a line [optimise] and below it for example objective = \"initiation_peak.force_nN\" and width = { from = \"5 nm\", to = \"20 nm\" }; \
         `peel keys optimise` lists its keys.",
    )
}

/// The search, with what is kept of it.
fn found(scene: &Scene, table: &OptimisationTable, problem: &DesignProblem, keeper: &Keeper) -> Result<Optimum, Stop> {
    let options = OptimisationOptions {
        stop: &|| scene.bounds.from_now(),
        go_on: &|| keeper.goes_on(),
        known: &|coordinates| keeper.known(coordinates),
        keep: &|_, design| keeper.keep(design),
        ..table.options(scene.accuracy)
    };
    let result = find(problem, &options);
    keeper.finish()?;
    result.map_err(|error| match error {
        NoOptimum::AllBad { .. } => Stop::cut_short(error),
        error => Stop::bad_input(
            format!("{}: there is no optimum: {error}", scene.name),
            "Change the table [optimise]; `peel run` of the same scene shows what its peel has.",
        ),
    })
}

fn write(
    output: &OutputFolder,
    scene: &Scene,
    command: &str,
    (problem, optimum): (&DesignProblem, &Optimum),
    summary: &OptimisationSummary,
) -> Result<Vec<PathBuf>, ReportError> {
    output.write(|dir| {
        let mut files = vec![summary.write(dir)?, report::write_history(dir, problem, optimum)?];
        files.extend(optimum_scene(dir, scene, optimum)?);
        files.push(report::write_parameters(dir, scene, command)?);
        files.extend(report::draw_optimum(problem, optimum, &scene.title, dir)?);
        Ok(files)
    })
}

/// The best design as a scene of its own.
fn optimum_scene(dir: &Path, scene: &Scene, optimum: &Optimum) -> Result<Option<PathBuf>, ReportError> {
    let Some(best) = scene.of_design(&optimum.after.values) else { return Ok(None) };
    let path = dir.join("optimum.toml");
    report::write_whole(&path, best.to_toml().as_bytes())?;
    Ok(Some(path))
}
