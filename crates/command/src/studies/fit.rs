//! `peel fit`: parameters of a scene from a measured force-displacement curve.

use crate::studies::drive::Drive;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use clap::Args;
use peelkit_analyses::{Data, Fitting};
use std::path::PathBuf;

/// Determines parameters of a scene from a measured force-displacement curve, with intervals
#[derive(Args)]
#[command(after_help = SHORT_HELP, after_long_help = LONG_HELP)]
pub struct Fit {
    #[command(flatten)]
    scene: SceneArgs,

    /// The measured curve: a CSV with displacement, force and, if known, its error
    ///
    /// The header has names and units: displacement_nm,force_nN or u (um),P (mN),P error (mN).
    /// Without it the scene names its curves, as fit.curves.
    #[arg(long, value_name = "CSV")]
    data: Option<PathBuf>,

    #[command(flatten)]
    out: OutArgs,

    /// Prints summary.json alone; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

pub fn fit(args: &Fit) -> Result<(), Stop> {
    let scene = args.scene.load_any()?;
    let data = args.data.as_deref().map_or(Data::OfScene, Data::File);
    let fitting = Fitting::of(&scene, data).map_err(|why| Stop::refused(&scene, why))?;
    let name = |data: &PathBuf| data.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let named: Vec<String> = ["fit".to_owned()].into_iter().chain(args.data.as_ref().map(name)).collect();
    let drive = Drive {
        scene: &scene,
        out: &args.out,
        folder: args.out.folder(args.json, || args.scene.default_folder(&named)),
        fresh: false,
        json: args.json,
        bar: Bar::spinner("fitting"),
        answer: Some("stopping: the best parameters so far are kept; Ctrl-C again stops at once"),
    };
    drive.run(&fitting, |found| text_summary::of_many::fit::fit(&found.report(&scene)))
}

// -- The help --

/// Of `peel fit -h`.
const SHORT_HELP: &str = "\
Example: peel fit strip-fit.toml --data strip-fit.csv
More: peel fit --help, on the table [fit] and the files; peel keys fit";

/// Of `peel fit --help`.
const LONG_HELP: &str = "\
Examples:
  peel fit strip-fit.toml --data strip-fit.csv
  peel fit strip-fit.toml --data strip-fit.csv --set fit.loss=huber --set fit.profile=all
  peel fit strip-fit.toml --data strip-fit.csv --set 'fit.parameters=[\"strip.youngs_modulus\"]'

The scene names what is fitted:
  [fit]
  parameters = [\"adhesion.hamaker_constant\", \"fit.displacement_zero\",
      { key = \"strip.youngs_modulus\", from = \"1 GPa\", to = \"5 GPa\" }]
  force_error = \"0.003 nN\"        standard error of a measured force; without it, it is estimated from the residuals
  curves = [{ data = \"at-90.csv\" }, { data = \"at-60.csv\", set = { \"drive.angle\" = \"60 deg\" } }]
                                  several curves at once, in place of --data

The search begins at the values of the scene. Without bounds a parameter above zero stays within a factor of 100 of its
first value. Compared is the first stable branch of the path, as a machine with the stiffness grip.stiffness records
it. Where the measured force falls to zero for good, or at fit.jump, the test jumps: points behind are not fitted, and
the displacement of the jump is a datum.

Files:
  summary.json       parameters with standard errors, 95 % intervals, correlations, combinations, jump and warnings
  fit.csv            one row for each measured point: what the model gives, residual, weight
  profiles.csv       profile likelihoods, of parameters that are poorly determined
  parameters.toml    the scene with the parameters that were found
  fit.svg, .png      the measured curve, that of the model, and the residuals
  profiles.svg, .png the profile likelihoods

Ctrl-C ends the search with the best parameters so far (exit status 3). To go on, fit parameters.toml.";
