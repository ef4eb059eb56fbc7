//! `peel uncertainty`: keys of a scene that have distributions, sampled and propagated.

mod kept;
mod setae;

use crate::command_line::command_line;
use crate::help;
use crate::input::SceneArgs;
use crate::output::{OutArgs, list_files, say};
use crate::seta::Setae;
use crate::stop::Stop;
use crate::text_summary;
use clap::Args;
use kept::Sampler;
use peelkit::study::uncertainty::{
    ALONE_AT, Analysis, DerivativesBy, Design, Outcome, SampledPeel, one_at_a_time, taylor_by_differences,
    taylor_polynomials,
};
use peelkit_report::{self as report, OutputFolder, ReportError, UncertaintySummary};
use peelkit_scene::{Scene, UncertaintyTable};
use setae::SampledSeta;
use std::path::PathBuf;
use std::time::Instant;

/// Samples uncertain keys of a scene: mean, quantiles, sensitivity indices
#[derive(Args)]
#[command(after_help = help::UNCERTAINTY, after_long_help = help::uncertainty())]
pub struct Uncertainty {
    #[command(flatten)]
    pub scene: SceneArgs,

    #[command(flatten)]
    pub out: OutArgs,

    /// Prints one JSON object only; writes files only if --out is given
    #[arg(long)]
    pub json: bool,

    /// Discards the checkpoint of an interrupted sample and starts anew
    #[arg(long)]
    pub fresh: bool,
}

pub fn uncertainty(args: &Uncertainty) -> Result<(), Stop> {
    let scene = args.scene.load_with_seta()?;
    let table = scene.uncertainty.clone().ok_or_else(|| without_table(&scene))?;
    let design =
        Design::new(table.plan(&scene)).map_err(|error| Stop::bad_input(error, "See peel keys uncertainty."))?;
    let command = command_line();
    let started = Instant::now();
    let sampler = Sampler::open(args, &scene, design.samples())?;
    let analysis = match &scene.seta {
        None => analysis(&scene, &table, design, &sampler)?,
        Some(_) => analysis_of_setae(&scene, &table, design, &sampler)?,
    };
    let solve_s = started.elapsed().as_secs_f64();
    let summary = UncertaintySummary::new(&scene, &analysis, solve_s).with_command(&command);
    let files = match (&sampler.output, analysis.computed()) {
        (Some(output), 1..) => write(output, &scene, &command, &analysis, &summary),
        _ => Ok(Vec::new()),
    };
    if files.is_ok() && analysis.computed() == analysis.design.samples() {
        sampler.discard()?;
    }
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!(
            "{}\n{}",
            text_summary::uncertainty(&scene, &analysis, sampler.remark().as_deref()),
            list_files(&files)
        ))?;
    }
    files?;
    stopped_short(&analysis)
}

fn without_table(scene: &Scene) -> Stop {
    Stop::bad_input(
        format!("{}: nothing is uncertain in this scene: it lacks the table [uncertainty]", scene.name),
        "Add a line [uncertainty] and below it for example inputs = [{ key = \"strip.height\", distribution = \"normal\", deviation = \"0.5 nm\" }]",
    )
}

/// The sample, and beside it what derivatives give.
fn analysis(
    scene: &Scene,
    table: &UncertaintyTable,
    design: Design,
    sampler: &Sampler,
) -> Result<Analysis, ReportError> {
    let model =
        |values: &[f64]| table.model(scene, values).map_err(|error| format!("{}. {}", error.found, error.remedy));
    let stop = || scene.bounds.from_now();
    let peel = SampledPeel { model: &model, of: &table.quantities, accuracy: &scene.accuracy, stop: &stop };
    // a sample is computed to its end, because it is kept; what is beside the samples is not
    let interruptible = || sampler.ends(scene.bounds.from_now());
    let beside = SampledPeel { stop: &interruptible, ..peel };
    let taylors = taylor_polynomials(design.plan(), &beside);
    let alone = one_at_a_time(design.plan(), ALONE_AT, &beside);
    let outcomes: Vec<Option<Outcome>> = sampler.sample(&design, &peel)?;
    Ok(Analysis::new(design, &table.quantities, outcomes, taylors, alone))
}

/// The same of setae, whose derivatives are differences of pull-offs.
fn analysis_of_setae(
    scene: &Scene,
    table: &UncertaintyTable,
    design: Design,
    sampler: &Sampler,
) -> Result<Analysis, ReportError> {
    let setae = Setae::like(scene);
    let stop = || scene.bounds.from_now();
    let pull_off = SampledSeta { scene, table, setae: &setae, stop: &stop };
    // as of peels
    let interruptible = || sampler.ends(scene.bounds.from_now());
    let beside = SampledSeta { stop: &interruptible, ..pull_off };
    let taylors = (taylor_by_differences(design.plan(), &beside), DerivativesBy::Differences);
    let alone = one_at_a_time(design.plan(), ALONE_AT, &beside);
    let outcomes = sampler.sample(&design, &pull_off)?;
    Ok(Analysis::new(design, &table.quantities, outcomes, taylors, alone))
}

fn write(
    output: &OutputFolder,
    scene: &Scene,
    command: &str,
    analysis: &Analysis,
    summary: &UncertaintySummary,
) -> Result<Vec<PathBuf>, ReportError> {
    output.write(|dir| {
        let mut files = vec![summary.write(dir)?];
        files.extend(report::write_uncertainty(dir, analysis)?);
        files.push(report::write_samples(dir, analysis)?);
        files.push(report::write_parameters(dir, scene, command)?);
        files.extend(report::draw_uncertainty(analysis, &scene.title, dir)?);
        Ok(files)
    })
}

/// Whether samples are missing, and those that were cut short.
fn stopped_short(analysis: &Analysis) -> Result<(), Stop> {
    let (computed, samples) = (analysis.computed(), analysis.design.samples());
    let interrupted = (computed < samples).then(|| {
        format!(
            "interrupted, {computed} of {samples} samples are done; the same command resumes from there, --fresh starts anew"
        )
    });
    let reasons = analysis.cut_short();
    let count: usize = reasons.iter().map(|of| of.count).sum();
    let failed = (count > 0).then(|| {
        let lines =
            reasons.iter().map(|of| format!("\n{} times, first at sample {}: {}", of.count, of.first, of.reason));
        format!("{count} of {computed} samples{}", lines.collect::<String>())
    });
    let parts: Vec<String> = interrupted.into_iter().chain(failed).collect();
    if parts.is_empty() { Ok(()) } else { Err(Stop::cut_short(parts.join("\nand "))) }
}
