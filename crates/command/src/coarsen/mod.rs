//! `peel coarsen`: the law of a tip of a seta, from the spatula of a scene.

mod help;
mod range;

use crate::command_line::command_line;
use crate::input::SceneArgs;
use crate::interrupt::Interrupt;
use crate::output::{OutArgs, list_files, say};
use crate::stop::Stop;
use crate::text_summary;
use clap::Args;
use indicatif::ProgressBar;
use peelkit::model::Hold;
use peelkit::study::Terms;
use peelkit::study::coarsening::{Coarsening, CoarseningError, CoarseningOptions, PadEnd, TipTable};
use peelkit_report::{self as report, ReportError, TipSummary, timed};
use peelkit_scene::{Dimension, Scene};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What a first Ctrl-C does.
const ANSWER: &str = "stopping at the next equilibrium of the spatula; Ctrl-C again stops at once";

/// Computes the force law of a tip of a seta from its spatula, as a table with error bounds
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::LONG)]
pub struct Coarsen {
    #[command(flatten)]
    scene: SceneArgs,

    /// Error wanted of forces and moment, relative to the largest
    #[arg(long, value_name = "X", default_value_t = 1e-3)]
    tolerance: f64,

    /// How far the tip is pressed [default: 50 nm; 5 nm if the pad is held]
    ///
    /// The table begins so far below the height without a normal force.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    press: Option<String>,

    /// Range of v, if the pad is held [default: -10 nm,10 nm]
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    lateral: Option<String>,

    /// Range of θ [default: -0.4 rad,0.4 rad; -0.1 rad,0.1 rad if the pad is held]
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    rotation: Option<String>,

    #[command(flatten)]
    out: OutArgs,

    /// Prints summary.json alone; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

impl Coarsen {
    fn folder(&self) -> Option<PathBuf> {
        match &self.out.out {
            None if self.json => None,
            None => Some(self.scene.default_folder(&["tip".to_owned()])),
            given => given.clone(),
        }
    }

    /// What is asked of the table of a scene.
    fn options(&self, scene: &Scene) -> Result<CoarseningOptions, Stop> {
        let pad_end = if scene.model.grip.horizontal == Hold::Fixed { PadEnd::Held } else { PadEnd::Sliding };
        let mut options = CoarseningOptions { tolerance: self.tolerance, ..CoarseningOptions::of(pad_end) };
        if let Some(text) = &self.press {
            options.range.press = range::number("--press", text, Dimension::Length)?;
        }
        if let Some(text) = &self.lateral {
            if pad_end == PadEnd::Sliding {
                return Err(Stop::bad_input(
                    "--lateral is of no use: the pad of this scene slides, and v changes nothing",
                    "Omit it, or give --set grip.horizontal=fixed, which holds the free end of the pad.",
                ));
            }
            options.range.lateral = range::pair("--lateral", text, Dimension::Length)?;
        }
        if let Some(text) = &self.rotation {
            options.range.rotation = range::pair("--rotation", text, Dimension::Angle)?;
        }
        options.check().map_err(|why| refused(&self.scene.path, &why.into()))?;
        Ok(options)
    }
}

pub fn coarsen(args: &Coarsen) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let options = args.options(&scene)?;
    if scene.accuracy.terms == Terms::Auto {
        return Err(Stop::bad_input(
            "the law of a tip takes the model with all of its terms, and the scene has terms = \"auto\"",
            "Give --set terms=all.",
        ));
    }
    let bar = ProgressBar::new_spinner().with_message("solving the spatula");
    let above = bar.clone();
    let interrupt = Interrupt::listen(move || above.println(ANSWER));
    let stop = interrupt.ends(scene.bounds.from_now());
    let coarsening = Coarsening::until(&scene.model, &options, &stop);
    let mut coarsening = coarsening.map_err(|why| refused(&args.scene.path, &why))?;
    let folder = args.folder().map(|folder| args.out.claim(&folder)).transpose()?;
    bar.enable_steady_tick(Duration::from_millis(200));
    let (found, solve_s) = timed(|| coarsening.table());
    bar.finish_and_clear();
    let table = found.map_err(|why| refused(&args.scene.path, &why))?;
    let command = command_line();
    let summary = TipSummary::new(&scene, &table, solve_s).with_command(&command);
    let files = folder.map_or(Ok(Vec::new()), |folder| folder.write(|dir| write(dir, &table, &summary, &scene.title)));
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::tip(&scene.title, &table, solve_s), list_files(&files)))?;
    }
    files?;
    if table.is_met() {
        return Ok(());
    }
    Err(Stop::cut_short(format!(
        "the table is not as accurate as asked: its relative error is {:.1e}, and {:.1e} was asked for",
        table.relative_error(),
        options.tolerance
    )))
}

/// Why there is no table of a scene.
fn refused(path: &Path, why: &CoarseningError) -> Stop {
    if let CoarseningError::Stopped { .. } = why {
        return Stop::cut_short(format!("{why}; nothing is written"));
    }
    Stop::bad_input(format!("{}: {why}", path.display()), why.remedy())
}

fn write(dir: &Path, table: &TipTable, summary: &TipSummary, title: &str) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![summary.write(dir)?];
    files.extend(report::write_tip_law(dir, table)?);
    files.extend(report::draw_tip_law(table, title, dir)?);
    Ok(files)
}
