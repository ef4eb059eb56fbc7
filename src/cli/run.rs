//! `peel run`: the whole peel of one scene.

use super::help;
use super::input::SceneArgs;
use super::output::{OutArgs, list_files, say};
use super::stop::Stop;
use super::words;
use clap::Args;
use peelkit::report::{self, PeelSummary, ReportError};
use peelkit::scene::Scene;
use peelkit::study::{self, End, Peel};
use std::path::{Path, PathBuf};

/// Peels one scene from rest to its end: the whole path with its limit points, and how far they may be wrong
#[derive(Args)]
#[command(after_long_help = help::run())]
pub struct Run {
    #[command(flatten)]
    scene: SceneArgs,

    #[command(flatten)]
    out: OutArgs,

    /// Prints the object of summary.json and nothing else; files are written only if --out is given
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Run) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let folder = match &args.out.out {
        None if args.json => None,
        None => Some(args.scene.default_folder()),
        given => given.clone(),
    };
    let folder = folder.map(|folder| args.out.claim(&folder)).transpose()?;
    let peel = study::peel(&scene.model, &scene.accuracy, &scene.bounds);
    let summary = PeelSummary::new(&scene, &peel);
    let files = folder.map_or(Ok(Vec::new()), |folder| folder.write(|dir| write(dir, &scene, &peel, &summary)));
    // what was found is told although it could not be written
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", words::peel(&scene, &peel), list_files(&files)))?;
    }
    files?;
    match &peel.end {
        End::Failed(reason) => Err(Stop::cut_short(reason)),
        _ => Ok(()),
    }
}

fn write(folder: &Path, scene: &Scene, peel: &Peel, summary: &PeelSummary) -> Result<Vec<PathBuf>, ReportError> {
    let mut files =
        vec![summary.write(folder)?, report::write_curve(folder, peel)?, report::write_limit_points(folder, peel)?];
    if peel.points.len() > 1 {
        files.extend(report::draw_peel(peel, &scene.title, folder)?);
    }
    Ok(files)
}
