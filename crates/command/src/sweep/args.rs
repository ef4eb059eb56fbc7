//! The arguments of `peel sweep`.

use crate::help;
use crate::input::SceneArgs;
use crate::output::OutArgs;
use clap::{Args, ValueEnum};
use peelkit::study::PointKind;
use std::path::PathBuf;

/// Varies one number of a scene: peak force, plateau, snap-off and work against its value
#[derive(Args)]
#[command(after_help = help::SWEEP, after_long_help = help::sweep())]
pub struct Sweep {
    #[command(flatten)]
    pub scene: SceneArgs,

    /// The key to vary, such as strip.bending_stiffness_factor or strip.length
    #[arg(long, value_name = "KEY")]
    pub vary: String,

    /// First value; with its unit where the key has one: "100 nm"
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    pub from: String,

    /// Last value; with its unit where the key has one
    #[arg(long, value_name = "B", allow_hyphen_values = true)]
    pub to: String,

    /// Number of values, both ends included
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub points: u32,

    /// Logarithmic spacing: equal ratios; both ends above zero
    #[arg(long)]
    pub log: bool,

    /// Follows one limit point alone
    ///
    /// No whole paths are computed, which is much faster.
    #[arg(long, value_name = "POINT", conflicts_with = "peak_only")]
    follow: Option<Point>,

    /// The same as --follow peak: the initiation peak alone
    ///
    /// That is the first local maximum of the force.
    #[arg(long)]
    peak_only: bool,

    #[command(flatten)]
    pub out: OutArgs,

    /// Prints one JSON object only; writes files only if --out is given
    #[arg(long)]
    pub json: bool,

    /// Discards the checkpoint of an interrupted sweep and starts anew
    #[arg(long)]
    pub fresh: bool,
}

/// What can be followed.
#[derive(Clone, Copy, ValueEnum)]
enum Point {
    /// The initiation peak
    Peak,
    /// The first displacement limit point: a displacement-controlled test jumps here
    SnapOff,
}

impl Sweep {
    pub fn followed(&self) -> Option<PointKind> {
        match self.follow {
            Some(Point::SnapOff) => Some(PointKind::SnapOff),
            Some(Point::Peak) => Some(PointKind::InitiationPeak),
            None => self.peak_only.then_some(PointKind::InitiationPeak),
        }
    }

    /// Where files go, if they are written.
    pub fn folder(&self) -> Option<PathBuf> {
        match &self.out.out {
            None if self.json => None,
            None => Some(self.scene.default_folder()),
            given => given.clone(),
        }
    }
}
