//! The arguments of `peel sweep`.

use super::varied::Varied;
use crate::help;
use crate::input::SceneArgs;
use crate::output::OutArgs;
use crate::text_summary::units::UnitsArgs;
use clap::{Args, ValueEnum};
use peelkit::study::PointKind;
use peelkit_report::Part;
use std::path::PathBuf;

/// Most parts of a sweep.
const MOST: usize = 1_000_000;

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
    #[arg(long, value_name = "I/N", value_parser = parse_part)]
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

/// Reads `I/N`.
fn parse_part(text: &str) -> Result<Part, String> {
    let wrong =
        || format!("write I/N with I from 1 to N and N at most {MOST}, such as 3/8 for the third of eight parts");
    let (index, of) = text.split_once('/').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse::<usize>().ok().filter(|&number| (1..=MOST).contains(&number));
    let part = number(index).zip(number(of)).map(|(index, of)| Part { index, of });
    part.filter(|part| part.index <= part.of).ok_or_else(wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_one_of_so_many() {
        assert_eq!(parse_part("3/8"), Ok(Part { index: 3, of: 8 }));
        for wrong in ["0/8", "9/8", "3", "3/", "/8", "-1/8", "1/0", "a/b", "1.5/2", "1/2000000"] {
            assert!(parse_part(wrong).is_err(), "{wrong}");
        }
    }
}
