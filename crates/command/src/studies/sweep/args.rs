//! The arguments of `peel sweep`.

use super::varied::Varied;
use crate::terminal::help;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::text_summary::units::UnitsArgs;
use clap::{Args, ValueEnum};
use peelkit::study::PointKind;
use peelkit_report::Part;
use std::path::PathBuf;

/// Varies a number of a scene, or two: peak force, plateau, snap-off and work against the values
#[derive(Args)]
#[command(after_long_help = help::sweep())]
pub struct Sweep {
    #[command(flatten)]
    pub scene: SceneArgs,

    #[command(flatten)]
    pub varied: Varied,

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

    /// Computes one part of N: 3/8; peel collect joins the parts
    ///
    /// The values of the sweep are dealt out in turn: part I takes the values I, I + N, I + 2 N, ...
    #[arg(long, value_name = "I/N")]
    pub part: Option<Part>,

    #[command(flatten)]
    pub out: OutArgs,

    #[command(flatten)]
    pub units: UnitsArgs,

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

    /// What the name of the folder says of the sweep: what is varied and followed, and not which values.
    fn folder_parts(&self) -> Vec<String> {
        let followed = match self.followed() {
            Some(PointKind::InitiationPeak) => Some("follow-peak"),
            Some(PointKind::SnapOff) => Some("follow-snap-off"),
            None => None,
        };
        let parts = ["sweep"].into_iter().chain(self.varied.paths()).chain(followed);
        parts.map(str::to_owned).collect()
    }

    fn default_folder(&self, part: Option<Part>) -> PathBuf {
        let part = part.map(|part| format!("part-{}-of-{}", part.index, part.of));
        self.scene.default_folder(&self.folder_parts().into_iter().chain(part).collect::<Vec<_>>())
    }

    /// Where all parts go together, if the user names no folder.
    pub fn folder_of_all(&self) -> PathBuf {
        self.default_folder(None)
    }

    /// Where files go, if they are written.
    pub fn folder(&self) -> Option<PathBuf> {
        self.out.folder(self.json, || self.default_folder(self.part))
    }
}
