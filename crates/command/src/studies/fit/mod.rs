//! `peel fit`: parameters of a scene from a measured force-displacement curve.

mod help;

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

pub fn fit(args: &Fit) -> Result<(), Stop> {
    let scene = args.scene.load_any()?;
    let fitting = Fitting::of(&scene, Data::File(&args.data)).map_err(|why| Stop::refused(&scene, why))?;
    let data = args.data.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let drive = Drive {
        scene: &scene,
        out: &args.out,
        folder: args.out.folder(args.json, || args.scene.default_folder(&["fit".to_owned(), data])),
        fresh: false,
        json: args.json,
        bar: Bar::spinner("fitting"),
        answer: Some("stopping: the best parameters so far are kept; Ctrl-C again stops at once"),
    };
    drive.run(&fitting, |found| text_summary::of_many::fit::fit(&found.report(&scene)))
}
